#include "latticeworld/language/grounded/environment/attributes/measure_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace {

struct Number {
  double value = 0.0;
  std::size_t tokens = 0;  // 0: no number starts here
  bool fraction = false;
};

// Wind speeds at the middle of each force of the Beaufort scale [m/s].
constexpr std::array<double, 13> kBeaufort_mps = {0.1,  1.0,  2.5,  4.4,  6.7,  9.4, 12.3,
                                                  15.5, 19.0, 22.6, 26.5, 30.6, 36.0};

class MeasureReader {
 public:
  explicit MeasureReader(NotedTokens* noted) : noted_(*noted), tokens_(noted->tokens) {}

  std::vector<HeardMeasure> Run() {
    std::vector<HeardMeasure> found;
    for (std::size_t at = 0; at < tokens_.size();) {
      std::optional<HeardMeasure> measure = ReadAt(at);
      if (!measure.has_value()) {
        ++at;
        continue;
      }
      measure->first = at;
      measure->last = std::min(measure->last, tokens_.size());
      noted_.Mark(measure->first, measure->last, &TokenNote::measure);
      at = std::max(at + 1, measure->last);
      found.push_back(*measure);
    }
    return found;
  }

 private:
  bool Is(std::size_t at, std::initializer_list<std::string_view> words) const {
    return noted_.IsAnyWord(at, words);
  }

  Number NumberAt(std::size_t at) const {
    if (at >= tokens_.size()) return {};
    if (tokens_[at].kind == TokenKind::kNumber) {
      const std::string& text = tokens_[at].text;
      double value = 0.0;
      std::from_chars(text.data(), text.data() + text.size(), value);
      const NumberMatch counted = MatchNumber(tokens_, at);
      if (counted.tokens > 1) return {static_cast<double>(counted.value), counted.tokens, false};
      return {std::min(value, 1e6), 1, text.find('.') != std::string::npos};
    }
    const NumberMatch number = MatchNumber(tokens_, at);
    return {static_cast<double>(number.value), number.tokens, false};
  }

  std::optional<HeardMeasure> ReadAt(std::size_t at) const {
    if (tokens_[at].kind == TokenKind::kComma || tokens_[at].kind == TokenKind::kStop) return {};
    if (auto hour = ReadHour(at)) return hour;
    if (auto speed = ReadSpeed(at)) return speed;
    return ReadQuantity(at);
  }

  // ------------------------------------------------------------------ hours

  std::optional<HeardMeasure> ReadHour(std::size_t at) const {
    // "half past nine", "a quarter to six", "ten past four"
    double shift_h = 0.0;
    std::size_t next = at;
    if (Is(at, {"half"}) && Is(at + 1, {"past"})) {
      shift_h = 0.5;
      next = at + 2;
    } else if (Is(at, {"quarter"}) && Is(at + 1, {"past", "to"})) {
      shift_h = Is(at + 1, {"past"}) ? 0.25 : -0.25;
      next = at + 2;
    } else if (const Number minutes = NumberAt(at); minutes.tokens > 0 && minutes.value < 60.0) {
      std::size_t word = at + minutes.tokens;
      if (Is(word, {"minutes"})) ++word;
      if (Is(word, {"past", "to"}) &&
          Is(word + 1, {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine",
                        "ten", "eleven", "twelve"})) {
        // "three to five" counts; minutes to an hour come in fives.
        const bool past = Is(word, {"past"});
        if (past || (minutes.value >= 5.0 && std::fmod(minutes.value, 5.0) == 0.0 && Clock(at))) {
          shift_h = (past ? minutes.value : -minutes.value) / 60.0;
          next = word + 1;
        }
      }
    }
    const Number number = NumberAt(next);
    if (number.tokens == 0) return {};
    if (number.fraction) return DottedHour(next);
    double hour = number.value;
    std::size_t end = next + number.tokens;
    bool sure = shift_h != 0.0;  // that an hour is meant
    bool military = false;       // four digits: of twenty-four hours
    // "18:30"
    if (end + 1 < tokens_.size() && tokens_[end].kind == TokenKind::kComma &&
        tokens_[end].text == ":" && tokens_[end + 1].kind == TokenKind::kNumber &&
        tokens_[end + 1].text.size() == 2 && tokens_[end].end == tokens_[end + 1].begin) {
      hour += NumberAt(end + 1).value / 60.0;
      end += 2;
      sure = true;
    } else if (tokens_[next].kind == TokenKind::kNumber && tokens_[next].text.size() == 4 &&
               tokens_[next].text[2] < '6' &&
               (tokens_[next].text.front() == '0' || Is(end, {"hours", "hrs", "h"}) ||
                (next > 0 && Is(next - 1, {"time"})) ||
                (Is(end, {"local"}) && Is(end + 1, {"time"})))) {
      // "0630", "1800 hours", "local time 1500"
      hour = std::floor(number.value / 100.0) + std::fmod(number.value, 100.0) / 60.0;
      if (Is(end, {"hours", "hrs", "h"})) ++end;
      sure = military = true;
    }
    const bool twelve_hours = hour < 13.0 && !military;
    if (Is(end, {"h", "hrs"}) && tokens_[next].kind == TokenKind::kNumber && !IsSpeedUnit(end)) {
      ++end;
      sure = true;
    }
    if (Is(end, {"o"}) && (Is(end + 1, {"clock"}) || noted_.Text(end, end + 1).size() > 4)) {
      end += Is(end + 1, {"clock"}) ? 2 : 1;
      sure = true;
    }
    if (hour >= 25.0) return {};
    if (const std::size_t half = HalfOfDay(end, &hour); half > 0) {
      return HeardMeasure{MeasureKind::kHour, Wrapped(hour + shift_h), at, end + half};
    }
    if (!sure) return {};
    if (twelve_hours && (tokens_[next].kind != TokenKind::kNumber || end == next + number.tokens ||
                         Is(end - 1, {"o", "clock"}))) {
      if (hour < 6.0) hour += 12.0;
      return HeardMeasure{MeasureKind::kVagueHour, Wrapped(hour + shift_h), at, end};
    }
    return HeardMeasure{MeasureKind::kHour, Wrapped(hour + shift_h), at, end};
  }

