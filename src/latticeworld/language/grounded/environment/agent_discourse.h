#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENT_DISCOURSE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENT_DISCOURSE_H_

// Of agent_reader.cc and its neighbours only: the state that reading about agents goes through. How
// agents are read: noun phrases ("about nine grazing sheep") make groups, verbs and places are said
// of the subject of their clause, and references ("three of them", "the others") and corrections
// ("no, make it six") go back to groups that were named before.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/language/grounded/environment/count_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"
#include "latticeworld/language/places.h"

namespace latticeworld::internal {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);
inline constexpr std::size_t kPhraseTokens = 6;  // a noun phrase, from its count to its noun
inline constexpr Count kSomeSeen{2, 3, 12, 0};   // what a bare plural stands for

// Whether each of `some` is one of `all`.
inline bool Contains(const std::vector<AgentCategory>& all,
                     const std::vector<AgentCategory>& some) {
  return std::all_of(some.begin(), some.end(), [&](AgentCategory category) {
    return std::find(all.begin(), all.end(), category) != all.end();
  });
}

// A group as it is read, with what the reader needs to know of it.
struct Group {
  AgentWish wish;
  std::size_t begin = 0;  // byte of the instruction where its words begin
  std::size_t end = 0;
  std::size_t sentence = 0;
  bool removed = false;
  bool purpose = false;  // only what the world is for ("to see how robots behave")
};

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

  bool FollowsPlace() const;

  // Whether a phrase of correction is said of the agents.
  bool Corrects(std::size_t said) const;

  void Known(std::size_t tokens);

  std::size_t ReadNobody(std::size_t tokens);

  // References

  std::size_t ReadReference();

  // "three of the eight sheep", "half of the ten sheep": the words before the whole's count.
  std::size_t ReadPartOfCounted();

  // "forty agents: thirty goblins and the rest eagles"
  std::size_t ReadRestOfTotal(std::size_t at);

  // "the former", "the second group": of the two groups named last.
  std::size_t ReadFormerOrLatter();

  // "two rovers and two drones, all four parked": of the groups that add up to so many.
  std::size_t ReadAllOfThem();

  // "the third one grazes"
  std::size_t ReadOrdinal();

  // "an eagle above them": where those are who were named before.
  std::size_t ReadCompany();

  // "a second band" of whoever was named last.
  std::size_t ReadAnotherGroup();

  // Another group of the same agents, whose state and place are still to be told.
  void AddLike(std::size_t model, const Count& count, std::size_t tokens);

  // "half of them sheep": the part has a name of its own.
  std::size_t RenamePart(std::size_t at);

  // A part of the last group becomes one of its own; the others stay behind.
  void Split(const Count& count, int quantity, std::size_t tokens);

  // "the others": what was left of the group that was split, or else the group itself.
  void TakeRest(const Count& count);

  Group* Last();

  // Noun phrases

  // A count, a noun, or both.
  std::size_t ReadNounPhrase();

  // Whether the phrase that begins here has a name of agents for its noun.
  bool NounAhead(std::size_t at) const;

  bool IsParticiple(std::size_t at) const;

  bool IsDoing(std::size_t at) const;

  // A count without a noun of its own: of them, of those named before, or a correction.
  std::size_t ReadLoneCount(const Count& count);

  // What may follow a noun phrase.
  bool EndsNounPhrase(std::size_t at) const;

  static void SetCount(const Count& count, Group* group);

  // Whether a word that can be both is a verb at this place ("guards", "flies").
  bool IsVerbHere(std::size_t at, bool counted) const;

  std::size_t ReadSpecies();

  // Whether the count that was read is a collective's without "of" ("a pack").
  bool IsBarePack() const;

  bool IsApposition(const SpeciesWord& word, std::size_t end) const;

  // "a goblin pack", "a goblin warband of 25"; "robots patrol" are no patrol.
  Count ReadPack(std::size_t end) const;

  // A word that no table has, as in "humanoid rescue robots".
  bool IsUnknownHere(std::size_t at) const;

  // "we study how people move": nobody is asked for yet.
  bool IsInPurpose() const;

  bool IsPossessive(std::size_t end) const;

  void ReadAbsence(const SpeciesWord& word, std::size_t end);

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

  // "Goblins attack the village. Eight goblins.": those of before, counted now. kNone: others.
  std::size_t VagueBefore(const std::vector<std::size_t>& same, const Count& count,
                          std::size_t end) const;

  std::vector<std::size_t> GroupsOf(const SpeciesWord& word, std::size_t end) const;

  void ReferTo(const std::vector<std::size_t>& same, const Count& count, std::size_t end);

  // "no, make it knights"
  void Replace(const SpeciesWord& word, const Count& count, std::size_t end);

  void ApplyLead(Group* group) const;

  // Whether the agents before have their own state or place, so that these are apart from them.
  bool GroupIsTold() const;

  // States

  std::size_t ReadState();

  bool SubjectIsRobots() const;

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

  // A place at the head of a clause, before the agents that it is said of.
  bool IsFronted(std::size_t end) const;

  void SetPlace(const std::vector<Place>& places, const std::optional<FeaturePlace>& feature,
                bool each, const std::vector<std::size_t>& owners, std::size_t end);

  // Clauses

  void BeginSentence();

  void EndPhrase();

  void EndClause();

  void EndSentence();

  // "Ten creatures: four sheep and six goblins": the first is the sum of the others.
  void DropAnnouncedTotal();

  void Extend(std::size_t index, std::size_t end);

  std::string WordsOf(const Group& group) const;

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
  std::vector<Place> lead_places_;
  std::optional<FeaturePlace> lead_feature_;
  bool lead_each_ = false;
  bool lead_set_ = false;

  // The text so far.
  std::vector<std::size_t> previous_;  // subjects that a pronoun goes back to
  std::size_t last_ = kNone;           // the group named last
  std::size_t part_ = kNone;           // split off it last
  std::size_t rest_ = kNone;           // what it was split off
  std::size_t halved_ = kNone;
  std::vector<Place> there_;  // the place named last
  std::optional<FeaturePlace> there_feature_;
  int part_of_ = 0;           // of the group that is being named, so many are meant
  bool split_state_ = false;  // the subject's state is only inherited
  std::size_t placed_ = kNone;
  std::size_t placed_sentence_ = 0;
  bool corrected_ = false;
  bool told_since_correction_ = false;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENT_DISCOURSE_H_
