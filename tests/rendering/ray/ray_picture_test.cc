#include "latticeworld/rendering/ray/ray_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/looks/picture_assets.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

constexpr int kWidth_px = 120, kHeight_px = 80;
constexpr float kField_rad = 1.0f;

Scene Plain(double height_m = 1.0) {
  return MakeScene(64, 64.0, [=](double, double) { return height_m; });
}

RayCamera FromAbove() {
  return RayCamera::Looking({0.0f, -0.1f, 40.0f}, static_cast<float>(M_PI / 2.0), -1.5f, kField_rad,
                            kWidth_px, kHeight_px);
}

cv::Mat Picture(const Scene& scene, const RayCamera& camera, RayPictureOptions options = {}) {
  cv::Mat bgr(kHeight_px, kWidth_px, CV_8UC3, cv::Scalar(1, 2, 3));
  const Status status = TracePicture(scene, MaterialsOf(scene), camera, options, Progress(), &bgr);
  EXPECT_TRUE(status.ok()) << status.ToString();
  return bgr;
}

double BrightnessAround(const cv::Mat& bgr, const Eigen::Vector2f& at, int reach = 3) {
  const cv::Rect box(static_cast<int>(at.x()) - reach, static_cast<int>(at.y()) - reach, 2 * reach,
                     2 * reach);
  const cv::Scalar mean = cv::mean(bgr(box & cv::Rect(0, 0, bgr.cols, bgr.rows)));
  return mean[0] + mean[1] + mean[2];
}

TEST(RayCameraTest, AKnownPointLiesOnAKnownPixel) {
  // 90 degrees wide, looking east from 2 m above the origin: what is 10 m ahead and 10 m to the
  // right (south) lies on the right edge.
  const RayCamera camera =
      RayCamera::Looking({0.0f, 0.0f, 2.0f}, 0.0f, 0.0f, static_cast<float>(M_PI / 2.0), 200, 100);
  EXPECT_TRUE(camera.Project({10.0f, 0.0f, 2.0f}).isApprox(Eigen::Vector2f(100.0f, 50.0f), 1e-4f));
  EXPECT_TRUE(
      camera.Project({10.0f, -10.0f, 2.0f}).isApprox(Eigen::Vector2f(200.0f, 50.0f), 1e-4f));
  EXPECT_TRUE(camera.Project({10.0f, 0.0f, 7.0f}).isApprox(Eigen::Vector2f(100.0f, 0.0f), 1e-4f) ||
              std::abs(camera.Project({10.0f, 0.0f, 7.0f}).y()) < 1e-3f);
}

TEST(RayCameraTest, DirectionsLeadToWhatIsProjectedThere) {
  for (const float heading : {0.0f, 0.7f, 2.0f, -2.5f}) {
    for (const float pitch : {-1.2f, -0.2f, 0.0f, 0.9f}) {
      const RayCamera camera =
          RayCamera::Looking({3.0f, -4.0f, 5.0f}, heading, pitch, 1.1f, 320, 200);
      for (const Eigen::Vector2f& at :
           {Eigen::Vector2f(0.5f, 0.5f), Eigen::Vector2f(160.0f, 100.0f),
            Eigen::Vector2f(300.0f, 20.0f)}) {
        const Eigen::Vector3f point = camera.eye_m() + 25.0f * camera.DirectionAt(at.x(), at.y());
        EXPECT_NEAR((camera.Project(point) - at).norm(), 0.0f, 2e-2f);
        EXPECT_GT(camera.DepthOf(point), 0.0f);
      }
    }
  }
}

TEST(RayPictureTest, ThingsAreWhereTheCameraProjectsThem) {
  Scene scene = Plain();
  const cv::Mat without = Picture(scene, FromAbove());
  const cv::Mat with =
      Picture(WithAssets(scene, {MakeBuilding(6.0f, 4.0f, 3.0f, 2.0f, 2.0f, 0.0f)}), FromAbove());
  cv::Mat difference;
  cv::absdiff(with, without, difference);
  const Eigen::Vector2f roof = FromAbove().Project({6.0f, 4.0f, 4.0f});
  const Eigen::Vector2f elsewhere = FromAbove().Project({-6.0f, -4.0f, 4.0f});
  EXPECT_GT(BrightnessAround(difference, roof, 2), 40.0);
  EXPECT_LT(BrightnessAround(difference, elsewhere, 2), 4.0);
}

