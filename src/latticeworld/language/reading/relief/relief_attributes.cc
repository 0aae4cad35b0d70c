#include "latticeworld/language/reading/relief/relief_attributes.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/places.h"

namespace latticeworld {
namespace {

// A measure of a wish, and the sentence that it comes from.
struct Measure {
  const char* name;
  std::optional<double>* value;
  std::string* words;
};

class AttributeReader {
 public:
  AttributeReader(const ReliefMention& mention, ReliefSentence* sentence, ReliefWish* wish,
                  std::vector<std::string>* warnings)
      : mention_(mention), s_(*sentence), wish_(*wish), warnings_(*warnings) {}

  void Read(std::size_t begin, std::size_t end) {
    ReadNumber();
    for (std::size_t i = begin; i < end; ++i) {
      const bool inside = i >= mention_.begin && i < mention_.end;
      // Adjectives stand close before their noun, or come after "is".
      const bool leads = i >= mention_.begin || Leads(i) || (begin == 0 && s_.IsNumber(i));
      if (inside || !leads || s_.IsOfCover(i) || s_.IsOfWay(i)) continue;
      ReadSize(i);
      ReadMeasure(i, begin);
    }
    if (mention_.kind == ReliefKind::kSlope && wish_.heading.east == 0 &&
        wish_.heading.south == 0) {
      wish_.heading = RiseOf(s_, begin, end);
    } else if (wish_.zones.empty()) {
      ReadZones(begin, end);
    }
    if (IsCourse(mention_.kind)) ReadCourse(end);
  }

 private:
  bool Leads(std::size_t at) const {
    for (std::size_t i = at; i < mention_.begin; ++i) {
      if (s_.Is(i, {"of", "in", "with", "to", "and", "is", "are"})) return false;
      if (s_.tokens()[i].kind == TokenKind::kStop) return false;
    }
    return mention_.begin - at <= 5;
  }

  void ReadNumber() {
    for (std::size_t i = mention_.begin; i-- > 0 && mention_.begin - i <= 4;) {
      const CountMatch count = MatchCount(s_.tokens(), i);
      if (count.tokens == 0 && s_.Is(i, {"a", "an", "and", "in", "to", "than"})) return;
      const bool is_measure =
          s_.MetresAt(i).has_value() || s_.Is(i + count.tokens, {"degree", "degrees"});
      if (count.tokens == 0 || is_measure) continue;
      const int most = count.most == CountMatch::kUnbounded ? count.least : count.most;
      wish_.count = std::max(count.least, (count.least + most + 1) / 2);
      s_.Take(i, i + count.tokens);
      return;
    }
  }

  void ReadSize(std::size_t at) {
    if (s_.Is(at, {"steep", "sheer"})) {
      wish_.steepness = 1.5;
    } else if (s_.Is(at, {"gentle", "low", "shallow"})) {
      wish_.steepness = 0.5;
    } else if (s_.Is(at, {"high", "tall", "deep", "towering"}) &&
               !(at > 1 && s_.MetresAt(at - 2).has_value())) {
      wish_.steepness = std::max(wish_.steepness, 1.25);
    } else if (const SizeMatch size = MatchSize(s_.tokens(), at);
               size.tokens > 0 && at < mention_.begin) {
      wish_.size = size.factor * size.width;
    } else {
      return;
    }
    s_.Take(at, at + 1);
  }

  // "120 m high", "a height of 120 m", "rises 40 m", "15 degrees".
  void ReadMeasure(std::size_t at, std::size_t clause) {
    if (!s_.IsNumber(at) || IsOfOther(at)) return;
    if (s_.IsDegrees(at)) {
      const double value = std::strtod(s_.tokens()[at].text.c_str(), nullptr);
      Keep({"slope", &wish_.slope_deg, &wish_.slope_words}, value);
      s_.Take(at, at + 2);
      return;
    }
    const std::optional<double> metres = s_.MetresAt(at);
    if (!metres) return;
    const std::optional<Measure> measure = MeasureOf(at, clause);
    if (!measure) return;
    Keep(*measure, *metres);
    s_.Take(at, at + 3);
  }

  // "A path of 15 degrees" says nothing of the hill.
  bool IsOfOther(std::size_t at) const {
    return at > 0 && s_.Is(at - 1, {"of"}) &&
           std::any_of(s_.others().begin(), s_.others().end(),
                       [at](const OtherMention& other) { return other.end + 1 == at; });
  }

