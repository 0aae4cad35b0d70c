#include "latticeworld_ros/world_markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld_ros/agent_conversion.h"
#include "latticeworld_ros/marker_pieces.h"

namespace latticeworld {
namespace {

using PartColors = std::array<Rgb, kMeshPartCount>;

std_msgs::ColorRGBA Color(float r, float g, float b, float a = 1.0f) {
  std_msgs::ColorRGBA color;
  color.r = r;
  color.g = g;
  color.b = b;
  color.a = a;
  return color;
}

std_msgs::ColorRGBA ColorOf(const PartColors& colors, MeshPart part) {
  const Rgb& rgb = colors[static_cast<std::size_t>(part)];
  return Color(rgb.r / 255.0f, rgb.g / 255.0f, rgb.b / 255.0f);
}

geometry_msgs::Point Point(double x, double y, double z) {
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

// The classes' colours at a cell, mixed by their weights.
std_msgs::ColorRGBA GroundColor(const ClassWeights& weights, CellIndex cell) {
  float r = 0.0f, g = 0.0f, b = 0.0f;
  for (const ClassWeight& entry : weights.classes) {
    const LayoutClass* layout_class = FindClass(weights.vocabulary, entry.letter);
    const float share = entry.weight[cell] / 255.0f;
    r += share * layout_class->color.r;
    g += share * layout_class->color.g;
    b += share * layout_class->color.b;
  }
  return Color(r, g, b);
}

void AddGround(const Terrain& terrain, int cells, MarkerPieces* ground, MarkerPieces* water) {
  const GridGeometry& geometry = terrain.geometry();
  const double half_m = geometry.half_size_m(), edge_m = geometry.size_m() / cells;
  const auto corner = [&](int i, int j) {
    const WorldPoint at{-half_m + i * edge_m, -half_m + j * edge_m};
    return Point(at.x_m, at.y_m, terrain.ground.HeightAt(at));
  };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto sw = corner(i, j), se = corner(i + 1, j), nw = corner(i, j + 1),
                 ne = corner(i + 1, j + 1);
      const WorldPoint middle{-half_m + (i + 0.5) * edge_m, -half_m + (j + 0.5) * edge_m};
      const CellIndex cell = geometry.CellAt(middle);
      const auto color = GroundColor(terrain.weights, cell);
      ground->MoveTo(middle);
      ground->Add(sw, se, nw, color);
      ground->Add(se, ne, nw, color);
      const float level_m = terrain.water_level_m[cell];
      if (std::isnan(level_m)) continue;
      const auto raised = [&](const geometry_msgs::Point& p) { return Point(p.x, p.y, level_m); };
      const auto blue = Color(0.15f, 0.35f, 0.8f, 0.7f);
      water->MoveTo(middle);
      water->Add(raised(sw), raised(se), raised(nw), blue);
      water->Add(raised(se), raised(ne), raised(nw), blue);
    }
  }
}

// A body between a ring of corners around the middle and one point above and below it.
void AddSpindle(const Asset& asset, int corners, double ring_share,
                const std_msgs::ColorRGBA& upper, const std_msgs::ColorRGBA& lower,
                MarkerPieces* pieces) {
  const double ring_z_m = asset.z_m + ring_share * asset.height_m;
  const auto ring = [&](int k) {
    const double angle = asset.yaw_rad + 2.0 * M_PI * k / corners;
    return Point(asset.x_m + asset.half_length_m * std::cos(angle),
                 asset.y_m + asset.half_length_m * std::sin(angle), ring_z_m);
  };
  const auto top = Point(asset.x_m, asset.y_m, asset.z_m + asset.height_m);
  const auto low = Point(asset.x_m, asset.y_m, asset.z_m);
  for (int k = 0; k < corners; ++k) {
    pieces->Add(ring(k), ring(k + 1), top, upper);
    pieces->Add(ring(k + 1), ring(k), low, lower);
  }
}

void AddBuilding(const Asset& asset, const std_msgs::ColorRGBA& wall,
                 const std_msgs::ColorRGBA& roof, MarkerPieces* pieces) {
  const double c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
  const auto corner = [&](int k, double z_m) {
    const double u = (k == 1 || k == 2) ? asset.half_length_m : -asset.half_length_m;
    const double v = k >= 2 ? asset.half_width_m : -asset.half_width_m;
    return Point(asset.x_m + c * u - s * v, asset.y_m + s * u + c * v, z_m);
  };
  const double low_m = asset.z_m, high_m = asset.z_m + asset.height_m;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    pieces->Add(corner(k, low_m), corner(next, low_m), corner(next, high_m), wall);
    pieces->Add(corner(k, low_m), corner(next, high_m), corner(k, high_m), wall);
  }
  pieces->Add(corner(0, high_m), corner(1, high_m), corner(2, high_m), roof);
  pieces->Add(corner(0, high_m), corner(2, high_m), corner(3, high_m), roof);
}

