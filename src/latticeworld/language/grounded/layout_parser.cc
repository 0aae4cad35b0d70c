#include "latticeworld/language/grounded/layout_parser.h"

#include <utility>

#include "latticeworld/language/grounded/course_reader.h"
#include "latticeworld/language/grounded/mention.h"
#include "latticeworld/language/grounded/noun_reader.h"
#include "latticeworld/language/grounded/place_reader.h"
#include "latticeworld/language/grounded/quality_reader.h"
#include "latticeworld/language/grounded/reading_state.h"
#include "latticeworld/language/grounded/tie_reader.h"

namespace latticeworld {
namespace {

constexpr double kWindingMeander = 2.2;
constexpr double kStraightMeander = 0.15;

// Leads the readers through an instruction, item by item and clause by clause.
class LayoutParser {
 public:
  LayoutParser(std::string_view instruction, Vocabulary vocabulary)
      : state_(instruction, vocabulary) {}

  LayoutReading Parse() {
    for (; !cursor_.AtEnd(); cursor_.Advance()) {
      const LayoutItem& item = cursor_.Item();
      ReadItem(item);
      const bool is_function =
          item.kind == LayoutItemKind::kWord && item.word == LayoutWord::kFunction;
      if (item.kind != LayoutItemKind::kUnknown && !is_function) state_.unknown.Close();
    }
    EndSentence();
    state_.unknown.AppendTo(&state_.reading.warnings);
    return std::move(state_.reading);
  }

 private:
  using Role = CourseReader::Role;

  void ReadItem(const LayoutItem& item) {
    switch (item.kind) {
      case LayoutItemKind::kNoun:
        ReadNoun(item);
        break;
      case LayoutItemKind::kPlace:
        ReadPlace(item);
        break;
      case LayoutItemKind::kNumber:
        qualities_.Modify()->number = item.number;
        break;
      case LayoutItemKind::kWord:
        ReadWord(item);
        break;
      case LayoutItemKind::kComma:
        ReadComma();
        break;
      case LayoutItemKind::kStop:
        EndSentence();
        break;
      case LayoutItemKind::kUnknown:
        state_.AddUnknown(item);
        break;
    }
  }

  void ReadNoun(const LayoutItem& item) {
    const Modifiers said = qualities_.Take();
    state_.clause_has_noun = true;
    state_.sentence_has_noun = true;
    state_.lead_used = true;
    const NounReader::Found found =
        nouns_.Read(item, said, ties_.is_open() || courses_.is_expecting());
    state_.last = found.index;
    if (found.index < 0) return;
    if (found.is_new) PlaceNew(found.index);
    ties_.Complete(found.index, found.begin, found.end);
    courses_.Complete(found.index);
    const Mention& mention = *state_.mention(found.index);
    if (mention.is_line() && !mention.negated) state_.line = found.index;
    negating_ = said.negated;
  }

  void PlaceNew(int index) {
    Mention* added = state_.mention(index);
    if (added->is_line()) courses_.TakePendingEnds(added);
    if (ties_.is_open()) return;
    if (!added->is_rest) places_.ApplyLead(added);
    state_.group.push_back(index);
  }

  void ReadPlace(const LayoutItem& item) {
    if (item.relative) {
      BeginTie();
      ties_.BeginHeading(HeadingOf(item.places.front().main));
      return;
    }
    ties_.DropNextTo();
    switch (courses_.ReadPlace(item)) {
      case CourseReader::Use::kTaken:
        return;
      case CourseReader::Use::kOfLast:
        places_.Attach(item);
        return;
      case CourseReader::Use::kNone:
        places_.Read(item);
        return;
    }
  }

  // What a tie cuts off.
  void BeginTie() {
    courses_.Expect(Role::kNone);
    qualities_.Forget();
  }

