#include "latticeworld/scene/tally.h"

#include <cmath>
#include <string_view>

namespace latticeworld {
namespace {

constexpr double kClearlyFewer = 0.8;  // of what was wanted
constexpr int kFewestMissing = 10;

// A house that was asked for is missed at once, a few tufts are not.
bool IsClearlyFewer(const KindCount& count) {
  if (count.placed >= kClearlyFewer * count.wanted) return false;
  return count.placed == 0 || count.kind == AssetKind::kBuilding ||
         count.wanted - count.placed >= kFewestMissing;
}

std::string_view WordsFor(Refusal refusal) {
  switch (refusal) {
    case Refusal::kWaterOrRoad:
      return "there is water, a road or the edge of the world";
    case Refusal::kTooSteep:
      return "the ground is too steep";
    case Refusal::kOccupied:
      return "something solid stands in the way";
    case Refusal::kHabitat:
      return "no model of the catalogue grows";
    case Refusal::kNone:
      break;
  }
  return "";
}

}  // namespace

std::vector<KindCount> Tally::Count(const std::vector<Asset>& assets) const {
  std::vector<KindCount> counts;
  counts.reserve(kAssetKindCount);
  for (const auto& kind : EnumNames(AssetKind{})) {
    counts.push_back({kind.value, static_cast<int>(std::lround(Of(kind.value).wanted)), 0});
  }
  for (const Asset& asset : assets) ++counts[static_cast<std::size_t>(asset.kind)].placed;
  return counts;
}

std::vector<std::string> Tally::Shortfalls(const std::vector<KindCount>& counts) const {
  std::vector<std::string> warnings;
  for (const KindCount& count : counts) {
    if (!IsClearlyFewer(count)) continue;
    std::string text = "placed " + std::to_string(count.placed) + " of the " +
                       std::to_string(count.wanted) + " " + std::string(NameOf(count.kind)) +
                       " assets that the densities ask for";
    std::string_view separator = ": ";
    const Kind& kind = Of(count.kind);
    for (int i = 1; i < kRefusalCount; ++i) {
      if (kind.refused[i] == 0) continue;
      text += std::string(separator) + "at " + std::to_string(kind.refused[i]) + " places " +
              std::string(WordsFor(static_cast<Refusal>(i)));
      separator = ", ";
    }
    if (separator == ": ") text += ": fewer places suit than the densities ask for";
    warnings.push_back(std::move(text));
  }
  return warnings;
}

}  // namespace latticeworld
