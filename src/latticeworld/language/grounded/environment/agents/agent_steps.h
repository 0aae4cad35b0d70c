#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_STEPS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_STEPS_H_

// This header is for agent_reader.cc and its neighbours only. It has the steps of reading about
// agents: noun phrases ("about nine grazing sheep") make groups, verbs and places are said of the
// subject of their clause, and references ("three of them", "the others") and corrections ("no,
// make it six") go back to groups that were named before.

#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/language/grounded/environment/agents/agent_discourse.h"

namespace latticeworld::internal {

class AgentReader : private AgentDiscourse {
 public:
  AgentReader(const EnvironmentWords& words, NotedTokens* noted, HeardEnvironment* heard)
      : AgentDiscourse(words, noted, heard) {}

  void Run();

 private:
  // One step

  std::size_t Step();

  void Known(std::size_t tokens);

  // "so do four horses"
  std::size_t ReadLikewise();

  // "each with", "every one of them has": of who follows there are as many as of the subject.
  std::size_t ReadEachHas();

  std::size_t ReadNobody(std::size_t tokens);

  // References

  std::size_t ReadReference();

  // "some of them", "a few of them", of so many tokens: a part of the last group.
  std::size_t ReadSomeOfThem(std::size_t tokens);

  // "Goblins? None, please."
  std::size_t ReadNoneWanted();

  // "the others", "the remaining five"
  std::size_t ReadOthers();

  // "they", "it": the subject goes on, or is what a verb before has for its object.
  std::size_t ReadPronoun();

  // "three of the eight sheep", "half of the ten sheep": the words before the whole's count.
  std::size_t ReadPartOfCounted();

  // "Eight sheep graze. Three of the sheep sleep.": of those who were named and counted before.
  std::size_t ReadPartOfNamed();

  // "forty agents: thirty goblins and the rest eagles"
  std::size_t ReadRestOfTotal(std::size_t at);

  // "the former", "the second group": of the two groups named last.
  std::size_t ReadFormerOrLatter();

  // "two of the former, a single one of the latter"
  std::size_t ReadCountOfFormer();

  // "two rovers and two drones, all four parked": of the groups that add up to so many.
  std::size_t ReadAllOfThem();

  // "the third one grazes", "a fourth has run away", "the last are asleep"
  std::size_t ReadOrdinal();

  // "an eagle above them", "next to the horses": where those are who were named before; "above it":
  // the land that was named before.
  std::size_t ReadCompany();

  // "a second band" of whoever was named last.
  std::size_t ReadAnotherGroup();

  void AddOtherSide();

  // "all of them are asleep", "everybody waits": all whose state was not told, at least those who
  // were named last.
  std::size_t ReadEverybody();

  // "all but one", "all except two of them".
  std::size_t ReadAllBut();

  // "half", "a third of them", "two thirds of the flock".
  std::size_t ReadFraction();

  // "six dogs in three pairs": what "one" of them is.
  std::size_t ReadUnit();

  // Another group of the same agents, whose state and place are still to be told.
  void AddLike(std::size_t model, const Count& count, std::size_t tokens);

  // "half of them sheep": the part has a name of its own.
  std::size_t RenamePart(std::size_t at);

  // "20 robots, 5 of them drones": the others are none.
  void LeaveOthers();

  // Names the group anew ("are sheep"); how many tokens say so.
  std::size_t Rename(std::size_t index, std::size_t at);

  // "..., except one, which has landed": said of a group before.
  std::size_t ReadExceptSome();

  // A part of the last group becomes one of its own; the others stay behind.
  void Split(const Count& count, int quantity, std::size_t tokens);

  // "the others": what was left of the group that was split, or else the group itself.
  void TakeRest(const Count& count);

  // "A goat, three sheep, two mares. The goat sleeps, the others graze.": the other groups that
  // nothing was said of. Whether there are any.
  bool TakeOtherGroups();

  Group* Last();

  // Comparisons

  // "as many", "twice as many goblins as knights", "the same number of": so many as are in a group
  // named before. The words that say which one are ignored from then on.
  Count ReadComparedCount();

  // The group in "... as there are knights"; kNone: none is said.
  std::size_t MeasureAhead(std::size_t at);

  // "25 against 15", "eight on each side": of groups that have no count yet.
  std::size_t ReadCountsOfSides();

  // Noun phrases

  // A count, a noun, or both.
  std::size_t ReadNounPhrase();

  // A count without a noun of its own: of them, of those named before, or a correction.
  std::size_t ReadLoneCount(const Count& count);