  // "at 22.30"
  std::optional<HeardMeasure> DottedHour(std::size_t at) const {
    const std::string_view text = tokens_[at].text;
    const std::size_t dot = text.find('.');
    if (!Clock(at) || text.size() != dot + 3 || dot > 2 || !noted_.IsPause(at + 1)) return {};
    const double value = NumberAt(at).value;
    const double minutes = 100.0 * (value - std::floor(value));
    if (value >= 24.0 || minutes > 59.5) return {};
    return HeardMeasure{MeasureKind::kHour, std::floor(value) + minutes / 60.0, at, at + 1};
  }
  bool Clock(std::size_t at) const { return at > 0 && Is(at - 1, {"at", "is"}); }

  static double Wrapped(double hour) {
    hour = std::fmod(hour, 24.0);
    return hour < 0.0 ? hour + 24.0 : hour;
  }

  // "am", "p.m.", "in the evening": how many tokens, and the hour of the day.
  std::size_t HalfOfDay(std::size_t at, double* hour) const {
    std::size_t tokens = 0;
    bool late = false;
    if (Is(at, {"am", "pm"})) {
      tokens = 1;
      late = Is(at, {"pm"});
    } else if (Is(at, {"a", "p"}) && at + 2 < tokens_.size() &&
               tokens_[at + 1].kind == TokenKind::kStop && Is(at + 2, {"m"})) {
      const bool dot = at + 3 < tokens_.size() && tokens_[at + 3].text == ".";
      tokens = dot ? 4 : 3;
      late = Is(at, {"p"});
    } else if (Is(at, {"in"}) && Is(at + 1, {"the"}) &&
               Is(at + 2, {"morning", "afternoon", "evening", "night"})) {
      tokens = 3;
      late = !Is(at + 2, {"morning"}) && !(Is(at + 2, {"night"}) && *hour < 5.0);
    } else if (Is(at, {"at"}) && Is(at + 1, {"night"})) {
      tokens = 2;
      late = *hour >= 5.0;
    }
    if (tokens == 0) return 0;
    if (late && *hour < 12.0) *hour += 12.0;
    const bool after_midnight =
        *hour >= 12.0 && *hour < 13.0 && (!late || Is(at, {"at"}) || Is(at + 2, {"night"}));
    if (after_midnight) *hour -= 12.0;
    return tokens;
  }

  // ------------------------------------------------------------------ speeds

  bool IsSpeedUnit(std::size_t at) const { return UnitOfSpeed(at).tokens > 0; }

