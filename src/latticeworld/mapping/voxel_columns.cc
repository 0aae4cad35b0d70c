#include "latticeworld/mapping/voxel_columns.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/mapping/octree.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// A crown begins at this share of a tree's height and ends at its top.
constexpr double kCrownBase = 0.3;

struct PlacedInterval {
  std::uint32_t column;
  VoxelInterval interval;
};

// Cuts the assets of a scene into columns.
class AssetCutter {
 public:
  AssetCutter(double voxel_m, const VoxelColumns& columns,
              const std::vector<std::uint16_t>& surface)
      : voxel_m_(voxel_m), columns_(columns), surface_(surface) {}

  void Add(const Asset& asset) {
    switch (asset.kind) {
      case AssetKind::kTree:
        AddCylinder(asset, asset.trunk_radius_m, (1.0 + kCrownBase) / 2.0 * asset.height_m);
        AddEllipsoid(asset, kCrownBase * asset.height_m);
        break;
      case AssetKind::kBush:
        AddEllipsoid(asset, 0.0);
        break;
      case AssetKind::kStone:
        AddCylinder(asset, asset.half_length_m, asset.height_m);
        break;
      case AssetKind::kBuilding:
        AddBox(asset);
        break;
      case AssetKind::kDeadBranch:
      case AssetKind::kGrassTuft:
      case AssetKind::kFlower:
      case AssetKind::kCrop:
        break;  // bodies pass through them
    }
  }

  const std::vector<PlacedInterval>& intervals() const { return intervals_; }

 private:
  // Calls visit(column, dx, dy) for the columns whose centre is at most reach_m from the asset
  // along each axis, at (dx, dy) [m] from it, and with (0, 0) for the column that holds the asset.
  template <typename Visit>
  void ForEachColumn(const Asset& asset, double reach_m, Visit&& visit) {
    const auto column_of = [this](double coordinate_m) {
      return std::clamp(VoxelKeyOf(coordinate_m, voxel_m_) - columns_.first_key, 0,
                        columns_.columns - 1);
    };
    const auto center_of = [this](int column) {
      return (columns_.first_key + column - kKeyOfZero + 0.5) * voxel_m_;
    };
    const int x_own = column_of(asset.x_m), y_own = column_of(asset.y_m);
    const int x_high = column_of(asset.x_m + reach_m), y_high = column_of(asset.y_m + reach_m);
    for (int y = column_of(asset.y_m - reach_m); y <= y_high; ++y) {
      for (int x = column_of(asset.x_m - reach_m); x <= x_high; ++x) {
        const bool own = x == x_own && y == y_own;
        visit(columns_.IndexOf(x, y), own ? 0.0 : center_of(x) - asset.x_m,
              own ? 0.0 : center_of(y) - asset.y_m);
      }
    }
  }

  void Place(std::size_t column, double low_m, double high_m) {
    const int low = std::clamp(VoxelKeyOf(low_m, voxel_m_), 0, kKeyCount - 1);
    const int high = std::clamp(VoxelKeyOf(high_m, voxel_m_), low, kKeyCount - 1);
    intervals_.push_back({static_cast<std::uint32_t>(column),
                          {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(high)}});
  }

  // From the ground of the column up to high_m.
  void PlaceStanding(std::size_t column, double low_m, double high_m) {
    const double ground_m = (surface_[column] - kKeyOfZero + 0.5) * voxel_m_;
    Place(column, std::min(low_m, ground_m), high_m);
  }

  void AddCylinder(const Asset& asset, double radius_m, double height_m) {
    ForEachColumn(asset, radius_m, [&](std::size_t column, double dx, double dy) {
      if (dx * dx + dy * dy <= radius_m * radius_m)
        PlaceStanding(column, asset.z_m, asset.z_m + height_m);
    });
  }

  void AddBox(const Asset& asset) {
    const double c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
    const double reach_m = std::hypot(asset.half_length_m, asset.half_width_m);
    ForEachColumn(asset, reach_m, [&](std::size_t column, double dx, double dy) {
      if (std::abs(c * dx + s * dy) <= asset.half_length_m &&
          std::abs(-s * dx + c * dy) <= asset.half_width_m)
        PlaceStanding(column, asset.z_m, asset.z_m + asset.height_m);
    });
  }

  // The ellipsoid of the asset's radius between bottom_m above its base and its top.
  void AddEllipsoid(const Asset& asset, double bottom_m) {
    const double radius_m = asset.half_length_m;
    const double half_height_m = 0.5 * (asset.height_m - bottom_m);
    const double center_z_m = asset.z_m + bottom_m + half_height_m;
    ForEachColumn(asset, radius_m, [&](std::size_t column, double dx, double dy) {
      const double share = radius_m > 0.0 ? (dx * dx + dy * dy) / (radius_m * radius_m) : 0.0;
      if (share > 1.0) return;
      const double half_chord_m = half_height_m * std::sqrt(1.0 - share);
      Place(column, center_z_m - half_chord_m, center_z_m + half_chord_m);
    });
  }

