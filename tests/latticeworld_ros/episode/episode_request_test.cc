#include "latticeworld_ros/episode/episode_request.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace latticeworld {
namespace {

using Request = latticeworld_msgs::StartEpisode::Request;

TEST(EpisodeRequestTest, CarriesWhatIsAsked) {
  Request request;
  request.name = "first";
  request.topics = {"/agents"};
  request.compression = "bz2";
  request.split_mb = 3;
  request.max_mb = 5;
  request.max_duration = 2.5;
  const auto read = ReadEpisodeRequest(request, "lz4");
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  EXPECT_EQ(read->options.name, "first");
  EXPECT_EQ(read->options.compression, BagCompression::kBz2);
  EXPECT_EQ(read->options.split_bytes, 3u << 20);
  EXPECT_EQ(read->options.max_bytes, 5u << 20);
  EXPECT_EQ(read->options.max_duration_s, 2.5);
  EXPECT_TRUE(read->filter.Matches("/agents"));
  EXPECT_FALSE(read->filter.Matches("/elements"));
}

TEST(EpisodeRequestTest, WhatIsLeftOpenIsUsual) {
  const auto read = ReadEpisodeRequest(Request(), "none");
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  EXPECT_EQ(read->options.name, "");
  EXPECT_EQ(read->options.compression, BagCompression::kNone);
  EXPECT_TRUE(read->filter.Matches("/elements"));
}

TEST(EpisodeRequestTest, EveryViolationIsToldAtOnce) {
  Request request;
  request.name = std::string(65, 'a');
  request.topics = {"/map", "((", std::string(300, 'x')};
  request.keep_state = true;
  request.seed = 7;
  request.compression = "zip";
  request.max_duration = std::nan("");
  const Status status = ReadEpisodeRequest(request, "lz4").status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  std::vector<std::string> fields;
  for (const Violation& violation : status.violations()) fields.push_back(violation.pointer);
  EXPECT_EQ(fields, (std::vector<std::string>{"name", "topics[1]", "topics[2]", "seed",
                                              "compression", "max_duration"}));
  for (const char* word : {"at most 64", "((", "256", "keep_state", "lz4", "nan"}) {
    EXPECT_NE(status.message().find(word), std::string::npos) << word;
  }
}

// What is repeated is written out as the pattern is read. References back are no part of the
// language, in which the ways to match a name are gone through together.
TEST(EpisodeRequestTest, PatternsThatRepeatTooOftenOrReferBackAreRefused) {
  Request request;
  request.topics = {"/camera_[0-9]{2}", "/(ab{11}){11}", "/a{1,101}", "/(a)b\\1"};
  const Status status = ReadEpisodeRequest(request, "lz4").status();
  std::vector<std::string> fields;
  for (const Violation& violation : status.violations()) fields.push_back(violation.pointer);
  EXPECT_EQ(fields, (std::vector<std::string>{"topics[1]", "topics[2]", "topics[3]"}));
}

}  // namespace
}  // namespace latticeworld