  // "seven in each", "twenty each in the fields and by the lake": how many tokens say so, 0: none.
  std::size_t ReadCountOfEach(const LoneCount& lone);

  // "his flock of sixty": a group of sheep.
  void AddFlock(const Count& count);

  // "sheep: nine": how many they are, or others at a place of their own ("in the south seven").
  void ReadBareCount(const LoneCount& lone);

  // If some of a group that was not counted are more than were thought, it has at least those.
  void RaiseLeastOfLast(const LoneCount& lone);

  static void SetCount(const Count& count, Group* group);

  std::size_t ReadSpecies();

  // The agents of that name are there, or are denied; how many tokens the noun phrase takes.
  std::size_t ReadNamed(const SpeciesWord& word, std::size_t end);

  void ReadAbsence(const SpeciesWord& word, std::size_t end);

  // "all are idle except the horses, which graze": then the horses are the subject.
  bool ReadExcepted(const SpeciesWord& word, std::size_t end);

  // In "ten robots, no drones", no robot is a drone.
  void NarrowDeniedKinds();

  void ReadPresence(const SpeciesWord& word, const Count& collective, std::size_t end);

  // Whether the noun names nobody new: it goes back to a group, replaces one or sums some up.
  bool ReadKnown(const SpeciesWord& word, const Count& count, std::size_t end);

  // The group that the noun names, with all that was said before it; uses that up.
  Group NewGroup(const SpeciesWord& word, const Count& count, std::size_t end);

  // "four knights with a dog each": four dogs.
  void CountForEachOwner(std::size_t end, Group* group);

  // Whom the group is with: who has it, or what others of its list are with.
  void PutInCompany(Group* group);

  // The new group is whom the subject acts on, or the subject of what follows.
  void MakeObject(std::size_t index, std::size_t end);
  void MakeSubject(std::size_t index);

  // "What can my robot do? ... One rover": what was meant by "my robot" is named now.
  void DropVagueKinds(const SpeciesWord& word);

  void ReferTo(const std::vector<std::size_t>& same, const Count& count, std::size_t end);

  // "no, make it knights"
  void Replace(const SpeciesWord& word, const Count& count, std::size_t end);

  // States

  std::size_t ReadState();

  // "none of them parked": the subject does something else.
  void DenyState(AgentState state);

  // The state, whose words end at `end`, is that of agents that are named next: "grazing sheep";
  // by: "guarded by four knights".
  void KeepStateForNext(AgentState state, bool by, std::size_t end);

  // The groups that a verb at at_ is said of; they become the subject. fragment: its sentence has
  // no subject of its own.
  std::vector<std::size_t> TakeOwnersOfState(bool fragment);

  // "the drones are on the ground"
  std::size_t ReadGrounded();

  void SetState(std::size_t index, AgentState state, bool outright);

  // Places

  std::size_t ReadPlace();

  // "not by the lake, in the fields": the owners are not where they were said to be.
  void TakeBackPlace(const PlaceMatch& place, const std::optional<FeaturePlace>& feature,
                     const std::vector<std::size_t>& owners);

  // "there" goes back to the place named last.
  std::size_t ReadThere();

  // "split between the lake and the forest": half of the group is at each. False: it is not so.
  bool ShareOut(const FeaturePlace& feature, std::size_t index);

  void SetPlace(const std::vector<Place>& places, const std::optional<FeaturePlace>& feature,
                bool each, const std::vector<std::size_t>& owners, std::size_t end);

  // "from left to right: three knights, two goblins"
  std::size_t ReadOrder();

  void PutInOrder();

  // Clauses

  void BeginSentence();

  void EndPhrase();

  void EndClause();

  void EndSentence();

  // "Ten creatures: four sheep and six goblins": the first is the sum of the others.
  void DropAnnouncedTotal();

  // Reduces a group to the categories that none of its parts has; the parts are `sum` agents
  // together. False: the words do not say how many those others are.
  bool TakePartsOf(std::size_t index, const std::vector<std::size_t>& parts, int sum);

  // "The only living thing is an eagle": agents of any kind are no group beside those named.
  void SumUpAnyAgents();

  void Extend(std::size_t index, std::size_t end);

  // "a drone above ten horses": the subject is where the new group is.
  void JoinSubjectTo(std::size_t index);

  // "Eight drones, all but two in the air": the two are not.
  void TellUnlike();

  // Gives those who are with others the place of those.
  void JoinCompany();

  void Finish();
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_STEPS_H_
