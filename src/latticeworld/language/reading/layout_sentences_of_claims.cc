#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/reading/sentences_of_claims.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/sentences/sentence_writer.h"

namespace latticeworld {
namespace {

// The nouns of a class.
struct Nouns {
  char letter;
  std::string_view spread;  // as land: "forest"
  std::string_view piece;   // one of it: "grove"
  std::string_view pieces;
  std::string_view line;  // as a line
  std::string_view several_lines;
};
constexpr Nouns kSuburb[] = {
    {'A', "farmland", "field", "fields", "farmland", "farmland"},
    {'B', "houses", "village", "houses", "houses", "houses"},
    {'D', "barren land", "desert", "deserts", "barren land", "barren land"},
    {'F', "forest", "grove", "groves", "forest", "forest"},
    {'G', "grassland", "meadow", "meadows", "grassland", "grassland"},
    {'R', "road", "road", "roads", "road", "roads"},
    {'W', "water", "lake", "lakes", "river", "rivers"},
};
constexpr Nouns kWild[] = {
    {'B', "grassland", "meadow", "meadows", "grassland", "grassland"},
    {'F', "forest", "grove", "groves", "forest", "forest"},
    {'R', "rock", "quarry", "quarries", "rock", "rock"},
    {'S', "snow", "glacier", "glaciers", "snow", "snow"},
    {'W', "water", "lake", "lakes", "river", "rivers"},
};

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

// "at least 3", "2 to 5", "3".
std::string BoundsInWords(double least, double most) {
  const bool has_least = least != Claim::kUnsaid && least > 0.0;
  const bool has_most = most != Claim::kUnsaid;
  if (has_least && has_most && least == most) return Number(least);
  if (has_least && has_most) return Number(least) + " to " + Number(most);
  if (has_most) return "at most " + Number(most);
  return "at least " + Number(has_least ? least : 0.0);
}

// Shares of the map, whole percents. A single number leaves eight points of room to either side
// (ShareOf), and stands for bounds that lie so far apart.
std::string PercentInWords(double least, double most) {
  constexpr double kTwiceTheRoom = 16.0;
  constexpr double kSome = 0.005;  // "at most 30 %" is some still
  const bool has_most = most != Claim::kUnsaid;
  if (least == Claim::kUnsaid || least < kSome) least = 0.0;
  const double low = std::round(100.0 * least);
  const double high = has_most ? std::round(100.0 * most) : Claim::kUnsaid;
  if (has_most && std::abs(high - low - kTwiceTheRoom) < 0.5) {
    return Number((low + high) / 2.0) + " %";
  }
  return BoundsInWords(low, high) + " %";
}

std::string OppositeName(Claim::Heading heading) {
  return HeadingName({-heading.east, -heading.south});
}

class ClaimSayer {
 public:
  ClaimSayer(const Claim& claim, Vocabulary vocabulary, const LandNames& names)
      : claim_(claim), vocabulary_(vocabulary), names_(names) {}

  std::vector<std::string> Say() {
    SayWhere();
    SayRelation();
    SayLine();
    for (const std::string& sentence : sentences_) {
      if (!ReadSentence(sentence, SentenceKind::kLayout).has_value()) return {};
    }
    return std::move(sentences_);
  }

 private:
  const Nouns& Of(char letter) const {
    const auto find = [letter](const auto& table) {
      return std::find_if(std::begin(table), std::end(table),
                          [letter](const Nouns& nouns) { return nouns.letter == letter; });
    };
    const Nouns* const found = vocabulary_ == Vocabulary::kSuburb ? find(kSuburb) : find(kWild);
    LW_CHECK(found != (vocabulary_ == Vocabulary::kSuburb ? std::end(kSuburb) : std::end(kWild)),
             "every class of the vocabulary has its nouns");
    return *found;
  }
  void Write(std::string_view form, const std::vector<Filling>& fillings) {
    sentences_.push_back(WriteSentence(SentenceKind::kLayout, form, fillings));
  }
  // Adds the place, where the zone is one.
  void WriteThere(std::string_view form, Filling what, const Zone& zone) {
    std::vector<Filling> fillings = {std::move(what)};
    if (!zone.is_anywhere()) fillings.emplace_back("zone", PlaceName(zone));
    Write(form, fillings);
  }

