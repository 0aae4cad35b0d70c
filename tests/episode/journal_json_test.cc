#include "latticeworld/episode/journal_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace latticeworld {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
// Numbers whose shortest text is long, and those that texts tend to lose.
constexpr double kAwkward[] = {0.1 + 0.2, 1.0 / 3.0, -0.0, 5e-324, 1.7976931348623157e308, M_PI};

bool SameBits(double a, double b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

template <typename Call>
Call RoundTrip(const Call& call) {
  const std::string json = EncodeCall(call);
  EXPECT_EQ(json.find('\n'), std::string::npos) << json;
  const auto decoded = DecodeCall(json);
  EXPECT_TRUE(decoded.ok()) << json << "\n" << decoded.status().ToString();
  if (!decoded.ok()) return Call{};
  EXPECT_TRUE(std::holds_alternative<Call>(*decoded)) << json;
  // What is encoded again is the same text: nothing was lost on the way.
  EXPECT_EQ(EncodeCall(*decoded), json);
  return std::get<Call>(*decoded);
}

TEST(JournalJsonTest, EveryBitOfACommandIsKept) {
  for (const double value : kAwkward) {
    CommandCall call{"robot", {{value, -value, 1.0}, value}};
    const CommandCall back = RoundTrip(call);
    EXPECT_EQ(back.agent, "robot");
    EXPECT_TRUE(SameBits(back.command.linear_mps.x(), value));
    EXPECT_TRUE(SameBits(back.command.linear_mps.y(), -value));
    EXPECT_TRUE(SameBits(back.command.yaw_rate_radps, value));
  }
}

TEST(JournalJsonTest, JointsKeepWhichValueIsGiven) {
  const CommandJointsCall back = RoundTrip(CommandJointsCall{
      "dog", {{"front_left_knee", 0.1 + 0.2, kNan, kNan}, {"rear_hip", kNan, kNan, -3.5}}});
  ASSERT_EQ(back.commands.size(), 2u);
  EXPECT_EQ(back.commands[0].joint, "front_left_knee");
  EXPECT_TRUE(SameBits(back.commands[0].position_rad, 0.1 + 0.2));
  EXPECT_TRUE(std::isnan(back.commands[0].velocity_radps));
  EXPECT_TRUE(std::isnan(back.commands[0].effort_nm));
  EXPECT_TRUE(std::isnan(back.commands[1].position_rad));
  EXPECT_EQ(back.commands[1].effort_nm, -3.5);
}

TEST(JournalJsonTest, ASpawnKeepsWhatWasGivenAndWhatWasNot) {
  SpawnCall call;
  call.request.category = AgentCategory::kAncientWarrior;
  call.request.region = Region::kUpperLeft;
  const SpawnCall bare = RoundTrip(call);
  EXPECT_FALSE(bare.request.state || bare.request.position || bare.request.team);
  EXPECT_EQ(bare.request.category, AgentCategory::kAncientWarrior);
  EXPECT_EQ(bare.request.region, Region::kUpperLeft);

  call.request.name = "a";
  call.request.species = "tractor";
  call.request.state = AgentState::kAttacking;
  call.request.position = WorldPoint{1.0 / 3.0, -0.0};
  call.request.heading_rad = M_PI;
  call.request.controllable = true;
  call.request.team = 3;
  call.request.policy = "pursuer";
  call.answer = "a_7";
  const SpawnCall full = RoundTrip(call);
  EXPECT_EQ(full.request.state, AgentState::kAttacking);
  EXPECT_TRUE(SameBits(full.request.position->x_m, 1.0 / 3.0));
  EXPECT_TRUE(SameBits(full.request.position->y_m, -0.0));
  EXPECT_TRUE(full.request.controllable);
  EXPECT_EQ(full.request.team, 3);
  EXPECT_EQ(full.request.policy, "pursuer");
  EXPECT_EQ(full.answer, "a_7");
}

TEST(JournalJsonTest, AnPropKeepsItsShapeAndPlace) {
  Prop prop;
  prop.name = "gate_1";
  prop.kind = PropKind::kGate;
  prop.position = {-0.1, 1.0 / 3.0};
  prop.z_m = 12.75;
  prop.yaw_rad = M_PI / 7.0;
  prop.size_m = {0.1, 0.2, 0.3};
  prop.mass_kg = 1.0 / 7.0;
  prop.strength = 2.0 / 3.0;
  const SpawnPropCall back = RoundTrip(SpawnPropCall{prop, "gate_1"});
  EXPECT_EQ(back.prop.kind, PropKind::kGate);
  EXPECT_TRUE(SameBits(back.prop.position.y_m, prop.position.y_m));
  EXPECT_TRUE(SameBits(back.prop.z_m, prop.z_m));
  EXPECT_TRUE(SameBits(back.prop.yaw_rad, prop.yaw_rad));
  EXPECT_EQ(back.prop.size_m, prop.size_m);
  EXPECT_TRUE(SameBits(back.prop.mass_kg, prop.mass_kg));
  EXPECT_TRUE(SameBits(back.prop.strength, prop.strength));
}

TEST(JournalJsonTest, WeatherKeepsWhatIsToStay) {
  WeatherChange change;
  change.weather = Weather::kSandstorm;
  change.hour = 0.0;
  change.transition_s = 0.3;
  const WeatherChange back = RoundTrip(SetWeatherCall{change}).change;
  EXPECT_EQ(back.weather, Weather::kSandstorm);
  EXPECT_EQ(back.hour, 0.0);
  EXPECT_FALSE(back.intensity || back.wind_speed_mps || back.wind_heading_rad || back.gust_mps ||
               back.visibility_m || back.ground_wetness || back.snow_depth_m || back.water_rise_m);
  EXPECT_EQ(back.transition_s, 0.3);
}

TEST(JournalJsonTest, TheOtherCallsKeepTheirWords) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(RoundTrip(ResetCall{kMost}).seed, kMost);
  EXPECT_EQ(RoundTrip(SaveCall{3}).snapshot, 3u);
  EXPECT_EQ(RoundTrip(RestoreCall{4}).snapshot, 4u);
  EXPECT_EQ(RoundTrip(StrikeCall{"goblin_1"}).agent, "goblin_1");
  EXPECT_EQ(RoundTrip(RemoveCall{"goblin_1"}).agent, "goblin_1");
  EXPECT_EQ(RoundTrip(RemovePropCall{"crate_1"}).prop, "crate_1");
  EXPECT_EQ(RoundTrip(OpenGateCall{"g", 1.0 / 3.0}).opening_rad, 1.0 / 3.0);
  EXPECT_EQ(RoundTrip(SetPolicyCall{{"", 2, "ambusher"}}).change.team, 2);
  EXPECT_EQ(RoundTrip(SetPolicyCall{{"a", std::nullopt, ""}}).change.agent, "a");
}