TEST(RayPictureTest, ShadowsFallAwayFromTheSun) {
  Scene scene = WithAssets(Plain(), {MakeBuilding(0.0f, 0.0f, 8.0f, 2.0f, 2.0f, 0.0f)});
  for (const double azimuth_rad : {0.0, 1.6, 3.1, 4.7}) {
    const Eigen::Vector3d sun =
        Eigen::Vector3d(std::cos(azimuth_rad), std::sin(azimuth_rad), 1.0).normalized();
    scene.atmosphere.sun_direction = sun;
    const cv::Mat picture = Picture(scene, FromAbove());
    const auto ground_at = [&](double along_m) {
      return BrightnessAround(
          picture,
          FromAbove().Project(
              Eigen::Vector3d(along_m * std::cos(azimuth_rad), along_m * std::sin(azimuth_rad), 1.0)
                  .cast<float>()),
          2);
    };
    EXPECT_GT(ground_at(5.5), 1.25 * ground_at(-5.5)) << azimuth_rad;
  }
}

TEST(RayPictureTest, FogHidesFarThingsMoreThanNearOnes) {
  // Houses on the left against the same view without them.
  const RayCamera camera = RayCamera::Looking({0.0f, -30.0f, 3.0f}, static_cast<float>(M_PI / 2.0),
                                              0.0f, kField_rad, kWidth_px, kHeight_px);
  const auto contrast = [&](double visibility_m, float away_m) {
    Scene scene = Plain();
    scene.atmosphere.visibility_m = visibility_m;
    const Eigen::Vector3f at(0.0f, -30.0f + away_m, 3.0f);
    const Scene with = WithAssets(
        scene, {MakeBuilding(0.0f, at.y() + 2.0f, 0.25f * away_m, 2.0f, 0.2f * away_m, 0.0f)});
    return std::abs(BrightnessAround(Picture(scene, camera), camera.Project(at), 2) -
                    BrightnessAround(Picture(with, camera), camera.Project(at), 2));
  };
  const double near_share = contrast(60.0, 8.0) / contrast(20000.0, 8.0);
  const double far_share = contrast(60.0, 50.0) / contrast(20000.0, 50.0);
  EXPECT_GT(near_share, 1.8 * far_share);
}

TEST(RayPictureTest, NightIsDarkerThanDuskAndDuskThanNoon) {
  Scene scene = Plain();
  const RayCamera camera =
      RayCamera::Looking({0.0f, 0.0f, 3.0f}, 0.5f, -0.1f, kField_rad, kWidth_px, kHeight_px);
  const auto brightness = [&](TimeOfDay time) {
    scene.environment.coarse.time_of_day = time;
    scene.atmosphere = DeriveAtmosphere(scene.environment.coarse, 0.0, 0.0);
    const cv::Scalar mean = cv::mean(Picture(scene, camera));
    return mean[0] + mean[1] + mean[2];
  };
  const double noon = brightness(TimeOfDay::kNoon), dusk = brightness(TimeOfDay::kDusk),
               night = brightness(TimeOfDay::kNight);
  EXPECT_LT(night, 0.6 * dusk);
  EXPECT_LT(dusk, noon);
  EXPECT_GT(night, 15.0);  // but not black
}

TEST(RayPictureTest, AnyNumberOfThreadsGivesTheSamePicture) {
  Scene scene = WithWater(MakeScene(64, 64.0, [](double x_m, double) { return 0.1 * x_m; }), -1.0f);
  std::vector<Asset> assets;
  for (int i = 0; i < 12; ++i)
    assets.push_back(MakeTree(-20.0f + 4.0f * static_cast<float>(i), 10.0f, 9.0f, 2.5f, 0.2f));
  for (const auto& style : EnumNames(ArtisticStyle{})) {
    scene.environment.coarse.artistic_style = style.value;
    const RayCamera camera =
        RayCamera::Looking({0.0f, -20.0f, 4.0f}, 1.5f, -0.1f, kField_rad, kWidth_px, kHeight_px);
    RayPictureOptions options;
    options.threads = 1;
    const cv::Mat one = Picture(WithAssets(scene, assets), camera, options);
    options.threads = 3;
    const cv::Mat three = Picture(WithAssets(scene, assets), camera, options);
    EXPECT_EQ(cv::norm(one, three, cv::NORM_INF), 0.0) << style.name;
  }
}

TEST(RayPictureTest, TheWorldGoesOnBeyondItsEdgeUnlessItIsABlock) {
  // From the middle of the north edge northward, a little down.
  const RayCamera camera = RayCamera::Looking({0.0f, 31.0f, 6.0f}, static_cast<float>(M_PI / 2.0),
                                              -0.5f, kField_rad, kWidth_px, kHeight_px);
  RayPictureOptions block;
  block.surroundings = RaySurroundings::kBlock;
  block.block_m = 3.0f;
  const cv::Vec3b before(1, 2, 3);
  EXPECT_EQ(Picture(Plain(), camera, block).at<cv::Vec3b>(40, 60), before);
  const cv::Vec3b land = Picture(Plain(), camera).at<cv::Vec3b>(40, 60);
  EXPECT_GT(land[1], land[0]);  // meadow
}

