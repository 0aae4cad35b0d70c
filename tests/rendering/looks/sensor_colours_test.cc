#include "latticeworld/rendering/looks/sensor_colours.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/sensing/sensor_scene.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;

constexpr int kWidth_px = 80, kHeight_px = 60;

CameraModel SmallCamera() {
  CameraModel model;
  model.width = kWidth_px;
  model.height = kHeight_px;
  model.fx_px = model.fy_px = 70.0;
  model.cx_px = 39.5;
  model.cy_px = 29.5;
  return model;
}

// A camera at that height above the origin that looks east and a little down.
Eigen::Isometry3d LookingEast(double height_m, double down_rad = 0.15) {
  Eigen::Matrix3d from_optical;
  from_optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Vector3d(0.0, 0.0, height_m);
  pose.linear() = Eigen::AngleAxisd(down_rad, Vector3d::UnitY()).toRotationMatrix() * from_optical;
  return pose;
}

// A meadow at noon, the sun high in the south.
class SensorColoursTest : public testing::Test {
 protected:
  SensorColoursTest() {
    Scene scene = MakeScene(64, 64.0, [](double, double) { return 0.0; });
    scene.environment.coarse.season = Season::kSummer;
    scene_ = std::make_shared<const Scene>(std::move(scene));
    world_.atmosphere = scene_->atmosphere;
    world_.atmosphere.sun_direction = Vector3d(0.0, -0.6, 0.8);
  }

  CameraFrame See(const Eigen::Isometry3d& pose, int threads = 1,
                  std::uint32_t except_agent = SensorScene::kNoAgent) const {
    auto rays = SensorScene::Create(scene_, SensorSceneOptions(), Progress());
    EXPECT_TRUE(rays.ok()) << rays.status().ToString();
    EXPECT_TRUE(rays->Update(world_).ok());
    EXPECT_TRUE(rays->Focus({pose.translation()}).ok());
    CameraFrame frame;
    SceneColours(scene_, threads).Render(*rays, world_, SmallCamera(), pose, except_agent, &frame);
    EXPECT_EQ(frame.colour.size(), 3u * kWidth_px * kHeight_px);
    return frame;
  }
  static Eigen::Vector3i At(const CameraFrame& frame, int u, int v) {
    const std::uint8_t* pixel = &frame.colour[3 * static_cast<std::size_t>(v * kWidth_px + u)];
    return {pixel[0], pixel[1], pixel[2]};
  }
  // Where a point of the map falls.
  static Eigen::Vector3i At(const CameraFrame& frame, const Eigen::Isometry3d& pose,
                            const Vector3d& point_m) {
    const auto pixel = Project(SmallCamera(), pose.inverse() * point_m);
    EXPECT_TRUE(pixel.has_value());
    return At(frame, static_cast<int>(std::lround(pixel->x())),
              static_cast<int>(std::lround(pixel->y())));
  }
  static double Brightness(const CameraFrame& frame) {
    double sum = 0.0;
    for (const std::uint8_t value : frame.colour) sum += value;
    return sum / static_cast<double>(frame.colour.size());
  }
  void AddProp(PropKind kind, double x_m, double y_m, const Vector3d& size_m) {
    SensedProp prop;
    prop.name = "element";
    prop.kind = kind;
    prop.size_m = size_m;
    prop.map_from_prop = Eigen::Translation3d(x_m, y_m, 0.0) * Eigen::Quaterniond::Identity();
    world_.props.push_back(prop);
  }

  std::shared_ptr<const Scene> scene_;
  SensedWorld world_;
};

TEST_F(SensorColoursTest, TheSkyIsBlueAndTheMeadowGreen) {
  const CameraFrame frame = See(LookingEast(1.0));
  const Eigen::Vector3i sky = At(frame, 40, 1), meadow = At(frame, 40, 58);
  EXPECT_GT(sky[2], sky[0] + 20);
  EXPECT_GT(meadow[1], meadow[2] + 20);
}

TEST_F(SensorColoursTest, ThingsAreSeenWhereTheyStand) {
  AddProp(PropKind::kCrate, 5.0, 0.0, {1.0, 1.0, 1.0});
  world_.atmosphere.sun_direction = Vector3d(-0.6, 0.0, 0.8);
  const Eigen::Isometry3d pose = LookingEast(1.2);
  const CameraFrame frame = See(pose);
  const Eigen::Vector3i wood = At(frame, pose, {4.5, 0.2, 0.63});
  EXPECT_GT(wood[0], wood[2] + 30);
  const Eigen::Vector3i meadow = At(frame, pose, {4.5, -1.5, 0.0});
  EXPECT_GT(meadow[1], meadow[0] - 10);
}

