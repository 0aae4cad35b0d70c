#include "latticeworld/exporting/maps/point_cloud.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <tuple>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/common/range.h"
#include "latticeworld/exporting/chosen_assets.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/views/painting.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "points";
constexpr int kDetail = 1;
constexpr Rgb kWaterColor = {44, 82, 90};

PointLabel LabelOf(AssetKind kind) {
  switch (kind) {
    case AssetKind::kTree:
      return PointLabel::kTree;
    case AssetKind::kBush:
      return PointLabel::kBush;
    case AssetKind::kStone:
      return PointLabel::kStone;
    case AssetKind::kBuilding:
      return PointLabel::kBuilding;
    case AssetKind::kDeadBranch:
      return PointLabel::kDeadBranch;
    case AssetKind::kGrassTuft:
      return PointLabel::kGrassTuft;
    case AssetKind::kFlower:
      return PointLabel::kFlower;
    case AssetKind::kCrop:
      return PointLabel::kCrop;
  }
  return PointLabel::kGround;
}

// How many lattice points fit along a length, at least one.
int CountAlong(double length_m, double spacing_m) {
  return std::max(1, static_cast<int>(std::floor(length_m / spacing_m + 1e-6)));
}

class Sampler {
 public:
  Sampler(const Scene& scene, const PointCloudOptions& options, const ExportRegion& region)
      : scene_(scene), options_(options), region_(region), draws_(options.seed, "points") {}

  void AddGround() {
    const Terrain& terrain = *scene_.terrain;
    const cv::Mat colors = MaterialsOf(scene_).color;
    const int cols = CountAlong(region_.width_m(), options_.spacing_m);
    const int rows = CountAlong(region_.depth_m(), options_.spacing_m);
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        const WorldPoint place = {region_.west_m + (col + 0.5) * region_.width_m() / cols,
                                  region_.north_m - (row + 0.5) * region_.depth_m() / rows};
        const CellIndex cell = terrain.geometry().CellAt(place);
        const cv::Vec3b bgr = ToBytes(colors.at<cv::Vec3f>(cell.row, cell.col));
        CloudPoint point;
        point.position_m =
            Eigen::Vector3d(place.x_m, place.y_m, terrain.ground.HeightAt(place)).cast<float>();
        point.color = {bgr[2], bgr[1], bgr[0]};
        if (terrain.surface[cell] == SurfaceClass::kRoad) point.label = PointLabel::kRoad;
        points_.push_back(point);
        const float level_m = terrain.water_level_m[cell];
        if (level_m > point.position_m.z()) {
          point.position_m.z() = level_m;
          point.color = kWaterColor;
          point.label = PointLabel::kWater;
          points_.push_back(point);
        }
      }
    }
  }

  // A whole number by chance whose mean is the area's share.
  void AddAsset(std::uint32_t number) {
    const Asset& asset = scene_.assets[number];
    const Mesh& mesh = MeshOf(asset);
    const auto colors = PartColors(scene_, asset);
    const Eigen::Vector3f size(asset.half_length_m, asset.half_width_m, asset.height_m);
    const Eigen::AngleAxisf turn(asset.yaw_rad, Eigen::Vector3f::UnitZ());
    const double per_m2 = 1.0 / (options_.spacing_m * options_.spacing_m);
    CloudPoint point;
    point.label = LabelOf(asset.kind);
    point.asset = static_cast<std::int32_t>(number);
    double owed = draws_.Uniform();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& triangle = mesh.triangles[i];
      const Eigen::Vector3f a = mesh.vertices[triangle[0]].cwiseProduct(size);
      const Eigen::Vector3f u = mesh.vertices[triangle[1]].cwiseProduct(size) - a;
      const Eigen::Vector3f v = mesh.vertices[triangle[2]].cwiseProduct(size) - a;
      owed += 0.5 * static_cast<double>(u.cross(v).norm()) * per_m2;
      for (; owed >= 1.0; owed -= 1.0) {
        double s = draws_.Uniform(), t = draws_.Uniform();
        if (s + t > 1.0) {
          s = 1.0 - s;
          t = 1.0 - t;
        }
        const Eigen::Vector3f within = a + static_cast<float>(s) * u + static_cast<float>(t) * v;
        // Roots and foundations are below the ground.
        if (within.z() < 0.0f) continue;
        point.position_m = turn * within + Eigen::Vector3f(asset.x_m, asset.y_m, asset.z_m);
        point.color = colors[static_cast<std::size_t>(mesh.parts[i])];
        points_.push_back(point);
      }
    }
  }

  std::size_t size() const { return points_.size(); }
  std::vector<CloudPoint> Take() { return std::move(points_); }

 private:
  const Mesh& MeshOf(const Asset& asset) {
    const int variation = MeshVariationOf(asset);
    const auto key = std::make_tuple(asset.model, asset.season_variant, variation);
    auto found = meshes_.find(key);
    if (found == meshes_.end()) {
      const auto& variants = scene_.catalogue->season_variants(TypeOf(asset.kind));
      found =
          meshes_
              .emplace(key, BuildMesh(scene_.catalogue->models()[asset.model],
                                      variants[asset.season_variant].foliage, kDetail, variation))
              .first;
    }
    return found->second;
  }

  const Scene& scene_;
  const PointCloudOptions& options_;
  const ExportRegion region_;
  RandomStream draws_;
  std::map<std::tuple<std::uint8_t, std::uint8_t, int>, Mesh> meshes_;
  std::vector<CloudPoint> points_;
};

}  // namespace

