#include "latticeworld/sensing/camera/camera_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace latticeworld {
namespace {

CameraModel Distorted() {
  CameraModel model;
  model.distortion = {-0.28, 0.07, 0.0008, -0.0005, 0.001};
  return model;
}

TEST(CameraModelTest, AKnownPointFallsOntoItsPixel) {
  CameraModel model;  // 320 x 240, 277 px
  const auto middle = Project(model, {0.0, 0.0, 4.0});
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->x(), 159.5, 1e-12);
  EXPECT_NEAR(middle->y(), 119.5, 1e-12);
  // One metre right and half a metre down at two metres.
  const auto pixel = Project(model, {1.0, 0.5, 2.0});
  EXPECT_NEAR(pixel->x(), 159.5 + 138.5, 1e-12);
  EXPECT_NEAR(pixel->y(), 119.5 + 69.25, 1e-12);
}

TEST(CameraModelTest, DistortionIsThatOfTheFormula) {
  CameraModel model;
  model.distortion = {0.1, 0.02, 0.003, 0.004, 0.005};
  const double x = 0.3, y = -0.2, r2 = x * x + y * y;
  const double radial = 1.0 + 0.1 * r2 + 0.02 * r2 * r2 + 0.005 * r2 * r2 * r2;
  const double xd = x * radial + 2 * 0.003 * x * y + 0.004 * (r2 + 2 * x * x);
  const double yd = y * radial + 0.003 * (r2 + 2 * y * y) + 2 * 0.004 * x * y;
  const auto pixel = Project(model, {3.0 * x, 3.0 * y, 3.0});
  EXPECT_NEAR(pixel->x(), 277.0 * xd + 159.5, 1e-9);
  EXPECT_NEAR(pixel->y(), 277.0 * yd + 119.5, 1e-9);
}

TEST(CameraModelTest, EveryPixelComesBackThroughItsDirection) {
  for (const CameraModel& model : {CameraModel(), Distorted()}) {
    for (int v = 0; v < model.height; v += 7) {
      for (int u = 0; u < model.width; u += 9) {
        const Eigen::Vector3d direction = DirectionOf(model, u, v);
        EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
        const auto pixel = Project(model, 5.0 * direction);
        ASSERT_TRUE(pixel.has_value()) << u << " " << v;
        EXPECT_NEAR(pixel->x(), u, 1e-8);
        EXPECT_NEAR(pixel->y(), v, 1e-8);
      }
    }
  }
}

TEST(CameraModelTest, WhatIsBehindFallsNowhere) {
  EXPECT_FALSE(Project(CameraModel(), {0.0, 0.0, -1.0}).has_value());
  EXPECT_FALSE(Project(CameraModel(), {1.0, 0.0, 0.0}).has_value());
  EXPECT_FALSE(Project(CameraModel(), {0.0, 0.0, std::nan("")}).has_value());
}

TEST(CameraModelTest, WhatLiesBeyondAFoldFallsNowhere) {
  CameraModel model;
  model.distortion[0] = -0.5;
  // r (1 - 0.5 r^2) turns at r = sqrt(2 / 3).
  EXPECT_NEAR(MonotonousRadius(model), std::sqrt(2.0 / 3.0), 1e-9);
  EXPECT_TRUE(Project(model, {0.80, 0.0, 1.0}).has_value());
  EXPECT_FALSE(Project(model, {0.83, 0.0, 1.0}).has_value());
  // The fold's image is 0.544 from the axis: nothing falls further out.
  EXPECT_TRUE(Undistort(model, {0.54, 0.0}).has_value());
  EXPECT_FALSE(Undistort(model, {0.55, 0.0}).has_value());
  const Eigen::Vector3d rim = DirectionOf(model, model.cx_px + 0.9 * model.fx_px, model.cy_px);
  EXPECT_NEAR(rim.x() / rim.z(), std::sqrt(2.0 / 3.0), 1e-6);
  EXPECT_TRUE(std::isinf(MonotonousRadius(CameraModel())));
}

}  // namespace
}  // namespace latticeworld
