#include "latticeworld/episode/episode_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace latticeworld {
namespace {

EpisodeRecord Record() {
  EpisodeRecord record;
  record.name = "battle";
  record.world_id = "world-0123456789ab";
  record.seed = 7;
  record.duration_s = 2.5;
  record.steps = 250;
  AgentTrack& track = record.tracks["robot"];
  track = {"robot", "wheeled robot", 1, true, {}};
  track.points.push_back({0.0, {1.0 / 3.0, 0.0, 0.5}, 0.1, 0.0, 1.0, "controlled", false});
  track.points.push_back({0.02, {0.5, 0.0, 0.5}, 0.1, 1.5, 0.75, "controlled", true});
  record.events = {{0.02, "hit", "robot", "a \"sharp\", tool", {1.0, 2.0, 3.0}}};
  return record;
}

TEST(EpisodeTextTest, TracksAreATableOfExactNumbers) {
  EXPECT_EQ(TracksCsv(Record()),
            "time_s,agent,species,team,x_m,y_m,z_m,yaw_rad,speed_mps,health,behaviour,continues\n"
            "0,robot,wheeled robot,1,0.3333333333333333,0,0.5,0.1,0,1,controlled,0\n"
            "0.02,robot,wheeled robot,1,0.5,0,0.5,0.1,1.5,0.75,controlled,1\n");
}

TEST(EpisodeTextTest, TextsThatWouldBreakATableAreQuoted) {
  EXPECT_EQ(EventsCsv(Record()),
            "time_s,kind,agent,other,x_m,y_m,z_m\n"
            "0.02,hit,robot,\"a \"\"sharp\"\", tool\",1,2,3\n");
}

TEST(EpisodeTextTest, WhatWasNotMeasuredIsEmpty) {
  const std::string csv = MetricsCsv(Record());
  const std::string head = csv.substr(0, csv.find('\n'));
  const std::string row = csv.substr(head.size() + 1);
  const auto commas = [](const std::string& text) {
    return std::count(text.begin(), text.end(), ',');
  };
  EXPECT_EQ(commas(head), commas(row));
  EXPECT_EQ(row.substr(row.size() - 2), ",\n");  // joint_work_j
}

TEST(EpisodeTextTest, TheSummarySaysWhatWasRecorded) {
  const std::string summary = SummaryOf(Record());
  for (const char* words :
       {"battle", "world-0123456789ab", "2.50 s", "250 steps", "1 hit", "robot", "not recorded"}) {
    EXPECT_NE(summary.find(words), std::string::npos) << words << "\n" << summary;
  }
}

}  // namespace
}  // namespace latticeworld
