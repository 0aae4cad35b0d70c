#include "latticeworld/language/grounded/layout_parser.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/layout_lexer.h"
#include "latticeworld/language/grounded/mention.h"
#include "latticeworld/language/grounded/not_understood.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

// What was said before the noun that it belongs to.
struct Modifiers {
  Amount amount = Amount::kUnsaid;
  Texture texture = Texture::kUnsaid;
  int number = 0;
  bool few = false;
  bool several = false;
  bool many = false;
  double meander = 1.0;
  bool negated = false;
  bool is_rest = false;
  bool definite = false;
  int first_item = -1;
};

constexpr double kWindingMeander = 2.2;

enum class Expect { kNothing, kFrom, kTo, kThrough };

class LayoutParser {
 public:
  LayoutParser(std::string_view instruction, Vocabulary vocabulary)
      : instruction_(instruction),
        vocabulary_(vocabulary),
        tokens_(Tokenize(instruction)),
        items_(LexLayout(tokens_)),
        unknown_(instruction) {}

  LayoutReading Parse() {
    while (at_ < items_.size()) {
      const LayoutItem& item = items_[at_];
      switch (item.kind) {
        case LayoutItemKind::kNoun:
          ReadNoun(item);
          break;
        case LayoutItemKind::kPlace:
          ReadPlace(item);
          break;
        case LayoutItemKind::kNumber:
          Modify()->number = item.number;
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
          unknown_.Add(tokens_[item.first].begin, tokens_[item.first].end);
          break;
      }
      if (item.kind != LayoutItemKind::kUnknown && !IsFunction(item)) unknown_.Close();
      ++at_;
    }
    EndSentence();
    unknown_.AppendTo(&reading_.warnings);
    return std::move(reading_);
  }

 private:
  static bool IsFunction(const LayoutItem& item) {
    return item.kind == LayoutItemKind::kWord && item.word == LayoutWord::kFunction;
  }
  bool IsWord(std::size_t at, LayoutWord word) const {
    return at < items_.size() && items_[at].kind == LayoutItemKind::kWord &&
           items_[at].word == word;
  }

  Mention* mention(int index) { return &reading_.mentions[static_cast<std::size_t>(index)]; }

  Modifiers* Modify() {
    if (modifiers_.first_item < 0) modifiers_.first_item = static_cast<int>(at_);
    return &modifiers_;
  }

