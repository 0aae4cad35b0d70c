#include "latticeworld/sensing/solids/scene_group.h"

#include <utility>

namespace latticeworld {

void SceneGroup::Fill(const std::vector<RTCScene>& scenes, Side* side) const {
  if (side->scene == nullptr) {
    side->scene.reset(rtcNewScene(device_));
    rtcSetSceneFlags(side->scene.get(),
                     static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC));
  }
  while (side->instances.size() < scenes.size()) {
    EmbreeGeometry instance(rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE));
    if (instance == nullptr) return;
    rtcDisableGeometry(instance.get());
    rtcAttachGeometryByID(side->scene.get(), instance.get(),
                          static_cast<unsigned>(side->instances.size()));
    side->instances.push_back(std::move(instance));
    side->scenes.push_back(nullptr);
  }
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (scenes[i] == side->scenes[i]) continue;
    const RTCGeometry instance = side->instances[i].get();
    if (scenes[i] == nullptr) {
      rtcDisableGeometry(instance);
    } else {
      rtcSetGeometryInstancedScene(instance, scenes[i]);
      rtcEnableGeometry(instance);
      rtcCommitGeometry(instance);
    }
    side->scenes[i] = scenes[i];
  }
  rtcCommitScene(side->scene.get());
}

Status SceneGroup::Prepare(const std::vector<RTCScene>& scenes) {
  Side& side = sides_[1 - active_];
  Fill(scenes, &side);
  Status status = EmbreeStatus(device_);
  if (!status.ok()) side = Side();
  return status;
}

}  // namespace latticeworld