bool IsDrawn(AssetKind kind) { return IsSolid(kind) || kind == AssetKind::kBush; }

// The pieces of every kind that is drawn.
struct AssetPieces {
  MarkerPieces trees, bushes, stones, buildings;

  explicit AssetPieces(double size_m)
      : trees("trees", size_m),
        bushes("bushes", size_m),
        stones("stones", size_m),
        buildings("buildings", size_m) {}
};

void AddAsset(const Asset& asset, const PartColors& colors, AssetPieces* pieces) {
  const auto leaves = ColorOf(colors, MeshPart::kLeaves);
  switch (asset.kind) {
    case AssetKind::kTree:
      pieces->trees.MoveTo(asset.position());
      AddSpindle(asset, 5, 0.3, leaves, ColorOf(colors, MeshPart::kBark), &pieces->trees);
      break;
    case AssetKind::kBush:
      pieces->bushes.MoveTo(asset.position());
      AddSpindle(asset, 4, 0.5, leaves, leaves, &pieces->bushes);
      break;
    case AssetKind::kBuilding:
      pieces->buildings.MoveTo(asset.position());
      AddBuilding(asset, ColorOf(colors, MeshPart::kWall), ColorOf(colors, MeshPart::kRoof),
                  &pieces->buildings);
      break;
    default: {
      const auto stone = ColorOf(colors, MeshPart::kStone);
      pieces->stones.MoveTo(asset.position());
      AddSpindle(asset, 4, 0.5, stone, stone, &pieces->stones);
      break;
    }
  }
}

void AddAssets(const Scene& scene, int max_assets, AssetPieces* pieces) {
  const auto drawn = std::count_if(scene.assets.begin(), scene.assets.end(),
                                   [](const Asset& asset) { return IsDrawn(asset.kind); });
  // Bresenham's way to keep max_assets of them, evenly: an asset stays when the sum rolls over.
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    if (!IsDrawn(asset.kind)) continue;
    sum += std::min<std::int64_t>(max_assets, drawn);
    if (sum < drawn) continue;
    sum -= drawn;
    const double draw = HashToUnit(0, static_cast<std::int64_t>(i), 0);  // which individual
    AddAsset(asset,
             ColorsOf(*scene.catalogue, TypeOf(asset.kind), asset.season_variant, asset.material,
                      scene.environment.coarse.season, draw),
             pieces);
  }
}

}  // namespace

visualization_msgs::MarkerArray ToMarkers(const Scene& scene, const WorldMarkerOptions& options) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker clear;
  clear.header.frame_id = kMapFrame;
  clear.action = visualization_msgs::Marker::DELETEALL;
  array.markers.push_back(clear);

  const double size_m = scene.geometry().size_m();
  MarkerPieces ground("ground", size_m), water("water", size_m);
  AssetPieces assets(size_m);
  AddGround(*scene.terrain, std::min(options.terrain_cells, scene.geometry().rows()), &ground,
            &water);
  AddAssets(scene, options.max_assets, &assets);
  for (MarkerPieces* pieces :
       {&ground, &water, &assets.trees, &assets.bushes, &assets.stones, &assets.buildings}) {
    for (visualization_msgs::Marker& marker : pieces->Take())
      array.markers.push_back(std::move(marker));
  }
  return array;
}

}  // namespace latticeworld
