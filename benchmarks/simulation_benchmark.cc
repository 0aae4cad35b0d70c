// Steps a second of a living world, beside a bare ODE loop as it is commonly written: the same land
// as a dHeightfield, every tree a geom in a quadtree space, and as many boxes as there are agents.

#include <benchmark/benchmark.h>
#include <ode/ode.h>

#include <string>
#include <vector>

#include "example_world.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;

std::string Agents(int count) {
  const int sheep = count / 2, horses = count / 5, goblins = count / 5;
  return std::to_string(sheep) + " sheep graze. " + std::to_string(horses) + " horses graze. " +
         std::to_string(goblins) + " goblins patrol. " +
         std::to_string(count - sheep - horses - goblins) +
         " eagles circle above. A wheeled robot waits in the center.";
}

void SetRates(benchmark::State& state, std::size_t bodies) {
  const double steps = static_cast<double>(state.iterations());
  state.SetItemsProcessed(state.iterations());
  state.counters["bodies"] = static_cast<double>(bodies);
  state.counters["real_time_factor"] =
      benchmark::Counter(steps * kStep_s, benchmark::Counter::kIsRate);
}

void BM_SimulatorStep(benchmark::State& state) {
  const auto world = ExampleWorld(Agents(static_cast<int>(state.range(0))));
  SimulatorOptions options;
  options.step_s = kStep_s;
  options.command_timeout_s = 60.0;
  const auto simulator = Simulator::Create(world->scene, options, 1).value();
  VelocityCommand forward;
  forward.linear_mps.x() = 1.0;
  for (int i = 0; i < 500; ++i) simulator->Step();  // everything has come to rest or got going
  std::int64_t step = 0;
  for (auto _ : state) {
    if (step++ % 1000 == 0) (void)simulator->Command("robot", forward);
    simulator->Step();
  }
  SetRates(state, simulator->State()->agents.size());
}
BENCHMARK(BM_SimulatorStep)->Arg(10)->Arg(50)->Arg(200)->Unit(benchmark::kMicrosecond);

class BareOde {
 public:
  BareOde(const Scene& scene, int boxes) {
    dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    group_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, 0, 0, -9.81);
    dWorldSetQuickStepNumIterations(world_, 20);
    AddGround(scene);
    AddTrees(scene);
    for (int i = 0; i < boxes; ++i) AddBox(scene, scene.agents[static_cast<std::size_t>(i)]);
  }
  ~BareOde() {
    dJointGroupDestroy(group_);
    dSpaceDestroy(space_);
    dGeomHeightfieldDataDestroy(heights_);
    dWorldDestroy(world_);
    dCloseODE();
  }
  BareOde(const BareOde&) = delete;
  BareOde& operator=(const BareOde&) = delete;

  void Step() {
    dSpaceCollide(space_, this, &Near);
    dWorldQuickStep(world_, kStep_s);
    dJointGroupEmpty(group_);
  }

 private:
  static void Near(void* self, dGeomID a, dGeomID b) {
    auto* ode = static_cast<BareOde*>(self);
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
      dSpaceCollide2(a, b, self, &Near);
      return;
    }
    if (dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr) return;
    dContact contacts[8] = {};
    const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      contacts[i].surface.mode = dContactApprox1;
      contacts[i].surface.mu = 0.8;
      dJointAttach(dJointCreateContact(ode->world_, ode->group_, &contacts[i]), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  void AddGround(const Scene& scene) {
    const Grid<float>& height_m = scene.terrain->ground.height_m();
    heights_ = dGeomHeightfieldDataCreate();
    const double width = scene.geometry().resolution_m() * (height_m.cols() - 1);
    dGeomHeightfieldDataBuildSingle(heights_, height_m.data(), 0, width, width, height_m.cols(),
                                    height_m.rows(), 1, 0, 1, 0);
    dGeomHeightfieldDataSetBounds(heights_, scene.terrain->ground.min_m(),
                                  scene.terrain->ground.max_m());
    const dGeomID ground = dCreateHeightfield(space_, heights_, 1);
    dMatrix3 y_up_to_z_up;
    dRFromAxisAndAngle(y_up_to_z_up, 1, 0, 0, M_PI / 2);
    dGeomSetRotation(ground, y_up_to_z_up);
  }

  void AddTrees(const Scene& scene) {
    const dVector3 center = {0, 0, 0, 0};
    const double half = scene.geometry().half_size_m();
    const dVector3 extents = {half, half, 500, 0};
    const dSpaceID trees = dQuadTreeSpaceCreate(space_, center, extents, 7);
    for (const Asset& asset : scene.assets) {
      if (asset.kind != AssetKind::kTree) continue;
      const dGeomID trunk = dCreateCylinder(nullptr, asset.trunk_radius_m, asset.height_m);
      dGeomSetPosition(trunk, asset.x_m, asset.y_m, asset.z_m + 0.5 * asset.height_m);
      dSpaceAdd(trees, trunk);
    }
  }

  void AddBox(const Scene& scene, const AgentStart& start) {
    const dBodyID body = dBodyCreate(world_);
    dMass mass;
    dMassSetBoxTotal(&mass, 50.0, 0.8, 0.5, 0.6);
    dBodySetMass(body, &mass);
    const dGeomID geom = dCreateBox(space_, 0.8, 0.5, 0.6);
    dGeomSetBody(geom, body);
    dBodySetPosition(body, start.position.x_m, start.position.y_m,
                     scene.terrain->ground.HeightAt(start.position) + 0.35);
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID group_;
  dHeightfieldDataID heights_;
};

void BM_BareOdeBoxes(benchmark::State& state) {
  const auto world = ExampleWorld(Agents(static_cast<int>(state.range(0))));
  const int boxes = static_cast<int>(world->scene->agents.size());
  BareOde ode(*world->scene, boxes);
  for (int i = 0; i < 500; ++i) ode.Step();
  for (auto _ : state) ode.Step();
  SetRates(state, static_cast<std::size_t>(boxes));
}
BENCHMARK(BM_BareOdeBoxes)->Arg(10)->Arg(50)->Arg(200)->Unit(benchmark::kMicrosecond);

void BM_Reset(benchmark::State& state) {
  const auto world = ExampleWorld(Agents(50));
  const auto simulator = Simulator::Create(world->scene, SimulatorOptions(), 1).value();
  for (auto _ : state) simulator->Reset(1);
}
BENCHMARK(BM_Reset)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
