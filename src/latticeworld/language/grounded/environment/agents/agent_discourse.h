#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_DISCOURSE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_DISCOURSE_H_

// Of agent_reader.cc and its neighbours only: the state that reading about agents goes through. How
// agents are read: noun phrases ("about nine grazing sheep") make groups, verbs and places are said
// of the subject of their clause, and references ("three of them", "the others") and corrections
// ("no, make it six") go back to groups that were named before.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/language/grounded/environment/agents/agent_groups.h"
#include "latticeworld/language/grounded/environment/count_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"
#include "latticeworld/language/places.h"

namespace latticeworld::internal {

class AgentReader {
 public:
  AgentReader(const EnvironmentWords& words, NotedTokens* noted, HeardEnvironment* heard)
      : words_(words), noted_(*noted), tokens_(noted->tokens), heard_(*heard) {}

  void Run();

 private:
  std::size_t RoleAt(Role role, std::size_t at) const { return words_.RoleAt(role, tokens_, at); }

  // One step

  std::size_t Step();

  // "better" and "actually" correct something only where something was said.
  bool IsPlainBetter(std::size_t said) const { return said == 1 && groups_.empty(); }

  // "I'd like a whale": no likeness of one.
  bool IsLiked() const;

  bool FollowsPlace() const;

  // Whether a phrase of correction is said of the agents.
  bool Corrects(std::size_t said) const;

  void Known(std::size_t tokens);

  // "so do four horses"
  std::size_t ReadLikewise();

  // "each with", "every one of them has": of who follows there are as many as of the subject.
  std::size_t ReadEachHas();

  // Whether the noun phrase here is what the subject has ("with a dog").
  bool IsHad() const;

  int TotalOf(const std::vector<std::size_t>& groups) const;

  std::size_t ReadNobody(std::size_t tokens);

  // References

  std::size_t ReadReference();

  // "half", "a third", "two thirds"; `tokens` 0: no such share.
  struct Fraction {
    int parts = 1;
    int of = 1;
    std::size_t tokens = 0;
  };
  Fraction FractionAt(std::size_t at) const;

  // "three of the eight sheep", "half of the ten sheep": the words before the whole's count.
  std::size_t ReadPartOfCounted();

  // "most (of them)", "a few (of the twenty)": from how many to how many those are of so many;
  // `tokens` 0: no such word.
  Count VaguePartAt(std::size_t at, int whole) const;

  // Which of the groups so many more can be a part of, what is left of one before the parts of it;
  // kNone: none.
  std::size_t WholeOf(const std::vector<std::size_t>& groups, int part) const;

  // "Eight sheep graze. Three of the sheep sleep.": of those who were named and counted before.
  std::size_t ReadPartOfNamed();

  // "forty agents: thirty goblins and the rest eagles"
  std::size_t ReadRestOfTotal(std::size_t at);

  // The two groups named last, the later one first; fewer where fewer were named.
  std::vector<std::size_t> NamedLast() const;

  // "the former", "the second group": of the two groups named last.
  std::size_t ReadFormerOrLatter();

  // "two of the former, a single one of the latter"
  std::size_t ReadCountOfFormer();

  // "two rovers and two drones, all four parked": of the groups that add up to so many.
  std::size_t ReadAllOfThem();

  // "the third one grazes", "a fourth has run away", "the last are asleep"
  std::size_t ReadOrdinal();

  // Which place in a row the word means; 0: none.
  int OrdinalAt(std::size_t at) const;

  // "an eagle above them", "next to the horses": where those are who were named before; "above it":
  // the land that was named before.
  std::size_t ReadCompany();

  bool IsSubject(std::size_t index) const {
    return std::find(subject_.begin(), subject_.end(), index) != subject_.end();
  }

  // The group that the words at `at` go back to in a phrase of company, and how many they are.
  // of_others: none of the subject itself.
  struct Reference {
    std::size_t tokens = 0;  // 0: no reference
    std::size_t group = kNone;
    bool land = false;  // may be of land just as well
    bool plural = false;
  };
  Reference ReferenceAt(std::size_t at, bool of_others) const;

  // The group named before that a pronoun means.
  std::size_t GroupBefore(bool plural, bool of_others) const;

  // The land that was named last before at_, at most a few sentences ago; `placed`: also where
  // groups were placed.
  std::optional<FeaturePlace> LandBefore(bool plural, bool placed) const;

