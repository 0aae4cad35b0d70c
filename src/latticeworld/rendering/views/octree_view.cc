#include "latticeworld/rendering/views/octree_view.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/views/footer.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr int kVoxelsAcross = 256;
constexpr double kMinVoxel_m = 0.05;
constexpr double kMaxVoxel_m = 16.0;

// The occupied voxels of a tree in a grid just large enough, x east, y north, z up.
class VoxelGrid {
 public:
  explicit VoxelGrid(const octomap::OcTree& tree) : depth_(tree.getTreeDepth()) {
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
      const Cube cube = CubeOf(leaf);
      for (int axis = 0; axis < 3; ++axis) {
        low_[axis] = std::min(low_[axis], cube.low[axis]);
        high_[axis] = std::max(high_[axis], cube.low[axis] + cube.side);
      }
    }
    occupied_.resize(static_cast<std::size_t>(count(0)) * count(1) * count(2));
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
      const Cube cube = CubeOf(leaf);
      for (int z = 0; z < cube.side; ++z) {
        for (int y = 0; y < cube.side; ++y) {
          const auto first =
              occupied_.begin() +
              IndexOf(cube.low[0] - low_[0], cube.low[1] - low_[1] + y, cube.low[2] - low_[2] + z);
          std::fill(first, first + cube.side, 1);
        }
      }
    }
  }

  int count(int axis) const { return std::max(0, high_[axis] - low_[axis]); }
  bool At(int x, int y, int z) const {
    return x >= 0 && x < count(0) && y >= 0 && y < count(1) && z >= 0 && z < count(2) &&
           occupied_[IndexOf(x, y, z)] != 0;
  }

 private:
  struct Cube {
    std::array<int, 3> low;
    int side;
  };
  template <typename Leaf>
  Cube CubeOf(const Leaf& leaf) const {
    const octomap::OcTreeKey key = leaf.getIndexKey();
    return {{key[0], key[1], key[2]}, 1 << (depth_ - leaf.getDepth())};
  }
  std::size_t IndexOf(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * count(1) + y) * count(0) + x;
  }

  unsigned int depth_;
  std::array<int, 3> low_ = {1 << 16, 1 << 16, 1 << 16};
  std::array<int, 3> high_ = {0, 0, 0};
  std::vector<unsigned char> occupied_;
};

// A parallel projection from the south-east, fitted into a square picture.
class Projection {
 public:
  Projection(const VoxelGrid& voxels, float side_px) {
    const float x = voxels.count(0), y = voxels.count(1), z = voxels.count(2);
    const float width = kRightX * x + kRightY * y;
    const float height = kUpY * y - kUpX * x + kUpZ * z;
    scale_ = 0.96f * side_px / std::max({width, height, 1.0f});
    left_ = 0.5f * (side_px - scale_ * width);
    bottom_ = 0.5f * (side_px + scale_ * height) + scale_ * kUpX * x;
  }
  Eigen::Vector2f operator()(int x, int y, int z) const {
    return {left_ + scale_ * (kRightX * x + kRightY * y),
            bottom_ - scale_ * (kUpX * x + kUpY * y + kUpZ * z)};
  }

 private:
  // The picture's axes in the map frame: azimuth 15 degrees, elevation 50 degrees.
  static constexpr float kRightX = 0.966f, kRightY = 0.259f;
  static constexpr float kUpX = -0.198f, kUpY = 0.740f, kUpZ = 0.643f;

  float scale_ = 1.0f;
  float left_ = 0.0f;
  float bottom_ = 0.0f;
};

// Returns a colour from blue for low (share 0) to red for high (share 1).
Color HeightColor(float share) {
  const float hue = 4.0f * (1.0f - std::clamp(share, 0.0f, 1.0f));
  const auto channel = [hue](float peak) {
    return std::clamp(2.0f - std::abs(hue - peak), 0.0f, 1.0f);
  };
  const float red = std::clamp(2.0f - hue, 0.0f, 1.0f);
  return Color(channel(4.0f), channel(2.0f), red) * 0.92f;
}

// Far voxels first, so that near ones cover them; hidden faces are left out.
void PaintVoxels(const VoxelGrid& voxels, cv::Mat* bgr) {
  const Projection project(voxels, static_cast<float>(bgr->cols));
  for (int y = voxels.count(1) - 1; y >= 0; --y) {
    for (int x = 0; x < voxels.count(0); ++x) {
      for (int z = 0; z < voxels.count(2); ++z) {
        if (!voxels.At(x, y, z)) continue;
        const Color color = HeightColor(static_cast<float>(z) / std::max(1, voxels.count(2) - 1));
        const auto paint = [&](std::array<std::array<int, 3>, 4> corners, float light) {
          std::vector<Eigen::Vector2f> polygon;
          for (const auto& at : corners)
            polygon.push_back(project(x + at[0], y + at[1], z + at[2]));
          FillPolygon(polygon, color * light, bgr);
        };
        if (!voxels.At(x, y, z + 1)) paint({{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}, 1.0f);
        if (!voxels.At(x, y - 1, z)) paint({{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}, 0.74f);
        if (!voxels.At(x + 1, y, z)) paint({{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}, 0.55f);
      }
    }
  }
}

}  // namespace

Result<std::string> DrawOctree(const Scene& scene, const PictureOptions& options,
                               const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options));
  const HeightField& ground = scene.terrain->ground;
  OctreeOptions octree_options;
  octree_options.resolution_m = std::clamp(
      std::max<double>(scene.geometry().size_m(), ground.max_m() - ground.min_m()) / kVoxelsAcross,
      kMinVoxel_m, kMaxVoxel_m);
  octree_options.thickness_m = 2.0 * octree_options.resolution_m;
  LW_ASSIGN_OR_RETURN(const auto tree, BuildOctree(scene, octree_options, progress));

  const Footer footer = LayOutFooter(scene, options.width_px, /*agents=*/false);
  const Sheet sheet(options.width_px, footer.lines);
  const cv::Vec3b paper = ToBytes(PaperColor());
  cv::Mat bgr(sheet.height * kSupersample, sheet.width * kSupersample, CV_8UC3,
              cv::Scalar(paper[0], paper[1], paper[2]));
  const int side_px = sheet.map_side() * kSupersample;
  cv::Mat map =
      bgr(cv::Rect(sheet.margin * kSupersample, sheet.margin * kSupersample, side_px, side_px));
  map.setTo(cv::Scalar(236, 232, 228));
  PaintVoxels(VoxelGrid(*tree), &map);
  DrawFrame({sheet.margin, sheet.margin, sheet.map_side(), sheet.map_side()}, &bgr);
  if (sheet.lettered()) {
    DrawLabel("OctoMap, voxels of " + FormatDouble(octree_options.resolution_m) + " m",
              {static_cast<float>(sheet.margin), sheet.baseline(0)}, sheet.letter(), InkColor(),
              &bgr);
  }
  DrawFooter(footer, sheet, &bgr);
  return EncodePng(Averaged(bgr), options);
}

}  // namespace latticeworld