  // What sentences before call the land of a class; null: nothing.
  const std::string* NameOf(char letter) const {
    const auto name = names_.find(letter);
    return name != names_.end() ? &name->second : nullptr;
  }

  // What is said of the land of a class: its name, where it has one, else "the houses" but
  // "forest". A thing that is told by its place is placed first and has a label from then on.
  std::string Land(char letter, const Zone& zone, std::string_view label) {
    if (const std::string* name = NameOf(letter)) return *name;
    const Nouns& nouns = Of(letter);
    if (!zone.is_anywhere()) {
      std::string name = std::string(nouns.spread) + " " + std::string(label);
      WriteThere("there", {"x", name}, zone);
      return name;
    }
    const bool definite = nouns.spread == "road" || nouns.spread == "houses";
    return (definite ? "the " : "") + std::string(nouns.spread);
  }
  std::string Subject() { return Land(claim_.subject, claim_.zone, "A"); }
  std::string Object() { return Land(claim_.object, claim_.object_zone, "B"); }
  std::string The(std::string_view noun) const { return "the " + std::string(noun); }
  // The land of a class by its name, where it has one, else by this noun.
  std::string The(char letter, std::string_view noun) const {
    const std::string* name = NameOf(letter);
    return name != nullptr ? *name : The(noun);
  }

  // What there is: a line, one small thing or land, by how little of it is enough (ClaimsOfPlan).
  std::string Present() const {
    constexpr double kLineAtMost = 0.01;
    const Nouns& nouns = Of(claim_.subject);
    const bool little = claim_.least != Claim::kUnsaid && claim_.least <= kLineAtMost;
    if (vocabulary_ == Vocabulary::kSuburb && claim_.subject == 'R') return "a road";
    return little && claim_.subject == 'W' ? "a river" : std::string(nouns.spread);
  }

  void SayWhere() {
    const Nouns& nouns = Of(claim_.subject);
    const std::string noun(nouns.spread);
    // Each kind has a phrase of its own, which tells the zone if the claim has one.
    switch (claim_.kind) {
      case ClaimKind::kPresent:
        WriteThere("there", {"x", Present()}, claim_.zone);
        return;
      case ClaimKind::kAbsent:
        WriteThere("absent", {"noun", noun}, claim_.zone);
        return;
      case ClaimKind::kAmount: {
        std::vector<Filling> fillings = {{"x", noun},
                                         {"percent", PercentInWords(claim_.least, claim_.most)}};
        const bool all = claim_.zone.is_anywhere();
        if (!all) fillings.emplace_back("zone", PlaceName(claim_.zone));
        Write(all ? "cover" : "cover_zone", fillings);
        return;
      }
      case ClaimKind::kDominant:
        WriteThere("mostly", {"noun", noun}, claim_.zone);
        return;
      case ClaimKind::kMoreThan:
        Write("more", {{"noun", noun}, {"noun", std::string(Of(claim_.object).spread)}});
        return;
      case ClaimKind::kLocated: {
        constexpr double kOnly = 0.85;
        const bool only = claim_.least != Claim::kUnsaid && claim_.least > kOnly;
        WriteThere(only ? "only" : "most_in", {"noun", noun}, claim_.zone);
        return;
      }
      case ClaimKind::kCount: {
        const double least = claim_.least == Claim::kUnsaid ? 1.0 : claim_.least;
        const bool one = least == 1.0 && claim_.most == 1.0;
        const std::string_view pieces = one ? nouns.piece : nouns.pieces;
        WriteThere("there", {"x", BoundsInWords(least, claim_.most) + " " + std::string(pieces)},
                   claim_.zone);
        return;
      }
      case ClaimKind::kClustered:
        Write("together", {{"x", The(nouns.pieces)}});
        return;
      case ClaimKind::kScattered:
        Write("scattered", {{"x", The(nouns.pieces)}});
        return;
      case ClaimKind::kRest: {
        std::vector<Filling> fillings = {{"noun", noun}};
        if (!claim_.zone.is_anywhere()) fillings.emplace_back("zone", PlaceName(claim_.zone));
        Write("rest", fillings);
        return;
      }
      default:
        return;
    }
  }

