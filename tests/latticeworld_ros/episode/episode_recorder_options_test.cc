#include "latticeworld_ros/episode/episode_recorder_options.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(EpisodeRecorderOptionsTest, WhatIsNotSaidKeepsItsDefault) {
  const auto none = RecorderOptionsFromParameters(XmlRpc::XmlRpcValue());
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(none->compression, "lz4");
  XmlRpc::XmlRpcValue parameters;
  parameters["compression"] = "bz2";
  parameters["buffer_mb"] = 7;
  const auto some = RecorderOptionsFromParameters(parameters);
  ASSERT_TRUE(some.ok()) << some.status().ToString();
  EXPECT_EQ(some->compression, "bz2");
  EXPECT_EQ(some->buffer_mb, 7);
  EXPECT_EQ(some->directory, none->directory);
}

TEST(EpisodeRecorderOptionsTest, EveryViolationIsNamedAtOnce) {
  XmlRpc::XmlRpcValue parameters;
  parameters["compression"] = "zip";
  parameters["buffer_mb"] = 0;
  parameters["directory"] = "";
  parameters["folder"] = "x";
  const Status status = RecorderOptionsFromParameters(parameters).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  for (const char* word : {"zip", "lz4", "65536", "directory", "folder"}) {
    EXPECT_NE(status.message().find(word), std::string::npos) << word << "\n" << status.message();
  }
  parameters = XmlRpc::XmlRpcValue();
  parameters["buffer_mb"] = "many";
  EXPECT_FALSE(RecorderOptionsFromParameters(parameters).ok());
  EXPECT_FALSE(RecorderOptionsFromParameters(XmlRpc::XmlRpcValue("text")).ok());
}

}  // namespace
}  // namespace latticeworld
