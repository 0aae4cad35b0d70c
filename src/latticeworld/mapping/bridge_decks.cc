#include "latticeworld/mapping/bridge_decks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "latticeworld/common/parallel.h"
#include "latticeworld/mapping/prop_boxes.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr int kTiles = 64;  // a side of the world

int TileAlong(double from_m, double size_m) {
  return std::clamp(static_cast<int>(std::floor(kTiles * from_m / size_m)), 0, kTiles - 1);
}

}  // namespace

BridgeDecks::BridgeDecks(const GridGeometry& geometry, const std::vector<PropDeck>& decks)
    : geometry_(geometry), decks_(decks) {
  if (decks.empty()) return;
  tiles_.resize(kTiles * kTiles);
  const double half_m = geometry.half_size_m(), size_m = geometry.size_m();
  for (std::size_t i = 0; i < decks.size(); ++i) {
    const WorldPoint middle = decks[i].footprint.centre;
    const double reach_m = decks[i].footprint.radius_m();
    const int last_x = TileAlong(middle.x_m + reach_m + half_m, size_m);
    const int last_y = TileAlong(middle.y_m + reach_m + half_m, size_m);
    for (int y = TileAlong(middle.y_m - reach_m + half_m, size_m); y <= last_y; ++y) {
      for (int x = TileAlong(middle.x_m - reach_m + half_m, size_m); x <= last_x; ++x) {
        tiles_[y * kTiles + x].push_back(i);
      }
    }
  }
}

std::size_t BridgeDecks::TileOf(WorldPoint point) const {
  const double half_m = geometry_.half_size_m(), size_m = geometry_.size_m();
  return TileAlong(point.y_m + half_m, size_m) * kTiles + TileAlong(point.x_m + half_m, size_m);
}

const PropDeck* BridgeDecks::At(WorldPoint point) const {
  if (empty()) return nullptr;
  const PropDeck* highest = nullptr;
  for (const std::size_t i : tiles_[TileOf(point)]) {
    const PropDeck& deck = decks_[i];
    const Footprint& footprint = deck.footprint;
    const double dx = point.x_m - footprint.centre.x_m, dy = point.y_m - footprint.centre.y_m;
    const double cosine = std::cos(footprint.yaw_rad), sine = std::sin(footprint.yaw_rad);
    if (std::abs(cosine * dx + sine * dy) > footprint.half_length_m) continue;
    if (std::abs(cosine * dy - sine * dx) > footprint.half_width_m) continue;
    if (highest == nullptr || deck.top_m > highest->top_m) highest = &deck;
  }
  return highest;
}

Grid<float> BuildDeckHeight(const Scene& scene, const SceneChanges& changes, int threads) {
  const GridGeometry& geometry = scene.geometry();
  const std::shared_ptr<const StandingProps> props = PropsIn(scene, changes);
  const BridgeDecks decks(geometry, props->decks);
  Grid<float> height_m(geometry.rows(), geometry.cols(), std::numeric_limits<float>::quiet_NaN());
  if (decks.empty()) return height_m;
  ParallelFor(geometry.rows(), threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int col = 0; col < geometry.cols(); ++col) {
        const PropDeck* deck = decks.At(geometry.CenterOf({row, col}));
        if (deck != nullptr) height_m(row, col) = static_cast<float>(deck->top_m);
      }
    }
  });
  return height_m;
}

HeightField DrivenSurface(const Scene& scene, const RobotLimits& limits,
                          const SceneChanges& changes) {
  const HeightField& ground = scene.terrain->ground;
  const std::shared_ptr<const StandingProps> props = PropsIn(scene, changes);
  Grid<float> height_m = ground.height_m();
  const CellWindow all = {0, height_m.rows(), 0, height_m.cols()};
  for (const PropDeck& deck : props->decks) {
    if (deck.carries_kg < limits.mass_kg) continue;
    ForEachCellOf(deck, ground, limits, all, [&](int row, int col, DeckEffect) {
      float& height = height_m(row, col);
      height = std::max(height, static_cast<float>(deck.top_m));
    });
  }
  return HeightField(ground.geometry(), std::move(height_m));
}

}  // namespace latticeworld
