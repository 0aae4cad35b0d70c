#include "latticeworld/simulation/ode/island_group.h"

#include <algorithm>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/ode/ode_library.h"

namespace latticeworld {
namespace {

constexpr double kErrorReduction = 0.3;    // of joints
constexpr double kSurfaceLayer_m = 0.001;  // depth at which contacts rest
constexpr int kSolverIterations = 12;
// Chains of hinges converge slowly, and so do brakes that hold a robot on a slope.
constexpr int kFineSolverIterations = 45;

constexpr char kOut = 0, kFine = 1, kCoarse = 2;

OdeWorldHandle MakeWorld(const OdeThreading& threading) {
  OdeWorldHandle made = threading.MakeWorld();
  const dWorldID world = made.get();
  dWorldSetGravity(world, 0.0, 0.0, -kGravity_mps2);
  dWorldSetERP(world, kErrorReduction);
  dWorldSetCFM(world, 1e-9);
  dWorldSetContactSurfaceLayer(world, kSurfaceLayer_m);
  dWorldSetAutoDisableFlag(world, 0);
  return made;
}

}  // namespace

IslandGroup::IslandGroup() : world_(MakeWorld(threading_)), joints_(world()) {}

void IslandGroup::Clear() {
  members_.clear();
  contacts.clear();
  asked.clear();
  search_time = {};
  strayed_.clear();
  slowed_.clear();
}

void IslandGroup::Step(double step_s, std::uint64_t solver_seed, std::vector<Contact>* of_two) {
  joints_.Join(step_s);
  Solve(step_s, solver_seed);
  WatchEnergy(step_s);
  joints_.Finish(of_two, &contacts);
  for (OdeBody* member : members_) {
    const bool sound = member->stands() ? !member->Mend() : member->FinishStep(step_s);
    if (!sound) strayed_.push_back(member->id());
  }
}

std::size_t IslandGroup::PlaceOf(const OdeBody* member) const {
  const auto found = std::lower_bound(members_.begin(), members_.end(), member->id(),
                                      [](const OdeBody* one, BodyId id) { return one->id() < id; });
  LW_CHECK(found != members_.end() && *found == member, "bodies of two groups touch");
  return static_cast<std::size_t>(found - members_.begin());
}

void IslandGroup::SetEnabled(char which, bool enabled) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (fine_[i] != which) continue;
    for (const dBodyID part : members_[i]->parts().all()) {
      enabled ? dBodyEnable(part) : dBodyDisable(part);
    }
  }
}

void IslandGroup::Solve(double step_s, std::uint64_t solver_seed) {
  // ODE has one number of iterations for all islands, but leaves out what is disabled.
  fine_.assign(members_.size(), kOut);
  bool any_fine = false, any_coarse = false;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const OdeBody& body = *members_[i];
    if (body.stands()) continue;
    fine_[i] = body.parts().link_count() > 0 || body.control().Brakes() ? kFine : kCoarse;
    (fine_[i] == kFine ? any_fine : any_coarse) = true;
  }
  for (bool spread = any_fine && any_coarse; spread;) {
    spread = false;
    for (const ContactJoint& joint : joints_.found()) {
      if (joint.b.body == nullptr) continue;
      char& a = fine_[PlaceOf(joint.a.body)];
      char& b = fine_[PlaceOf(joint.b.body)];
      if (a == b) continue;
      a = b = kFine;
      spread = true;
    }
  }
  if (any_coarse) {
    if (any_fine) SetEnabled(kFine, false);
    dWorldSetQuickStepNumIterations(world(), kSolverIterations);
    StepOde(world(), step_s, solver_seed);
    if (any_fine) SetEnabled(kFine, true);
  }
  if (any_fine) {
    if (any_coarse) SetEnabled(kCoarse, false);
    dWorldSetQuickStepNumIterations(world(), kFineSolverIterations);
    StepOde(world(), step_s, solver_seed);
    if (any_coarse) SetEnabled(kCoarse, true);
  }
}

}  // namespace latticeworld
