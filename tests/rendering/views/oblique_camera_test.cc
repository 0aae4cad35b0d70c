#include "latticeworld/rendering/views/oblique_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

constexpr int kSide_px = 500;
constexpr float kSize_m = 256.0f;
constexpr float kBlock_m = 0.045f * kSize_m;

// Where the land and the block below it come to lie in the picture [px].
struct Box {
  float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
  void Add(const Eigen::Vector2f& at) {
    left = std::min(left, at.x());
    right = std::max(right, at.x());
    top = std::min(top, at.y());
    bottom = std::max(bottom, at.y());
  }
};

RayCamera CameraOf(const Scene& scene) {
  return ObliqueCamera(scene, kBlock_m, kSide_px, kSide_px);
}

Box BoxOf(const Scene& scene) {
  const RayCamera camera = CameraOf(scene);
  const GridGeometry& geometry = scene.geometry();
  const HeightField& ground = scene.terrain->ground;
  Box box;
  for (int row = 0; row < geometry.rows(); ++row) {
    for (int col = 0; col < geometry.cols(); ++col) {
      const WorldPoint at = geometry.CenterOf({row, col});
      box.Add(camera.Project(
          Eigen::Vector3d(at.x_m, at.y_m, ground.height_m()(row, col)).cast<float>()));
    }
  }
  const float half_m = 0.5f * kSize_m;
  for (const float x_m : {-half_m, half_m})
    box.Add(camera.Project({x_m, -half_m, ground.min_m() - kBlock_m}));
  return box;
}

// A range of mountains of that height along the northern (1) or southern (-1) edge.
Scene Mountains(double height_m, double where) {
  return MakeScene(64, kSize_m, [=](double x_m, double y_m) {
    const double away = (y_m - 0.35 * where * kSize_m) / (0.15 * kSize_m);
    return height_m * std::exp(-away * away) * (0.75 + 0.25 * std::sin(x_m / 20.0));
  });
}

TEST(ObliqueCameraTest, LandOfAnyReliefFillsThePictureAndNothingIsCutOff) {
  for (const double height_m : {0.0, 4.0, 20.0, 60.0, 100.0, 150.0}) {
    for (const double where : {-1.0, 0.0, 1.0}) {
      const Box box = BoxOf(Mountains(height_m, where));
      SCOPED_TRACE(::testing::Message() << height_m << " m high at " << where);
      EXPECT_GE(box.right - box.left, 0.75f * kSide_px);
      EXPECT_GE(box.bottom - box.top, 0.65f * kSide_px);
      EXPECT_GE(box.left, 0.0f);
      EXPECT_GE(box.top, 0.0f);
      EXPECT_LE(box.right, kSide_px);
      EXPECT_LE(box.bottom, kSide_px);
    }
  }
}

TEST(ObliqueCameraTest, TallTreesAndFlyersAtTheFarEdgeAreInThePicture) {
  Scene scene = WithAssets(Mountains(0.0, 0.0), {MakeTree(0.0f, 127.0f, 30.0f, 5.0f, 0.5f)});
  AgentStart eagle;
  eagle.category = AgentCategory::kEagle;
  eagle.position = {0.0, 127.0};
  eagle.height_above_ground_m = 35.0;
  scene.agents.push_back(eagle);
  EXPECT_GT(CameraOf(scene).Project({0.0f, 127.0f, 35.0f}).y(), 0.0f);
}

TEST(ObliqueCameraTest, TreesThatAreHighForASmallWorldAreNotCutOff) {
  const Scene scene = WithAssets(Mountains(0.0, 0.0), {MakeTree(0.0f, 127.0f, 90.0f, 5.0f, 0.5f)});
  EXPECT_GT(CameraOf(scene).Project({0.0f, 127.0f, 90.0f}).y(), 0.0f);
}

TEST(ObliqueCameraTest, UprightStaysUprightAndFartherIsHigherAndSmaller) {
  const Scene scene = Mountains(0.0, 0.0);
  const RayCamera camera = CameraOf(scene);
  const Eigen::Vector3f near_m(50.0f, -100.0f, 0.0f), far_m(50.0f, 100.0f, 0.0f);
  EXPECT_LT(camera.DepthOf(near_m), camera.DepthOf(far_m));
  EXPECT_GT(camera.PixelsPerMetre(camera.DepthOf(near_m)),
            camera.PixelsPerMetre(camera.DepthOf(far_m)));
  EXPECT_GT(camera.Project(near_m).y(), camera.Project(far_m).y());
  EXPECT_NEAR(camera.Project(near_m).x(), camera.Project({50.0f, -100.0f, 40.0f}).x(), 1e-3f);
}

}  // namespace
}  // namespace latticeworld
