// What a rig's cameras see, against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "latticeworld/sensing/camera/camera_renderer.h"
#include "sensing/rig_world_for_tests.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;

const CameraFrame& PicturesOf(const SensorFrame& frame) {
  return std::get<CameraFrame>(frame.reading);
}

CameraSensor Camera() {
  CameraSensor camera;
  camera.model.width = 162;  // not whole tiles
  camera.model.height = 122;
  camera.model.fx_px = camera.model.fy_px = 140.0;
  camera.model.cx_px = 80.5;
  camera.model.cy_px = 60.5;
  camera.outputs = {false, true, true, true};
  return camera;
}

// One frame of a robot that stands at the origin and looks along x from 1 m up.
CameraFrame Look(const Scene& scene, const CameraSensor& camera, const SensedWorld& world,
                 const SensorRigOptions& options = {}) {
  const auto rig = RigOf(scene, {Spec("camera", 10.0, camera)}, options);
  return PicturesOf(rig->Step(world, kStep_s, WantAll).value().at(0));
}
SensedWorld StillWorld() { return WorldAt(0, {RobotAt(0.0, Vector3d::Zero(), 0.0)}); }

TEST(RigCameraTest, DepthOfAnUprightPlaneIsTheSameInEveryPixel) {
  SensedWorld world = StillWorld();
  world.props = {CrateAt({8.0, 0.0, -5.0}, {2.0, 60.0, 40.0})};
  for (const double k1 : {0.0, -0.2}) {
    CameraSensor camera = Camera();
    camera.model.distortion[0] = k1;
    const CameraFrame frame = Look(LevelScene(-30.0), camera, world);
    ASSERT_EQ(frame.depth_m.size(), 162u * 122u);
    for (const float depth_m : frame.depth_m) ASSERT_NEAR(depth_m, 7.0, 1e-4);
  }
}

TEST(RigCameraTest, DepthOfTheGroundGrowsTowardsTheHorizon) {
  CameraSensor camera = Camera();
  camera.model.far_m = 30.0;
  const CameraFrame frame = Look(LevelScene(), camera, StillWorld());
  for (int row = 0; row < camera.model.height; ++row) {
    const double down = (row - camera.model.cy_px) / camera.model.fy_px;
    for (int col = 0; col < camera.model.width; col += 11) {
      const float depth_m = frame.depth_m[row * camera.model.width + col];
      if (down > 0.0 && 1.0 / down < 30.0) {
        ASSERT_NEAR(depth_m, 1.0 / down, 2e-4 / down) << row;
      } else {
        ASSERT_EQ(depth_m, INFINITY) << row;
      }
    }
  }
}

TEST(RigCameraTest, ANearThingIsTooNear) {
  SensedWorld world = StillWorld();
  world.props = {CrateAt({1.2, 0.0, 0.0}, {2.0, 4.0, 4.0})};
  CameraSensor camera = Camera();
  camera.model.near_m = 0.3;
  const CameraFrame frame = Look(LevelScene(), camera, world);
  EXPECT_EQ(frame.depth_m[60 * 162 + 80], -INFINITY);
}

TEST(RigCameraTest, APointOfTheWorldFallsOntoThePixelThatSeesIt) {
  SensedWorld world = StillWorld();
  world.props = {CrateAt({6.0, -1.0, 1.5}, {0.4, 0.4, 0.4})};
  CameraSensor camera = Camera();
  camera.model.distortion = {-0.1, 0.01, 0.0, 0.0, 0.0};
  const CameraFrame frame = Look(LevelScene(), camera, world);
  // The middle of its face is 5.8 m ahead, 1 m to the right and 0.7 m up.
  const auto pixel = Project(camera.model, {1.0, -0.7, 5.8});
  const int place = static_cast<int>(std::lround(pixel->y())) * camera.model.width +
                    static_cast<int>(std::lround(pixel->x()));
  EXPECT_EQ(frame.classes[place], static_cast<std::uint8_t>(SensedClass::kProp));
  EXPECT_EQ(frame.instances[place], PropInstance("crate_1"));
  EXPECT_NEAR(frame.depth_m[place], 5.8, 1e-3);
  // And nowhere far from there.
  for (int row = 0; row < 122; ++row) {
    for (int col = 0; col < 162; ++col) {
      if (frame.instances[row * 162 + col] != PropInstance("crate_1")) continue;
      EXPECT_LT(std::hypot(col - pixel->x(), row - pixel->y()), 8.0);
    }
  }
}

TEST(RigCameraTest, LabelsTellWhatThingsAre) {
  Scene scene = WithAssets(LevelScene(), {MakeTree(10.0, 4.0, 8.0, 2.0, 0.3),
                                          MakeBuilding(20.0, -12.0, 6.0, 4.0, 4.0, 0.0),
                                          MakeRound(AssetKind::kStone, 8.0, -1.5, 1.0, 0.8)});
  SensedWorld world = StillWorld();
  SensedAgent sheep = RobotAt(0.0, Vector3d::Zero(), 0.0, "sheep_1");
  sheep.category = AgentCategory::kSheep;
  sheep.has_sensors = false;
  sheep.height_m = 1.0;
  sheep.map_from_base.translation() = Vector3d(6.0, 1.0, 0.0);
  world.agents.push_back(sheep);
  const CameraFrame frame = Look(scene, Camera(), world);
  std::map<std::uint8_t, std::set<std::uint32_t>> instances;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    instances[frame.classes[i]].insert(frame.instances[i]);
  }
  const auto of = [&](SensedClass what) { return instances[static_cast<std::uint8_t>(what)]; };
  using Set = std::set<std::uint32_t>;
  EXPECT_EQ(of(SensedClass::kSky), Set{0});
  EXPECT_EQ(of(SensedClass::kGround), Set{0});
  EXPECT_EQ(of(SensedClass::kTree), Set{AssetInstance(0)});
  EXPECT_EQ(of(SensedClass::kBuilding), Set{AssetInstance(1)});
  EXPECT_EQ(of(SensedClass::kStone), Set{AssetInstance(2)});
  EXPECT_EQ(of(SensedClass::kAgent), Set{AgentInstance("sheep_1")});
}