TEST(RayPictureTest, ABlocksCutsShowItsEarthAndItsWater) {
  const RayCamera camera = RayCamera::Looking({0.0f, -60.0f, 0.0f}, static_cast<float>(M_PI / 2.0),
                                              0.0f, kField_rad, kWidth_px, kHeight_px);
  RayPictureOptions block;
  block.surroundings = RaySurroundings::kBlock;
  block.block_m = 6.0f;
  const Scene dry = Plain(1.0), wet = WithWater(Plain(1.0), 4.0f);
  const auto pixel = [&](const Scene& scene, float z_m) {
    const Eigen::Vector2f at = camera.Project({0.0f, -32.0f, z_m});
    return Picture(scene, camera, block)
        .at<cv::Vec3b>(static_cast<int>(at.y()), static_cast<int>(at.x()));
  };
  const cv::Vec3b earth = pixel(dry, -2.0f), water = pixel(wet, 2.5f);
  EXPECT_GT(earth[2], earth[0]);
  EXPECT_GT(water[0], water[2]);
  EXPECT_EQ(pixel(dry, -6.5f), cv::Vec3b(1, 2, 3));  // below the block
}

TEST(RayPictureTest, StylesScaleWhatIsDrawnAndRealisticDoesNot) {
  Scene scene = WithAssets(Plain(), {MakeTree(0.0f, 0.0f, 9.0f, 2.5f, 0.2f),
                                     MakeBuilding(9.0f, 9.0f, 6.0f, 4.0f, 4.0f, 0.0f)});
  const auto drawn = [&](ArtisticStyle style) {
    scene.environment.coarse.artistic_style = style;
    return DrawnAssets(scene, 0.0f);
  };
  const auto natural = drawn(ArtisticStyle::kRealistic), cartoon = drawn(ArtisticStyle::kCartoon),
             neon = drawn(ArtisticStyle::kCyberpunk);
  EXPECT_EQ(natural[0].half_length_m, 2.5f);
  EXPECT_EQ(natural[1].height_m, 6.0f);
  EXPECT_GT(cartoon[0].half_length_m, 2.5f);
  EXPECT_GT(neon[1].height_m, 6.0f);
  for (const auto* list : {&cartoon, &neon})
    for (std::size_t i = 0; i < natural.size(); ++i) {
      EXPECT_EQ((*list)[i].x_m, natural[i].x_m);
      EXPECT_EQ((*list)[i].trunk_radius_m, natural[i].trunk_radius_m);
    }
  EXPECT_EQ(DrawnAssets(scene, 8.5f).size(), 1u);  // small things are left out
}

TEST(RaySkyTest, ClarityFollowsTheVisibility) {
  Scene scene = Plain();
  scene.atmosphere.visibility_m = 300.0;
  const RaySky sky(scene);
  EXPECT_FLOAT_EQ(sky.Clarity(0.0f), 1.0f);
  EXPECT_NEAR(sky.Clarity(300.0f), 0.05f, 1e-3f);
  EXPECT_NEAR(sky.Clarity(150.0f), std::sqrt(0.05f), 1e-3f);
}

TEST(RaySkyTest, RainyNightsAreNotBlack) {
  Scene scene = Plain();
  scene.environment.coarse.time_of_day = TimeOfDay::kNight;
  const auto skylight = [&](Weather weather) {
    scene.environment.coarse.weather = weather;
    scene.atmosphere = DeriveAtmosphere(scene.environment.coarse, 0.0, 0.0);
    return Brightness(RaySky(scene).Ambient(Eigen::Vector3f::UnitZ()));
  };
  EXPECT_GT(skylight(Weather::kRain), 1.2f * skylight(Weather::kSunny));
}

TEST(RaySkyTest, LampsAreLitAtNightOnly) {
  Scene scene = Plain();
  const auto lit = [&](TimeOfDay time) {
    scene.environment.coarse.time_of_day = time;
    scene.atmosphere = DeriveAtmosphere(scene.environment.coarse, 0.0, 0.0);
    return RaySky(scene).lamps_are_lit();
  };
  EXPECT_FALSE(lit(TimeOfDay::kNoon));
  EXPECT_FALSE(lit(TimeOfDay::kMorning));
  EXPECT_TRUE(lit(TimeOfDay::kNight));
  EXPECT_TRUE(lit(TimeOfDay::kDusk));
}

}  // namespace
}  // namespace latticeworld
