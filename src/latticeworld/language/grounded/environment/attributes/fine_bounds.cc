#include "latticeworld/language/grounded/environment/attributes/fine_bounds.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <string>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

enum class Side { kNone, kLeast, kMost };

// A phrase that makes a bound of the number beside it.
struct Bound {
  Side side = Side::kNone;
  std::size_t first = 0;  // its first token
};

// A number and the token where it begins.
struct LowEnd {
  double value = 0.0;
  std::size_t first = 0;
  bool found = false;
};

class BoundReader {
 public:
  BoundReader(const EnvironmentWords& words, const NotedTokens& noted, const HeardMeasure& measure)
      : words_(words), noted_(noted), tokens_(noted.tokens), measure_(measure) {}

  MeasureBounds Read() const {
    MeasureBounds bounds;
    bounds.first = bounds.said = measure_.first;
    if (const LowEnd low = RangeBefore(); low.found && low.value < measure_.value) {
      bounds.least = low.value;
      bounds.most = measure_.value;
      bounds.first = bounds.said = low.first;
      return bounds;
    }
    Bound bound = Before(measure_.first);
    if (bound.side == Side::kNone) bound = {After(), measure_.first};
    bounds.said = bound.side == Side::kNone ? measure_.first : bound.first;
    if (bound.side == Side::kLeast) bounds.least = measure_.value;
    if (bound.side != Side::kMost) return bounds;
    bounds.most = measure_.value;
    // "at least 5 but at most 10 m/s"
    std::size_t joint = bound.first;
    if (joint == 0 || !Is(joint - 1, {"but", "and"})) return bounds;
    --joint;
    if (joint > 0 && noted_.IsPause(joint - 1)) --joint;
    const LowEnd low = NumberBefore(joint);
    if (!low.found || low.value >= measure_.value) return bounds;
    const Bound least = Before(low.first);
    if (least.side != Side::kLeast) return bounds;
    bounds.least = low.value;
    bounds.first = low.first;
    bounds.said = least.first;
    return bounds;
  }

 private:
  bool Is(std::size_t at, std::initializer_list<std::string_view> any) const {
    return noted_.IsAnyWord(at, any);
  }

  static double ValueOf(const std::vector<Token>& number) {
    if (number.size() != 1 || number[0].kind != TokenKind::kNumber) {
      return MatchNumber(number, 0).value;
    }
    double value = 0.0;
    const std::string& text = number[0].text;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }

  // How much of its unit the measure's number is worth.
  double Worth() const {
    const std::size_t tokens =
        std::max<std::size_t>(1, MatchNumber(tokens_, measure_.first).tokens);
    const auto begin = tokens_.begin() + static_cast<std::ptrdiff_t>(measure_.first);
    const double number = ValueOf({begin, begin + static_cast<std::ptrdiff_t>(tokens)});
    return number == 0.0 ? 1.0 : measure_.value / number;
  }

  // The number that ends right before `end`, in the unit of the measure.
  LowEnd NumberBefore(std::size_t end) const {
    while (end > 0 && Is(end - 1, {"percent", "degrees", "degree", "m", "s", "mps", "km", "h",
                                   "kmh", "kph", "mph", "knots"})) {
      --end;
    }
    constexpr std::size_t kWords = 3;
    for (std::size_t length = std::min(kWords, end); length > 0; --length) {
      const std::size_t first = end - length;
      if (noted_.IsPause(first)) continue;
      const bool decimal = length == 1 && tokens_[first].kind == TokenKind::kNumber;
      if (!decimal && MatchNumber(tokens_, first).tokens != length) continue;
      const auto begin = tokens_.begin() + static_cast<std::ptrdiff_t>(first);
      const double number = ValueOf({begin, begin + static_cast<std::ptrdiff_t>(length)});
      return {Worth() * number, first, true};
    }
    return {};
  }

