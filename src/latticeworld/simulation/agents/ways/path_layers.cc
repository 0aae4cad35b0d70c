#include "latticeworld/simulation/agents/ways/path_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "latticeworld/simulation/agents/ways/solid_clearance.h"

namespace latticeworld {
namespace {

constexpr double kCell_m = 1.0;  // of a path's cell, at most, where the scene is not coarser

double RoundUp(double value, double step) { return std::ceil(value / step - 1e-9) * step; }
double RoundDown(double value, double step) { return std::floor(value / step + 1e-9) * step; }

// Poses of trees that lie, in steps: one that rocks in water must not make the map anew all the
// time.
Eigen::Vector3d Rounded(const Eigen::Vector3d& point_m) {
  constexpr double kStep_m = 0.1;
  return (point_m / kStep_m).array().round() * kStep_m;
}

bool IsSame(const FallenTree& a, const FallenTree& b) {
  return a.asset == b.asset && a.foot_m == b.foot_m && a.tip_m == b.tip_m;
}

RobotLimits LimitsOf(const BodyClass& body) {
  RobotLimits limits;
  limits.radius_m = body.radius_m;
  limits.max_slope_rad = body.max_slope_rad;
  limits.max_fording_depth_m = body.wade_depth_m;
  limits.clearance_m = 0.0;  // agents push through crowns
  limits.mass_kg = body.mass_kg;
  limits.grip = body.grip;
  limits.on_wheels = body.on_wheels;
  return limits;
}

}  // namespace

BodyClass ClassOf(const Species& species) {
  BodyClass body;
  body.swims = species.plan == BodyPlan::kSwimmer;
  body.radius_m = RoundUp(species.radius_m + kPathClearance_m, 0.1);
  body.height_m = RoundUp(species.height_m, 0.5);
  if (body.swims) {
    body.wade_depth_m = RoundUp(species.wade_depth_m, 0.1);
    body.max_slope_rad = body.grip = body.mass_kg = 0.0;
  } else {
    body.wade_depth_m = std::max(0.0, RoundDown(species.wade_depth_m, 0.05));
    body.max_slope_rad = std::clamp(RoundDown(species.max_slope_rad, 0.02), 0.02, 1.5);
    body.grip = std::max(0.1, RoundDown(species.grip, 0.1));
    body.on_wheels = species.plan == BodyPlan::kVehicle;
    body.mass_kg = std::exp2(std::ceil(std::log2(species.mass_kg)));
  }
  return body;
}

struct PathLayers::Layer {
  Layer(const PathLayers* layers, const BodyClass& the_body, int cells, double cell_m,
        WorldPoint north_west)
      : body(the_body),
        map(cells, cell_m, north_west, [layers, this](int row, int col, PathLayer::Tile* ease) {
          if (body.swims) {
            layers->FillInWater(body, row, col, ease);
          } else {
            layers->FillOnGround(*this, row, col, ease);
          }
          layers->BlockBelowStems(body, row, col, ease);
        }) {
    if (!body.swims) window.emplace(layers->scene_, LimitsOf(body), layers->scene_cells_);
  }
  Layer(const Layer&) = delete;
  Layer& operator=(const Layer&) = delete;

