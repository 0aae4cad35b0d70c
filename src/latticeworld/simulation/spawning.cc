#include <cmath>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/spawn_rules.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/agents/bodies.h"
#include "latticeworld/simulation/agents/species.h"
#include "latticeworld/simulation/agents/steering.h"
#include "latticeworld/simulation/simulator_impl.h"

namespace latticeworld {

Status SimulatorImpl::CheckRequest(const SpawnRequest& request) const {
  if (agents_.size() >= static_cast<std::size_t>(kMaxAgents)) {
    return ResourceExhausted("the world holds " + std::to_string(agents_.size()) +
                             " agents, the most that it can");
  }
  if (!request.name.empty()) {
    LW_RETURN_IF_ERROR(CheckAgentName(request.name));
    if (ids_.count(request.name) != 0) {
      return Status(StatusCode::kAlreadyExists,
                    "there is an agent named " + Quote(request.name) + " already");
    }
  }
  if (request.state.has_value() && !CanBe(request.category, *request.state)) {
    return InvalidArgument("a " + std::string(NameOf(request.category)) + " cannot be " +
                           std::string(NameOf(*request.state)));
  }
  if (!std::isfinite(request.heading_rad)) {
    return InvalidArgument("heading must be finite, not " + FormatDouble(request.heading_rad));
  }
  if (request.position.has_value() &&
      (!std::isfinite(request.position->x_m) || !std::isfinite(request.position->y_m))) {
    return InvalidArgument("position must be finite, not (" + FormatDouble(request.position->x_m) +
                           ", " + FormatDouble(request.position->y_m) + ")");
  }
  return Status();
}

Result<WorldPoint> SimulatorImpl::PlaceFor(const SpawnRequest& request) {
  const double radius_m = BodyRadius(request.category);
  if (!request.position.has_value()) {
    std::vector<WorldPoint> taken;
    for (const auto& [id, agent] : agents_) taken.push_back(agent.place());
    return FindSpawn(*scene_, weather_->now(), request.category, radius_m, request.region, taken,
                     &spawn_random_);
  }
  LW_RETURN_IF_ERROR(
      CheckSpawn(*scene_, weather_->now(), request.category, radius_m, *request.position));
  return *request.position;
}

std::string SimulatorImpl::NameFor(const SpawnRequest& request) const {
  if (!request.name.empty()) return request.name;
  int number = 1;
  while (ids_.count(NumberedName(request.category, number)) != 0) ++number;
  return NumberedName(request.category, number);
}

Result<std::string> SimulatorImpl::Spawn(const SpawnRequest& request) {
  LW_RETURN_IF_ERROR(CheckRequest(request));
  // A refused request leaves everything as it was, the random stream too.
  const RandomStream random_before = spawn_random_;
  const Result<WorldPoint> place = PlaceFor(request);
  const auto refuse = [&](Status status) {
    spawn_random_ = random_before;
    return status;
  };
  if (!place.ok()) return refuse(place.status());
  const double radius_m = BodyRadius(request.category);
  for (const auto& [id, agent] : agents_) {
    const double gap_m = DistanceBetween(agent.place(), *place) - agent.radius_m - radius_m;
    if (gap_m > 0.0) continue;
    return refuse(FailedPrecondition("(" + FormatDouble(place->x_m) + ", " +
                                     FormatDouble(place->y_m) + ") is taken by " + agent.name));
  }

  AgentStart start;
  start.name = NameFor(request);
  start.category = request.category;
  start.state = request.state.value_or(UsualState(request.category));
  start.team = TeamOf(request.category, request.controllable);
  start.controllable = request.controllable;
  start.position = *place;
  start.height_above_ground_m = SpeciesOf(request.category).altitude_m;
  start.heading_rad = request.heading_rad;
  const Agent& agent = Begin(start);
  World().Tell(EventKind::kSpawned, agent, "");
  state_.reset();
  return agent.name;
}

Status SimulatorImpl::Remove(const std::string& name) {
  const auto found = ids_.find(name);
  if (found == ids_.end()) return NotFound("there is no agent named " + Quote(name));
  const Agent& agent = agents_.at(found->second);
  World().Tell(EventKind::kRemoved, agent, "");
  physics_->Remove(agent.body);
  agent_of_body_.erase(agent.body);
  agents_.erase(found->second);
  ids_.erase(found);
  state_.reset();
  return Status();
}

}  // namespace latticeworld