  const double voxel_m_;
  const VoxelColumns& columns_;
  const std::vector<std::uint16_t>& surface_;
  std::vector<PlacedInterval> intervals_;
};

std::vector<std::uint16_t> SurfaceKeys(const HeightField& ground, double voxel_m,
                                       const VoxelColumns& columns) {
  std::vector<std::uint16_t> surface(columns.IndexOf(0, columns.columns));
  const auto center_of = [&](int column) {
    return (columns.first_key + column - kKeyOfZero + 0.5) * voxel_m;
  };
  for (int y = 0; y < columns.columns; ++y) {
    for (int x = 0; x < columns.columns; ++x)
      surface[columns.IndexOf(x, y)] = static_cast<std::uint16_t>(
          VoxelKeyOf(ground.HeightAt({center_of(x), center_of(y)}), voxel_m));
  }
  return surface;
}

std::uint16_t LowestOfNeighbourhood(const std::vector<std::uint16_t>& surface,
                                    const VoxelColumns& columns, int x, int y) {
  std::uint16_t lowest = surface[columns.IndexOf(x, y)];
  const int last = columns.columns - 1;
  for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, last); ++ny) {
    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, last); ++nx)
      lowest = std::min(lowest, surface[columns.IndexOf(nx, ny)]);
  }
  return lowest;
}

// Sorts [first, last), joins what overlaps or touches, and gives the new end.
VoxelInterval* Merge(VoxelInterval* first, VoxelInterval* last) {
  std::sort(first, last, [](VoxelInterval a, VoxelInterval b) { return a.low < b.low; });
  VoxelInterval* end = first + 1;
  for (const VoxelInterval* next = first + 1; next != last; ++next) {
    VoxelInterval& top = *(end - 1);
    if (next->low <= top.high + 1)
      top.high = std::max(top.high, next->high);
    else
      *end++ = *next;
  }
  return end;
}

}  // namespace

int VoxelKeyOf(double coordinate_m, double voxel_m) {
  return static_cast<int>(std::floor(coordinate_m * (1.0 / voxel_m))) + kKeyOfZero;
}

VoxelColumns CutIntoColumns(const Scene& scene, const OctreeOptions& options) {
  const double voxel_m = options.resolution_m;
  const double half_size_m = scene.geometry().half_size_m();
  VoxelColumns result;
  result.first_key = VoxelKeyOf(-half_size_m, voxel_m);
  result.columns =
      static_cast<int>(std::ceil(half_size_m / voxel_m)) + kKeyOfZero - result.first_key;
  const std::vector<std::uint16_t> surface = SurfaceKeys(scene.terrain->ground, voxel_m, result);
  AssetCutter cutter(voxel_m, result, surface);
  for (const Asset& asset : scene.assets) cutter.Add(asset);

  // Counting sort of the intervals by column, ground first.
  result.begin.assign(surface.size() + 1, 0);
  for (std::size_t i = 0; i < surface.size(); ++i) result.begin[i + 1] = 1;
  for (const PlacedInterval& placed : cutter.intervals()) ++result.begin[placed.column + 1];
  for (std::size_t i = 0; i < surface.size(); ++i) result.begin[i + 1] += result.begin[i];
  result.intervals.resize(result.begin.back());
  std::vector<std::size_t> next(result.begin.begin(), result.begin.end() - 1);
  const double thickness_voxels = options.thickness_m / voxel_m;
  for (int y = 0; y < result.columns; ++y) {
    for (int x = 0; x < result.columns; ++x) {
      const std::size_t column = result.IndexOf(x, y);
      const int below = std::max(0, static_cast<int>(surface[column] - thickness_voxels));
      const int low = std::min<int>(below, LowestOfNeighbourhood(surface, result, x, y));
      result.intervals[next[column]++] = {static_cast<std::uint16_t>(low), surface[column]};
    }
  }
  for (const PlacedInterval& placed : cutter.intervals())
    result.intervals[next[placed.column]++] = placed.interval;

  // Merge within each column and close the gaps that this leaves.
  std::size_t out = 0;
  for (std::size_t column = 0; column < surface.size(); ++column) {
    VoxelInterval* first = result.intervals.data() + result.begin[column];
    const VoxelInterval* end = Merge(first, result.intervals.data() + result.begin[column + 1]);
    result.begin[column] = out;
    for (const VoxelInterval* i = first; i != end; ++i) result.intervals[out++] = *i;
  }
  result.begin.back() = out;
  result.intervals.resize(out);
  return result;
}

}  // namespace latticeworld
