#include "latticeworld/common/text.h"
#include "latticeworld/scene/elements.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/simulator_impl.h"

namespace latticeworld {

Result<std::string> SimulatorImpl::SpawnElement(const Element& element) {
  if (!element.name.empty()) LW_RETURN_IF_ERROR(CheckName(element.name));
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal element", Validate(element)));
  const Footprint footprint = FootprintOf(element);
  const auto taken_by = [&element](const std::string& what) {
    return FailedPrecondition("(" + FormatDouble(element.position.x_m) + ", " +
                              FormatDouble(element.position.y_m) + ") is taken by " + what);
  };
  for (const auto& [id, agent] : agents_) {
    if (agent.species->plan == BodyPlan::kFlyer) continue;
    if (GapTo(footprint, agent.place()) <= agent.species->radius_m) return taken_by(agent.name);
  }
  for (const Footprint& stem : felling_->Obstacles()) {
    if (GapBetween(footprint, stem) <= 0.0) return taken_by("a tree that lies or falls");
  }
  Element named = element;
  if (named.name.empty()) named.name = NumberedNameFor(std::string(NameOf(element.kind)));
  const Result<std::string> name = elements_->Add(named, changes_);
  if (!name.ok()) return name;
  const auto running = elements_->state().find(*name);
  TellOf(EventKind::kSpawned, *name, "", physics_->MotionOf(running->second.body).position_m);
  ++map_version_;
  ListChanges();
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
  strays_.erase(name);
  TellOf(EventKind::kRemoved, name, "", position_m);
  ++map_version_;
  ListChanges();
  state_.reset();
  return Status();
}

Status SimulatorImpl::OpenGate(const std::string& element, double opening_rad) {
  LW_RETURN_IF_ERROR(elements_->OpenGate(element, opening_rad));
  state_.reset();
  return Status();
}

}  // namespace latticeworld
