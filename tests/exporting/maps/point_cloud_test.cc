#include "latticeworld/exporting/maps/point_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "generation/test_world.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

class PointCloudTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;

  std::vector<CloudPoint> Sample(const PointCloudOptions& options) const {
    auto points = SamplePoints(scene_, options, Progress());
    EXPECT_TRUE(points.ok()) << points.status().ToString();
    return *points;
  }
};

TEST_F(PointCloudTest, PointsLieOnWhatTheySay) {
  PointCloudOptions options;
  options.spacing_m = 0.4;
  std::map<PointLabel, int> counts;
  for (const CloudPoint& point : Sample(options)) {
    ++counts[point.label];
    const WorldPoint place = {point.position_m.x(), point.position_m.y()};
    if (point.label == PointLabel::kGround) {
      ASSERT_NEAR(point.position_m.z(), scene_.terrain->ground.HeightAt(place), 1e-4);
    } else if (point.label == PointLabel::kWater) {
      ASSERT_NEAR(point.position_m.z(), -0.9, 1e-5);
    } else if (point.asset >= 0) {
      const Asset& asset = scene_.assets.at(static_cast<std::size_t>(point.asset));
      ASSERT_LE(std::hypot(place.x_m - asset.x_m, place.y_m - asset.y_m),
                std::hypot(asset.half_length_m, asset.half_width_m) * 1.01 + 1e-3);
      ASSERT_GE(point.position_m.z(), asset.z_m - 1e-3);
    }
  }
  EXPECT_EQ(counts[PointLabel::kGround], 80 * 80);  // 32 m at 0.4 m
  for (const PointLabel label : {PointLabel::kWater, PointLabel::kTree, PointLabel::kBuilding})
    EXPECT_GT(counts[label], 5) << NameOf(label);
}

TEST_F(PointCloudTest, DensityIsAPointToTheSpacingSquared) {
  PointCloudOptions fine, coarse;
  fine.spacing_m = 0.25;
  coarse.spacing_m = 0.5;
  const auto on_things = [&](const PointCloudOptions& options) {
    double count = 0.0;
    for (const CloudPoint& point : Sample(options)) count += point.asset >= 0 ? 1.0 : 0.0;
    return count;
  };
  EXPECT_NEAR(on_things(fine) / on_things(coarse), 4.0, 0.2);
}

TEST_F(PointCloudTest, SeedsMovePointsOnThingsOnly) {
  PointCloudOptions options, other;
  other.seed = 1;
  const auto a = Sample(options), b = Sample(options), c = Sample(other);
  EXPECT_EQ(ToPly(a), ToPly(b));
  EXPECT_NE(ToPly(a), ToPly(c));
  EXPECT_EQ(a.front().position_m, c.front().position_m);
}

TEST_F(PointCloudTest, LasHasEveryPointToTheMillimetre) {
  const auto points = Sample({});
  const std::string las = *ToLas(points, GeoOrigin{47.0, 8.0, 0.0});
  const auto at = [&las](std::size_t offset, auto value) {
    std::memcpy(&value, las.data() + offset, sizeof value);
    return value;
  };
  EXPECT_EQ(las.substr(0, 4), "LASF");
  const std::size_t start = at(96, std::uint32_t());
  const std::size_t length = at(105, std::uint16_t());
  EXPECT_EQ(at(247, std::uint64_t()), points.size());
  ASSERT_EQ(las.size(), start + length * points.size());
  for (std::size_t i = 0; i < points.size(); i += 97) {
    const std::size_t record = start + i * length;
    EXPECT_NEAR(0.001 * at(record + 8, std::int32_t()), points[i].position_m.z(), 5.1e-4);
    EXPECT_EQ(at(record + 16, std::uint8_t()), LasClassOf(points[i].label));
    EXPECT_EQ(at(record + 30, std::uint16_t()), 257 * points[i].color.r);
  }
}

TEST_F(PointCloudTest, TooManyAndUnusableAreRefused) {
  PointCloudOptions options;
  for (const double spacing_m : {0.0, -1.0, std::nan(""), 1e9}) {
    options.spacing_m = spacing_m;
    EXPECT_EQ(SamplePoints(scene_, options, Progress()).status().code(),
              StatusCode::kInvalidArgument);
  }
  options.region = ExportRegion{-50.0, 0.0, 10.0, 10.0};
  EXPECT_EQ(SamplePoints(scene_, options, Progress()).status().violations().size(), 2u);
}

}  // namespace
}  // namespace latticeworld
