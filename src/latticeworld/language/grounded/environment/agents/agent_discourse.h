#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_DISCOURSE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_DISCOURSE_H_

// This header is for agent_reader.cc and its neighbours only. It has the state that reading about
// agents goes through, and the questions about the words and the groups that it asks. None of them
// changes the state; each is defined beside the step of agent_steps.h that asks it.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/language/grounded/environment/agents/agent_groups.h"
#include "latticeworld/language/grounded/environment/agents/agent_phrases.h"
#include "latticeworld/language/grounded/environment/count_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"
#include "latticeworld/language/places.h"

namespace latticeworld::internal {

class AgentDiscourse {
 protected:
  AgentDiscourse(const EnvironmentWords& words, NotedTokens* noted, HeardEnvironment* heard)
      : words_(words), noted_(*noted), tokens_(noted->tokens), heard_(*heard) {}

  std::size_t RoleAt(Role role, std::size_t at) const { return words_.RoleAt(role, tokens_, at); }

  // One step

  // "better" and "actually" correct something only where something was said.
  bool IsPlainBetter(std::size_t said) const { return said == 1 && groups_.empty(); }

  // "I'd like a whale": no likeness of one.
  bool IsLiked() const;

  bool FollowsPlace() const;

  // Whether a phrase of correction is said of the agents.
  bool Corrects(std::size_t said) const;

  // Whether the noun phrase here is what the subject has ("with a dog").
  bool IsHad() const;

  int TotalOf(const std::vector<std::size_t>& groups) const;

  // References

  // The share of a group that the words at `at` say.
  Fraction FractionAt(std::size_t at) const;

  // "most (of them)", "a few (of the twenty)": from how many to how many those are of so many;
  // `tokens` 0: no such word.
  Count VaguePartAt(std::size_t at, int whole) const;

  // Which of the groups so many more can be a part of, what is left of one before the parts of it;
  // kNone: none.
  std::size_t WholeOf(const std::vector<std::size_t>& groups, int part) const;

  // The two groups named last, the later one first; fewer where fewer were named.
  std::vector<std::size_t> NamedLast() const;

  // Which place in a row the word means; 0: none.
  int OrdinalAt(std::size_t at) const;

  bool IsSubject(std::size_t index) const {
    return std::find(subject_.begin(), subject_.end(), index) != subject_.end();
  }

  // The words at `at` in a phrase of company. of_others: they go back to none of the subject
  // itself.
  Reference ReferenceAt(std::size_t at, bool of_others) const;

  // The group named before that a pronoun means.
  std::size_t GroupBefore(bool plural, bool of_others) const;

  // The land that was named last before at_, at most a few sentences ago; `placed`: also where
  // groups were placed.
  std::optional<FeaturePlace> LandBefore(bool plural, bool placed) const;

  // Whether the clause goes on to "each other".
  bool IsMutual() const;

  // Noun phrases

  // "Four wheeled robots" are four, "four-wheeled robots" are any number.
  bool CountsWheeled(std::size_t at) const;

  // Whether the phrase that begins here has a name of agents for its noun.
  bool NounAhead(std::size_t at) const;

  bool IsParticiple(std::size_t at) const;

  bool IsDoing(std::size_t at) const;

  // The count at at_, of the group named last, with what stands behind it.
  LoneCount LoneCountOf(const Count& said) const;

  // Whether the count only sums up those of the sentence ("50 in all").
  bool IsTotalOfSentence(const LoneCount& lone) const;

  // Whether the count says how many the group named last is.
  bool IsCountOfLast(const LoneCount& lone) const;

  // Whether the count is of some of the group named last, rather than of others like them.
  bool IsPartOfLast(const LoneCount& lone) const;

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

  // Whether a word that can be both is a verb at this place ("guards", "flies").
  bool IsVerbHere(std::size_t at, bool counted) const;

  // Whether the name that ends at `end` is part of another thing's: "a stuffed owl", "the knight's
  // sword", "a wolf den".
  bool IsOtherThing(const SpeciesWord& word, std::size_t end) const;

  // "Agents: ...", "People: 1 shepherd": those who are meant are named behind it.
  bool IsHeadingOfAgents(const SpeciesWord& word, std::size_t end) const;

