#include "latticeworld/simulation/simulator/agent_roster.h"

#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/agents/minds/thinking.h"

namespace latticeworld {

Agent& AgentRoster::Add(Agent agent) {
  const AgentId id = agent.id;
  in_step_.clear();
  ids_[agent.name] = id;
  return agents_.emplace(id, std::move(agent)).first->second;
}

void AgentRoster::Erase(AgentId id) {
  const Agent& agent = agents_.at(id);
  agent_of_body_.erase(agent.body);
  ids_.erase(agent.name);
  agents_.erase(id);
  in_step_.clear();
  places_ = AgentGrid();
}

void AgentRoster::Clear() {
  agents_.clear();
  ids_.clear();
  agent_of_body_.clear();
  in_step_.clear();
  places_ = AgentGrid();
}

void AgentRoster::SetBody(BodyId body, Agent* agent) {
  agent_of_body_.erase(agent->body);
  agent->body = body;
  agent_of_body_[body] = agent->id;
}

Result<Agent*> AgentRoster::Find(const std::string& name) {
  const auto found = ids_.find(name);
  if (found != ids_.end()) return &agents_.at(found->second);
  return NoneNamed("agent", name, ids_);
}

AgentId AgentRoster::IdOfBody(BodyId body) const {
  const auto found = agent_of_body_.find(body);
  return found == agent_of_body_.end() ? AgentId{0} : found->second;
}

void AgentRoster::BeginStep(double world_size_m) {
  FindPlaces(world_size_m);
  if (in_step_.size() == agents_.size()) return;
  in_step_.clear();
  for (auto& [id, agent] : agents_) in_step_.push_back(&agent);
}

void AgentRoster::Restore(const std::map<AgentId, Agent>& agents) {
  // Assigned over what is there, whose memory is taken again: a restore runs many times a second
  // where planners try commands out.
  agents_ = agents;
  ids_.clear();
  agent_of_body_.clear();
  in_step_.clear();
  places_ = AgentGrid();
  for (const auto& [id, agent] : agents_) {
    ids_[agent.name] = id;
    agent_of_body_[agent.body] = id;
  }
}

void AgentRoster::AddTo(Digest* digest) const {
  digest->Add(static_cast<std::uint64_t>(agents_.size()));
  for (const auto& [id, agent] : agents_) latticeworld::AddTo(digest, agent);
}

}  // namespace latticeworld