  // "(5 to) 8 m/s", "(between 5 and) 8 m/s", "(0.2-)0.4"
  LowEnd RangeBefore() const {
    std::size_t end = measure_.first;
    if (end == 0) return {};
    if (Is(end - 1, {"and"})) {
      const LowEnd low = NumberBefore(end - 1);
      const bool between = low.found && low.first > 0 && Is(low.first - 1, {"between"});
      return between ? low : LowEnd{};
    }
    if (Is(end - 1, {"to", "or", "until"})) {
      --end;
      if (end > 0 && Is(end - 1, {"up"})) --end;
      const LowEnd low = NumberBefore(end);
      return low.found && IsChangedFrom(low.first) ? LowEnd{} : low;
    }
    const LowEnd low = NumberBefore(end);
    if (!low.found) return {};
    // Only a dash is between them.
    const std::size_t from = tokens_[end - 1].end, to = tokens_[measure_.first].begin;
    if (from >= to) return {};
    std::string between(noted_.instruction.substr(from, to - from));
    for (const std::string_view dash : {"-", "\xE2\x80\x93", "\xE2\x80\x94", "~"}) {
      const std::size_t at = between.find(dash);
      if (at == between.npos) continue;
      between.erase(at, dash.size());
      return between.find_first_not_of(" %") == between.npos ? low : LowEnd{};
    }
    return {};
  }

  // "raise the wind from (5) to 8 m/s": 5 is what it was.
  bool IsChangedFrom(std::size_t low) const {
    if (low == 0 || !Is(low - 1, {"from"})) return false;
    for (std::size_t at = low; at > 0 && !IsStopAt(tokens_, at - 1); --at) {
      if (Is(at - 1,
             {"raise",  "raised",  "increase", "increased", "increases", "lower",   "lowered",
              "reduce", "reduced", "decrease", "decreased", "change",    "changed", "turn",
              "turned", "rise",    "rises",    "rose",      "drop",      "drops",   "dropped"})) {
        return true;
      }
    }
    return false;
  }

  static Side Other(Side side) { return side == Side::kLeast ? Side::kMost : Side::kLeast; }

  // Whether what begins at `first` is denied: "no (stronger than)", "should not (exceed)", "must
  // not be (above)".
  bool IsDenied(std::size_t first) const {
    if (noted_.notes[first].negated) return true;
    while (first > 0 && Is(first - 1, {"be", "get", "go", "ever", "become"})) --first;
    return first > 0 && Is(first - 1, {"not", "no", "never", "nowhere"});
  }

  // The bound that is said right before `end`.
  Bound Before(std::size_t end) const {
    constexpr std::size_t kLongest = 4;
    for (std::size_t length = std::min(kLongest, end); length > 0; --length) {
      const std::size_t first = end - length;
      if (words_.RoleAt(Role::kAtLeast, tokens_, first) == length) return {Side::kLeast, first};
      if (words_.RoleAt(Role::kAtMost, tokens_, first) == length) return {Side::kMost, first};
      Side side = Side::kNone;
      if (words_.RoleAt(Role::kMoreThan, tokens_, first) == length) side = Side::kLeast;
      if (words_.RoleAt(Role::kFewerThan, tokens_, first) == length) side = Side::kMost;
      if (length == 2 && Is(first + 1, {"than"})) {
        if (IsMore(first)) side = Side::kLeast;
        if (IsLess(first)) side = Side::kMost;
      }
      if (length == 2 && Is(first, {"limited", "capped"}) && Is(first + 1, {"to", "at"})) {
        side = Side::kMost;
      }
      if (length == 1 && Is(first, {"exceeding", "exceeds", "exceed"})) side = Side::kLeast;
      // "five eagles fly over 30 degree slopes"
      const bool place = length == 1 && first > 0 && Is(first, {"over", "above", "under", "below"});
      if (place && !noted_.IsPause(first - 1) && IsAgentOrActBefore(first)) continue;
      if (side != Side::kNone) return {IsDenied(first) ? Other(side) : side, first};
    }
    return Extreme(end);
  }

  // Whether agents, or what they do, are named right before `end`.
  bool IsAgentOrActBefore(std::size_t end) const {
    if (Is(end - 1, {"live", "lives", "wind", "winds"})) return Is(end - 1, {"live", "lives"});
    return words_.species.LengthAt(tokens_, end - 1) == 1 ||
           words_.states.LengthAt(tokens_, end - 1) >= 1;
  }