  const BodyClass body;
  std::optional<TraversabilityWindow> window;  // none: it swims
  PathLayer map;
};

PathLayers::PathLayers(const Scene& scene)
    : scene_(scene),
      scene_cells_(std::max(1, static_cast<int>(kCell_m / scene.geometry().resolution_m()))) {
  changes_.props = PropsIn(scene, changes_);
}

PathLayers::~PathLayers() = default;

PathLayer& PathLayers::Of(const Species& species) {
  const BodyClass body = ClassOf(species);
  for (const std::unique_ptr<Layer>& layer : layers_) {
    if (layer->body == body) return layer->map;
  }
  const GridGeometry& geometry = scene_.geometry();
  const int cells = (geometry.rows() + scene_cells_ - 1) / scene_cells_;
  const double half_m = geometry.half_size_m();
  layers_.push_back(
      std::make_unique<Layer>(this, body, cells, cell_m(), WorldPoint{-half_m, half_m}));
  return layers_.back()->map;
}

void PathLayers::FillOnGround(const Layer& layer, int row, int col, PathLayer::Tile* ease) const {
  const GridGeometry& geometry = scene_.geometry();
  const CellWindow window{
      row * scene_cells_, std::min((row + PathLayer::kTile) * scene_cells_, geometry.rows()),
      col * scene_cells_, std::min((col + PathLayer::kTile) * scene_cells_, geometry.cols())};
  std::vector<float> values(static_cast<std::size_t>(window.rows()) * window.cols());
  SceneChanges standing;  // stems that lie are looked at with the body's height
  standing.gone = changes_.gone;
  for (const FallenTree& tree : changes_.fallen) standing.gone.push_back(tree.asset);
  std::sort(standing.gone.begin(), standing.gone.end());
  standing.props = changes_.props;
  standing.ground = changes_.ground;
  layer.window->Fill(window, standing, values.data());

  std::array<float, PathLayer::kTile> least;
  for (int r = 0; r < PathLayer::kTile; ++r) {
    least.fill(1.0f);
    const int begin = (row + r) * scene_cells_;
    for (int y = begin; y < std::min(begin + scene_cells_, window.row_end); ++y) {
      const float* const line =
          values.data() + static_cast<std::size_t>(y - window.row_begin) * window.cols();
      for (int x = 0; x < window.cols(); ++x) {
        float& cell = least[static_cast<std::size_t>(x / scene_cells_)];
        cell = std::min(cell, line[x]);
      }
    }
    for (int c = 0; c < PathLayer::kTile; ++c) {
      const float value = least[static_cast<std::size_t>(c)];
      (*ease)[static_cast<std::size_t>(r) * PathLayer::kTile + c] =
          value > 0.0f ? static_cast<std::uint8_t>(std::max(1.0f, value * 255.0f)) : 0;
    }
  }
}

void PathLayers::FillInWater(const BodyClass& body, int row, int col, PathLayer::Tile* ease) const {
  const auto is_free = [&](WorldPoint center) {
    const double beside_m = body.radius_m;
    for (const WorldPoint off :
         {WorldPoint{0.0, 0.0}, WorldPoint{beside_m, 0.0}, WorldPoint{-beside_m, 0.0},
          WorldPoint{0.0, beside_m}, WorldPoint{0.0, -beside_m}}) {
      const WorldPoint point{center.x_m + off.x_m, center.y_m + off.y_m};
      if (!scene_.geometry().Contains(point) ||
          scene_.terrain->WaterDepthAt(point) < body.wade_depth_m)
        return false;
    }
    const double surface_m = scene_.terrain->water_level_m[scene_.geometry().CellAt(center)];
    for (const auto* const blocks : {&changes_.props->blocks, &changes_.props->below}) {
      for (const PropBlock& block : *blocks) {
        if (block.bottom_m < surface_m && GapTo(block.footprint, center) < beside_m) return false;
      }
    }
    bool clear = true;
    scene_.index.ForEachNear(center, beside_m, [&](std::uint32_t asset) {
      clear = clear &&
              (!SolidContains(scene_.assets[asset], center, beside_m) || !changes_.Stands(asset));
    });
    return clear;
  };
  for (int r = 0; r < PathLayer::kTile; ++r) {
    for (int c = 0; c < PathLayer::kTile; ++c)
      (*ease)[static_cast<std::size_t>(r) * PathLayer::kTile + c] =
          is_free(CenterOf(row + r, col + c)) ? 255 : 0;
  }
}

void PathLayers::BlockBelowStems(const BodyClass& body, int row, int col,
                                 PathLayer::Tile* ease) const {
  const GridGeometry& geometry = scene_.geometry();
  for (const FallenTree& tree : changes_.fallen) {
    const double trunk_m = scene_.assets[tree.asset].trunk_radius_m;
    const double reach_m = trunk_m + body.radius_m;
    // The cells of the tile that the stem may come near.
    const auto first = [&](double from_edge_m) {
      return std::max(0.0, std::floor((from_edge_m - reach_m) / cell_m()));
    };
    const auto last = [&](double from_edge_m) {
      return std::min(PathLayer::kTile - 1.0, std::floor((from_edge_m + reach_m) / cell_m()));
    };
    const double north_m = geometry.half_size_m() - row * cell_m();
    const double west_m = -geometry.half_size_m() + col * cell_m();
    const auto row_end =
        static_cast<int>(last(north_m - std::min(tree.foot_m.y(), tree.tip_m.y())));
    const auto col_end = static_cast<int>(last(std::max(tree.foot_m.x(), tree.tip_m.x()) - west_m));
    for (auto r = static_cast<int>(first(north_m - std::max(tree.foot_m.y(), tree.tip_m.y())));
         r <= row_end; ++r) {
      for (auto c = static_cast<int>(first(std::min(tree.foot_m.x(), tree.tip_m.x()) - west_m));
           c <= col_end; ++c) {
        const WorldPoint center = CenterOf(row + r, col + c);
        if (StemDistance(tree, scene_.terrain->ground, trunk_m, center, center, body.height_m) <
            body.radius_m)
          (*ease)[static_cast<std::size_t>(r) * PathLayer::kTile + c] = 0;
      }
    }
  }
}

void PathLayers::Forget(std::uint32_t asset) {
  for (const std::unique_ptr<Layer>& layer : layers_)
    layer->map.Forget(scene_.assets[asset].position(),
                      SolidRadius(scene_.assets[asset]) + layer->body.radius_m + 2.0 * cell_m());
}

void PathLayers::Forget(const FallenTree& tree) {
  const Eigen::Vector3d middle_m = 0.5 * (tree.foot_m + tree.tip_m);
  const double reach_m = 0.5 * (tree.tip_m - tree.foot_m).head<2>().cwiseAbs().maxCoeff() +
                         scene_.assets[tree.asset].trunk_radius_m;
  for (const std::unique_ptr<Layer>& layer : layers_)
    layer->map.Forget({middle_m.x(), middle_m.y()},
                      reach_m + layer->body.radius_m + 2.0 * cell_m());
}

void PathLayers::Forget(const Footprint& footprint) {
  for (const std::unique_ptr<Layer>& layer : layers_)
    layer->map.Forget(footprint.centre,
                      footprint.radius_m() + layer->body.radius_m + 2.0 * cell_m());
}

void PathLayers::ForgetDifferent(const StandingProps& before, const StandingProps& after) {
  const auto forget = [this](const auto& from, const auto& but) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const bool is_in_place = i < but.size() && from[i] == but[i];
      if (!is_in_place && std::find(but.begin(), but.end(), from[i]) == but.end())
        Forget(from[i].footprint);
    }
  };
  forget(before.blocks, after.blocks);
  forget(after.blocks, before.blocks);
  forget(before.decks, after.decks);
  forget(after.decks, before.decks);
}

