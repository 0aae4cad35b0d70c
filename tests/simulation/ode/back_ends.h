#ifndef LATTICEWORLD_TESTS_SIMULATION_ODE_BACK_ENDS_H_
#define LATTICEWORLD_TESTS_SIMULATION_ODE_BACK_ENDS_H_

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/ode_world.h"
#include "latticeworld/simulation/physics_world.h"
#include "simulation/ode/test_bodies.h"
#include "simulation/test_scene.h"

namespace latticeworld {

// Makers of PhysicsWorld: whoever writes another one adds it here and has every test of the
// contract run on it.
struct BackEnd {
  std::string name;
  std::unique_ptr<PhysicsWorld> (*make)(std::shared_ptr<const Scene> scene);
};
inline std::vector<BackEnd> BackEnds() {
  return {{"Ode", [](std::shared_ptr<const Scene> scene) { return MakeOdeWorld(scene); }}};
}

class PhysicsContract : public testing::TestWithParam<BackEnd> {
 protected:
  static std::unique_ptr<PhysicsWorld> Make(const TestScene& scene = TestScene()) {
    return GetParam().make(scene.Build());
  }
};
#define LATTICEWORLD_ON_EVERY_BACK_END(suite)         \
  INSTANTIATE_TEST_SUITE_P(                           \
      BackEnds, suite, testing::ValuesIn(BackEnds()), \
      [](const testing::TestParamInfo<BackEnd>& info) { return info.param.name; })

inline constexpr double kStep_s = 0.01;

inline void StepFor(PhysicsWorld* physics, double seconds, std::uint64_t first_seed = 0) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep_s)); ++i) {
    physics->Step(kStep_s, first_seed + static_cast<std::uint64_t>(i));
  }
}

inline std::string DigestOf(const PhysicsWorld& physics) {
  Digest digest;
  physics.AddTo(&digest);
  return digest.Hex();
}

using test_bodies::Ball;
using test_bodies::Box;
using test_bodies::BoxInertia;
using test_bodies::Robot;
using test_bodies::Walker;

inline void DriveAll(PhysicsWorld* physics, BodyId body, double rate_radps, double steer_rad = 0) {
  for (std::size_t i = 0; i < physics->SpecOf(body).wheels.size(); ++i) {
    physics->SetWheel(body, i, rate_radps, steer_rad);
  }
}

inline double Friction(SurfaceClass surface) { return DryPropertiesOf(surface).friction; }

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SIMULATION_ODE_BACK_ENDS_H_