std::uint8_t LasClassOf(PointLabel label) {
  switch (label) {
    case PointLabel::kGround:
      return 2;
    case PointLabel::kRoad:
      return 11;
    case PointLabel::kWater:
      return 9;
    case PointLabel::kTree:
      return 5;
    case PointLabel::kBush:
      return 4;
    case PointLabel::kStone:
      return 64;
    case PointLabel::kBuilding:
      return 6;
    case PointLabel::kDeadBranch:
    case PointLabel::kGrassTuft:
    case PointLabel::kFlower:
    case PointLabel::kCrop:
      return 3;
  }
  return 1;
}

Result<std::vector<CloudPoint>> SamplePoints(const Scene& scene, const PointCloudOptions& options,
                                             const Progress& progress) {
  std::vector<Violation> violations = Validate(options.region, scene.geometry());
  CheckRange("spacing_m", options.spacing_m, {0.02, 100.0}, " m", &violations);
  LW_RETURN_IF_ERROR(Status::FromViolations("points", std::move(violations)));
  const ExportRegion region = options.region.value_or(WholeWorld(scene.geometry()));
  const double on_ground =
      region.width_m() * region.depth_m() / (options.spacing_m * options.spacing_m);
  if (on_ground > static_cast<double>(kMostPoints)) {
    return InvalidArgument("the ground alone would have " +
                           std::to_string(std::llround(on_ground)) + " points, legal are " +
                           std::to_string(kMostPoints) + ": take a region, or a larger spacing");
  }
  progress.Report(kStage, 0.0);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  Sampler sampler(scene, options, region);
  sampler.AddGround();
  const auto chosen = ChooseAssets(scene, region, options.small_plants);
  constexpr std::size_t kBatch = 1000;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (i % kBatch == 0) {
      progress.Report(kStage, 0.3 + 0.7 * static_cast<double>(i) / chosen.size());
      LW_RETURN_IF_ERROR(progress.CheckCancelled());
    }
    sampler.AddAsset(chosen[i]);
    if (sampler.size() > kMostPoints)
      return ResourceExhausted("more than " + std::to_string(kMostPoints) +
                               " points: take a region, or a larger spacing");
  }
  progress.Report(kStage, 1.0);
  return sampler.Take();
}

}  // namespace latticeworld