void PathLayers::Update(const SceneChanges& changes) {
  if (changes.props != changes_.props) {
    const std::shared_ptr<const StandingProps> props = PropsIn(scene_, changes);
    ForgetDifferent(*changes_.props, *props);
    changes_.props = props;
  }
  if (changes.ground != changes_.ground) {
    for (const std::unique_ptr<Layer>& layer : layers_) {
      if (!layer->body.swims) layer->map.Forget({0.0, 0.0}, scene_.geometry().half_size_m());
    }
    changes_.ground = changes.ground;
  }
  if (changes.empty() && changes_.empty()) return;
  SceneChanges rounded = changes;
  rounded.props = changes_.props;
  for (FallenTree& tree : rounded.fallen) {
    tree.foot_m = Rounded(tree.foot_m);
    tree.tip_m = Rounded(tree.tip_m);
  }
  // Both lists are in the order of assets.
  std::swap(changes_, rounded);
  const SceneChanges& before = rounded;
  auto was = before.fallen.begin();
  auto is = changes_.fallen.begin();
  while (was != before.fallen.end() || is != changes_.fallen.end()) {
    const bool gone =
        is == changes_.fallen.end() || (was != before.fallen.end() && was->asset < is->asset);
    const bool came = !gone && (was == before.fallen.end() || is->asset < was->asset);
    if (gone || came) {
      const FallenTree& tree = gone ? *was++ : *is++;
      Forget(tree.asset);
      Forget(tree);
    } else {
      if (!IsSame(*was, *is)) {
        Forget(*was);
        Forget(*is);
      }
      ++was, ++is;
    }
  }
  if (before.gone != changes_.gone) {
    std::vector<std::uint32_t> different;
    std::set_symmetric_difference(before.gone.begin(), before.gone.end(), changes_.gone.begin(),
                                  changes_.gone.end(), std::back_inserter(different));
    for (const std::uint32_t asset : different) Forget(asset);
  }
}

}  // namespace latticeworld
