#ifndef LATTICEWORLD_TESTS_SIMULATION_PROPS_THING_WORLD_H_
#define LATTICEWORLD_TESTS_SIMULATION_PROPS_THING_WORLD_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/ode_world.h"
#include "latticeworld/simulation/props/felling.h"
#include "latticeworld/simulation/props/props.h"

namespace latticeworld {

// Physics with trees that fall and props, and nobody who thinks.
class ThingWorld : private ContactJudge {
 public:
  explicit ThingWorld(std::shared_ptr<const Scene> the_scene)
      : scene(std::move(the_scene)),
        physics(MakeOdeWorld(scene)),
        felling(*scene, physics.get()),
        props(*scene, physics.get()) {
    physics->SetJudge(this);
  }
  ~ThingWorld() override { physics->SetJudge(nullptr); }

  void Step(double step_s) {
    felling.Act(scene->atmosphere);
    props.Act(scene->atmosphere, step_s);
    physics->Step(step_s, ++steps);
    const Felling::Outcome trees = felling.Step(
        step_s, steps, [](BodyId body) { return "body_" + std::to_string(body); }, &events);
    map_changes += trees.maps ? 1 : 0;
    props.Step(step_s, steps, &events);
  }
  void Run(double seconds, double step_s = 0.01) {
    for (double time_s = 0.0; time_s < seconds - 0.5 * step_s; time_s += step_s) Step(step_s);
  }
  int Count(EventKind kind) const {
    int count = 0;
    for (const Event& event : events) count += event.kind == kind ? 1 : 0;
    return count;
  }
  std::string Hash() const {
    Digest digest;
    physics->AddTo(&digest);
    felling.AddTo(&digest);
    props.AddTo(&digest);
    return digest.Hex();
  }

  const std::shared_ptr<const Scene> scene;
  const std::unique_ptr<PhysicsWorld> physics;
  Felling felling;
  Props props;
  std::vector<Event> events;
  std::uint64_t steps = 0;
  int map_changes = 0;  // steps in which what maps show of trees changed

 private:
  bool GivesWay(const Contact& contact) override {
    return contact.kind == ContactKind::kAsset ? felling.GivesWay(contact)
                                               : props.GivesWay(contact);
  }
};

// A block that stays upright and slides with hardly any friction, its front at +x.
inline BodySpec RammerOf(double mass_kg, const Eigen::Vector3d& size_m, double bottom_m = 0.1) {
  BodySpec spec;
  spec.mass_kg = mass_kg;
  spec.center_height_m = bottom_m + 0.5 * size_m.z();
  spec.inertia_kgm2.setConstant(mass_kg * size_m.squaredNorm() / 12.0);
  BodyShape box;
  box.form = ShapeForm::kBox;
  box.half_extents_m = 0.5 * size_m;
  box.center_m = {0.0, 0.0, spec.center_height_m};
  spec.shapes = {box};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      spec.ground_samples.push_back({{x * size_m.x(), y * size_m.y(), 0.0}, 0.0});
    }
  }
  spec.upright = true;
  spec.grip = 0.02;
  return spec;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SIMULATION_PROPS_THING_WORLD_H_