TEST(RigCameraTest, FogShortensDepthAndLeavesLabelsAlone) {
  SensedWorld world = StillWorld();
  const CameraFrame clear = Look(LevelScene(), Camera(), world);
  world.atmosphere.weather = Weather::kFog;
  world.atmosphere.visibility_m = 20.0;
  const CameraFrame fog = Look(LevelScene(), Camera(), world);
  EXPECT_EQ(fog.classes, clear.classes);
  int kept = 0, lost = 0;
  for (std::size_t i = 0; i < fog.depth_m.size(); ++i) {
    if (std::isfinite(fog.depth_m[i])) {
      EXPECT_LE(fog.depth_m[i], 20.0f);
      EXPECT_EQ(fog.depth_m[i], clear.depth_m[i]);
      ++kept;
    } else {
      EXPECT_TRUE(std::isnan(fog.depth_m[i]));  // the sky looks like what fog hides
      lost += std::isfinite(clear.depth_m[i]) ? 1 : 0;
    }
  }
  EXPECT_GT(kept, 1000);
  EXPECT_GT(lost, 100);
}

TEST(RigCameraTest, DepthNoiseGrowsWithTheSquareOfTheDistance) {
  CameraSensor camera = Camera();
  camera.model.depth_noise = 0.002;
  for (const double distance_m : {3.0, 9.0}) {
    SensedWorld world = StillWorld();
    world.props = {CrateAt({distance_m + 1.0, 0.0, -20.0}, {2.0, 80.0, 60.0})};
    const CameraFrame frame = Look(LevelScene(-40.0), camera, world);
    double sum = 0.0, squares = 0.0;
    for (const float depth_m : frame.depth_m) {
      sum += depth_m - distance_m;
      squares += std::pow(depth_m - distance_m, 2);
    }
    const auto count = static_cast<double>(frame.depth_m.size());
    const double expected_m = 0.002 * distance_m * distance_m;
    EXPECT_NEAR(std::sqrt(squares / count), expected_m, 0.03 * expected_m);
    EXPECT_NEAR(sum / count, 0.0, 0.05 * expected_m);
  }
}

// Paints what it is asked to.
class Painter final : public ColourRenderer {
 public:
  void Render(const SensorScene&, const SensedWorld&, const CameraModel& model,
              const Eigen::Isometry3d& map_from_optical, std::uint32_t except_agent,
              CameraFrame* frame) const override {
    EXPECT_EQ(except_agent, 0u);
    EXPECT_TRUE(map_from_optical.linear().col(2).isApprox(Vector3d::UnitX()));   // forward
    EXPECT_TRUE(map_from_optical.linear().col(0).isApprox(-Vector3d::UnitY()));  // right
    EXPECT_TRUE(map_from_optical.translation().isApprox(Vector3d(0.0, 0.0, 1.0)));
    frame->colour.assign(3u * model.width * model.height, 100);
  }
};

TEST(RigCameraTest, ColourComesFromTheRendererAndNoiseFromTheCamera) {
  CameraSensor camera = Camera();
  camera.outputs = {true, false, false, false};
  camera.model.colour_noise = 5.0;
  SensorRigOptions options;
  EXPECT_TRUE(Look(LevelScene(), camera, StillWorld(), options).colour.empty());
  options.colours = std::make_shared<Painter>();
  const CameraFrame frame = Look(LevelScene(), camera, StillWorld(), options);
  ASSERT_EQ(frame.colour.size(), 3u * 162u * 122u);
  EXPECT_TRUE(frame.depth_m.empty());
  double squares = 0.0;
  for (const std::uint8_t value : frame.colour) squares += std::pow(value - 100.0, 2);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(frame.colour.size())), 5.0, 0.1);
}

TEST(RigCameraTest, OnlyTheWantedPicturesAreMade) {
  const auto rig = RigOf(LevelScene(), {Spec("camera", 10.0, Camera())});
  const auto frames = FramesOf(
      rig.get(), 20,
      [](std::uint64_t step) { return WorldAt(step, {RobotAt(0.0, Vector3d::Zero(), 0.0)}); },
      [](const std::string&, const SensorSpec&) {
        return SensorWish{true, {true, false, true, false}};
      });
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_TRUE(PicturesOf(frames[1]).depth_m.empty());
  EXPECT_TRUE(PicturesOf(frames[1]).instances.empty());
  EXPECT_FALSE(PicturesOf(frames[1]).classes.empty());
}

}  // namespace
}  // namespace latticeworld
