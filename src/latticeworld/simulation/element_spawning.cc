#include "latticeworld/common/text.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/footprint.h"
#include "latticeworld/simulation/simulator_impl.h"

namespace latticeworld {

Result<std::string> SimulatorImpl::SpawnElement(const Element& element) {
  if (!element.name.empty()) LW_RETURN_IF_ERROR(CheckName(element.name));
  for (const auto& [id, agent] : agents_) {
    if (agent.species->plan == BodyPlan::kFlyer) continue;
    if (DistanceToElement(element, element.position, element.yaw_rad, agent.place()) <=
        agent.species->radius_m) {
      return FailedPrecondition("(" + FormatDouble(element.position.x_m) + ", " +
                                FormatDouble(element.position.y_m) + ") is taken by " + agent.name);
    }
  }
  Element named = element;
  if (named.name.empty()) named.name = NumberedNameFor(std::string(NameOf(element.kind)));
  const Result<std::string> name = elements_->Add(named);
  if (!name.ok()) return name;
  const auto running = elements_->state().find(*name);
  TellOf(EventKind::kSpawned, *name, "", physics_->MotionOf(running->second.body).position_m);
  state_.reset();
  return name;
}

Status SimulatorImpl::RemoveElement(const std::string& name) {
  const auto running = elements_->state().find(name);
  if (running == elements_->state().end()) {
    return NoneNamed("element", name, elements_->state());
  }
  const Eigen::Vector3d position_m = physics_->MotionOf(running->second.body).position_m;
  LW_RETURN_IF_ERROR(elements_->Remove(name));
  TellOf(EventKind::kRemoved, name, "", position_m);
  state_.reset();
  return Status();
}

Status SimulatorImpl::OpenGate(const std::string& element, double opening_rad) {
  LW_RETURN_IF_ERROR(elements_->OpenGate(element, opening_rad));
  state_.reset();
  return Status();
}

}  // namespace latticeworld
