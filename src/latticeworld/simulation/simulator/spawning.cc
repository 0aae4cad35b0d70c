#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/agents/agent_placement.h"
#include "latticeworld/scene/agents/spawn_rules.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "latticeworld/simulation/simulator/simulator_impl.h"

namespace latticeworld {
namespace {

constexpr int kRobotTeam = 1;
constexpr int kTries = 8;  // places that the rules allow and something that moved is in the way of
constexpr double kStemSpacing_m = 3.0;  // between the places that a fallen stem takes

std::string At(WorldPoint place) {
  return "(" + FormatDouble(place.x_m) + ", " + FormatDouble(place.y_m) + ")";
}

}  // namespace

Status SimulatorImpl::CheckName(const std::string& name) const {
  LW_RETURN_IF_ERROR(CheckAgentName(name));
  if (!IsNameTaken(name)) return Status();
  return Status(StatusCode::kAlreadyExists,
                "there is an agent or element named " + Quote(name) + " already");
}

bool SimulatorImpl::IsNameTaken(const std::string& name) const {
  return ids_.count(name) != 0 || props_->Has(name);
}

std::string SimulatorImpl::NumberedNameFor(const std::string& kind) const {
  int number = 1;
  while (IsNameTaken(NumberedName(kind, number))) ++number;
  return NumberedName(kind, number);
}

Result<const Species*> SimulatorImpl::SpeciesFor(const SpawnRequest& request) const {
  if (request.species.empty()) return &options_.species->Of(request.category);
  if (const Species* species = options_.species->Find(request.species)) return species;
  std::vector<std::string> names;
  for (const Species& one : options_.species->all()) names.push_back(one.name);
  return InvalidArgument("there is no species " + Quote(request.species) + ": there are " +
                         Join(names, ", "));
}

Status SimulatorImpl::CheckRequest(const SpawnRequest& request, const Species& species) const {
  if (agents_.size() >= static_cast<std::size_t>(kMaxAgentStarts)) {
    return ResourceExhausted("the world holds " + std::to_string(agents_.size()) +
                             " agents; it can hold no more than " +
                             std::to_string(kMaxAgentStarts));
  }
  if (!request.name.empty()) LW_RETURN_IF_ERROR(CheckName(request.name));
  if (request.state.has_value() && !CanBe(species.category, *request.state)) {
    return InvalidArgument("a " + species.name + " cannot be " +
                           std::string(NameOf(*request.state)));
  }
  LW_RETURN_IF_ERROR(Status::FromViolations("spawn", Validate(request)));
  if (request.controllable && !request.policy.empty()) {
    return InvalidArgument("a controllable agent follows its own commands: it has no policy, not " +
                           Quote(request.policy));
  }
  return Status();
}

Status SimulatorImpl::CheckFree(const Species& species, WorldPoint place, AgentId except) const {
  const auto taken_by = [&](const std::string& what) {
    return FailedPrecondition(At(place) + " is taken by " + what);
  };
  for (const auto& [id, agent] : agents_) {
    if (id == except) continue;
    const double gap_m =
        DistanceBetween(agent.place(), place) - agent.species->radius_m - species.radius_m;
    if (gap_m <= 0.0) return taken_by(agent.name);
  }
  if (species.plan == BodyPlan::kFlyer) return Status();
  for (const auto& [name, running] : props_->state()) {
    if (GapTo(props_->BoxNow(running).footprint, place) <= species.radius_m) {
      return taken_by(name);
    }
  }
  for (const Footprint& stem : felling_->Obstacles()) {
    if (GapTo(stem, place) <= species.radius_m) return taken_by("a tree that lies or falls");
  }
  return Status();
}

Result<WorldPoint> SimulatorImpl::PlaceFor(const SpawnRequest& request, const Species& species) {
  if (request.position.has_value()) {
    const Status fits = CheckSpawn(*scene_, weather_->now(), species.category, species.radius_m,
                                   *request.position, &changes_);
    if (!fits.ok()) {
      return species.name == NameOf(species.category) ? fits : fits.WithContext(species.name);
    }
    LW_RETURN_IF_ERROR(CheckFree(species, *request.position, 0));
    return *request.position;
  }
  std::vector<WorldPoint> taken;
  for (const auto& [id, agent] : agents_) taken.push_back(agent.place());
  for (const auto& [name, running] : props_->state()) {
    const Eigen::Vector3d at = physics_->MotionOf(running.body).position_m;
    taken.push_back({at.x(), at.y()});
  }
  for (const Footprint& stem : felling_->Obstacles()) {
    const int places = 1 + static_cast<int>(2.0 * stem.half_length_m / kStemSpacing_m);
    for (int i = 0; i <= places; ++i) {
      taken.push_back(stem.At(stem.half_length_m * (2.0 * i / places - 1.0), 0.0));
    }
  }
  Status in_the_way;
  for (int i = 0; i < kTries; ++i) {
    const Result<WorldPoint> place =
        FindSpawn(*scene_, weather_->now(), species.category, species.radius_m, request.region,
                  taken, &spawn_random_, &changes_);
    if (!place.ok()) return place;
    in_the_way = CheckFree(species, *place, 0);
    if (in_the_way.ok()) return place;
  }
  return in_the_way;
}

Result<std::string> SimulatorImpl::Spawn(const SpawnRequest& request) {
  const Result<const Species*> found = SpeciesFor(request);
  if (!found.ok()) return found.status();
  const Species& species = **found;
  LW_RETURN_IF_ERROR(CheckRequest(request, species));
  // A refused request leaves everything as it was, the random stream too.
  const RandomStream random_before = spawn_random_;
  const Result<WorldPoint> place = PlaceFor(request, species);
  if (!place.ok()) {
    spawn_random_ = random_before;
    return place.status();
  }

  AgentStart start;
  start.name = request.name.empty() ? NumberedNameFor(species.name) : request.name;
  start.category = species.category;
  start.state = request.state.value_or(UsualState(species.category));
  start.team = request.team.value_or(request.controllable ? kRobotTeam : TeamOf(species.category));
  start.controllable = request.controllable;
  start.position = *place;
  start.height_above_ground_m = species.altitude_m;
  start.heading_rad = request.heading_rad;
  const Agent& agent = Begin(start, species, request.policy);
  TellOf(EventKind::kSpawned, agent.name, "", agent.motion.position_m);
  state_.reset();
  return agent.name;
}

Status SimulatorImpl::Remove(const std::string& name) {
  const Result<Agent*> found = FindAgent(name);
  if (!found.ok()) return found.status();
  const Agent& agent = **found;
  TellOf(EventKind::kRemoved, agent.name, "", agent.motion.position_m);
  Erase(agent.id);
  return Status();
}

void SimulatorImpl::Erase(AgentId id) {
  const Agent& agent = agents_.at(id);
  physics_->Remove(agent.body);
  agent_of_body_.erase(agent.body);
  frozen_until_.erase(id);
  strays_.erase(agent.name);
  ids_.erase(agent.name);
  agents_.erase(id);
  in_order_.clear();
  // Who was near whom is found anew by each step; until then nobody is.
  near_ = AgentGrid();
  state_.reset();
}

}  // namespace latticeworld
