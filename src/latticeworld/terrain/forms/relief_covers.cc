#include "latticeworld/terrain/forms/relief_covers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "latticeworld/layout/class_letters.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/terrain/cover.h"
#include "latticeworld/terrain/forms/relief_claim_list.h"

namespace latticeworld {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kBorder_m = 1.0f;      // to either side of a height, in which classes mix
constexpr double kMargin_m = 2.0;      // around it, that no claim is about
constexpr double kLeastCovered = 0.8;  // of the ground on the cover's side
constexpr double kLeastFree = 0.9;     // of the ground on the other

// Land that nobody has made, and that is no water.
bool IsOpen(Vocabulary vocabulary, char letter) {
  return letter != class_letter::kWater && !IsManMade(vocabulary, letter);
}

// What lies where a class ends: below snow is rock, beyond a forest is grass.
char NextTo(Vocabulary vocabulary, char letter) {
  if (vocabulary == Vocabulary::kSuburb) {
    return letter == suburb_letter::kGrassland ? suburb_letter::kBarren : suburb_letter::kGrassland;
  }
  const bool beside_rock = letter == wild_letter::kSnow || letter == wild_letter::kGrassland;
  return beside_rock ? wild_letter::kRock : wild_letter::kGrassland;
}

struct HeightRange {
  float low = -kInfinity;
  float high = kInfinity;
  bool Holds(double height_m, double margin_m) const {
    return height_m > low + margin_m && height_m < high - margin_m;
  }
};

// The heights that a cover has to itself.
HeightRange RangeOf(const HeightCover& cover, const std::vector<HeightCover>& covers) {
  HeightRange range;
  const auto own_m = static_cast<float>(cover.height_m);
  (cover.above ? range.low : range.high) = own_m;
  for (const HeightCover& other : covers) {
    const auto height_m = static_cast<float>(other.height_m);
    if (other.above != cover.above || other.letter == cover.letter) continue;
    if (cover.above && height_m > own_m) range.high = std::min(range.high, height_m);
    if (!cover.above && height_m < own_m) range.low = std::max(range.low, height_m);
  }
  return range;
}

// Returns a share that rises from 0 below the limit to 1 above it.
float ShareAbove(float height_m, float limit_m) {
  if (std::isinf(limit_m)) return limit_m < 0.0f ? 1.0f : 0.0f;
  return std::clamp(0.5f + 0.5f * (height_m - limit_m) / kBorder_m, 0.0f, 1.0f);
}

Grid<float>& MaskOf(char letter, const Grid<float>& like, SmoothedMasks* masks) {
  auto at = std::find_if(masks->classes.begin(), masks->classes.end(),
                         [letter](const SmoothedMask& mask) { return mask.letter >= letter; });
  if (at == masks->classes.end() || at->letter != letter) {
    at = masks->classes.insert(at, {letter, Grid<float>(like.rows(), like.cols(), 0.0f)});
  }
  return at->weight;
}

// Moves a share of the open land of every cell to a class.
void Give(char letter, const Grid<float>& share, SmoothedMasks* masks) {
  Grid<float>& own = MaskOf(letter, share, masks);
  for (SmoothedMask& mask : masks->classes) {
    if (mask.letter == letter || !IsOpen(masks->vocabulary, mask.letter)) continue;
    for (std::size_t i = 0; i < share.size(); ++i) {
      const float moved = share.data()[i] * mask.weight.data()[i];
      mask.weight.data()[i] -= moved;
      own.data()[i] += moved;
    }
  }
}

// Takes a share of a class away in every cell, for what lies beyond it.
void TakeAway(char letter, const Grid<float>& share, SmoothedMasks* masks) {
  const char next = NextTo(masks->vocabulary, letter);
  MaskOf(letter, share, masks);  // both are there before either is looked up
  Grid<float>& to = MaskOf(next, share, masks);
  Grid<float>& own = MaskOf(letter, share, masks);
  for (std::size_t i = 0; i < share.size(); ++i) {
    const float moved = share.data()[i] * own.data()[i];
    own.data()[i] -= moved;
    to.data()[i] += moved;
  }
}

}  // namespace

namespace internal {

void CoverByHeight(const std::vector<HeightCover>& covers, const Grid<float>& height_m,
                   SmoothedMasks* masks) {
  for (const HeightCover& cover : covers) {
    const HeightRange range = RangeOf(cover, covers);
    Grid<float> inside(height_m.rows(), height_m.cols());
    Grid<float> beyond(height_m.rows(), height_m.cols());
    const auto limit_m = static_cast<float>(cover.height_m);
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const float height = height_m.data()[i];
      const float above = ShareAbove(height, limit_m);
      inside.data()[i] = ShareAbove(height, range.low) * (1.0f - ShareAbove(height, range.high));
      beyond.data()[i] = cover.above ? 1.0f - above : above;
    }
    TakeAway(cover.letter, beyond, masks);
    Give(cover.letter, inside, masks);
  }
}

}  // namespace internal

std::vector<ReliefMeasure> MeasureCovers(const std::vector<HeightCover>& covers,
                                         const Terrain& terrain) {
  internal::ReliefClaimList claims;
  const Vocabulary vocabulary = terrain.weights.vocabulary;
  const Grid<float>& height_m = terrain.ground.height_m();
  for (const HeightCover& cover : covers) {
    const HeightRange range = RangeOf(cover, covers);
    HeightRange other_side;
    (cover.above ? other_side.high : other_side.low) = static_cast<float>(cover.height_m);
    const SurfaceClass asked = internal::SurfaceOf(vocabulary, cover.letter);
    // Open land is counted within the cover's range, and on the other side of its height.
    int inside = 0, covered = 0, outside = 0, free = 0;
    for (std::size_t i = 0; i < height_m.size(); ++i) {
      const SurfaceClass surface = terrain.surface.data()[i];
      const bool made = surface == SurfaceClass::kRoad || surface == SurfaceClass::kBuilding ||
                        surface == SurfaceClass::kFarmland;
      if (made || !std::isnan(terrain.water_level_m.data()[i])) continue;
      const double height = height_m.data()[i];
      if (range.Holds(height, kMargin_m)) {
        ++inside;
        if (surface == asked) ++covered;
      } else if (other_side.Holds(height, kMargin_m)) {
        ++outside;
        if (surface != asked) ++free;
      }
    }
    // The claim holds if enough is covered within, and enough is free of it beyond.
    const std::string name(FindClass(vocabulary, cover.letter)->name);
    const std::string side =
        (cover.above ? " above " : " below ") + internal::Metres(cover.height_m);
    if (inside == 0) {
      claims.Add("relief_cover", cover.words, false, 1.0, "no open land lies" + side);
      continue;
    }
    const double share = static_cast<double>(covered) / inside;
    const double free_share = outside == 0 ? 1.0 : static_cast<double>(free) / outside;
    claims.Add("relief_cover", cover.words, share >= kLeastCovered && free_share >= kLeastFree,
               std::max(1.0 - share, 1.0 - free_share),
               name + " covers " + internal::Percent(share) + " of the open land" + side + " and " +
                   internal::Percent(1.0 - free_share) +
                   " of what lies on the other side; at least " + internal::Percent(kLeastCovered) +
                   " and at most " + internal::Percent(1.0 - kLeastFree) + " are asked");
  }
  return claims.Take();
}

}  // namespace latticeworld
