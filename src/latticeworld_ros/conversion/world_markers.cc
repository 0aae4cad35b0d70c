#include "latticeworld_ros/conversion/world_markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/geometry/upright.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/rendering/looks/bridge_colors.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/conversion/marker_pieces.h"

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

Rgb Mix(const Rgb& a, const Rgb& b, double share_of_b) {
  const auto mix = [share_of_b](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * share_of_b));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

// Natural colours of the ground by SurfaceClass, under the world's season and snow.
class GroundColors {
 public:
  explicit GroundColors(const Scene& scene) {
    const std::string& variant = scene.environment.fine_of(AssetType::kGrass).season_variant;
    Rgb grass = {124, 148, 84};
    for (const SeasonVariant& known : scene.catalogue->season_variants(AssetType::kGrass)) {
      const auto season = static_cast<std::size_t>(scene.environment.coarse.season);
      if (known.name == variant) grass = Mix(known.color[season].from, known.color[season].to, 0.5);
    }
    constexpr double kCoveredFrom_m = 0.1;
    const double snow = std::min(1.0, scene.atmosphere.snow_depth_m / kCoveredFrom_m);
    for (const auto& entry : EnumNames(SurfaceClass{})) {
      const bool covered = entry.value != SurfaceClass::kWaterBed;
      const Rgb rgb = Mix(NaturalColor(entry.value, grass), kSnow, covered ? 0.85 * snow : 0.0);
      colors_[static_cast<std::size_t>(entry.value)] =
          Color(rgb.r / 255.0f, rgb.g / 255.0f, rgb.b / 255.0f);
    }
  }

  const std_msgs::ColorRGBA& operator[](SurfaceClass surface) const {
    return colors_[static_cast<std::size_t>(surface)];
  }

 private:
  static constexpr Rgb kSnow = {240, 244, 248};

  static Rgb NaturalColor(SurfaceClass surface, const Rgb& grass) {
    switch (surface) {
      case SurfaceClass::kGrass:
        return grass;
      case SurfaceClass::kForestFloor:
        return {96, 88, 62};
      case SurfaceClass::kFarmland:
        return {162, 138, 88};
      case SurfaceClass::kBarren:
        return {178, 158, 122};
      case SurfaceClass::kRoad:
        return {118, 116, 114};
      case SurfaceClass::kBuilding:
        return Mix(grass, {150, 140, 120}, 0.4);
      case SurfaceClass::kRock:
        return {132, 128, 122};
      case SurfaceClass::kSnow:
        return kSnow;
      case SurfaceClass::kWaterBed:
        return {112, 102, 82};
    }
    return grass;
  }

  std::array<std_msgs::ColorRGBA, EnumNames(SurfaceClass{}).size()> colors_;
};

void AddGround(const Scene& scene, int cells, MarkerPieces* ground, MarkerPieces* water) {
  const Terrain& terrain = *scene.terrain;
  const GroundColors colors(scene);
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
      const auto& color = colors[terrain.surface[cell]];
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

// What a spindle stands or lies along, map frame [m].
struct Axis {
  Eigen::Vector3d foot_m, tip_m;
};
Axis AxisOf(const Asset& asset) {
  return {{asset.x_m, asset.y_m, asset.z_m}, {asset.x_m, asset.y_m, asset.z_m + asset.height_m}};
}

// A body between a ring of corners around its axis and the axis' two ends.
void AddSpindle(const Asset& asset, const Axis& axis, int corners, double ring_share,
                const std_msgs::ColorRGBA& upper, const std_msgs::ColorRGBA& lower,
                MarkerPieces* pieces) {
  const Eigen::Vector3d along_m = axis.tip_m - axis.foot_m;
  const Eigen::Vector3d middle_m = axis.foot_m + ring_share * along_m;
  const Eigen::Matrix3d turn = TurnFromUp(along_m).toRotationMatrix();
  const auto ring = [&](int k) {
    const double angle = asset.yaw_rad + 2.0 * M_PI * k / corners;
    return ToPoint(middle_m + asset.half_length_m * turn *
                                  Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0));
  };
  const auto top = ToPoint(axis.tip_m);
  const auto low = ToPoint(axis.foot_m);
  for (int k = 0; k < corners; ++k) {
    pieces->Add(ring(k), ring(k + 1), top, upper);
    pieces->Add(ring(k + 1), ring(k), low, lower);
  }
}

// The coarsest mesh of its model.
void AddMesh(const Asset& asset, const Mesh& mesh, const PartColors& colors, MarkerPieces* pieces) {
  const double c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
  const auto place = [&](std::uint32_t vertex) {
    const Eigen::Vector3f& unit = mesh.vertices[vertex];
    const double u = asset.half_length_m * unit.x(), v = asset.half_width_m * unit.y();
    return Point(asset.x_m + c * u - s * v, asset.y_m + s * u + c * v,
                 asset.z_m + asset.height_m * unit.z());
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, d] = mesh.triangles[i];
    pieces->Add(place(a), place(b), place(d), ColorOf(colors, mesh.parts[i]));
  }
}

bool IsDrawn(AssetKind kind) { return IsSolid(kind) || kind == AssetKind::kBush; }

