#include "latticeworld/episode/episode_text.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/episode/episode_metrics.h"

namespace latticeworld {
namespace {

std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}
std::string Cell(double value) { return FormatDouble(value); }
std::string Cell(int value) { return std::to_string(value); }

template <typename... Values>
void AddRow(std::string* csv, const Values&... values) {
  const char* separator = "";
  ((*csv += separator + Cell(values), separator = ","), ...);
  *csv += "\n";
}

std::string Fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

void AddAgents(const std::vector<AgentMetrics>& all, std::ostringstream* text) {
  std::size_t width = 5;
  for (const AgentMetrics& one : all) width = std::max(width, one.name.size());
  *text << "\n  " << std::left << std::setw(static_cast<int>(width)) << "agent"
        << "  team   way [m]  top [m/s]  collisions  blows given/taken  deaths  health\n";
  for (const AgentMetrics& one : all) {
    *text << "  " << std::left << std::setw(static_cast<int>(width)) << one.name << std::right
          << std::setw(6) << one.team << std::setw(10) << Fixed(one.distance_m, 1) << std::setw(11)
          << Fixed(one.max_speed_mps, 2) << std::setw(12) << one.collisions << std::setw(19)
          << std::to_string(one.blows_given) + "/" + std::to_string(one.blows_taken) << std::setw(8)
          << one.deaths << std::setw(8) << Fixed(one.last_health, 2) << "\n";
  }
}

}  // namespace

std::string SummaryOf(const EpisodeRecord& record) {
  std::ostringstream text;
  text << "episode  " << record.name << "\n"
       << "world    " << record.world_id << "\n"
       << "seed     " << record.seed << "\n"
       << "length   " << Fixed(record.duration_s, 2) << " s of simulated time, " << record.steps
       << " steps\n"
       << "record   " << record.calls << " calls that changed the simulation, " << record.hashes
       << " hashes of its state\n"
       << "end      " << (record.ended_by.empty() ? "not recorded" : record.ended_by) << "\n";
  std::map<std::string, int> kinds;
  for (const EpisodeEvent& event : record.events) ++kinds[event.kind];
  if (!kinds.empty()) {
    text << "events  ";
    const char* separator = " ";
    for (const auto& [kind, count] : kinds) {
      text << separator << count << " " << kind;
      separator = ", ";
    }
    text << "\n";
  }
  AddAgents(MetricsOf(record), &text);
  return text.str();
}

std::string TracksCsv(const EpisodeRecord& record) {
  std::string csv =
      "time_s,agent,species,team,x_m,y_m,z_m,yaw_rad,speed_mps,health,behaviour,continues\n";
  for (const auto& [name, track] : record.tracks) {
    for (const TrackPoint& point : track.points) {
      AddRow(&csv, point.time_s, name, track.species, track.team, point.position_m.x(),
             point.position_m.y(), point.position_m.z(), point.yaw_rad, point.speed_mps,
             point.health, point.behaviour, static_cast<int>(point.continues));
    }
  }
  return csv;
}

std::string EventsCsv(const EpisodeRecord& record) {
  std::string csv = "time_s,kind,agent,other,x_m,y_m,z_m\n";
  for (const EpisodeEvent& event : record.events) {
    AddRow(&csv, event.time_s, event.kind, event.agent, event.other, event.position_m.x(),
           event.position_m.y(), event.position_m.z());
  }
  return csv;
}

std::string MetricsCsv(const EpisodeRecord& record) {
  std::string csv =
      "agent,species,team,present_s,distance_m,climb_m,mean_speed_mps,max_speed_mps,collisions,"
      "blows_given,blows_taken,falls,deaths,pursued,survived_s,last_health,joint_work_j\n";
  for (const AgentMetrics& one : MetricsOf(record)) {
    AddRow(&csv, one.name, one.species, one.team, one.present_s, one.distance_m, one.climb_m,
           one.mean_speed_mps, one.max_speed_mps, one.collisions, one.blows_given, one.blows_taken,
           one.falls, one.deaths, one.pursued, one.survived_s, one.last_health,
           one.joint_work_j < 0.0 ? std::string() : FormatDouble(one.joint_work_j));
  }
  return csv;
}

}  // namespace latticeworld
