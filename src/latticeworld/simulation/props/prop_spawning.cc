#include "latticeworld/common/text.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/simulator/simulator_impl.h"

namespace latticeworld {

Result<std::string> SimulatorImpl::SpawnProp(const Prop& prop) {
  if (!prop.name.empty()) LW_RETURN_IF_ERROR(CheckName(prop.name));
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal element", Validate(prop)));
  const Footprint footprint = FootprintOf(prop);
  const auto taken_by = [&prop](const std::string& what) {
    return FailedPrecondition("(" + FormatDouble(prop.position.x_m) + ", " +
                              FormatDouble(prop.position.y_m) + ") is taken by " + what);
  };
  for (const auto& [id, agent] : agents_) {
    if (agent.species->plan == BodyPlan::kFlyer) continue;
    if (GapTo(footprint, agent.place()) <= agent.species->radius_m) return taken_by(agent.name);
  }
  for (const Footprint& stem : felling_->Obstacles()) {
    if (GapBetween(footprint, stem) <= 0.0) return taken_by("a tree that lies or falls");
  }
  Prop named = prop;
  if (named.name.empty()) named.name = NumberedNameFor(std::string(NameOf(prop.kind)));
  const Result<std::string> name = props_->Add(named, changes_);
  if (!name.ok()) return name;
  const auto running = props_->state().find(*name);
  TellOf(EventKind::kSpawned, *name, "", physics_->MotionOf(running->second.body).position_m);
  ++map_version_;
  ListChanges();
  state_.reset();
  return name;
}

Status SimulatorImpl::RemoveProp(const std::string& name) {
  const auto running = props_->state().find(name);
  if (running == props_->state().end()) {
    return NoneNamed("element", name, props_->state());
  }
  const Eigen::Vector3d position_m = physics_->MotionOf(running->second.body).position_m;
  LW_RETURN_IF_ERROR(props_->Remove(name));
  strays_.erase(name);
  TellOf(EventKind::kRemoved, name, "", position_m);
  ++map_version_;
  ListChanges();
  state_.reset();
  return Status();
}

Status SimulatorImpl::OpenGate(const std::string& prop, double opening_rad) {
  LW_RETURN_IF_ERROR(props_->OpenGate(prop, opening_rad));
  state_.reset();
  return Status();
}

}  // namespace latticeworld