  // "a second band" of whoever was named last.
  std::size_t ReadAnotherGroup();

  // Whether the clause goes on to "each other".
  bool IsMutual() const;

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

  // "Four wheeled robots" are four, "four-wheeled robots" are any number.
  bool CountsWheeled(std::size_t at) const;

  // Whether the phrase that begins here has a name of agents for its noun.
  bool NounAhead(std::size_t at) const;

  bool IsParticiple(std::size_t at) const;

  bool IsDoing(std::size_t at) const;

  // A count without a noun of its own: of them, of those named before, or a correction.
  std::size_t ReadLoneCount(const Count& count);

  // All who are named in this sentence.
  std::vector<std::size_t> GroupsOfSentence() const;

  // Whether the count that begins here stands right behind the group's noun, or its label.
  bool FollowsNoun(const Group& group) const;

  // Whether the group was only announced, without a number, and the count that begins here is its.
  bool IsAnnounced(const Group& group, bool bare) const;

  // "Our rovers are spread along the road, two ...": whether those named are only shared out.
  bool IsSpreadOut(const Group& group) const;

  bool IsFlockOf(const Group& group) const;

  bool IsPlaceAhead(std::size_t at) const;

  // Whether places are listed that go on at `at`, up to "and the east".
  bool IsPlaceList(std::size_t at) const;

  // What may follow a noun phrase.
  bool EndsNounPhrase(std::size_t at) const;

  static void SetCount(const Count& count, Group* group);

  // Whether a word that can be both is a verb at this place ("guards", "flies").
  bool IsVerbHere(std::size_t at, bool counted) const;

  std::size_t ReadSpecies();

  // "none of the two robots moves"
  bool IsNoneOf() const;

  // Whether the count that was read is a collective's without "of" ("a pack").
  bool IsBarePack() const;

  bool IsApposition(const SpeciesWord& word, std::size_t end) const;

  // "a goblin pack", "a goblin warband of 25"; "robots patrol" are no patrol.
  Count ReadPack(std::size_t end) const;

  // A word that no table has, as in "humanoid rescue robots".
  bool IsUnknownHere(std::size_t at) const;

  bool IsAudience(const SpeciesWord& word) const;

  // "we study how people move": nobody is asked for yet.
  bool IsInPurpose() const;

  bool IsPossessive(std::size_t end) const;

  void ReadAbsence(const SpeciesWord& word, std::size_t end);

  // How many tokens deny who is named up to `end`: "Whales do not belong there", "whales: none".
  std::size_t UnwantedAfter(std::size_t end) const;

  // "all are idle except the horses, which graze": then the horses are the subject.
  bool ReadExcepted(const SpeciesWord& word, std::size_t end);

  // Whether the group named last, of a species that we lack, gives way to one that follows.
  bool IsSubstituted(const std::vector<AgentCategory>& categories) const;

  // Of "ten robots, no drones" none is a drone.
  void NarrowDeniedKinds();

  std::string NameHere(std::size_t end) const { return JoinWords(tokens_, at_, end); }

  // A kind's word denies all of the kind ("no robots").
  std::vector<AgentCategory> AbsentCategories(const SpeciesWord& word, std::size_t tokens) const;

  bool PlaceFollows(std::size_t at) const;

  Count DefaultCount(const SpeciesWord& word) const;

  // "a white sheep"
  bool NearArticle() const;

  // The determiner of the noun phrase that ends at at_.
  bool IsDefinite() const;

  void ReadPresence(const SpeciesWord& word, const Count& collective, std::size_t end);

  // "What can my robot do? ... One rover": what was meant by "my robot" is named now.
  void DropVagueKinds(const SpeciesWord& word);

  // "Twenty mares graze. The stallion sleeps.": one beside those who were named before.
  bool IsAnotherOne(const SpeciesWord& word, const std::vector<std::size_t>& same,
                    std::size_t end) const;

  // "No, eagles.": nothing else is said of them.
  bool IsBareSentence(const Group& group) const;

  // "Goblins attack the village. Eight goblins.", "Eagles. Three eagles circle.": those of before,
  // counted now. kNone: others.
  std::size_t VagueBefore(const std::vector<std::size_t>& same, const Count& count,
                          std::size_t end) const;