TEST_F(SensorColoursTest, ThingsThrowShadowsAwayFromTheSun) {
  AddProp(PropKind::kCrate, 6.0, 0.0, {1.0, 1.0, 1.0});
  const Eigen::Isometry3d pose = LookingEast(2.0, 0.3);
  const CameraFrame frame = See(pose);
  // The sun stands in the south: the shadow lies north of the crate.
  const int in_shadow = At(frame, pose, {6.0, 0.85, 0.0}).sum();
  const int in_the_sun = At(frame, pose, {6.0, -1.2, 0.0}).sum();
  EXPECT_LT(in_shadow, 0.7 * in_the_sun);
}

TEST_F(SensorColoursTest, ARobotDoesNotSeeItselfButItsShadow) {
  SensedAgent robot;
  robot.name = "robot";
  robot.category = AgentCategory::kHumanoidRobot;
  robot.height_m = 1.8;
  robot.radius_m = 0.4;
  robot.map_from_base.translation() = Vector3d(1.5, 0.0, 0.0);
  const Eigen::Isometry3d pose = LookingEast(1.2, 0.4);
  const CameraFrame nobody = See(pose);
  world_.agents.push_back(robot);
  EXPECT_NE(At(See(pose), pose, {1.5, 0.0, 0.9}), At(nobody, pose, {1.5, 0.0, 0.9}));
  const CameraFrame own = See(pose, 1, 0);
  EXPECT_EQ(At(own, pose, {1.5, 0.0, 0.9}), At(nobody, pose, {1.5, 0.0, 0.9}));
  EXPECT_NE(own.colour, nobody.colour);
}

TEST_F(SensorColoursTest, FogHidesWhatIsFar) {
  AddProp(PropKind::kCrate, 20.0, 0.0, {4.0, 4.0, 4.0});
  const Eigen::Isometry3d pose = LookingEast(1.5);
  const Vector3d face_m(18.0, 0.5, 1.6), beside_m(18.0, 4.0, 1.6);
  const auto contrast = [&] {
    const CameraFrame frame = See(pose);
    return (At(frame, pose, face_m) - At(frame, pose, beside_m)).cwiseAbs().sum();
  };
  const int clear = contrast();
  world_.atmosphere.weather = Weather::kFog;
  world_.atmosphere.visibility_m = 15.0;
  const int foggy = contrast();
  EXPECT_GT(clear, 60);
  EXPECT_LT(foggy, clear / 4);
}

TEST_F(SensorColoursTest, SnowOfTheMomentWhitensTheMeadow) {
  const Eigen::Vector3i green = At(See(LookingEast(1.0)), 40, 58);
  world_.atmosphere.snow_depth_m = 0.2;
  const Eigen::Vector3i white = At(See(LookingEast(1.0)), 40, 58);
  EXPECT_GT(white.minCoeff(), green.minCoeff() + 60);
  EXPECT_LT(white.maxCoeff() - white.minCoeff(), 50);
}

TEST_F(SensorColoursTest, NightIsDark) {
  const double day = Brightness(See(LookingEast(1.0)));
  world_.atmosphere.sun_direction = Vector3d(0.0, 0.6, -0.8);
  EXPECT_LT(Brightness(See(LookingEast(1.0))), 0.7 * day);
}

TEST_F(SensorColoursTest, DropsFallInRainAlone) {
  const auto at = [&](double time_s) {
    world_.time_s = time_s;
    return See(LookingEast(1.0)).colour;
  };
  EXPECT_EQ(at(1.0), at(2.0));
  world_.atmosphere.weather = Weather::kRain;
  world_.atmosphere.rain_mmph = 8.0;
  const auto first = at(1.0);
  EXPECT_NE(first, at(2.0));
  EXPECT_EQ(first, at(1.0));
}

TEST_F(SensorColoursTest, PicturesAreTheSameWithAnyNumberOfThreads) {
  AddProp(PropKind::kLooseStone, 4.0, 0.5, {0.8, 0.8, 0.8});
  EXPECT_EQ(See(LookingEast(1.0), 1).colour, See(LookingEast(1.0), 3).colour);
}

}  // namespace
}  // namespace latticeworld