  Number UnitOfSpeed(std::size_t at) const {
    if (Is(at, {"m"}) && Is(at + 1, {"s"})) return {1.0, 2};
    if (Is(at, {"mps"})) return {1.0, 1};
    if (Is(at, {"metres", "meters"}) && Is(at + 1, {"per", "a"}) && Is(at + 2, {"second"})) {
      return {1.0, 3};
    }
    if (Is(at, {"km"}) && Is(at + 1, {"h"})) return {1.0 / 3.6, 2};
    if (Is(at, {"kmh", "kph"})) return {1.0 / 3.6, 1};
    if (Is(at, {"kilometres", "kilometers", "km"}) && Is(at + 1, {"per", "an"}) &&
        Is(at + 2, {"hour"})) {
      return {1.0 / 3.6, 3};
    }
    if (Is(at, {"mph"})) return {0.44704, 1};
    if (Is(at, {"miles"}) && Is(at + 1, {"per", "an"}) && Is(at + 2, {"hour"})) return {0.44704, 3};
    if (Is(at, {"knots", "knot", "kn", "kts"})) return {0.51444, 1};
    return {};
  }

  std::optional<HeardMeasure> ReadSpeed(std::size_t at) const {
    if (Is(at, {"force", "beaufort", "bft"})) {
      const Number force = NumberAt(at + 1);
      if (force.tokens > 0) return Beaufort(force.value, at, at + 1 + force.tokens);
    }
    const Number number = NumberAt(at);
    if (number.tokens == 0) return {};
    const std::size_t end = at + number.tokens;
    if (const Number unit = UnitOfSpeed(end); unit.tokens > 0) {
      return HeardMeasure{MeasureKind::kSpeed, number.value * unit.value, at, end + unit.tokens};
    }
    if (Is(end, {"beaufort", "bft"})) return Beaufort(number.value, at, end + 1);
    return {};
  }

  static HeardMeasure Beaufort(double force, std::size_t at, std::size_t end) {
    const auto index = static_cast<std::size_t>(std::clamp(force, 0.0, 12.0));
    return {MeasureKind::kSpeed, kBeaufort_mps[index], at, end};
  }

  // ------------------------------------------------------------------ other units

  // A minus sign or word before the token.
  bool IsNegative(std::size_t at) const {
    if (at > 0 && Is(at - 1, {"minus", "negative", "\xE2\x88\x92"})) return true;
    const std::size_t begin = tokens_[at].begin;
    const std::string_view before = noted_.instruction.substr(0, begin);
    if (before.empty() || before.back() != '-') return false;
    return before.size() == 1 || before[before.size() - 2] == ' ' ||
           before[before.size() - 2] == '(';
  }

  std::optional<HeardMeasure> ReadQuantity(std::size_t at) const {
    if (Is(at + 1, {"as", "the", "their", "its", "size", "sized", "scale", "normal", "height"})) {
      if (Is(at, {"twice", "double"})) {
        if (IsOfNumber(at + 1)) return {};
        return Factor(2.0, at, at + 1);
      }
      if (Is(at, {"thrice", "triple"})) return Factor(3.0, at, at + 1);
    }
    // "half their usual size"
    if (Is(at, {"half"}) && Is(at + 1, {"the", "their", "its", "of"})) {
      for (std::size_t i = at + 2; i < at + 5; ++i) {
        if (Is(i, {"size", "scale", "height"})) return Factor(0.5, at, at + 1);
        if (!Is(i, {"usual", "normal", "regular", "original", "standard", "real", "the", "their",
                    "its", "ordinary", "natural"})) {
          break;
        }
      }
    }
    if (Is(at, {"half"}) && !IsOfNumber(at + 1) &&
        (Is(at + 1, {"the", "as"}) || Is(at + 1, {"size", "scale", "sized"})) &&
        (Is(at + 2, {"size", "scale", "usual", "normal", "large", "big", "tall", "high"}) ||
         Is(at + 1, {"size", "scale", "sized"}))) {
      return Factor(0.5, at, at + 1);
    }
    Number number = NumberAt(at);
    if (Is(at, {"a"}) && Is(at + 1, {"metre", "meter"})) number = {1.0, 1, false};
    if (Is(at, {"half"}) && Is(at + 1, {"a"}) && Is(at + 2, {"metre", "meter"})) {
      number = {0.5, 2, true};
    }
    if (number.tokens == 0) return {};
    std::size_t end = at + number.tokens;
    // "one and a half metres"
    if (Is(end, {"and"}) && Is(end + 1, {"a"}) && Is(end + 2, {"half"}) &&
        !Is(end + 3, {"times"})) {
      number.value += 0.5;
      number.fraction = true;
      end += 3;
    }
    const double sign = IsNegative(at) ? -1.0 : 1.0;
    const std::size_t byte = tokens_[end - 1].end;
    if (byte < noted_.instruction.size() && noted_.instruction[byte] == '%') {
      return HeardMeasure{MeasureKind::kShare, number.value / 100.0, at, end};
    }
    if (Is(end, {"percent"}) || (Is(end, {"per"}) && Is(end + 1, {"cent"}))) {
      return HeardMeasure{MeasureKind::kShare, number.value / 100.0, at,
                          end + (Is(end, {"percent"}) ? 1u : 2u)};
    }
    if (Is(end, {"and"}) && Is(end + 1, {"a"}) && Is(end + 2, {"half"}) && Is(end + 3, {"times"})) {
      return Factor(number.value + 0.5, at, end + 4);
    }
    if (Is(end, {"times"})) {
      if (IsOfNumber(end + 1)) return {};
      return Factor(number.value, at, end + 1);
    }
    if (auto temperature = ReadDegrees(sign * number.value, at, end)) return temperature;
    double unit_m = 0.0;
    if (Is(end, {"m", "metre", "metres", "meter", "meters"})) unit_m = 1.0;
    if (Is(end, {"cm", "centimetres", "centimeters"})) unit_m = 0.01;
    if (Is(end, {"feet", "ft"})) unit_m = 0.3048;
    if (unit_m > 0.0) {
      return HeardMeasure{MeasureKind::kLength, sign * number.value * unit_m, at, end + 1};
    }
    std::size_t said = at;  // "density: 1", "density of 0"
    // "density between 0.2 and 1", but "of low density and 1 sheep"
    const bool range = said > 1 && Is(said - 1, {"and", "to"}) && noted_.IsPause(end) &&
                       tokens_[said - 2].kind == TokenKind::kNumber;
    if (range) said -= 2;
    while (said > 0 && (Is(said - 1, {"of", "is", "to", "at"}) ||
                        (range && Is(said - 1, {"between", "from"})) ||
                        tokens_[said - 1].kind == TokenKind::kComma)) {
      --said;
    }
    const bool density = number.value <= 1.0 && said > 0 && Is(said - 1, {"density"});
    if (number.fraction || density)
      return HeardMeasure{MeasureKind::kDecimal, number.value, at, end};
    return {};
  }