  void SayTwo(std::string_view form) {
    std::string subject = Subject();
    std::string object = Object();
    Write(form, {{"x", std::move(subject)}, {"y", std::move(object)}});
  }
  void SayCells(std::string_view form, double cells) {
    std::string subject = Subject();
    std::string object = Object();
    Write(form, {{"x", std::move(subject)}, {"y", std::move(object)}, {"n", Number(cells)}});
  }

  void SayRelation() {
    const bool same = claim_.subject == claim_.object;
    // Each kind has a phrase of its own; pieces of one class have phrases apart.
    switch (claim_.kind) {
      case ClaimKind::kAdjacent: {
        const double most = claim_.most == Claim::kUnsaid ? 1.0 : claim_.most;
        if (same) return Write("touch_self", {{"x", The(Of(claim_.subject).pieces)}});
        if (most <= 2.0) return SayTwo("touch");
        if (most == 4.0) return SayTwo("near");
        return SayCells("near_cells", most);
      }
      case ClaimKind::kApart: {
        const double least = claim_.least == Claim::kUnsaid ? 3.0 : claim_.least;
        if (same) {
          return Write("apart_cells",
                       {{"x", The(Of(claim_.subject).pieces)}, {"n", Number(least)}});
        }
        return least == 3.0 ? SayTwo("away") : SayCells("away_cells", least);
      }
      case ClaimKind::kSurrounds:
        return SayTwo("surround");
      case ClaimKind::kWithin:
        return SayTwo("inside");
      case ClaimKind::kBothSides:
        return SayTwo("both_sides");
      case ClaimKind::kDirection: {
        std::string subject = Subject();
        std::string object = Object();
        return Write("heading", {{"x", std::move(subject)},
                                 {"heading", HeadingName(claim_.heading)},
                                 {"y", std::move(object)}});
      }
      case ClaimKind::kBetween:
        if (claim_.object == claim_.second_object) {
          return Write("between_all", {{"x", Subject()}, {"y", The(Of(claim_.object).pieces)}});
        }
        return Write("between", {{"x", Subject()},
                                 {"y", Land(claim_.object, {}, "")},
                                 {"z", Land(claim_.second_object, {}, "")}});
      case ClaimKind::kOrder: {
        std::string nouns;
        for (const char letter : claim_.sequence) {
          nouns += (nouns.empty() ? "" : ", ") + std::string(Of(letter).spread);
        }
        return Write("order", {{"heading", OppositeName(claim_.heading)},
                               {"heading", HeadingName(claim_.heading)},
                               {"nouns", std::move(nouns)}});
      }
      default:
        return;
    }
  }

  std::string Line(char letter) const { return The(letter, Of(letter).line); }

