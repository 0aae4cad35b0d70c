// The camera of a rig: all pictures of one moment.

#include <utility>

#include "latticeworld/sensing/camera/camera_renderer.h"
#include "latticeworld/sensing/counter_noise.h"
#include "latticeworld/sensing/rig_sensor.h"
#include "latticeworld/sensing/weather_effects.h"

namespace latticeworld {
namespace {

class RigCamera final : public RigSensor {
 public:
  RigCamera(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent, std::uint64_t key)
      : spec_(std::move(spec)),
        camera_(std::get<CameraSensor>(spec_->model)),
        renderer_(camera_.model),
        clock_(spec_->rate_hz),
        base_from_optical_(BaseFromSensor(*spec_, agent.height_m) * SensorFromOptical()),
        key_(key) {}

  bool IsCollecting() const override { return false; }

  Status Step(const RigStep& step, const SensorWish& wish,
              std::vector<SensorFrame>* frames) override {
    RigWorld& shared = *step.shared;
    const SensedWorld& world = shared.world();
    if (!wish.any || !clock_.IsDue(world.step, step.step_s)) return Status();
    CameraOutputs outputs;
    outputs.colour = camera_.outputs.colour && wish.pictures.colour;
    outputs.depth = camera_.outputs.depth && wish.pictures.depth;
    outputs.class_labels = camera_.outputs.class_labels && wish.pictures.class_labels;
    outputs.instance_labels = camera_.outputs.instance_labels && wish.pictures.instance_labels;

    LW_ASSIGN_OR_RETURN(const SensorScene* scene, shared.Rays());
    const std::uint64_t key = KeyOf(key_, clock_.Number(world.step, step.step_s));
    CameraFrame frame;
    frame.time_s = world.time_s;
    CameraShot shot;
    shot.scene = scene;
    shot.world = &world;
    shot.conditions = ConditionsIn(world.atmosphere);
    shot.map_from_optical = step.agent->map_from_base * base_from_optical_;
    shot.except_agent = step.agent_index;
    shot.key = KeyOf(key, 0);
    shot.threads = step.threads;
    renderer_.Render(shot, outputs, &frame);
    if (outputs.colour && shared.options().colours != nullptr) {
      shared.options().colours->Render(*scene, world, camera_.model, shot.map_from_optical,
                                       step.agent_index, &frame);
      AddColourNoise(camera_.model, KeyOf(key, 1), &frame);
    }
    frames->push_back({step.agent->name, spec_, world.time_s, std::move(frame)});
    return Status();
  }

 private:
  // Optical: z forward, x right, y down.
  static Eigen::Isometry3d SensorFromOptical() {
    Eigen::Isometry3d sensor_from_optical = Eigen::Isometry3d::Identity();
    sensor_from_optical.linear() << 0.0, 0.0, 1.0,  //
        -1.0, 0.0, 0.0,                             //
        0.0, -1.0, 0.0;
    return sensor_from_optical;
  }

  std::shared_ptr<const SensorSpec> spec_;
  CameraSensor camera_;
  CameraRenderer renderer_;
  SensorClock clock_;
  Eigen::Isometry3d base_from_optical_;
  std::uint64_t key_;
};

}  // namespace

std::unique_ptr<RigSensor> MakeRigCamera(std::shared_ptr<const SensorSpec> spec,
                                         const SensedAgent& agent, std::uint64_t key) {
  return std::make_unique<RigCamera>(std::move(spec), agent, key);
}

}  // namespace latticeworld
