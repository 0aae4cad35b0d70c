#include "latticeworld/sensing/solids/mesh_instances.h"

#include <gtest/gtest.h>

#include "latticeworld/sensing/solids/scene_instances.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

bool RefuseMemory(void*, ssize_t bytes, bool) { return bytes <= 0; }

// A device that has no memory for anything new.
EmbreeDevice FullDevice() {
  EmbreeDevice device(rtcNewDevice(nullptr));
  rtcSetDeviceMemoryMonitorFunction(device.get(), RefuseMemory, nullptr);
  return device;
}

TEST(MeshInstancesTest, AMeshWithoutMemoryIsAnError) {
  const EmbreeDevice device = FullDevice();
  const auto made =
      MakePrototype(device.get(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {0});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().code(), StatusCode::kResourceExhausted);
}

TEST(MeshInstancesTest, ErrorsOfWorkersAreNotLost) {
  std::vector<Asset> assets;
  for (int i = 0; i < 20; ++i)
    assets.push_back(MakeTree(static_cast<float>(3 * i - 30), 0.0f, 8.0f, 2.0f, 0.2f));
  Scene scene = WithAssets(MakeScene(32, 64.0, [](double, double) { return 0.0; }), assets);
  scene.agents.emplace_back();
  const EmbreeDevice device = FullDevice();
  for (const int threads : {1, 4}) {
    RaySceneOptions options;
    options.threads = threads;
    const auto made = AssetInstances(device.get(), scene, options, Progress());
    ASSERT_FALSE(made.ok()) << threads;
    EXPECT_EQ(made.status().code(), StatusCode::kResourceExhausted);
  }
  EXPECT_FALSE(AgentInstances(device.get(), scene).ok());
}

}  // namespace
}  // namespace latticeworld