  void SayLine() {
    const Nouns& nouns = Of(claim_.subject);
    const bool same = claim_.subject == claim_.object;
    const std::string line = Line(claim_.subject);
    switch (claim_.kind) {
      case ClaimKind::kCourse:
        return Write("course", {{"x", "a " + std::string(nouns.line)},
                                {"end", EndName(claim_.from)},
                                {"end", EndName(claim_.to)}});
      case ClaimKind::kThrough:
        return Write("through",
                     {{"x", line}, {"end", The(claim_.object, Of(claim_.object).spread)}});
      case ClaimKind::kAlong:
        if (claim_.object == '\0')
          return Write("along", {{"x", line}, {"end", EndName(claim_.zone)}});
        return Write("lined", {{"x", Subject()}, {"end", Line(claim_.object)}});
      case ClaimKind::kCrosses:
        if (same) return Write("cross_self", {{"x", The(nouns.several_lines)}});
        return Write("cross", {{"x", line}, {"y", Line(claim_.object)}});
      case ClaimKind::kParallel:
        if (same) return Write("parallel", {{"x", The(nouns.several_lines)}});
        return Write("parallel", {{"x", line}, {"y", Line(claim_.object)}});
      case ClaimKind::kConnects:
        if (claim_.object == claim_.second_object) {
          return Write("connect_all", {{"x", line}, {"y", The(Of(claim_.object).pieces)}});
        }
        return Write("connect",
                     {{"x", line},
                      {"y", The(claim_.object, Of(claim_.object).spread)},
                      {"z", The(claim_.second_object, Of(claim_.second_object).spread)}});
      case ClaimKind::kShape:
        return SayShape();
      default:
        return;
    }
  }

  void SayShape() {
    const Nouns& nouns = Of(claim_.subject);
    constexpr std::pair<ClaimShape, std::string_view> kShapes[] = {
        {ClaimShape::kRound, "round"},       {ClaimShape::kElongated, "long"},
        {ClaimShape::kBent, "curved"},       {ClaimShape::kRing, "ring-shaped"},
        {ClaimShape::kStraight, "straight"}, {ClaimShape::kWinding, "winding"},
    };
    const auto* const found =
        std::find_if(std::begin(kShapes), std::end(kShapes),
                     [this](const auto& entry) { return entry.first == claim_.shape; });
    if (found == std::end(kShapes)) return Write("grid", {{"x", The(nouns.several_lines)}});
    const bool line = claim_.shape == ClaimShape::kStraight || claim_.shape == ClaimShape::kWinding;
    Write("shape", {{"x", The(claim_.subject, line ? nouns.line : nouns.spread)},
                    {"shape", std::string(found->second)}});
  }

  const Claim& claim_;
  const Vocabulary vocabulary_;
  const LandNames& names_;
  std::vector<std::string> sentences_;
};

// "3 lakes in the north" is two claims, that there is a lake in the north and that there are three,
// but one sentence: two would be read as two things. So the count takes the one place of its class.
std::vector<Claim> WithPlacedCounts(const std::vector<Claim>& claims) {
  std::vector<Claim> merged = claims;
  for (const Claim& count : claims) {
    if (count.kind != ClaimKind::kCount || !count.zone.is_anywhere()) continue;
    const auto is_place = [&count](const Claim& claim) {
      return claim.kind == ClaimKind::kPresent && claim.subject == count.subject;
    };
    const auto place = std::find_if(merged.begin(), merged.end(), is_place);
    if (std::count_if(merged.begin(), merged.end(), is_place) != 1) continue;
    Claim placed = count;
    placed.zone = place->zone;
    *place = std::move(placed);
    merged.erase(std::find_if(merged.begin(), merged.end(), [&count](const Claim& claim) {
      return claim.kind == ClaimKind::kCount && claim.subject == count.subject &&
             claim.zone.is_anywhere() && claim.words == count.words;
    }));
  }
  return merged;
}

}  // namespace

std::vector<std::string> SentencesOf(const Claim& claim, Vocabulary vocabulary) {
  return ClaimSayer(claim, vocabulary, {}).Say();
}

std::vector<std::string> SentencesOf(const std::vector<Claim>& claims, Vocabulary vocabulary,
                                     const LandNames& names) {
  std::vector<std::string> all;
  for (const Claim& claim : WithPlacedCounts(claims)) {
    for (std::string& sentence : ClaimSayer(claim, vocabulary, names).Say()) {
      if (std::find(all.begin(), all.end(), sentence) == all.end()) {
        all.push_back(std::move(sentence));
      }
    }
  }
  return all;
}

}  // namespace latticeworld
