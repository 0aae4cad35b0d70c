#include "latticeworld/generation/bundle/bridges_json.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

const GridGeometry kGeometry = GridGeometry::FromCells(64, 64.0);

Bridge Example() {
  Bridge bridge;
  bridge.kind = BridgeKind::kStoneArch;
  bridge.line = {{-9.5, 0.25}, {0.125, 1.0 / 3.0}, {9.0, 2.0}};
  bridge.width_m = 5.0;
  bridge.deck_z_m = 2.1;
  bridge.thickness_m = 0.4;
  bridge.water_level_m = 0.3;
  bridge.railing_m = 1.0;
  bridge.load_kg = 30e3;
  bridge.supports_m = {3.0, 9.0, 15.0};
  return bridge;
}

TEST(BridgesJsonTest, ABridgeComesBackToTheBit) {
  const Bridge given = Example();
  const auto read = DecodeBridges(EncodeBridges({given, given}), kGeometry);
  ASSERT_TRUE(read.ok()) << read.status().message();
  ASSERT_EQ(read->size(), 2u);
  const Bridge& back = read->at(1);
  EXPECT_EQ(back.kind, given.kind);
  ASSERT_EQ(back.line.size(), given.line.size());
  for (std::size_t i = 0; i < given.line.size(); ++i) {
    EXPECT_EQ(back.line[i].x_m, given.line[i].x_m);
    EXPECT_EQ(back.line[i].y_m, given.line[i].y_m);
  }
  EXPECT_EQ(back.width_m, given.width_m);
  EXPECT_EQ(back.deck_z_m, given.deck_z_m);
  EXPECT_EQ(back.thickness_m, given.thickness_m);
  EXPECT_EQ(back.water_level_m, given.water_level_m);
  EXPECT_EQ(back.railing_m, given.railing_m);
  EXPECT_EQ(back.load_kg, given.load_kg);
  EXPECT_EQ(back.supports_m, given.supports_m);
}

TEST(BridgesJsonTest, LoadAndClearanceAreStatedAndHaveToAgree) {
  const std::string text = EncodeBridges({Example()});
  EXPECT_NE(text.find("\"load_kg\": 30000.0"), std::string::npos) << text;
  const std::string stated = "\"clearance_m\": 1.4";
  const std::size_t at = text.find(stated);
  ASSERT_NE(at, std::string::npos) << text;
  std::string wrong = text;
  wrong.replace(at, stated.size(), "\"clearance_m\": 2.4");
  const auto read = DecodeBridges(wrong, kGeometry);
  EXPECT_EQ(read.status().code(), StatusCode::kDataLoss);
  EXPECT_NE(read.status().message().find("clearance_m"), std::string::npos);
}

TEST(BridgesJsonTest, WhatIsNoBridgeIsNamed) {
  const auto message_of = [](const Bridge& bridge) {
    const auto read = DecodeBridges(EncodeBridges({bridge}), kGeometry);
    EXPECT_EQ(read.status().code(), StatusCode::kDataLoss);
    return read.status().message();
  };
  Bridge bridge = Example();
  bridge.line.resize(1);
  EXPECT_NE(message_of(bridge).find("bridge 0: line"), std::string::npos);
  bridge = Example();
  bridge.line[1] = bridge.line[0];
  EXPECT_NE(message_of(bridge).find("line"), std::string::npos);
  bridge = Example();
  bridge.line[2].x_m = 40.0;
  EXPECT_NE(message_of(bridge).find("x_m"), std::string::npos);
  bridge = Example();
  bridge.supports_m = {9.0, 3.0};
  EXPECT_NE(message_of(bridge).find("supports_m"), std::string::npos);
  bridge = Example();
  bridge.width_m = -1.0;
  EXPECT_NE(message_of(bridge).find("width_m"), std::string::npos);
  EXPECT_EQ(DecodeBridges("{}", kGeometry).status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(DecodeBridges("[", kGeometry).status().code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