  // What a number of metres says: by the word behind its unit, by the noun before it, or by a verb.
  std::optional<Measure> MeasureOf(std::size_t at, std::size_t clause) {
    const Measure height = {"height", &wish_.height_m, &wish_.height_words};
    const Measure depth = {"depth", &wish_.depth_m, &wish_.depth_words};
    const Measure width = {"width", &wish_.width_m, &wish_.width_words};
    const Measure length = {"length", &wish_.length_m, &wish_.length_words};
    const std::size_t how = at + 2;
    if (s_.Is(how, {"high", "tall"})) return height;
    if (s_.Is(how, {"deep"})) return depth;
    if (s_.Is(how, {"wide", "across", "broad"})) return width;
    if (s_.Is(how, {"long"})) return length;
    for (std::size_t i = at; i-- > clause && at - i <= 3;) {
      const bool said = s_.Is(i, {"height", "drop", "depth", "width", "diameter", "length"});
      if (!said) continue;
      s_.Take(i, i + 1);
      if (s_.Is(i, {"height", "drop"})) return height;
      if (s_.Is(i, {"depth"})) return depth;
      return s_.Is(i, {"length"}) ? length : width;
    }
    const bool rises = s_.Has(clause, at, {"rises", "rise", "rising", "towers", "drops"});
    if (rises || s_.Is(how, {"in"})) return height;
    return std::nullopt;
  }

  void Keep(const Measure& measure, double value) {
    if (measure.value->has_value() && **measure.value != value) {
      warnings_.push_back(Quote(*measure.words) + " and " + Quote(s_.words()) +
                          " cannot both be: the later " + measure.name + " counts");
    }
    *measure.value = value;
    *measure.words = s_.words();
  }

  void ReadZones(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!s_.Is(i, {"in", "at", "on", "across", "along", "over", "to"})) continue;
      if (s_.Is(i + 1, {"its", "their"})) continue;  // "to its top"
      const PlaceMatch match = MatchPlaceAfter(s_.Word(i), s_.tokens(), i + 1);
      if (match.tokens == 0 || match.of_other) continue;
      for (const Place& place : match.places) wish_.zones.push_back(place.zone);
      s_.Take(i, i + 1 + match.tokens);
      i += match.tokens;
    }
  }

  void ReadCourse(std::size_t end) {
    for (std::size_t i = mention_.end; i + 1 < end; ++i) {
      if (!s_.Is(i, {"from"})) continue;
      const PlaceMatch from = MatchPlace(s_.tokens(), i + 1);
      const std::size_t to_at = i + 1 + from.tokens;
      if (from.tokens == 0 || !s_.Is(to_at, {"to"})) continue;
      const PlaceMatch to = MatchPlace(s_.tokens(), to_at + 1);
      if (to.tokens == 0) continue;
      wish_.from = {RimOf(from.places.front())};
      wish_.to = {RimOf(to.places.front())};
      wish_.zones.clear();
      s_.Take(i, to_at + 1 + to.tokens);
      return;
    }
  }

  // "From the north" begins at the edge.
  static Zone RimOf(const Place& place) {
    return place.main == Region::kAnywhere ? place.zone : RimZoneOf(HeadingOf(place.main));
  }

  const ReliefMention& mention_;
  ReliefSentence& s_;
  ReliefWish& wish_;
  std::vector<std::string>& warnings_;
};

// Returns where the words begin that describe a mention: at the beginning of the sentence, or after
// the thing named before it: at the comma between them, else at the words that lead its noun ("a
// hill and a 25 m deep gorge").
std::size_t BeginOf(const ReliefSentence& sentence, std::size_t mention) {
  const std::size_t noun = sentence.mentions()[mention].begin;
  std::size_t before = mention == 0 ? 0 : sentence.mentions()[mention - 1].end;
  for (const OtherMention& other : sentence.others()) {
    if (other.end <= noun) before = std::max(before, other.end);
  }
  if (before == 0) return 0;
  std::size_t begin = noun;
  for (std::size_t i = noun; i-- > before;) {
    if (sentence.tokens()[i].kind == TokenKind::kComma) return i;
    if (noun - i <= 6 && sentence.Is(i, {"a", "an", "the", "and", "between"})) begin = i;
  }
  return begin;
}

}  // namespace

void ReadReliefAttributes(std::size_t mention, ReliefSentence* sentence, ReliefWish* wish,
                          std::vector<std::string>* warnings) {
  const std::vector<ReliefMention>& all = sentence->mentions();
  const std::size_t begin = BeginOf(*sentence, mention);
  const std::size_t end = mention + 1 < all.size()
                              ? std::max(all[mention].end, BeginOf(*sentence, mention + 1))
                              : sentence->tokens().size();
  AttributeReader(all[mention], sentence, wish, warnings).Read(begin, end);
}

Claim::Heading RiseOf(const ReliefSentence& sentence, std::size_t begin, std::size_t end) {
  bool down = false;
  for (std::size_t i = begin; i < end; ++i) {
    if (sentence.Is(i,
                    {"falls", "fall", "falling", "slopes", "descends", "drops", "dips", "down"})) {
      down = true;
    }
    if (sentence.Is(i, {"up", "rises", "rising"})) down = false;
    if (!sentence.Is(i, {"to", "toward", "towards"})) continue;
    const std::size_t at = sentence.Is(i + 1, {"the"}) ? i + 2 : i + 1;
    const HeadingMatch heading = MatchHeading(sentence.tokens(), at);
    if (heading.tokens == 0) continue;
    const int sign = down ? -1 : 1;
    return {sign * heading.heading.east, sign * heading.heading.south};
  }
  return {};
}

}  // namespace latticeworld
