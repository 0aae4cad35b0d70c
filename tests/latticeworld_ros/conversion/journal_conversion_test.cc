#include "latticeworld_ros/conversion/journal_conversion.h"

#include <gtest/gtest.h>

#include "latticeworld_ros/episode/parameters_json.h"

namespace latticeworld {
namespace {

TEST(JournalConversionTest, ACallComesBackFromItsMessage) {
  const JournalEntry entry{3, 40, OpenGateCall{"gate", 1.0 / 3.0}};
  const auto message = ToJournalEntryMessage(entry, ros::Time(1.5), "world-1", 2);
  EXPECT_EQ(message.header.stamp, ros::Time(1.5));
  EXPECT_EQ(message.world_id, "world-1");
  EXPECT_EQ(message.run, 2u);
  const auto back = ToJournalEntry(message);
  ASSERT_TRUE(back.ok()) << back.status().ToString();
  EXPECT_EQ(back->number, 3u);
  EXPECT_EQ(back->step, 40u);
  EXPECT_EQ(std::get<OpenGateCall>(back->call).opening_rad, 1.0 / 3.0);
}

TEST(JournalConversionTest, AMessageThatHoldsNoCallIsNamed) {
  latticeworld_msgs::JournalEntry message;
  message.number = 12;
  message.call = "nonsense";
  const auto entry = ToJournalEntry(message);
  EXPECT_EQ(entry.status().code(), StatusCode::kDataLoss);
  EXPECT_NE(entry.status().message().find("call 12"), std::string::npos);
}

TEST(JournalConversionTest, FilesKeepEveryByte) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  const auto back = ToWorldFiles(
      ToWorldFileMessages(std::vector<WorldFile>{{"weights/G.png", bytes}, {"a", ""}}));
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].path, "weights/G.png");
  EXPECT_EQ(back[0].data, bytes);
  EXPECT_TRUE(back[1].data.empty());
}

TEST(JournalConversionTest, ParametersBecomeJson) {
  XmlRpc::XmlRpcValue parameters;
  parameters["a"] = 1;
  parameters["b"]["c"] = true;
  parameters["b"]["d"][0] = "x\n\"y\"";
  parameters["b"]["d"][1] = 0.5;
  EXPECT_EQ(ParametersToJson(parameters), R"({"a":1,"b":{"c":true,"d":["x\n\"y\"",0.5]}})");
  EXPECT_EQ(ParametersToJson(XmlRpc::XmlRpcValue()), "null");
}

}  // namespace
}  // namespace latticeworld