  // Whether a noun comes before the clause ends or anything else that could own the words here.
  bool NounAhead() const {
    for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
      const LayoutItem& item = items_[i];
      if (item.kind == LayoutItemKind::kNoun) return true;
      if (item.kind == LayoutItemKind::kNumber || item.kind == LayoutItemKind::kUnknown) continue;
      if (item.kind != LayoutItemKind::kWord) return false;
      switch (item.word) {
        case LayoutWord::kFunction:
        case LayoutWord::kMostly:
        case LayoutWord::kCovers:
        case LayoutWord::kMore:
        case LayoutWord::kLess:
        case LayoutWord::kFew:
        case LayoutWord::kMany:
        case LayoutWord::kSeveral:
        case LayoutWord::kScattered:
        case LayoutWord::kClustered:
        case LayoutWord::kWinding:
        case LayoutWord::kStraight:
        case LayoutWord::kHeights:
          continue;
        default:
          return false;
      }
    }
    return false;
  }

  // ---- words ----

  void ReadWord(const LayoutItem& item) {
    switch (item.word) {
      case LayoutWord::kNone:
        break;
      case LayoutWord::kFunction:
        if (tokens_[item.first].text == "the" || tokens_[item.first].text == "this") {
          modifiers_.definite = true;
        }
        break;
      case LayoutWord::kAnd:
        ReadAnd(item);
        break;
      case LayoutWord::kBreak:
        BreakClause();
        break;
      case LayoutWord::kMostly:
        SetAmount(Amount::kMost);
        break;
      case LayoutWord::kCovers:
        ReadCovers();
        break;
      case LayoutWord::kMore:
        SetAmount(Amount::kMuch);
        break;
      case LayoutWord::kLess:
        SetAmount(Amount::kLittle);
        break;
      case LayoutWord::kFew:
        Modify()->few = true;
        break;
      case LayoutWord::kMany:
        Modify()->many = true;
        break;
      case LayoutWord::kSeveral:
        Modify()->several = true;
        break;
      case LayoutWord::kScattered:
        SetTexture(Texture::kScattered);
        break;
      case LayoutWord::kClustered:
        SetTexture(Texture::kClustered);
        break;
      case LayoutWord::kNo:
        Modify()->negated = true;
        break;
      case LayoutWord::kTreeless:
        AddAbsent("forest", item);
        break;
      case LayoutWord::kRoadless:
        AddAbsent("road", item);
        break;
      case LayoutWord::kWaterless:
        AddAbsent("water", item);
        break;
      case LayoutWord::kUninhabited:
        AddAbsent("building", item);
        break;
      case LayoutWord::kRest:
        ReadRest();
        break;
      case LayoutWord::kMoreThan:
      case LayoutWord::kLessThan:
        ReadMoreThan(item.word == LayoutWord::kMoreThan);
        break;
      case LayoutWord::kNextTo:
        BeginTie(TieKind::kNextTo, false);
        break;
      case LayoutWord::kSurroundedBy:
        BeginTie(TieKind::kSurrounds, true);
        break;
      case LayoutWord::kSurrounds:
        BeginTie(TieKind::kSurrounds, false);
        break;
      case LayoutWord::kBetween:
        ReadBetween();
        break;
      case LayoutWord::kRuns:
        ReadRuns();
        break;
      case LayoutWord::kFrom:
        expect_ = Expect::kFrom;
        break;
      case LayoutWord::kTo:
        expect_ = Expect::kTo;
        break;
      case LayoutWord::kThrough:
        expect_ = Expect::kThrough;
        break;
      case LayoutWord::kConnects:
        connecting_ = true;
        expect_ = Expect::kFrom;
        break;
      case LayoutWord::kConnectedBy:
        connected_ = last_;
        BreakClause();
        break;
      case LayoutWord::kWinds:
        ReadRuns();
        if (line_ >= 0) mention(line_)->meander = kWindingMeander;
        break;
      case LayoutWord::kWinding:
        SetMeander(kWindingMeander);
        break;
      case LayoutWord::kStraight:
        SetMeander(0.15);
        break;
      case LayoutWord::kHorizontal:
        SetEnds(Region::kMiddleLeft, Region::kMiddleRight);
        break;
      case LayoutWord::kVertical:
        SetEnds(Region::kUpper, Region::kLower);
        break;
      case LayoutWord::kDiagonal:
        SetEnds(Region::kUpperLeft, Region::kLowerRight);
        break;
      case LayoutWord::kEverywhere:
        ReadEverywhere();
        break;
      case LayoutWord::kHeights:
        unknown_.Add(tokens_[item.first].begin, tokens_[item.last - 1].end);
        unknown_.Close();
        break;
    }
  }

  void SetAmount(Amount amount) {
    if (NounAhead()) {
      Modify()->amount = amount;
    } else if (last_ >= 0 && !(amount == Amount::kMost && PlaceIsNext())) {
      mention(last_)->amount = amount;
      Extend(last_);
    }
  }

  void ReadAnd(const LayoutItem& item) {
    expect_ = Expect::kNothing;
    clause_has_noun_ = false;
    group_has_and_ = !group_.empty();
    const bool noun_next = at_ + 1 < items_.size() && items_[at_ + 1].kind == LayoutItemKind::kNoun;
    if (negating_ && (noun_next || tokens_[item.first].text == "or")) Modify()->negated = true;
  }

  // "forest covers the north", "the north is covered with forest"; of a map without a place this
  // says no more than that it is there.
  void ReadCovers() {
    if (last_ >= 0 && clause_has_noun_ && PlaceIsNext()) {
      mention(last_)->amount = Amount::kMost;
    } else if (!lead_.empty() && !lead_used_ && NounAhead()) {
      Modify()->amount = Amount::kMost;
    }
  }

  bool PlaceIsNext() const {
    std::size_t i = at_ + 1;
    while (i < items_.size() && IsFunction(items_[i])) ++i;
    return i < items_.size() && items_[i].kind == LayoutItemKind::kPlace;
  }

  void SetTexture(Texture texture) {
    if (NounAhead() && !(clause_has_noun_ && SpreadOver())) {
      Modify()->texture = texture;
    } else if (last_ >= 0) {
      mention(last_)->texture = texture;
      Extend(last_);
    }
  }

  // "ponds scattered across a meadow": said of the ponds, not of the meadow.
  bool SpreadOver() const {
    const LayoutItem& item = items_[at_];
    for (const std::size_t i : {item.last - 1, item.last}) {
      if (i >= tokens_.size()) continue;
      for (const std::string_view word : {"across", "over", "around", "about", "in", "on", "along",
                                          "among", "throughout", "through", "within"}) {
        if (tokens_[i].text == word) return true;
      }
    }
    return false;
  }

  void SetMeander(double meander) {
    if (NounAhead() || line_ < 0) {
      Modify()->meander = meander;
    } else {
      mention(line_)->meander = meander;
    }
  }

  void SetEnds(Region from, Region to) {
    if (line_ >= 0 && !NounAhead()) {
      mention(line_)->from = from;
      mention(line_)->to = to;
      Extend(line_);
    } else {
      pending_from_ = from;
      pending_to_ = to;
    }
  }

  void ReadEverywhere() {
    // Of a course it says no more than that it crosses the map.
    if (last_ < 0 || mention(last_)->is_line()) return;
    Mention* said = mention(last_);
    if (said->negated) return;
    if (said->texture == Texture::kUnsaid && said->noun->shape == WordShape::kMass) {
      said->amount = Amount::kMost;
    } else if (said->noun->shape == WordShape::kThing) {
      said->texture = Texture::kScattered;
    }
    Extend(last_);
  }

  void ReadRest() {
    if (RestNounAhead()) {
      Modify()->is_rest = true;
    } else if (last_ >= 0) {
      mention(last_)->is_rest = true;
      Extend(last_);
    }
  }

  // "the rest of the map is covered with grass": nothing but small words before the noun.
  bool RestNounAhead() const {
    for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
      const LayoutItem& item = items_[i];
      if (item.kind == LayoutItemKind::kNoun) return true;
      if (item.kind == LayoutItemKind::kStop || item.kind == LayoutItemKind::kPlace ||
          IsWord(i, LayoutWord::kAnd) ||
          (IsWord(i, LayoutWord::kBreak) && tokens_[item.first].text != "with")) {
        return false;
      }
    }
    return false;
  }

  void ReadMoreThan(bool more) {
    for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
      if (items_[i].kind == LayoutItemKind::kStop) break;
      if (tokens_[items_[i].first].text != "than") continue;
      comparing_ = more ? 1 : -1;
      return;
    }
    SetAmount(more ? Amount::kMuch : Amount::kLittle);
  }

  void AddAbsent(std::string_view phrase, const LayoutItem& item) {
    const std::vector<Token> word = Tokenize(phrase);
    const ClassWord* noun = MatchClassWord(word, 0).word;
    if (noun == nullptr || noun->LetterIn(vocabulary_) == '\0') return;
    Mention absent;
    absent.noun = noun;
    absent.letter = noun->LetterIn(vocabulary_);
    absent.negated = true;
    absent.places = lead_;
    absent.begin = tokens_[item.first].begin;
    absent.end = tokens_[item.last - 1].end;
    reading_.mentions.push_back(std::move(absent));
  }

  // ---- nouns ----

  void ReadNoun(const LayoutItem& item) {
    const Modifiers said = std::exchange(modifiers_, Modifiers());
    const std::size_t first =
        said.first_item >= 0 ? items_[static_cast<std::size_t>(said.first_item)].first : item.first;
    const std::size_t begin = tokens_[first].begin;
    const std::size_t end = tokens_[item.last - 1].end;
    const char letter = item.noun->LetterIn(vocabulary_);
    clause_has_noun_ = true;
    sentence_has_noun_ = true;
    lead_used_ = true;
    if (letter == '\0') {
      reading_.warnings.push_back("the " + std::string(NameOf(vocabulary_)) +
                                  " vocabulary has nothing like " + QuoteOf(begin, end) +
                                  "; it is not placed");
      last_ = -1;
      return;
    }
    int index = said.negated ? -1 : Known(item, letter, said);
    if (index < 0) {
      index = AddMention(item, letter, said, begin, end);
    } else if (said.amount != Amount::kUnsaid) {
      mention(index)->amount = said.amount;
    }
    CompleteTie(index, begin, end);
    CompleteComparison(index);
    CompleteConnection(index);
    CompleteCourse(index);
    last_ = index;
    if (mention(index)->is_line() && !mention(index)->negated) line_ = index;
    negating_ = said.negated;
  }

  // The mention that the noun points back to: "the forest", or the other end of a tie.
  int Known(const LayoutItem& item, char letter, const Modifiers& said) const {
    const bool points_back = said.definite || tie_open_ || expect_ != Expect::kNothing;
    if (!points_back || said.number > 0 || said.is_rest) return -1;
    for (std::size_t i = reading_.mentions.size(); i-- > 0;) {
      const Mention& known = reading_.mentions[i];
      if (!known.negated && known.letter == letter &&
          known.is_line() == (item.noun->shape == WordShape::kLine)) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  int AddMention(const LayoutItem& item, char letter, const Modifiers& said, std::size_t begin,
                 std::size_t end) {
    Mention added;
    added.letter = letter;
    added.noun = item.noun;
    added.plural = item.plural;
    added.negated = said.negated;
    added.is_rest = said.is_rest;
    added.amount = said.amount;
    added.texture = said.texture;
    added.number = said.number;
    added.meander = said.meander;
    added.begin = begin;
    added.end = end;
    ApplyVagueNumber(said, &added);
    if (added.is_line() &&
        (pending_from_ != Region::kAnywhere || pending_to_ != Region::kAnywhere)) {
      added.from = std::exchange(pending_from_, Region::kAnywhere);
      added.to = std::exchange(pending_to_, Region::kAnywhere);
    }
    if (!lead_.empty() && !added.is_rest && !tie_open_) {
      added.places = lead_;
      added.place_from_lead = true;
      added.begin = std::min(added.begin, lead_begin_);
    }
    if (!item.noun->IsExactIn(vocabulary_) && !added.negated) {
      reading_.warnings.push_back(
          QuoteOf(begin, end) + " is laid as " + std::string(FindClass(vocabulary_, letter)->name) +
          ", the nearest class of the " + std::string(NameOf(vocabulary_)) + " vocabulary");
    }
    reading_.mentions.push_back(std::move(added));
    const int index = static_cast<int>(reading_.mentions.size()) - 1;
    if (!tie_open_) group_.push_back(index);
    return index;
  }

  static void ApplyVagueNumber(const Modifiers& said, Mention* added) {
    const bool mass = added->noun->shape == WordShape::kMass;
    const bool line = added->is_line();
    if (said.few) {
      if (mass) {
        added->amount = Amount::kLittle;
      } else {
        added->number = line ? 2 : 3;
      }
    }
    if (said.several && !mass) added->number = line ? 3 : 4;
    if (said.many) {
      if (mass) {
        added->amount = Amount::kMuch;
      } else {
        added->number = line ? 4 : 8;
      }
    }
    if (line) added->wide = said.amount == Amount::kMuch;
  }

  // ---- places ----

  void ReadPlace(const LayoutItem& item) {
    if (item.relative) {
      BeginTie(TieKind::kHeading, false);
      tie_.heading = HeadingOf(item.places.front().main);
      expect_ = Expect::kNothing;
      return;
    }
    // "near the center" is a place, not a tie.
    if (tie_open_ && tie_.kind == TieKind::kNextTo) tie_open_ = false;
    if (ReadCourseEnd(item)) return;
    if (!clause_has_noun_ && NounFollowsPlace()) {
      const bool more =
          at_ > 0 && IsWord(at_ - 1, LayoutWord::kAnd) && !lead_.empty() && !lead_used_;
      if (!more) lead_.clear();
      if (!more) lead_begin_ = tokens_[item.first].begin;
      lead_.insert(lead_.end(), item.places.begin(), item.places.end());
      lead_used_ = false;
      group_.clear();
      return;
    }
    AttachPlace(item);
  }

  // A place right before a noun leads its clause: "in the north lies a forest".
  bool NounFollowsPlace() const {
    for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
      const LayoutItem& item = items_[i];
      if (item.kind == LayoutItemKind::kNoun) return true;
      if (item.kind == LayoutItemKind::kStop) return false;
      if (item.kind == LayoutItemKind::kComma) {
        // "in the north, a forest" leads; "forest in the north, farmland ..." has had its noun.
        if (last_ >= 0 && sentence_has_noun_) return false;
        continue;
      }
      if (item.kind == LayoutItemKind::kPlace && !IsWord(i - 1, LayoutWord::kAnd)) return false;
      if (IsWord(i, LayoutWord::kAnd) && sentence_has_noun_) return false;
    }
    return false;
  }

  void AttachPlace(const LayoutItem& item) {
    std::vector<int> owners;
    if (!lead_.empty() && last_ >= 0) {
      owners = {last_};
    } else if (!group_.empty()) {
      // "a forest and a lake in the north" shares the place; "a lake, a village in the center" not.
      for (const int index : group_) {
        if (group_has_and_ || index == group_.back()) owners.push_back(index);
      }
    } else if (last_ >= 0) {
      owners = {last_};
    }
    if (owners.empty()) {
      unknown_.Add(tokens_[item.first].begin, tokens_[item.last - 1].end);
      unknown_.Close();
      return;
    }
    for (const int owner : owners) {
      Mention* placed = mention(owner);
      if (placed->is_line() && placed->has_course()) {
        for (const Place& place : item.places) placed->through.push_back(place.main);
      } else {
        if (placed->place_from_lead) placed->places.clear();
        placed->place_from_lead = false;
        placed->places.insert(placed->places.end(), item.places.begin(), item.places.end());
      }
      placed->end = std::max(placed->end, tokens_[item.last - 1].end);
    }
    group_.clear();
    group_has_and_ = false;
  }

  // ---- courses ----

  void ReadRuns() {
    if (line_ < 0 && last_ >= 0 && mention(last_)->is_line()) line_ = last_;
    running_ = true;
    std::size_t next = at_ + 1;
    while (next < items_.size() && IsFunction(items_[next])) ++next;
    // "crosses the forest", "follows the river"
    if (next < items_.size() && items_[next].kind == LayoutItemKind::kNoun) {
      expect_ = Expect::kThrough;
    }
  }

  // A place that is an end of a course or a stop on its way.
  bool ReadCourseEnd(const LayoutItem& item) {
    const bool to_follows = IsWord(at_ + 1, LayoutWord::kTo);
    const bool starts_pair = expect_ == Expect::kNothing && running_ && to_follows;
    if (expect_ == Expect::kNothing && !starts_pair) return false;
    Expect role = starts_pair ? Expect::kFrom : expect_;
    expect_ = Expect::kNothing;
    const Region main = item.places.front().main;
    const int owner = line_ >= 0 ? line_ : -1;
    if (owner < 0) {
      if (last_ >= 0 && role != Expect::kThrough) {
        // "forest stretches from the north to the south": it covers both ends.
        expect_ = Expect::kNothing;
        AttachPlace(item);
        return true;
      }
      if (role == Expect::kFrom) pending_from_ = main;
      if (role == Expect::kTo) pending_to_ = main;
      return role != Expect::kThrough;
    }
    Mention* line = mention(owner);
    if (role == Expect::kFrom) {
      line->from = main;
    } else if (role == Expect::kTo) {
      line->to = main;
    } else {
      line->through.push_back(main);
    }
    if (connecting_ && role == Expect::kFrom) AwaitOtherEnd();
    Extend(owner);
    group_.erase(std::remove(group_.begin(), group_.end(), owner), group_.end());
    return true;
  }

  // "two villages, one in the north and one in the south, connected by a road"; "a lake and a
  // village connected by a road".
  void CompleteConnection(int index) {
    const int subject = std::exchange(connected_, -1);
    if (subject < 0 || !mention(index)->is_line() || mention(index)->negated) return;
    Mention* line = mention(index);
    const std::vector<Place>& ends = mention(subject)->places;
    if (ends.size() >= 2) {
      line->from = ends.front().main;
      line->to = ends.back().main;
    } else if (subject > 0) {
      line->from_mention = subject - 1;
      line->to_mention = subject;
    }
  }

  // "connects the lake and the village": the word between the ends does not part them.
  void AwaitOtherEnd() {
    connecting_ = false;
    expect_ = Expect::kTo;
    if (IsWord(at_ + 1, LayoutWord::kAnd) || IsWord(at_ + 1, LayoutWord::kBreak)) ++at_;
  }

  // A noun at the end of a course: "leads to the village", "through the forest".
  void CompleteCourse(int index) {
    const Expect role = std::exchange(expect_, Expect::kNothing);
    if (role == Expect::kNothing || line_ < 0 || line_ == index) return;
    Mention* line = mention(line_);
    if (role == Expect::kFrom) line->from_mention = index;
    if (role == Expect::kTo) line->to_mention = index;
    if (connecting_) AwaitOtherEnd();
    if (mention(index)->letter != line->letter) {
      reading_.ties.push_back({TieKind::kNextTo,
                               line_,
                               index,
                               {},
                               line->begin,
                               std::max(line->end, mention(index)->end)});
    }
  }

  // ---- ties ----

  void BeginTie(TieKind kind, bool passive) {
    tie_ = Tie();
    tie_.kind = kind;
    tie_passive_ = passive;
    tie_.subject = last_;
    tie_open_ = true;
    tie_.begin = last_ >= 0 ? mention(last_)->begin : tokens_[items_[at_].first].begin;
    expect_ = Expect::kNothing;
    modifiers_ = Modifiers();
  }

  void CompleteTie(int index, std::size_t begin, std::size_t end) {
    if (between_ > 0 && between_subject_ >= 0 && between_subject_ != index) {
      reading_.ties.push_back(
          {TieKind::kNextTo, between_subject_, index, {}, mention(between_subject_)->begin, end});
      --between_;
    }
    if (!tie_open_ || tie_.subject == index) return;
    if (tie_.subject < 0) {
      // "Next to the lake lies a village": the object came first.
      if (tie_object_first_ < 0) {
        tie_object_first_ = index;
        return;
      }
      tie_.subject = index;
      tie_.object = std::exchange(tie_object_first_, -1);
    } else {
      tie_.object = index;
    }
    tie_open_ = false;
    if (mention(tie_.subject)->negated || mention(tie_.object)->negated) return;
    if (tie_passive_) std::swap(tie_.subject, tie_.object);
    tie_.begin = std::min(tie_.begin, begin);
    tie_.end = end;
    reading_.ties.push_back(tie_);
  }

  void ReadBetween() {
    between_subject_ = line_ >= 0 ? line_ : last_;
    between_ = 2;
    expect_ = Expect::kNothing;
    group_.clear();
  }

  void CompleteComparison(int index) {
    if (comparing_ == 0) return;
    if (compared_ < 0) {
      compared_ = index;
      return;
    }
    Tie tie;
    tie.kind = TieKind::kMoreThan;
    tie.subject = comparing_ > 0 ? compared_ : index;
    tie.object = comparing_ > 0 ? index : compared_;
    tie.begin = mention(compared_)->begin;
    tie.end = mention(index)->end;
    reading_.ties.push_back(tie);
    comparing_ = 0;
    compared_ = -1;
  }

  // ---- clauses ----

  void ReadComma() {
    // "without roads, buildings or water" goes on denying.
    if (negating_ && at_ + 2 < items_.size() && items_[at_ + 1].kind == LayoutItemKind::kNoun &&
        (IsWord(at_ + 2, LayoutWord::kAnd) || items_[at_ + 2].kind == LayoutItemKind::kComma)) {
      Modify()->negated = true;
      return;
    }
    negating_ = false;
    expect_ = Expect::kNothing;
    clause_has_noun_ = false;
    running_ = false;
    tie_open_ = tie_open_ && tie_.subject < 0;
  }

  void BreakClause() {
    negating_ = false;
    ReadComma();
    group_.clear();
    group_has_and_ = false;
    connecting_ = false;
    modifiers_ = Modifiers();
  }

  void EndSentence() {
    BreakClause();
    lead_.clear();
    tie_open_ = false;
    tie_object_first_ = -1;
    between_ = 0;
    connected_ = -1;
    comparing_ = 0;
    compared_ = -1;
    last_ = -1;
    line_ = -1;
    sentence_has_noun_ = false;
    pending_from_ = pending_to_ = Region::kAnywhere;
    unknown_.Close();
  }

  void Extend(int index) {
    mention(index)->end = std::max(mention(index)->end, tokens_[items_[at_].last - 1].end);
  }

  std::string QuoteOf(std::size_t begin, std::size_t end) const {
    return Quote(instruction_.substr(begin, end - begin));
  }

  std::string_view instruction_;
  Vocabulary vocabulary_;
  std::vector<Token> tokens_;
  std::vector<LayoutItem> items_;
  NotUnderstood unknown_;
  LayoutReading reading_;
  std::size_t at_ = 0;

  Modifiers modifiers_;
  bool negating_ = false;
  int last_ = -1;           // the mention that words after it belong to
  int line_ = -1;           // the line that a course belongs to
  std::vector<int> group_;  // mentions that share the place that comes
  bool group_has_and_ = false;
  std::vector<Place> lead_;  // "In the north there is ..."
  std::size_t lead_begin_ = 0;
  bool lead_used_ = false;
  bool clause_has_noun_ = false;
  bool sentence_has_noun_ = false;
  Expect expect_ = Expect::kNothing;
  bool running_ = false;
  bool connecting_ = false;
  Region pending_from_ = Region::kAnywhere;  // said before the line was named
  Region pending_to_ = Region::kAnywhere;
  Tie tie_;
  bool tie_open_ = false;
  bool tie_passive_ = false;
  int tie_object_first_ = -1;
  int between_ = 0;  // objects still to come
  int between_subject_ = -1;
  int connected_ = -1;  // what a line that comes connects
  int comparing_ = 0;   // 1 more, -1 less
  int compared_ = -1;
};

}  // namespace

LayoutPlan ParseLayoutInstruction(std::string_view instruction, Vocabulary vocabulary) {
  return PlanFromReading(LayoutParser(instruction, vocabulary).Parse(), instruction, vocabulary);
}

}  // namespace latticeworld