  // "twice as many goblins"
  bool IsOfNumber(std::size_t at) const {
    return (Is(at, {"as"}) && Is(at + 1, {"many"})) ||
           (Is(at, {"the", "that", "this", "their"}) && Is(at + 1, {"number", "count", "many"}));
  }

  std::optional<HeardMeasure> Factor(double factor, std::size_t at, std::size_t end) const {
    return HeardMeasure{MeasureKind::kFactor, factor, at, end};
  }

  std::optional<HeardMeasure> ReadDegrees(double value, std::size_t at, std::size_t end) const {
    constexpr std::string_view kSign = "\xC2\xB0";  // the degree sign is a letter to the tokenizer
    bool degrees = false;
    bool celsius = false;
    bool fahrenheit = false;
    if (Is(end, {"degrees", "degree", "deg"})) {
      degrees = true;
      ++end;
    } else if (end < tokens_.size() && tokens_[end].text.compare(0, kSign.size(), kSign) == 0) {
      const std::string rest = tokens_[end].text.substr(kSign.size());
      degrees = rest.empty();
      celsius = rest == "c";
      fahrenheit = rest == "f";
      if (!degrees && !celsius && !fahrenheit) return {};
      ++end;
    }
    if (Is(end, {"c", "celsius", "centigrade"}) && !fahrenheit) {
      celsius = true;
      ++end;
    } else if (Is(end, {"f", "fahrenheit"}) && !celsius) {
      fahrenheit = true;
      ++end;
    }
    if (Is(end, {"below"}) && (Is(end + 1, {"zero", "freezing"}) || (!degrees && IsEndOf(end)))) {
      value = -std::abs(value);
      celsius = !fahrenheit;
      end += Is(end + 1, {"zero", "freezing"}) ? 2 : 1;
    } else if (degrees && Is(end, {"above"}) && Is(end + 1, {"zero", "freezing"})) {
      celsius = true;
      end += 2;
    }
    if (fahrenheit) value = (value - 32.0) / 1.8;
    if (celsius || fahrenheit || (degrees && value < 0.0)) {
      return HeardMeasure{MeasureKind::kTemperature, value, at, end};
    }
    if (degrees) return HeardMeasure{MeasureKind::kDegrees, value, at, end};
    return {};
  }

  bool IsEndOf(std::size_t at) const { return noted_.IsPause(at + 1); }

  NotedTokens& noted_;
  const std::vector<Token>& tokens_;
};

}  // namespace

std::vector<HeardMeasure> ReadMeasures(NotedTokens* noted) { return MeasureReader(noted).Run(); }

}  // namespace latticeworld
