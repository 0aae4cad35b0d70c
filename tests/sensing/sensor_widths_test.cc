// Embree takes a packet apart into as many rays as the processor traces at once.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "latticeworld/sensing/solids/asset_tiles.h"
#include "latticeworld/sensing/solids/moving_things.h"
#include "mapping/hand_made_scene.h"
#include "sensing/sensed_things.h"

namespace latticeworld {
namespace {

// What 320 rays across a grove full of robots meet; none baked. Empty: this machine cannot do so.
std::vector<RayHit> HitsOn(const char* processor) {
  const EmbreeDevice device(rtcNewDevice(processor));
  if (device == nullptr || rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) return {};
  std::vector<Asset> assets;
  for (int i = 0; i < 40; ++i)
    assets.push_back(MakeTree(static_cast<float>(3 * (i % 8) - 10),
                              static_cast<float>(4 * (i / 8) - 10), 8.0f, 1.5f, 0.2f));
  const Scene scene = WithAssets(MakeScene(64, 64.0, [](double, double) { return 0.0; }), assets);
  const auto tiles =
      AssetTiles::Create(device.get(), scene, SensorSceneOptions(), Progress()).value();
  const auto moving = MovingThings::Create(device.get()).value();
  SensedWorld world;
  for (int i = 0; i < 30; ++i)
    world.agents.push_back(MakeRobot({0.9 * i - 14.0, 5.0 * std::sin(i), 0.0}, i));
  world.props = {
      MakeProp(PropKind::kLooseStone, {2.0, 2.0, 2.0}, {-8.0, 2.0, 0.0}),
  };
  EXPECT_TRUE(moving->Prepare(world, scene.assets, tiles.get()).ok());
  moving->Use();

  std::vector<RayHit> hits;
  for (int first = 0; first < 320; first += RayPacket::kSize) {
    std::vector<Ray> rays;
    for (int i = first; i < first + RayPacket::kSize; ++i)
      rays.push_back(MakeRay({-31.0f, -12.0f + 0.075f * static_cast<float>(i), 0.5f},
                             {1.0f, 0.0f, 0.004f * static_cast<float>(i % 7) - 0.012f}));
    RayPacket packet;
    packet.Load(rays.data(), RayPacket::kSize, kSeesAll);
    std::vector<RayHit> met(RayPacket::kSize);
    RTCIntersectContext context = CoherentContext();
    packet.Trace(tiles->scene(), &context);
    for (int lane = 0; lane < RayPacket::kSize; ++lane)
      if (packet.met(lane)) tiles->Describe(packet, lane, &met[lane]);
    moving->Trace(7, &packet);
    for (int lane = 0; lane < RayPacket::kSize; ++lane) {
      if (packet.met(lane)) moving->Describe(packet, lane, &met[lane]);
      if (packet.met_any[lane] != 0) met[lane].distance_m = packet.rays.ray.tfar[lane];
    }
    hits.insert(hits.end(), met.begin(), met.end());
  }
  return hits;
}

TEST(SensorWidthsTest, WideAndNarrowProcessorsMeetTheSame) {
  const std::vector<RayHit> expected = HitsOn("threads=1");
  ASSERT_FALSE(expected.empty());
  int trees = 0, robots = 0, stones = 0;
  for (const RayHit& hit : expected) {
    trees += hit.target == RayTarget::kAsset ? 1 : 0;
    robots += hit.target == RayTarget::kAgent ? 1 : 0;
    stones += hit.target == RayTarget::kProp ? 1 : 0;
    EXPECT_FALSE(hit.target == RayTarget::kAgent && hit.index == 7);
  }
  EXPECT_GT(trees, 5);
  EXPECT_GT(robots, 50);
  EXPECT_GT(stones, 10);
  for (const char* processor : {"threads=1,isa=sse2", "threads=1,isa=sse4.2", "threads=1,isa=avx",
                                "threads=1,isa=avx2", "threads=1,isa=avx512"}) {
    const std::vector<RayHit> hits = HitsOn(processor);
    if (hits.empty()) continue;
    int differing = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
      differing += hits[i].target == expected[i].target && hits[i].index == expected[i].index &&
                           (hits[i].distance_m == expected[i].distance_m ||
                            std::abs(hits[i].distance_m - expected[i].distance_m) < 1e-3f)
                       ? 0
                       : 1;
    EXPECT_LE(differing, 3) << processor;
  }
}

}  // namespace
}  // namespace latticeworld
