#include "latticeworld/sensing/rig_world.h"

#include "latticeworld/common/progress.h"

namespace latticeworld {

void RigWorld::BeginStep(const SensedWorld& world, std::vector<Eigen::Vector3d> eyes_m) {
  world_ = &world;
  eyes_m_ = std::move(eyes_m);
  rays_are_of_step_ = surfaces_are_of_step_ = false;
}

Result<const SensorScene*> RigWorld::Rays() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!rays_) {
    SensorSceneOptions options;
    options.threads = options_.threads;
    LW_ASSIGN_OR_RETURN(rays_, SensorScene::Create(scene_, options, Progress()));
  }
  if (!rays_are_of_step_) {
    LW_RETURN_IF_ERROR(rays_->Update(*world_));
    LW_RETURN_IF_ERROR(rays_->Focus(eyes_m_));
    rays_are_of_step_ = true;
  }
  return &*rays_;
}

const LidarSurfaces& RigWorld::surfaces() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!surfaces_) surfaces_.emplace(scene_);
  if (!surfaces_are_of_step_) surfaces_->SetWeather(world_->atmosphere);
  surfaces_are_of_step_ = true;
  return *surfaces_;
}

}  // namespace latticeworld