  void ReadWord(const LayoutItem& item) {
    switch (item.word) {
      case LayoutWord::kNone:
        break;
      case LayoutWord::kFunction:
        if (cursor_.FirstWord(item) == "the" || cursor_.FirstWord(item) == "this") {
          qualities_.MakeDefinite();
        }
        break;
      case LayoutWord::kAnd:
        ReadAnd(item);
        break;
      case LayoutWord::kBreak:
        BreakClause();
        break;
      case LayoutWord::kMostly:
        qualities_.SetAmount(Amount::kMost);
        break;
      case LayoutWord::kCovers:
        qualities_.ReadCovers();
        break;
      case LayoutWord::kMore:
        qualities_.SetAmount(Amount::kMuch);
        break;
      case LayoutWord::kLess:
        qualities_.SetAmount(Amount::kLittle);
        break;
      case LayoutWord::kFew:
        qualities_.Modify()->few = true;
        break;
      case LayoutWord::kMany:
        qualities_.Modify()->many = true;
        break;
      case LayoutWord::kSeveral:
        qualities_.Modify()->several = true;
        break;
      case LayoutWord::kScattered:
        qualities_.SetTexture(Texture::kScattered);
        break;
      case LayoutWord::kClustered:
        qualities_.SetTexture(Texture::kClustered);
        break;
      case LayoutWord::kNo:
        qualities_.Modify()->negated = true;
        break;
      case LayoutWord::kTreeless:
        nouns_.AddAbsent("forest", item);
        break;
      case LayoutWord::kRoadless:
        nouns_.AddAbsent("road", item);
        break;
      case LayoutWord::kWaterless:
        nouns_.AddAbsent("water", item);
        break;
      case LayoutWord::kUninhabited:
        nouns_.AddAbsent("building", item);
        break;
      case LayoutWord::kRest:
        qualities_.ReadRest();
        break;
      case LayoutWord::kMoreThan:
      case LayoutWord::kLessThan:
        ReadComparison(item.word == LayoutWord::kMoreThan);
        break;
      case LayoutWord::kNextTo:
      case LayoutWord::kSurroundedBy:
      case LayoutWord::kSurrounds:
        BeginTie();
        ties_.Begin(item.word == LayoutWord::kNextTo ? TieKind::kNextTo : TieKind::kSurrounds,
                    /*passive=*/item.word == LayoutWord::kSurroundedBy);
        break;
      case LayoutWord::kBetween:
        ties_.BeginBetween();
        courses_.Expect(Role::kNone);
        break;
      case LayoutWord::kRuns:
        courses_.BeginRun();
        break;
      case LayoutWord::kFrom:
        courses_.Expect(Role::kFrom);
        break;
      case LayoutWord::kTo:
        courses_.Expect(Role::kTo);
        break;
      case LayoutWord::kThrough:
        courses_.Expect(Role::kThrough);
        break;
      case LayoutWord::kConnects:
        courses_.BeginConnection();
        break;
      case LayoutWord::kConnectedBy:
        courses_.BeginConnectedBy();
        BreakClause();
        break;
      case LayoutWord::kWinds:
        courses_.BeginRun();
        if (state_.line >= 0) state_.mention(state_.line)->meander = kWindingMeander;
        break;
      case LayoutWord::kWinding:
        qualities_.SetMeander(kWindingMeander);
        break;
      case LayoutWord::kStraight:
        qualities_.SetMeander(kStraightMeander);
        break;
      case LayoutWord::kHorizontal:
        courses_.SetEnds(Region::kMiddleLeft, Region::kMiddleRight);
        break;
      case LayoutWord::kVertical:
        courses_.SetEnds(Region::kUpper, Region::kLower);
        break;
      case LayoutWord::kDiagonal:
        courses_.SetEnds(Region::kUpperLeft, Region::kLowerRight);
        break;
      case LayoutWord::kEverywhere:
        qualities_.ReadEverywhere();
        break;
      case LayoutWord::kHeights:
        state_.AddUnknown(item);
        break;
    }
  }

  void ReadComparison(bool more) {
    if (cursor_.ThanAhead()) {
      ties_.BeginComparison(more);
    } else {
      qualities_.SetAmount(more ? Amount::kMuch : Amount::kLittle);
    }
  }

  void ReadAnd(const LayoutItem& item) {
    courses_.Expect(Role::kNone);
    state_.clause_has_noun = false;
    state_.group_has_and = !state_.group.empty();
    if (negating_ && (cursor_.NextIsNoun() || cursor_.FirstWord(item) == "or")) {
      qualities_.Modify()->negated = true;
    }
  }

  void ReadComma() {
    if (negating_ && cursor_.ListGoesOn()) {
      qualities_.Modify()->negated = true;
      return;
    }
    EndPhrase();
  }

  void EndPhrase() {
    negating_ = false;
    state_.clause_has_noun = false;
    courses_.EndPhrase();
    ties_.EndClause();
  }

  void BreakClause() {
    EndPhrase();
    state_.group.clear();
    state_.group_has_and = false;
    courses_.EndClause();
    qualities_.Forget();
  }

  void EndSentence() {
    BreakClause();
    ties_.EndSentence();
    courses_.EndSentence();
    state_.lead.clear();
    state_.last = -1;
    state_.line = -1;
    state_.sentence_has_noun = false;
    state_.unknown.Close();
  }

  ReadingState state_;
  ItemCursor& cursor_ = state_.cursor;
  QualityReader qualities_{&state_};
  NounReader nouns_{&state_};
  PlaceReader places_{&state_};
  CourseReader courses_{&state_};
  TieReader ties_{&state_};
  bool negating_ = false;  // "no forest, ..." goes on denying
};

}  // namespace

LayoutPlan ParseLayoutInstruction(std::string_view instruction, Vocabulary vocabulary) {
  return PlanFromReading(LayoutParser(instruction, vocabulary).Parse(), instruction, vocabulary);
}

}  // namespace latticeworld
