#include "latticeworld/language/reading/things/sentence_things.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

constexpr double kPercentRoom = 0.08;  // that "30 %" leaves to either side
constexpr double kMostCounted = 1000.0;

// The bounds of a phrase with one or two numbers: "at least 3", "2 to 4", "5".
struct Bounds {
  double least = 0.0;
  double most = 0.0;
  bool open_below = false;
  bool open_above = false;
};
Bounds BoundsOf(const Phrase& phrase) {
  const std::vector<const Phrase*> numbers = phrase.FindAll("n");
  Bounds bounds;
  bounds.least = NumberOf(*numbers.front());
  bounds.most = NumberOf(*numbers.back());
  if (bounds.least > bounds.most) std::swap(bounds.least, bounds.most);
  bounds.open_above = StartsWith(phrase.text, "at least");
  bounds.open_below = StartsWith(phrase.text, "at most");
  return bounds;
}

CountMatch CountOf(const Phrase& quantity) {
  const Bounds bounds = BoundsOf(quantity);
  const auto whole = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0, kMostCounted)));
  };
  CountMatch count;
  count.least = bounds.open_below ? 0 : whole(bounds.least);
  count.most = bounds.open_above ? CountMatch::kUnbounded : whole(bounds.most);
  count.tokens = 1;
  return count;
}

// The noun whose class a noun of the small language has, where the table of classes takes its word
// otherwise: a farm is its buildings, its land is fields.
std::string_view ClassNoun(std::string_view noun) {
  if (noun == "farm") return "farmhouse";
  if (noun == "farms") return "farmhouses";
  return noun;
}

}  // namespace

bool IsSaidSingly(const Phrase& thing) {
  return thing.Has("quantity") || StartsWith(thing.text, "a ") || StartsWith(thing.text, "an ");
}

double NumberOf(const Phrase& phrase) { return std::strtod(phrase.text.c_str(), nullptr); }

ShareMatch ShareOf(const Phrase& percent) {
  constexpr double kSome = 0.002;
  Bounds bounds = BoundsOf(percent);
  const double low = std::clamp(bounds.least / 100.0, 0.0, 1.0);
  const double high = std::clamp(bounds.most / 100.0, 0.0, 1.0);
  ShareMatch share;
  share.fraction = true;
  share.tokens = 1;
  if (bounds.open_above) {
    share.least = low;
    share.value = std::min(1.0, low + kPercentRoom);
  } else if (bounds.open_below) {
    share.least = kSome;
    share.most = high;
    share.value = 0.7 * high;
  } else {
    const double room = low == high ? kPercentRoom : 0.0;
    share.value = (low + high) / 2.0;
    share.least = std::max(low - room, std::min(low, kSome));
    share.most = std::min(1.0, high + room);
  }
  return share;
}

void AddSize(std::string_view size, Qualities* qualities) {
  constexpr double kLargeShare = 0.08;
  qualities->size *= size == "tiny" ? 0.25 : size == "small" ? 0.5 : size == "large" ? 1.8 : 3.0;
  if (size == "large" || size == "huge") qualities->least_share = kLargeShare;
  qualities->any = true;
}

void AddShape(std::string_view shape, Qualities* qualities) {
  constexpr std::pair<std::string_view, ClaimShape> kShapes[] = {
      {"round", ClaimShape::kRound},       {"long", ClaimShape::kElongated},
      {"curved", ClaimShape::kBent},       {"ring-shaped", ClaimShape::kRing},
      {"straight", ClaimShape::kStraight}, {"winding", ClaimShape::kWinding},
  };
  for (const auto& [name, which] : kShapes)
    if (name == shape) qualities->shape = which;
  qualities->any = true;
}

NounPhrase NounOf(const Phrase& thing) {
  NounPhrase phrase;
  const Phrase* noun = thing.slot == "noun" ? &thing : thing.Find("noun");
  const std::vector<Token> tokens = Tokenize(ClassNoun(noun->text));
  const ClassWordMatch match = MatchClassWord(tokens, 0);
  phrase.noun = match.word;
  phrase.plural = match.plural;
  phrase.definite = StartsWith(thing.text, "the ");
  phrase.indefinite = StartsWith(thing.text, "a ") || StartsWith(thing.text, "an ");
  for (const Phrase* size : thing.FindAll("size")) AddSize(size->text, &phrase.qualities);
  for (const Phrase* shape : thing.FindAll("shape")) AddShape(shape->text, &phrase.qualities);
  if (const Phrase* quantity = thing.Find("quantity"); quantity != nullptr) {
    phrase.qualities.count = CountOf(*quantity);
    phrase.qualities.any = true;
  }
  return phrase;
}

}  // namespace latticeworld