  // Those of before whose name is that of tokens [first, end).
  std::vector<std::size_t> GroupsOf(const SpeciesWord& word, std::size_t first,
                                    std::size_t end) const;

  // "Ten robot dogs. The dogs ...": those of before whose name ends in what is said up to `end`.
  std::vector<std::size_t> GroupsCalled(std::size_t end) const;

  void ReferTo(const std::vector<std::size_t>& same, const Count& count, std::size_t end);

  // "no, make it knights"
  void Replace(const SpeciesWord& word, const Count& count, std::size_t end);

  void ApplyLead(Group* group) const;

  // Whether the agents before have their own state or place, so that these are apart from them.
  bool GroupIsTold() const;

  // States

  std::size_t ReadState();

  bool SubjectIsRobots() const;

  // "at the station", where robots charge; at a village they attack.
  bool IsAtCharger(std::size_t at) const;

  bool IsSubjectWinged() const;

  // "the drones are on the ground"
  std::size_t ReadGrounded();

  // "guarded by two knights", but "parked by the lake".
  bool AgentsAfterBy(std::size_t at) const;

  // Whether such a verb has an object: those who are hunted, or watched.
  static bool Takes(AgentState state);

  bool Passive() const;

  // "chases" but not "chasing".
  bool IsFinite(std::size_t at) const;

  std::size_t SubjectEnd() const;

  void SetState(std::size_t index, AgentState state, bool outright);

  bool NounFollows(std::size_t at) const;

  // Agents that this clause has still to name.
  bool AgentsAhead(std::size_t at) const;

  // Places

  std::size_t ReadPlace();

  // "Location: ..."
  bool IsLabel(std::size_t at) const;

  // Whether the land named from at_ to `end` without a preposition is where the subject is.
  bool IsBareLand(std::size_t end) const;

  // "not by the lake, in the fields": the owners are not where they were said to be.
  void TakeBackPlace(const PlaceMatch& place, const std::optional<FeaturePlace>& feature,
                     const std::vector<std::size_t>& owners);

  // How many tokens only say where other land is: "with the forest to their south".
  std::size_t SurroundingsAt(std::size_t at) const;

  // "there" goes back to the place named last.
  std::size_t ReadThere();

  // "Heat shimmers over the road, and three mares ...": the place was that of another clause.
  bool EndsOtherClause(std::size_t end) const;

  // "Bridge: one warrior"
  bool IsHeading(std::size_t at) const;

  // "The village is full of robots."
  bool IsFilled(std::size_t at) const;

  std::vector<std::size_t> Owners() const;

  // "Three goblins. Just standing, in the north.": nothing of its own before it in the sentence.
  bool IsFragment() const;

  // "Three goblins. All in the north." is said of the goblins.
  bool ContinuesPrevious() const;

  // A bare compass word is a place where nothing follows that it could qualify.
  bool IsBarePlace(const PlaceMatch& place, std::size_t at) const;

  // "forest edge", "of the village": land that the place is at.
  std::optional<FeaturePlace> ReadFeature(std::size_t* end, bool near, const PlaceMatch& place,
                                          std::size_t place_at) const;

  // The land that is named at *at, past articles and adjectives; moves *at behind its name.
  std::optional<FeatureWord> LandAt(std::size_t* at) const;

  // "(between the lake) and the village", "(from the lake) to the village".
  void ReadOtherEnd(std::size_t first, FeaturePlace* feature, std::size_t* end) const;

  // "split between the lake and the forest": half of the group is at each. False: it is not so.
  bool ShareOut(const FeaturePlace& feature, std::size_t index);

  bool IsSharedOut(std::size_t at) const;

  // "far side of the lake, seen from the village"
  std::optional<FeaturePlace> ReadFarSide(std::size_t* at) const;

  // A place at the head of a clause, before the agents that it is said of.
  bool IsFronted(std::size_t end) const;

  // How many tokens a phrase of place or company takes that begins at `at` with a preposition.
  std::size_t PlacePhraseAt(std::size_t at) const;

  // The places within those that the clause began with; all of them where none is.
  std::vector<Place> NarrowedByLead(const std::vector<Place>& places) const;

  // "on the grass by the village", "in the grass east of the lake": whether the latter narrows the
  // land that was named right before it.
  bool Narrows(const FeaturePlace& feature, const std::optional<FeaturePlace>& land) const;

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

