#include "latticeworld_ros/world_markers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "latticeworld_ros/agent_conversion.h"

namespace latticeworld {
namespace {

using visualization_msgs::Marker;

std_msgs::ColorRGBA Color(float r, float g, float b, float a = 1.0f) {
  std_msgs::ColorRGBA color;
  color.r = r;
  color.g = g;
  color.b = b;
  color.a = a;
  return color;
}

geometry_msgs::Point Point(double x, double y, double z) {
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

Marker Triangles(const std::string& ns) {
  Marker marker;
  marker.header.frame_id = kMapFrame;
  marker.ns = ns;
  marker.type = Marker::TRIANGLE_LIST;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color = Color(1.0f, 1.0f, 1.0f);
  return marker;
}

void AddTriangle(const geometry_msgs::Point& a, const geometry_msgs::Point& b,
                 const geometry_msgs::Point& c, const std_msgs::ColorRGBA& color, Marker* marker) {
  marker->points.insert(marker->points.end(), {a, b, c});
  marker->colors.push_back(color);  // one a triangle
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

void AddGround(const Terrain& terrain, int cells, Marker* ground, Marker* water) {
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
      const CellIndex cell =
          geometry.CellAt({-half_m + (i + 0.5) * edge_m, -half_m + (j + 0.5) * edge_m});
      const auto color = GroundColor(terrain.weights, cell);
      AddTriangle(sw, se, nw, color, ground);
      AddTriangle(se, ne, nw, color, ground);
      const float level_m = terrain.water_level_m[cell];
      if (std::isnan(level_m)) continue;
      const auto raised = [&](const geometry_msgs::Point& p) { return Point(p.x, p.y, level_m); };
      const auto blue = Color(0.15f, 0.35f, 0.8f, 0.7f);
      AddTriangle(raised(sw), raised(se), raised(nw), blue, water);
      AddTriangle(raised(se), raised(ne), raised(nw), blue, water);
    }
  }
}

// A body between a ring of corners around the middle and one point above and below it.
void AddSpindle(const Asset& asset, int corners, double ring_z_m, double low_z_m,
                const std_msgs::ColorRGBA& color, Marker* marker) {
  const auto ring = [&](int k) {
    const double angle = asset.yaw_rad + 2.0 * M_PI * k / corners;
    return Point(asset.x_m + asset.half_length_m * std::cos(angle),
                 asset.y_m + asset.half_length_m * std::sin(angle), ring_z_m);
  };
  const auto top = Point(asset.x_m, asset.y_m, asset.z_m + asset.height_m);
  const auto low = Point(asset.x_m, asset.y_m, low_z_m);
  for (int k = 0; k < corners; ++k) {
    AddTriangle(ring(k), ring(k + 1), top, color, marker);
    AddTriangle(ring(k + 1), ring(k), low, color, marker);
  }
}

void AddBox(const Asset& asset, const std_msgs::ColorRGBA& wall, const std_msgs::ColorRGBA& roof,
            Marker* marker) {
  const double c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
  const auto corner = [&](int k, double z_m) {
    const double u = (k == 1 || k == 2) ? asset.half_length_m : -asset.half_length_m;
    const double v = k >= 2 ? asset.half_width_m : -asset.half_width_m;
    return Point(asset.x_m + c * u - s * v, asset.y_m + s * u + c * v, z_m);
  };
  const double low_m = asset.z_m, high_m = asset.z_m + asset.height_m;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    AddTriangle(corner(k, low_m), corner(next, low_m), corner(next, high_m), wall, marker);
    AddTriangle(corner(k, low_m), corner(next, high_m), corner(k, high_m), wall, marker);
  }
  AddTriangle(corner(0, high_m), corner(1, high_m), corner(2, high_m), roof, marker);
  AddTriangle(corner(0, high_m), corner(2, high_m), corner(3, high_m), roof, marker);
}

bool IsDrawn(AssetKind kind) { return IsSolid(kind) || kind == AssetKind::kBush; }

void AddAssets(const Scene& scene, int max_assets, Marker* marker) {
  const auto drawn = std::count_if(scene.assets.begin(), scene.assets.end(),
                                   [](const Asset& asset) { return IsDrawn(asset.kind); });
  // Bresenham's way to keep max_assets of them, evenly: an asset stays when the sum rolls over.
  std::int64_t sum = 0;
  for (const Asset& asset : scene.assets) {
    if (!IsDrawn(asset.kind)) continue;
    sum += std::min<std::int64_t>(max_assets, drawn);
    if (sum < drawn) continue;
    sum -= drawn;
    const double middle_m = asset.z_m + 0.5 * asset.height_m;
    switch (asset.kind) {
      case AssetKind::kTree:
        AddSpindle(asset, 5, asset.z_m + 0.3 * asset.height_m, asset.z_m,
                   Color(0.13f, 0.42f, 0.16f), marker);
        break;
      case AssetKind::kBush:
        AddSpindle(asset, 4, middle_m, asset.z_m, Color(0.35f, 0.55f, 0.25f), marker);
        break;
      case AssetKind::kBuilding:
        AddBox(asset, Color(0.82f, 0.76f, 0.68f), Color(0.6f, 0.25f, 0.2f), marker);
        break;
      default:
        AddSpindle(asset, 4, middle_m, asset.z_m, Color(0.5f, 0.5f, 0.5f), marker);
        break;
    }
  }
}

}  // namespace

visualization_msgs::MarkerArray ToMarkers(const Scene& scene, const WorldMarkerOptions& options) {
  visualization_msgs::MarkerArray array;
  Marker clear;
  clear.header.frame_id = kMapFrame;
  clear.action = Marker::DELETEALL;
  array.markers.push_back(clear);

  Marker ground = Triangles("ground"), water = Triangles("water"), assets = Triangles("assets");
  AddGround(*scene.terrain, std::min(options.terrain_cells, scene.geometry().rows()), &ground,
            &water);
  AddAssets(scene, options.max_assets, &assets);
  for (Marker* marker : {&ground, &water, &assets}) {
    // rviz warns about a list without points.
    if (!marker->points.empty()) array.markers.push_back(std::move(*marker));
  }
  return array;
}

}  // namespace latticeworld
