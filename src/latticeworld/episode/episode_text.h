#ifndef LATTICEWORLD_EPISODE_EPISODE_TEXT_H_
#define LATTICEWORLD_EPISODE_EPISODE_TEXT_H_

#include <string>

#include "latticeworld/episode/episode_record.h"

namespace latticeworld {

// Tells people what was recorded, who was there, and what happened how often.
std::string SummaryOf(const EpisodeRecord& record);

// Tables with a head line, lines ended by "\n", numbers in SI units; texts that hold a comma, a
// quote or a line end are quoted (RFC 4180).
// time_s,agent,species,team,x_m,y_m,z_m,yaw_rad,speed_mps,health,behaviour,continues
std::string TracksCsv(const EpisodeRecord& record);
// time_s,kind,agent,other,x_m,y_m,z_m
std::string EventsCsv(const EpisodeRecord& record);
// One row an agent, one column a field of AgentMetrics.
std::string MetricsCsv(const EpisodeRecord& record);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_EPISODE_TEXT_H_