  bool IsMore(std::size_t at) const {
    return Is(at, {"more", "greater", "higher", "stronger", "faster", "steeper", "denser", "larger",
                   "bigger", "thicker", "harder"});
  }

  bool IsLess(std::size_t at) const {
    return Is(at, {"less", "fewer", "lower", "weaker", "slower", "gentler", "flatter", "sparser",
                   "smaller", "thinner", "lighter"});
  }

  // Whether what is measured is named at `at`, or the number follows.
  bool IsMeasuredAt(std::size_t at, std::size_t end) const {
    return at >= end || tokens_[at].kind != TokenKind::kWord ||
           Is(at, {"wind",    "winds",    "gust",     "gusts",   "breeze",      "speed",
                   "slope",   "slopes",   "gradient", "incline", "inclination", "steepness",
                   "density", "cover",    "coverage", "height",  "angle",       "rotation",
                   "size",    "scale",    "value",    "of",      "is",          "amount",
                   "average", "mountain", "allowed",  "possible"}) ||
           words_.assets.LengthAt(tokens_, at) > 0 || words_.features.LengthAt(tokens_, at) > 0;
  }

  // "max wind speed: (6 m/s)", "a maximum slope of (25 degrees)"
  Bound Extreme(std::size_t end) const {
    constexpr std::size_t kReach = 6;
    for (std::size_t at = end; at > 0 && at + kReach > end; --at) {
      const Token& token = tokens_[at - 1];
      const bool most = Is(at - 1, {"max", "maximum", "maximal"}),
                 least = Is(at - 1, {"min", "minimum"});
      // "max fun: wind 8 m/s"
      if (most || least) {
        if (!IsMeasuredAt(at, end)) return {};
        return {most ? Side::kMost : Side::kLeast, at - 1};
      }
      const bool goes_on = token.kind == TokenKind::kWord || token.text == ":" ||
                           token.text == "=" || token.text == "(" || token.text == ")";
      if (!goes_on || Is(at - 1, {"and", "but", "with"})) break;
      if (MatchNumber(tokens_, at - 1).tokens > 0) break;
    }
    return {};
  }

  // "(12 m/s) or more", "(0.3) at most"
  Side After() const {
    std::size_t at = measure_.last;
    if (Is(at, {"percent"})) ++at;
    if (Is(at, {"or", "and"})) {
      // "12 m/s and above the lake two drones" is no bound.
      if (!noted_.IsPause(at + 2) && !(Is(at, {"or"}) && Is(at + 1, {"more", "less"}))) {
        return Side::kNone;
      }
      if (Is(at + 1, {"over", "above", "up"}) || IsMore(at + 1)) return Side::kLeast;
      if (Is(at + 1, {"under", "below"}) || IsLess(at + 1)) return Side::kMost;
      return Side::kNone;
    }
    if (at < tokens_.size() && tokens_[at].text == ",") ++at;
    if (Is(at, {"at"})) {
      ++at;
      while (Is(at, {"the", "very"})) ++at;
      if (!noted_.IsPause(at + 1)) return Side::kNone;  // "5 m/s, at most ten sheep"
      if (Is(at, {"least"})) return Side::kLeast;
      return Is(at, {"most"}) ? Side::kMost : Side::kNone;
    }
    const bool label = at + 1 < tokens_.size() && tokens_[at + 1].text == ":";  // "max: 5 sheep"
    if (!noted_.IsPause(at + 1) || label) return Side::kNone;
    if (Is(at, {"minimum", "min"})) return Side::kLeast;
    return Is(at, {"maximum", "max", "tops"}) ? Side::kMost : Side::kNone;
  }

  const EnvironmentWords& words_;
  const NotedTokens& noted_;
  const std::vector<Token>& tokens_;
  const HeardMeasure& measure_;
};

}  // namespace

MeasureBounds BoundsOf(const EnvironmentWords& words, const NotedTokens& noted,
                       const HeardMeasure& measure) {
  return BoundReader(words, noted, measure).Read();
}

}  // namespace latticeworld
