#include "latticeworld/scene/vegetation/scatter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/scene/vegetation/blue_noise.h"

namespace latticeworld {
namespace {

constexpr int kNeedSamples = 256;    // a side of the world: where densities are looked at
constexpr double kMostStep_m = 8.0;  // so that thin bands are seen
constexpr int kTilesPerBlock = 16;   // worked on together

// The largest MostAt in a box, by samples.
double MostIn(const ScatterDensity& density, const GridGeometry& geometry, WorldPoint low,
              WorldPoint high) {
  const CellIndex north_west = geometry.CellAt({low.x_m, high.y_m});
  const CellIndex south_east = geometry.CellAt({high.x_m, low.y_m});
  const int width = south_east.col - north_west.col + 1;
  const int step = std::max(1, std::min({width / 4, geometry.rows() / kNeedSamples,
                                         static_cast<int>(kMostStep_m / geometry.resolution_m())}));
  const int last = geometry.rows() - 1;
  double most = 0.0;
  // A step further on every side: what begins between two samples is seen from the next.
  for (int row = north_west.row - step; row <= south_east.row + step; row += step) {
    for (int col = north_west.col - step; col <= south_east.col + step; col += step) {
      most = std::max(most, density.MostAt({std::clamp(row, 0, last), std::clamp(col, 0, last)}));
    }
  }
  return most;
}

// Crowns reach over small things, not far into houses.
bool IsInTheWay(const SolidSet& solids, const Asset& asset) {
  constexpr double kOfCrown = 0.4;
  return solids.Overlaps(asset.position(), SolidRadius(asset)) ||
         (asset.kind == AssetKind::kTree &&
          solids.OverlapsLarge(asset.position(), kOfCrown * asset.half_length_m));
}

// What was made on some tiles, in their order.
struct Block {
  std::vector<Asset> assets;
  Tally::Kind tally;
};

// Every place by itself.
std::vector<Block> MakeBlocks(const Placement& placement, AssetKind kind, std::string_view stream,
                              const ScatterDensity& density, const MakeAt& make) {
  const Terrain& terrain = placement.terrain;
  const double largest = density.largest_per_m2();
  const std::uint64_t seed = StreamSeed(placement.seed, stream);
  // Candidates are ranked blue noise: a place stays if its rank is below the density there.
  const RankedBlueNoise noise(
      terrain.geometry().size_m(), largest, seed,
      [&](WorldPoint low, WorldPoint high) {
        return MostIn(density, terrain.geometry(), low, high) / largest;
      },
      placement.threads);

  // Blocks are worked on side by side; random numbers depend on the candidate alone.
  std::vector<Block> blocks((noise.tiles() + kTilesPerBlock - 1) / kTilesPerBlock);
  const std::uint64_t place_seed = StreamSeed(seed, "places");
  const auto work = [&](int index) {
    Block& block = blocks[index];
    const int end = std::min(noise.tiles(), (index + 1) * kTilesPerBlock);
    for (int tile = index * kTilesPerBlock; tile < end; ++tile) {
      noise.ForEachIn(tile, [&](const RankedBlueNoise::Point& candidate) {
        ScatterPlace place;
        place.point = {candidate.x_m, candidate.y_m};
        const double rank = candidate.rank * largest;
        // The cheap bound is asked before the density.
        if (rank >= density.MostAt(terrain.geometry().CellAt(place.point))) return;
        PointRandom random(place_seed, candidate.id);
        place.per_m2 = density.At(place.point, random.Uniform(), &place.letter);
        if (rank >= place.per_m2) return;
        Asset asset;
        asset.kind = kind;
        StandAt(terrain, place.point, &asset);
        const Refusal refusal = make(place, &random, &asset);
        if (refusal == Refusal::kNone) {
          block.assets.push_back(asset);
        } else {
          block.tally.Refuse(refusal);
        }
      });
    }
  };
  ParallelFor(static_cast<int>(blocks.size()), placement.threads, [&](int begin, int end) {
    for (int index = begin; index < end; ++index) work(index);
  });
  return blocks;
}

}  // namespace

void StandAt(const Terrain& terrain, WorldPoint point, Asset* asset) {
  asset->x_m = static_cast<float>(point.x_m);
  asset->y_m = static_cast<float>(point.y_m);
  asset->z_m = static_cast<float>(terrain.ground.HeightAt(asset->position()));
}

void Scatter(Placement* placement, AssetKind kind, std::string_view stream,
             const ScatterDensity& density, const MakeAt& make) {
  if (density.largest_per_m2() <= 0.0) return;
  std::vector<Block> blocks = MakeBlocks(*placement, kind, stream, density, make);
  // Assets are added in the order of their blocks, but for solid ones that stand in another's way.
  const bool solid = IsSolid(kind);
  std::size_t made = 0;
  for (const Block& block : blocks) made += block.assets.size();
  placement->assets.reserve(placement->assets.size() + made);
  Tally::Kind& tally = placement->tally.Of(kind);
  for (Block& block : blocks) {
    for (int i = 0; i < kRefusalCount; ++i) tally.refused[i] += block.tally.refused[i];
    for (const Asset& asset : block.assets) {
      if (solid && IsInTheWay(placement->solids, asset)) {
        tally.Refuse(Refusal::kOccupied);
      } else {
        AddAsset(placement, asset);
      }
    }
    block.assets = std::vector<Asset>();
  }
}

}  // namespace latticeworld