  // "8 robots and 3 drones": whether the latter are none of the former.
  bool IsBeside(std::size_t total, std::size_t part) const;

  // Of the group only those stay who are none of its parts, which are `sum` together. False: it is
  // not said how many those are.
  bool TakePartsOf(std::size_t index, const std::vector<std::size_t>& parts, int sum);

  // "The only living thing is an eagle": agents of any kind are no group beside those named.
  void SumUpAnyAgents();

  // Exactly, at least or at most as many agents of all kinds as the group says.
  EnvironmentClaim TotalClaim(const Group& total) const;

  // Whether those named after the group are a list of who is in it.
  bool IsListed(std::size_t index) const;

  // How many packs were counted, where nobody said how many are in each; 0: none.
  int PackCount() const;

  // How many are in each of the packs that were counted; 1: no packs.
  int PackSize() const;

  // "There used to be twenty horses": how many there are now is told later.
  bool IsBygone() const;

  // "three drones altogether": those who were named.
  bool IsSum(const SpeciesWord& word, const Count& count, std::size_t end) const;

  void Extend(std::size_t index, std::size_t end);

  std::string WordsOf(const Group& group) const;

  // "a drone above ten horses": the subject is where the new group is.
  void JoinSubjectTo(std::size_t index);

  // "Eight drones, all but two in the air": the two are not.
  void TellUnlike();

  // Gives those who are with others the place of those.
  void JoinCompany();

  void Finish();

  bool IsDenied(const EnvironmentClaim& claim) const;

  const EnvironmentWords& words_;
  NotedTokens& noted_;
  const std::vector<Token>& tokens_;
  HeardEnvironment& heard_;
  std::size_t at_ = 0;
  std::size_t sentence_ = 0;
  std::vector<Group> groups_;

  // The noun phrase that is being read.
  Count pending_;
  std::size_t count_at_ = 0;
  std::optional<AgentState> state_before_;
  std::size_t state_at_ = 0;
  std::size_t phrase_begin_ = kNone;  // byte

  // The clause.
  std::vector<std::size_t> subject_;
  std::size_t object_ = kNone;
  std::size_t object_end_ = 0;
  bool acted_ = false;  // a verb that takes an object came after the subject
  std::size_t verb_end_ = kNone;
  std::size_t acted_on_ = 0;  // the sentence, from 1, of the last verb
  bool joined_ = false;       // "and" since the subject
  bool paused_ = false;       // a comma since the subject
  bool new_clause_ = false;
  bool absent_here_ = false;  // who was just denied a place
  bool clause_open_ = true;   // nothing but pauses and prepositions so far
  Lead lead_;

  std::optional<AxisMatch> order_;  // along which the groups are told
  std::size_t order_first_ = 0;     // the first of them

  std::size_t with_ = kNone;  // whom those named last are with

  // The text so far.
  std::vector<std::size_t> previous_;  // subjects that a pronoun goes back to
  std::size_t last_ = kNone;           // the group named last
  std::size_t part_ = kNone;           // split off it last
  std::size_t rest_ = kNone;           // what it was split off
  int whole_quantity_ = 0;             // of the group named last, before any part was taken
  int packs_ = 0;                      // in so many packs
  int unit_ = 1;                       // so many of it are one pair, or one team
  std::vector<Place> there_;           // the place named last
  std::optional<FeaturePlace> there_feature_;
  Count part_of_;             // of the group that is being named, so many are meant
  bool all_but_ = false;      // "all but two of the ten", "only two of the ten": unlike the others
  bool split_state_ = false;  // the subject's state is only inherited
  std::size_t placed_ = kNone;
  std::size_t placed_sentence_ = 0;
  std::size_t told_former_ = 0;      // the sentence, from 1, that spoke of the former
  std::size_t substituted_ = kNone;  // the group that gives way to who is named next
  std::size_t by_subject_ = kNone;   // "chased by two goblins": who is
  std::size_t model_ = kNone;        // "so do": whose state and place those have who follow
  int times_ = 1;                    // "each with a dog": so many of who is named next
  bool everybody_ = false;           // the subject is all of them
  bool corrected_ = false;
  bool told_since_correction_ = false;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_DISCOURSE_H_
