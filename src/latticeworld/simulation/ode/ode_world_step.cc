// How a step of OdeWorld goes, and how its contacts are solved.

#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

constexpr int kSolverIterations = 12;
// Chains of hinges converge slowly, and so do brakes that hold a robot on a slope.
constexpr int kFineSolverIterations = 30;

}  // namespace

void OdeWorld::Step(double step_s, std::uint64_t solver_seed) {
  LW_CHECK(step_s > 0.0 && std::isfinite(step_s), "a step takes some time");
  contacts_.clear();
  strayed_.clear();
  FindContacts(step_s);
  joints_->Join(step_s);
  Solve(step_s, solver_seed);
  WatchEnergy(step_s);
  joints_->Finish(&contacts_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    OdeBody* body = bodies_[i].body.get();
    const bool sound = body->stands() ? !body->Mend() : body->FinishStep(step_s);
    if (!sound) strayed_.push_back(bodies_[i].id);
  }
}

void OdeWorld::FindContacts(double step_s) {
  const auto begin = std::chrono::steady_clock::now();
  TouchBodies();
  for (Entry& entry : bodies_) {
    OdeBody* body = entry.body.get();
    if (body->stands()) continue;
    body->BeginStep(step_s);
    TouchGroundOf(body, step_s);
    if (body->ball_radius_m() >= 0.0) TouchAssetsOf(&entry);
    TouchBoundaryOf(body, step_s);
  }
  collision_time_ = std::chrono::steady_clock::now() - begin;
}

void OdeWorld::Solve(double step_s, std::uint64_t solver_seed) {
  // ODE has one number of iterations for all islands, but leaves out what is disabled.
  constexpr char kOut = 0, kFine = 1, kCoarse = 2;
  fine_.assign(bodies_.size(), kOut);
  bool any_fine = false;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const OdeBody& body = *bodies_[i].body;
    if (body.stands()) continue;
    fine_[i] = body.link_count() > 0 || body.Brakes() ? kFine : kCoarse;
    any_fine = any_fine || fine_[i] == kFine;
  }
  dWorldSetQuickStepNumIterations(world_, kSolverIterations);
  if (!any_fine) {
    StepOde(world_, step_s, solver_seed);
    return;
  }
  for (bool spread = true; spread;) {
    spread = false;
    for (const ContactJoint& joint : joints_->found()) {
      if (joint.body_a == 0 || joint.body_b == 0) continue;
      char& a = fine_[IndexOf(joint.body_a)];
      char& b = fine_[IndexOf(joint.body_b)];
      if (a == b) continue;
      a = b = kFine;
      spread = true;
    }
  }
  const auto set_enabled = [this](char which, bool enabled) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (fine_[i] != which) continue;
      const OdeBody& body = *bodies_[i].body;
      for (std::size_t k = 0; k < body.part_count(); ++k) {
        enabled ? dBodyEnable(body.part(k)) : dBodyDisable(body.part(k));
      }
    }
  };
  set_enabled(kFine, false);
  StepOde(world_, step_s, solver_seed);
  set_enabled(kCoarse, false);
  set_enabled(kFine, true);
  dWorldSetQuickStepNumIterations(world_, kFineSolverIterations);
  StepOde(world_, step_s, solver_seed);
  set_enabled(kCoarse, true);
}

}  // namespace latticeworld
