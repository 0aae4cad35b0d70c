#include "latticeworld/episode/episode_metrics.h"

#include <algorithm>
#include <map>

namespace latticeworld {
namespace {

AgentMetrics MetricsOfTrack(const AgentTrack& track) {
  AgentMetrics metrics;
  metrics.name = track.name;
  metrics.species = track.species;
  metrics.team = track.team;
  metrics.joint_work_j = track.joint_work_j;
  if (track.points.empty()) return metrics;
  double moved_s = 0.0;
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    const TrackPoint& point = track.points[i];
    metrics.max_speed_mps = std::max(metrics.max_speed_mps, point.speed_mps);
    if (i == 0 || !point.continues) continue;
    const TrackPoint& before = track.points[i - 1];
    metrics.distance_m += (point.position_m - before.position_m).norm();
    metrics.climb_m += std::max(0.0, point.position_m.z() - before.position_m.z());
    moved_s += point.time_s - before.time_s;
  }
  const double first_s = track.points.front().time_s, last_s = track.points.back().time_s;
  metrics.present_s = last_s - first_s;
  metrics.survived_s = metrics.present_s;
  if (moved_s > 0.0) metrics.mean_speed_mps = metrics.distance_m / moved_s;
  metrics.last_health = track.points.back().health;
  return metrics;
}

}  // namespace

std::vector<AgentMetrics> MetricsOf(const EpisodeRecord& record) {
  std::map<std::string, AgentMetrics> by_name;
  for (const auto& [name, track] : record.tracks) by_name[name] = MetricsOfTrack(track);
  for (const EpisodeEvent& event : record.events) {
    const auto other = by_name.find(event.other);
    if (event.kind == "pursued" && other != by_name.end()) ++other->second.pursued;
    if (event.kind == "hit" && other != by_name.end()) ++other->second.blows_given;
    const auto agent = by_name.find(event.agent);
    if (agent == by_name.end()) continue;
    AgentMetrics& metrics = agent->second;
    if (event.kind == "collided") ++metrics.collisions;
    if (event.kind == "hit") ++metrics.blows_taken;
    if (event.kind == "knocked_over") ++metrics.falls;
    if (event.kind == "died" && metrics.deaths++ == 0) {
      const std::vector<TrackPoint>& points = record.tracks.at(event.agent).points;
      if (!points.empty()) {
        metrics.survived_s =
            std::clamp(event.time_s - points.front().time_s, 0.0, metrics.present_s);
      }
    }
  }
  std::vector<AgentMetrics> all;
  for (auto& entry : by_name) all.push_back(std::move(entry.second));
  return all;
}

}  // namespace latticeworld