// The pieces of every kind that is drawn.
struct AssetPieces {
  MarkerPieces trees, bushes, stones, buildings;
  std::map<std::uint8_t, Mesh> building_meshes;  // by model

  explicit AssetPieces(double size_m)
      : trees("trees", size_m),
        bushes("bushes", size_m),
        stones("stones", size_m),
        buildings("buildings", size_m) {}
};

void AddAsset(const Asset& asset, const Axis& axis, const AssetModel& model,
              const PartColors& colors, AssetPieces* pieces) {
  const auto leaves = ColorOf(colors, MeshPart::kLeaves);
  switch (asset.kind) {
    case AssetKind::kTree:
      pieces->trees.MoveTo(asset.position());
      AddSpindle(asset, axis, 5, model.crown_base + (1.0 - model.crown_base) * model.crown_widest,
                 leaves, ColorOf(colors, MeshPart::kBark), &pieces->trees);
      break;
    case AssetKind::kBush:
      pieces->bushes.MoveTo(asset.position());
      AddSpindle(asset, axis, 4, 0.5, leaves, leaves, &pieces->bushes);
      break;
    case AssetKind::kBuilding: {
      Mesh& mesh = pieces->building_meshes[asset.model];
      if (mesh.triangles.empty()) mesh = BuildMesh(model, 1.0, kMeshDetails - 1, 0);
      pieces->buildings.MoveTo(asset.position());
      AddMesh(asset, mesh, colors, &pieces->buildings);
      break;
    }
    default: {
      const auto stone = ColorOf(colors, MeshPart::kStone);
      pieces->stones.MoveTo(asset.position());
      AddSpindle(asset, axis, 4, 0.5, stone, stone, &pieces->stones);
      break;
    }
  }
}

void AddAssets(const Scene& scene, int max_assets, const SceneChanges& changes,
               AssetPieces* pieces) {
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
    const auto number = static_cast<std::uint32_t>(i);
    if (std::binary_search(changes.gone.begin(), changes.gone.end(), number)) continue;
    const auto fallen = std::find_if(changes.fallen.begin(), changes.fallen.end(),
                                     [&](const FallenTree& tree) { return tree.asset == number; });
    const Axis axis =
        fallen == changes.fallen.end() ? AxisOf(asset) : Axis{fallen->foot_m, fallen->tip_m};
    const double draw = HashToUnit(0, static_cast<std::int64_t>(i), 0);  // which individual
    AddAsset(asset, axis, scene.catalogue->models()[asset.model],
             ColorsOf(*scene.catalogue, TypeOf(asset.kind), asset.season_variant, asset.material,
                      scene.environment.coarse.season, draw),
             pieces);
  }
}

std_msgs::ColorRGBA ColorOf(const Bridge& bridge, const BridgePart& part) {
  const Rgb rgb = RgbOfBridge(bridge.kind, part.kind, part.kind == BridgePartKind::kDeck);
  return Color(rgb.r / 255.0f, rgb.g / 255.0f, rgb.b / 255.0f);
}

void AddBridges(const Terrain& terrain, MarkerPieces* pieces) {
  // Corners of the six sides, counter-clockwise seen from outside; bit 0: ahead, 1: left, 2: above.
  constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const Bridge& bridge : terrain.bridges) {
    for (const BridgePart& part : PartsOf(bridge, terrain.ground)) {
      const double c = std::cos(part.yaw_rad), s = std::sin(part.yaw_rad);
      const auto corner = [&](int i) {
        const double u = (i & 1 ? 1.0 : -1.0) * part.half_length_m;
        const double v = (i & 2 ? 1.0 : -1.0) * part.half_width_m;
        return Point(part.middle.x_m + c * u - s * v, part.middle.y_m + s * u + c * v,
                     i & 4 ? part.top_m : part.bottom_m);
      };
      pieces->MoveTo(part.middle);
      const auto color = ColorOf(bridge, part);
      for (const auto& side : kSides) {
        pieces->Add(corner(side[0]), corner(side[1]), corner(side[2]), color);
        pieces->Add(corner(side[0]), corner(side[2]), corner(side[3]), color);
      }
    }
  }
}

}  // namespace

visualization_msgs::MarkerArray ToMarkerArray(const Scene& scene, const WorldMarkerOptions& options,
                                              const SceneChanges& changes) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker clear;
  clear.header.frame_id = kMapFrame;
  clear.action = visualization_msgs::Marker::DELETEALL;
  array.markers.push_back(clear);

  const double size_m = scene.geometry().size_m();
  MarkerPieces ground("ground", size_m), water("water", size_m);
  MarkerPieces bridges("bridges", size_m);
  AssetPieces assets(size_m);
  AddGround(scene, std::min(options.terrain_cells, scene.geometry().rows()), &ground, &water);
  AddBridges(*scene.terrain, &bridges);
  AddAssets(scene, options.max_assets, changes, &assets);
  for (MarkerPieces* pieces : {&ground, &water, &bridges, &assets.trees, &assets.bushes,
                               &assets.stones, &assets.buildings}) {
    for (visualization_msgs::Marker& marker : pieces->Take())
      array.markers.push_back(std::move(marker));
  }
  return array;
}

}  // namespace latticeworld