TEST(JournalJsonTest, WhatIsNoCallIsRefusedWithTheReason) {
  const struct {
    std::string json, reason;
  } cases[] = {
      {"", "parse error"},
      {"7", "no object"},
      {"[]", "no object"},
      {R"({"agent": "a"})", "call"},
      {R"({"call": "fly", "agent": "a"})", "restore"},
      {R"({"call": "strike"})", "agent"},
      {R"({"call": "strike", "agent": "a", "force": 1})", "force"},
      {R"({"call": "strike", "agent": 7})", "a text"},
      {R"({"call": "reset", "seed": -1})", "seed"},
      {R"({"call": "command", "agent": "a", "linear_mps": [1, 2], "yaw_rate_radps": 0})",
       "3 numbers"},
      {R"({"call": "open_gate", "element": "g", "opening_rad": 1e999})", ""},
      {std::string(100000, '['), "deeper"},
      {std::string(2 << 20, ' '), "legal"},
  };
  for (const auto& one : cases) {
    const auto call = DecodeCall(one.json);
    ASSERT_FALSE(call.ok()) << one.json.substr(0, 80);
    EXPECT_EQ(call.status().code(), StatusCode::kDataLoss);
    EXPECT_NE(call.status().message().find(one.reason), std::string::npos)
        << call.status().message();
  }
}

TEST(JournalJsonTest, OptionsComeBackWithTheSpeciesThatUsersAdded) {
  SimulatorOptions options;
  options.step_s = 0.02;
  options.day_length_s = 600.1;
  const auto plain = DecodeSimulatorOptions(EncodeSimulatorOptions(options));
  ASSERT_TRUE(plain.ok()) << plain.status().ToString();
  EXPECT_EQ(plain->step_s, 0.02);
  EXPECT_EQ(plain->day_length_s, 600.1);
  EXPECT_EQ(plain->species->all().size(), options.species->all().size());

  auto extended = SpeciesCatalogue::Extended({{"user.json", R"({"species": [{
      "name": "donkey", "category": "horse", "plan": "grazer", "mass_kg": 180.1, "height_m": 1.4,
      "radius_m": 0.9, "eye_height_m": 1.3, "cruise_mps": 1.2, "top_speed_mps": 6,
      "acceleration_mps2": 3, "turn_rate_radps": 1.8, "max_slope_rad": 0.7, "wade_depth_m": 0.4,
      "drag_area_m2": 0.8, "water_drag_area_m2": 0.8, "density_kgpm3": 980,
      "field_of_view_rad": 6, "sight_m": 60, "hearing_m": 60, "hit_points": 80}]})"}});
  ASSERT_TRUE(extended.ok()) << extended.status().ToString();
  options.species = *extended;
  const auto back = DecodeSimulatorOptions(EncodeSimulatorOptions(options));
  ASSERT_TRUE(back.ok()) << back.status().ToString();
  ASSERT_NE(back->species->Find("donkey"), nullptr);
  EXPECT_EQ(back->species->Find("donkey")->mass_kg, 180.1);
}

TEST(JournalJsonTest, OptionsThatNoSimulatorTakesAreRefused) {
  std::string json = EncodeSimulatorOptions(SimulatorOptions());
  const std::size_t at = json.find("0.01");
  ASSERT_NE(at, std::string::npos);
  json.replace(at, 4, "99.0");
  const auto options = DecodeSimulatorOptions(json);
  ASSERT_FALSE(options.ok());
  EXPECT_NE(options.status().message().find("step_s"), std::string::npos);
  EXPECT_FALSE(DecodeSimulatorOptions("{}").ok());
}

}  // namespace
}  // namespace latticeworld
