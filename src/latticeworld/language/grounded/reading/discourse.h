#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_DISCOURSE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_DISCOURSE_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/reading/chunk.h"

namespace latticeworld {

// What is known of a feature besides what the plan says.
struct Thing {
  const ClassWord* noun = nullptr;
  bool plural = false;
  bool is_island = false;
  bool zones_from_lead = false;   // "In the north ...": a place of its own replaces it
  bool dropped = false;           // "scratch that"
  std::optional<Waypoint> start;  // of what may yet turn out to run: "cuts in from the north"
  int counted = 0;                // "exactly two lakes": there are no others; 0: not said
  int left = 0;                   // those of them that no words have told of one by one
  int sentence = 0;
  std::size_t begin = 0;  // bytes of the instruction
  std::size_t end = 0;
};

// "island", "wooded islet"
bool NamesIsland(const ClassWord& noun);

// The things that an instruction speaks of so far and what is said of them; finds what words refer
// to. Indices are those of plan().features.
class Discourse {
 public:
  Discourse(std::string_view instruction, Vocabulary vocabulary);

  // A new feature for the phrase; -1, with a warning, where the vocabulary has no class for it or
  // the layout no more room.
  int Create(const NounPhrase& phrase, std::size_t begin, std::size_t end);
  // The features that a phrase points back to: "the lake", "both villages", "the former"; empty:
  // none.
  std::vector<int> Find(const NounPhrase& phrase, const std::vector<int>& subjects) const;
  // What "it" means while `subjects` are spoken of; empty: nothing was named.
  std::vector<int> Antecedent(const std::vector<int>& subjects, bool many) const;
  // What was named last; -1: nothing.
  int LastMentioned() const { return mentioned_.empty() ? -1 : mentioned_.back(); }
  // The last two things named that are not among `subjects`.
  std::vector<int> LastTwo(const std::vector<int>& subjects) const;
  // Some pieces of a feature, fewer than it has, as one of their own, for "one in the north, the
  // other in the south".
  int SplitOff(int index, int pieces = 1);
  // The same thing once more, to lie elsewhere: "fields to the north and to the south".
  int Twin(int index);
  // A feature of the letter of `word`, the latest first; -1: none.
  int Latest(char letter, FeatureForm form) const;

  // A clause speaks of these: the next "it" may mean them.
  void SetTopic(const std::vector<int>& subjects);
  void Mention(int index) { mentioned_.push_back(index); }
  void NextSentence() { ++sentence_; }
  int sentence() const { return sentence_; }

  void Describe(const Qualities& said, int index);
  void AddZones(int index, const std::vector<Zone>& zones);
  void Extend(int index, std::size_t end);  // its words reach to here
  void Relate(PlannedRelation relation);    // without words: from the one to the other
  void Drop(int index);
  void Deny(PlannedAbsence absence);
  void TakeBackDenial();                     // the last one
  void AllIsSaid() { all_is_said_ = true; }  // "nothing else"

  PlannedFeature& feature(int index) { return plan_.features[static_cast<std::size_t>(index)]; }
  const PlannedFeature& feature(int index) const {
    return plan_.features[static_cast<std::size_t>(index)];
  }
  Thing& thing(int index) { return things_[static_cast<std::size_t>(index)]; }
  const Thing& thing(int index) const { return things_[static_cast<std::size_t>(index)]; }
  int size() const { return static_cast<int>(things_.size()); }
  LayoutPlan& plan() { return plan_; }
  std::string Words(std::size_t begin, std::size_t end) const {
    return end > begin ? std::string(instruction_.substr(begin, end - begin)) : std::string();
  }
  std::string_view instruction() const { return instruction_; }

  // The plan with the words of all things; without what was dropped.
  LayoutPlan Finish();

 private:
  // Whether the vocabulary has a class for the phrase and the layout room for it; warns where it is
  // not so, and where the class is no more than the nearest.
  bool MayCreate(const NounPhrase& phrase, const std::string& words);
  // "grid city": its streets are a grid, not the city.
  void LayStreets(int city, std::size_t begin, std::size_t end);
  void WidenMiddles();
  void WidenQuarters();
  void SettleDenials();
  void SettleIslands();
  int SupposeWaterAround(int island);
  bool WidenRiverAround(int island);
  void SettleRest();
  void SettleCrossroads();
  void SettleChains();
  void SettleAlong();
  void SettleFollowing();
  void SettleApproaches();
  void PlaceContained();
  void SettleOpenEnds();
  bool Matches(const NounPhrase& phrase, int index) const;

  static constexpr std::size_t kMaxFeatures = 32;  // more than anybody can lay out on one map

  std::string_view instruction_;
  LayoutPlan plan_;
  std::vector<Thing> things_;
  std::vector<std::vector<int>> topics_;
  std::vector<int> mentioned_;
  std::vector<int> named_before_denial_;  // by absence: how many features
  int sentence_ = 0;
  bool full_ = false;
  bool all_is_said_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_DISCOURSE_H_
