// What is there stays when Embree has no memory for more.

#include <gtest/gtest.h>

#include <vector>

#include "latticeworld/sensing/solids/asset_tiles.h"
#include "latticeworld/sensing/solids/moving_things.h"
#include "mapping/hand_made_scene.h"
#include "sensing/sensed_things.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

bool RefuseIfFull(void* is_full, ssize_t bytes, bool) {
  return !*static_cast<const bool*>(is_full) || bytes <= 0;
}

class SensorMemoryTest : public testing::Test {
 protected:
  SensorMemoryTest() : device_(rtcNewDevice("threads=1")) {
    rtcSetDeviceMemoryMonitorFunction(device_.get(), RefuseIfFull, &full_);
    std::vector<Asset> assets;
    for (int i = 0; i < 40; ++i)
      assets.push_back(MakeTree(static_cast<float>(3 * (i % 8) - 10),
                                static_cast<float>(4 * (i / 8) - 10), 8.0f, 1.5f, 0.2f));
    scene_ = WithAssets(MakeScene(64, 64.0, [](double, double) { return 0.0; }), assets);
    tiles_ = AssetTiles::Create(device_.get(), scene_, SensorSceneOptions(), Progress()).value();
    moving_ = MovingThings::Create(device_.get()).value();
  }

  // What rays along a row of trees meet of both.
  std::vector<RayHit> Hits() const {
    std::vector<RayHit> hits;
    for (int i = 0; i < 40; ++i) {
      const Ray ray = MakeRay({-31.0f, -10.0f + 0.5f * static_cast<float>(i), 4.0f},
                              {1.0f, 0.01f * static_cast<float>(i), 0.0f});
      RayPacket packet;
      packet.Load(&ray, 1, kSeesAll);
      RTCIntersectContext context = CoherentContext();
      packet.Trace(tiles_->scene(), &context);
      RayHit hit;
      if (packet.met(0)) tiles_->Describe(packet, 0, &hit);
      if (!moving_->empty()) {
        moving_->Trace(~0u, &packet);
        if (packet.met(0)) moving_->Describe(packet, 0, &hit);
      }
      hit.distance_m = packet.rays.ray.tfar[0];
      hits.push_back(hit);
    }
    return hits;
  }

  void ExpectSame(const std::vector<RayHit>& before) const {
    const std::vector<RayHit> after = Hits();
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(after[i].target, before[i].target) << i;
      EXPECT_EQ(after[i].index, before[i].index) << i;
      EXPECT_EQ(after[i].distance_m, before[i].distance_m) << i;
    }
  }

  bool full_ = false;
  EmbreeDevice device_;
  Scene scene_;
  std::unique_ptr<AssetTiles> tiles_;
  std::unique_ptr<MovingThings> moving_;
};

TEST_F(SensorMemoryTest, TilesStayAsTheyWere) {
  const std::vector<RayHit> before = Hits();
  full_ = true;
  EXPECT_EQ(tiles_->Focus({Vector3d::Zero()}).code(), StatusCode::kResourceExhausted);
  EXPECT_EQ(tiles_->SetAbsent({3, 7, 20}).code(), StatusCode::kResourceExhausted);
  ExpectSame(before);
  full_ = false;
  // What was refused is made when it is asked for again.
  ASSERT_TRUE(tiles_->Focus({Vector3d::Zero()}).ok());
  ASSERT_TRUE(tiles_->SetAbsent({3, 7, 20}).ok());
  for (const RayHit& hit : Hits()) {
    if (hit.target == RayTarget::kNothing) continue;
    EXPECT_TRUE(hit.index != 3 && hit.index != 7 && hit.index != 20);
  }
  ASSERT_TRUE(tiles_->SetAbsent({}).ok());
  ASSERT_TRUE(tiles_->Focus({}).ok());
  ExpectSame(before);
}

TEST_F(SensorMemoryTest, MovingThingsStayWhereTheyWere) {
  SensedWorld world;
  for (int i = 0; i < 30; ++i) world.agents.push_back(MakeRobot({-20.0, 0.7 * i - 10.0, 3.7}));
  ASSERT_TRUE(moving_->Prepare(world, scene_.assets, tiles_.get()).ok());
  moving_->Use();
  const std::vector<RayHit> before = Hits();
  SensedWorld later = world;
  for (int i = 0; i < 300; ++i) later.agents.push_back(MakeRobot({-25.0, 0.07 * i - 10.0, 3.7}));
  full_ = true;
  EXPECT_EQ(moving_->Prepare(later, scene_.assets, tiles_.get()).code(),
            StatusCode::kResourceExhausted);
  ExpectSame(before);
  full_ = false;
  ASSERT_TRUE(moving_->Prepare(later, scene_.assets, tiles_.get()).ok());
  ExpectSame(before);  // until they are used
  moving_->Use();
  int nearer = 0;
  const std::vector<RayHit> after = Hits();
  for (std::size_t i = 0; i < after.size(); ++i)
    nearer += after[i].distance_m < before[i].distance_m ? 1 : 0;
  EXPECT_GT(nearer, 30);
}

}  // namespace
}  // namespace latticeworld
