#include "latticeworld/simulation/simulator/map_state.h"

#include <cmath>

#include "latticeworld/common/digest.h"
#include "latticeworld/scene/surface_table.h"

namespace latticeworld {
namespace {

// Whether bodies climb as steep on them, as far as maps care.
bool HoldAlike(const SurfaceTable& a, const SurfaceTable& b) {
  constexpr double kMapStep_rad = 0.02;
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    for (const bool on_wheels : {true, false}) {
      if (std::abs(ClimbableSlope(a.Of(entry.value), 1.0, on_wheels) -
                   ClimbableSlope(b.Of(entry.value), 1.0, on_wheels)) > kMapStep_rad)
        return false;
    }
  }
  return true;
}

}  // namespace

void MapState::List(const DynamicScene& scene) {
  changes_ = scene.felling().changes();
  changes_.props = scene.props().standing();
  changes_.ground = ground_;
}

void MapState::FollowGround(const RunningWeather& weather, const DynamicScene& scene) {
  const GroundState ground = weather.now().ground();
  const GroundState of_scene = scene_->atmosphere.ground();
  const bool differs = ground != changes_.ground.value_or(of_scene);
  if (!differs ||
      (weather.moving() && HoldAlike(weather.surfaces(), SurfacesIn(*scene_, changes_))))
    return;
  ground_ = ground;
  if (ground == of_scene) ground_.reset();
  NewVersion();
  List(scene);
}

MapState::State MapState::Save() const {
  State state;
  state.version = version_;
  state.ground = ground_;
  return state;
}

void MapState::Restore(const State& state) {
  version_ = state.version;
  ground_ = state.ground;
}

void MapState::AddTo(Digest* digest) const {
  digest->Add(version_);
  const GroundState ground = ground_.value_or(scene_->atmosphere.ground());
  for (const double value : {ground.wetness, ground.snow_depth_m, ground.blown_sand})
    digest->Add(value);
}

}  // namespace latticeworld