  // The token after the whole name, of which `end` is the first noun's: "dog robot" ends with its
  // kind, which also says whether the name is a plural. nullopt: another noun follows and says what
  // they are ("robot sheep").
  std::optional<std::size_t> EndOfName(std::size_t end, SpeciesWord* word) const;

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

  // How many tokens deny who is named up to `end`: "Whales do not belong there", "whales: none".
  std::size_t UnwantedAfter(std::size_t end) const;

  // Whether the group named last, of a species that we lack, gives way to one that follows.
  bool IsSubstituted(const std::vector<AgentCategory>& categories) const;

  std::string NameHere(std::size_t end) const { return JoinWords(tokens_, at_, end); }

  // A kind's word denies all of the kind ("no robots").
  std::vector<AgentCategory> AbsentCategories(const SpeciesWord& word, std::size_t tokens) const;

  bool PlaceFollows(std::size_t at) const;

  Count DefaultCount(const SpeciesWord& word) const;

  // "a white sheep"
  bool NearArticle() const;

  // The determiner of the noun phrase that ends at at_.
  bool IsDefinite() const;

  // The count before the noun, with that of the collective behind it ("three wolf packs").
  Count CountWith(const Count& collective) const;

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

  void ApplyLead(Group* group) const;

  // Whether the agents before have their own state or place, so that these are apart from them.
  bool GroupIsTold() const;

  // States

  // "charging", of so many tokens, said of robots that stand at their charger.
  bool ChargesAtStation(std::size_t tokens) const;

  // Whether the state's one word is a noun here: "a storm", "until the charge". noun_next: agents
  // are named right behind it.
  bool IsStateNoun(bool noun_next) const;

  bool SubjectIsRobots() const;

  // "at the station", where robots charge; at a village they attack.
  bool IsAtCharger(std::size_t at) const;

  bool IsSubjectWinged() const;

  // "guarded by two knights", but "parked by the lake".
  bool AgentsAfterBy(std::size_t at) const;

  // Whether such a verb has an object: those who are hunted, or watched.
  static bool Takes(AgentState state);

  bool Passive() const;

  // "chases" but not "chasing".
  bool IsFinite(std::size_t at) const;

  std::size_t SubjectEnd() const;

  bool NounFollows(std::size_t at) const;

  // Agents that this clause has still to name.
  bool AgentsAhead(std::size_t at) const;

  // Places

  // The words of a place that begin at at_.
  PlacePhrase PlacePhraseHere() const;

  // Whether the land named at `at`, of so many tokens, stands alone between pauses and is a place.
  bool IsListedLand(std::size_t at, std::size_t land) const;

  // What the preposition at at_ tells of where on the land: "in the middle of the lake", "at the
  // village" is in it. bare: the land's name is all that follows.
  void MoveByPreposition(std::size_t preposition, bool bare, FeaturePlace* feature) const;

  // "stones everywhere": whether the place here is that of assets.
  bool IsPlaceOfAssets() const;

  // How many tokens say only where somebody looks: "facing north"; 0: none.
  std::size_t FacingAt(std::size_t at) const;

  // "in the settlement: nobody"
  bool IsDeniedBehind(std::size_t end) const;

  // Returns the groups whose place it is; none: of those whom the clause has still to name.
  std::vector<std::size_t> OwnersOf(const PlacePhrase& phrase, bool fronted) const;

  // Whether an aside of the subject ends before at_: "a robot (on patrol) in the village".
  bool FollowsAside() const;

  // Whether the land is water that the group can only stand beside.
  bool StandsBeside(const std::optional<FeaturePlace>& land, std::size_t index) const;

  // "Location: ..."
  bool IsLabel(std::size_t at) const;

  // Whether the land named from at_ to `end` without a preposition is where the subject is.
  bool IsBareLand(std::size_t end) const;

  // How many tokens only say where other land is: "with the forest to their south".
  std::size_t SurroundingsAt(std::size_t at) const;

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

  // Clauses

  // "8 robots and 3 drones": whether the latter are none of the former.
  bool IsBeside(std::size_t total, std::size_t part) const;

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

  std::string WordsOf(const Group& group) const;

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
