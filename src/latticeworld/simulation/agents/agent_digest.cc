#include <optional>
#include <vector>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/agents/minds/thinking.h"

namespace latticeworld {
namespace {

void AddPoint(Digest* digest, WorldPoint point) {
  digest->Add(point.x_m);
  digest->Add(point.y_m);
}

void AddVector(Digest* digest, const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i) digest->Add(vector[i]);
}

void AddSize(Digest* digest, std::size_t size) { digest->Add(static_cast<std::uint64_t>(size)); }

void AddPoints(Digest* digest, const std::vector<WorldPoint>& points) {
  AddSize(digest, points.size());
  for (const WorldPoint& point : points) AddPoint(digest, point);
}

void AddOptional(Digest* digest, const std::optional<WorldPoint>& point) {
  digest->Add(point.has_value());
  if (point.has_value()) AddPoint(digest, *point);
}

void AddVelocity(Digest* digest, const VelocityCommand& velocity) {
  AddVector(digest, velocity.linear_mps);
  digest->Add(velocity.yaw_rate_radps);
}

void AddSteering(Digest* digest, const Steering& steering) {
  digest->Add(steering.heading_rad);
  digest->Add(steering.speed_mps);
  digest->Add(steering.base_z_m.has_value());
  if (steering.base_z_m.has_value()) digest->Add(*steering.base_z_m);
  AddOptional(digest, steering.hold);
  digest->Add(steering.strike);
}

void AddSighting(Digest* digest, const Sighting& sighting) {
  digest->Add(sighting.who);
  digest->Add(sighting.team);
  AddVector(digest, sighting.position_m);
  AddVector(digest, sighting.velocity_mps);
  digest->Add(sighting.step);
  digest->Add(sighting.seen_now);
  digest->Add(sighting.only_heard);
}

void AddPath(Digest* digest, const PathPlan& plan) {
  AddPoints(digest, plan.points);
  AddPoint(digest, plan.goal);
  digest->Add(plan.complete);
  digest->Add(plan.made_at);
  digest->Add(plan.map_version);
  digest->Add(plan.nearest_m);
  digest->Add(plan.nearest_at);
  digest->Add(plan.followed_at);
  digest->Add(plan.sidestep_until);
}

void AddAmbush(Digest* digest, const AmbushPlan& plan) {
  AddPoints(digest, plan.watched);
  digest->Add(plan.tries);
  digest->Add(plan.fewest);
  AddOptional(digest, plan.best);
}

void AddMind(Digest* digest, const Mind& mind) {
  for (const std::uint64_t word : mind.random.state()) digest->Add(word);
  AddPoint(digest, mind.home);
  digest->Add(mind.home_z_m);
  AddSize(digest, mind.memory.size());
  for (const Sighting& sighting : mind.memory) AddSighting(digest, sighting);
  AddPoints(digest, mind.route);
  AddSize(digest, mind.next_place);
  AddOptional(digest, mind.goal);
  digest->Add(mind.goal_until);
  digest->Add(mind.pause_until);
  AddPath(digest, mind.path);
  digest->Add(mind.turn_side);
  digest->Add(mind.target);
  digest->Add(mind.hit_by);
  digest->Add(mind.hit_at);
  digest->Add(mind.alarmed_until);
  digest->Add(mind.searched_until);
  digest->Add(mind.closes_at);
  AddAmbush(digest, mind.ambush);
  AddOptional(digest, mind.hide);
  AddSteering(digest, mind.steering);
}

void AddStart(Digest* digest, const AgentStart& start) {
  digest->Add(start.state);
  digest->Add(start.team);
  AddPoint(digest, start.position);
  digest->Add(start.height_above_ground_m);
  digest->Add(start.heading_rad);
}

void AddBody(Digest* digest, const Agent& agent) {
  digest->Add(agent.body);
  digest->Add(agent.posture.down);
  digest->Add(agent.posture.still_since);
  digest->Add(agent.posture.gait_phase);
  digest->Add(agent.posture.water_s);
  digest->Add(agent.posture.commanded_joints);
  digest->Add(agent.posture.stands);
  digest->Add(agent.posture.righting);
  AddVector(digest, agent.posture.gait_trim);
  digest->Add(agent.posture.turn_trim_radps);
  AddVelocity(digest, agent.driven);
  AddSize(digest, agent.joint_targets.size());
  for (const auto& [joint, target] : agent.joint_targets) {
    AddSize(digest, joint);
    digest->Add(target.mode);
    digest->Add(target.value);
  }
  digest->Add(agent.joints_until);
}

}  // namespace

void AddTo(Digest* digest, const Agent& agent) {
  digest->Add(agent.id);
  digest->AddText(agent.name);
  digest->AddText(agent.species->name);
  digest->Add(agent.state);
  digest->Add(agent.team);
  digest->Add(agent.controllable);
  digest->AddText(agent.policy);
  AddStart(digest, agent.start);
  digest->Add(agent.hit_points);
  digest->Add(agent.died_at);
  digest->Add(agent.behaviour);
  digest->Add(agent.command.has_value());
  if (agent.command.has_value()) AddVelocity(digest, *agent.command);
  digest->Add(agent.command_until);
  digest->Add(agent.strike_wanted);
  digest->Add(agent.next_blow);
  digest->Add(agent.next_collision);
  AddBody(digest, agent);
  AddMind(digest, agent.mind);
}

}  // namespace latticeworld
