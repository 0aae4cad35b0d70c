#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geometry/in_region.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/simulation/start_warnings.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

TestScene Place() {
  TestScene scene;
  scene.water_depth_m = [](double x, double) { return x > 20.0 ? 3.0 : 0.0; };
  scene.AddBuilding(0.0, 10.0, 4.0, 4.0);
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  scene.AddProp("crate", PropKind::kCrate, -20.0, -20.0);
  return scene;
}

SpawnRequest At(AgentCategory category, double x_m, double y_m, const std::string& name = "") {
  SpawnRequest request;
  request.category = category;
  request.position = WorldPoint{x_m, y_m};
  request.name = name;
  return request;
}

TEST(SpawningTest, SpawnsWhereAskedWithTheNameAskedFor) {
  const auto simulator = MakeSimulator(Place());
  SpawnRequest request = At(AgentCategory::kHumanoidRobot, -5.0, -5.0, "Alice_2");
  request.controllable = true;
  request.heading_rad = 1.0;
  const auto name = simulator->Spawn(request);
  ASSERT_TRUE(name.ok()) << name.status().ToString();
  EXPECT_EQ(*name, "Alice_2");
  const AgentSnapshot alice = Now(*simulator, "Alice_2");
  EXPECT_NEAR(alice.position_m.x(), -5.0, 1e-9);
  EXPECT_NEAR(YawOf(alice), 1.0, 1e-9);
  EXPECT_EQ(alice.team, 1);
  EXPECT_TRUE(simulator->Command("Alice_2", Forward(1.0)).ok());
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kSpawned, "Alice_2"), 1);
}

TEST(SpawningTest, GivesNumberedNames) {
  const auto simulator = MakeSimulator(Place());
  EXPECT_EQ(*simulator->Spawn(At(AgentCategory::kSheep, -10.0, 0.0)), "sheep_1");
  EXPECT_EQ(*simulator->Spawn(At(AgentCategory::kSheep, -14.0, 0.0)), "sheep_2");
  ASSERT_TRUE(simulator->Remove("sheep_1").ok());
  EXPECT_EQ(*simulator->Spawn(At(AgentCategory::kSheep, -10.0, 0.0)), "sheep_1");
}

TEST(SpawningTest, RefusesAndSaysWhyAndChangesNothing) {
  const auto simulator = MakeSimulator(Place());
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  SpawnRequest grazing_goblin = At(AgentCategory::kGoblin, -5.0, 0.0);
  grazing_goblin.state = AgentState::kGrazing;
  SpawnRequest dizzy = At(AgentCategory::kGoblin, -5.0, 0.0);
  dizzy.heading_rad = kNan;
  SpawnRequest dragon = At(AgentCategory::kGoblin, -5.0, 0.0);
  dragon.species = "dragon";
  SpawnRequest pacifist = At(AgentCategory::kGoblin, -5.0, 0.0);
  pacifist.policy = "pacifist";
  SpawnRequest outsider = At(AgentCategory::kGoblin, -5.0, 0.0);
  outsider.team = 16;
  SpawnRequest torn = At(AgentCategory::kGoblin, -5.0, 0.0);
  torn.controllable = true;
  torn.policy = "pursuer";
  const struct {
    SpawnRequest request;
    StatusCode code;
  } cases[] = {
      {At(AgentCategory::kSheep, 0.0, 10.0), StatusCode::kFailedPrecondition},   // in the building
      {At(AgentCategory::kSheep, 25.0, 0.0), StatusCode::kFailedPrecondition},   // under water
      {At(AgentCategory::kWhale, -10.0, 0.0), StatusCode::kFailedPrecondition},  // on land
      {At(AgentCategory::kSheep, 40.0, 0.0), StatusCode::kOutOfRange},
      {At(AgentCategory::kSheep, kNan, 0.0), StatusCode::kInvalidArgument},
      {At(AgentCategory::kSheep, 0.3, 0.0), StatusCode::kFailedPrecondition},  // on the robot
      {At(AgentCategory::kSheep, -5.0, 0.0, "robot"), StatusCode::kAlreadyExists},
      {At(AgentCategory::kSheep, -5.0, 0.0, "7up"), StatusCode::kInvalidArgument},
      {At(AgentCategory::kSheep, -5.0, 0.0, "/robot"), StatusCode::kInvalidArgument},
      {At(AgentCategory::kSheep, -5.0, 0.0, "a b"), StatusCode::kInvalidArgument},
      {At(AgentCategory::kSheep, -5.0, 0.0, std::string(65, 'a')), StatusCode::kInvalidArgument},
      {grazing_goblin, StatusCode::kInvalidArgument},
      {dizzy, StatusCode::kInvalidArgument},
      {dragon, StatusCode::kInvalidArgument},
      {pacifist, StatusCode::kInvalidArgument},
      {outsider, StatusCode::kInvalidArgument},
      {torn, StatusCode::kInvalidArgument},
      {At(AgentCategory::kSheep, -5.0, 0.0, "crate"), StatusCode::kAlreadyExists},
      {At(AgentCategory::kSheep, -20.0, -20.0), StatusCode::kFailedPrecondition},  // in the crate
  };
  const std::string before = simulator->StateHash();
  for (const auto& one : cases) {
    const auto name = simulator->Spawn(one.request);
    ASSERT_FALSE(name.ok());
    EXPECT_EQ(name.status().code(), one.code) << name.status().ToString();
    EXPECT_GT(name.status().message().size(), 10u);
    EXPECT_EQ(simulator->StateHash(), before);
  }
  EXPECT_TRUE(simulator->TakeEvents().empty());
}

std::vector<std::string> FieldsOf(const Status& status) {
  std::vector<std::string> fields;
  for (const Violation& violation : status.violations()) fields.push_back(violation.pointer);
  return fields;
}

TEST(SpawningTest, NamesEverythingThatIsIllegalAtOnce) {
  const auto simulator = MakeSimulator(Place());
  SpawnRequest request = At(AgentCategory::kGoblin, std::numeric_limits<double>::infinity(), 0.0);
  request.name = "7up";
  request.state = AgentState::kGrazing;
  request.heading_rad = std::numeric_limits<double>::quiet_NaN();
  request.team = 16;
  request.policy = "pacifist";
  request.controllable = true;
  const Status spawned = simulator->Spawn(request).status();
  EXPECT_EQ(FieldsOf(spawned), (std::vector<std::string>{"name", "state", "position.x", "heading",
                                                         "team", "policy", "policy"}))
      << spawned.ToString();
  for (const char* word : {"7up", "letter", "grazing", "patrolling", "nan", "16", "1 .. 15",
                           "pacifist", "pursuer", "controllable"}) {
    EXPECT_NE(spawned.message().find(word), std::string::npos) << word;
  }
  request.species = "dragon";
  EXPECT_EQ(FieldsOf(simulator->Spawn(request).status())[1], "species");

  const Status set = simulator->SetPolicy({"robot", 16, "pacifist"});
  EXPECT_EQ(FieldsOf(set), (std::vector<std::string>{"agent", "team", "policy"}));
  EXPECT_EQ(FieldsOf(simulator->SetPolicy({"", -1, ""})), std::vector<std::string>{"team"});
}

TEST(SpawningTest, NamesEverythingThatIsIllegalOfAProp) {
  const auto simulator = MakeSimulator(Place());
  const std::string before = simulator->StateHash();
  // In the robot's way as well, which is said of what is legal only.
  Prop post = UsualProp(PropKind::kPost);
  post.name = "no name";
  post.size_m.z() = 100.0;
  post.mass_kg = NAN;
  post.strength = -1.0;
  const Status status = simulator->SpawnProp(post).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(FieldsOf(status), (std::vector<std::string>{"name", "size.z", "mass", "strength"}))
      << status.ToString();
  for (double* const number : {&post.position.x_m, &post.z_m, &post.yaw_rad, &post.strength}) {
    post = UsualProp(PropKind::kPost);
    *number = NAN;
    EXPECT_EQ(simulator->SpawnProp(post).status().code(), StatusCode::kInvalidArgument);
  }
  EXPECT_EQ(simulator->StateHash(), before);
}

TEST(SpawningTest, NamesTheSpeciesThatItRefuses) {
  const auto simulator = MakeSimulator(Place());
  SpawnRequest car = At(AgentCategory::kWheeledRobot, 0.0, 10.0);
  car.species = "ackermann car";
  const auto name = simulator->Spawn(car);
  ASSERT_FALSE(name.ok());
  EXPECT_EQ(name.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(name.status().message().rfind("ackermann car: no ", 0), 0u) << name.status().message();
}

TEST(SpawningTest, FindsAPlaceInARegion) {
  const auto simulator = MakeSimulator(Place());
  for (int i = 0; i < 12; ++i) {
    SpawnRequest request;
    request.category = AgentCategory::kSheep;
    request.region = Region::kLowerLeft;
    const auto name = simulator->Spawn(request);
    ASSERT_TRUE(name.ok()) << name.status().ToString();
    const AgentSnapshot sheep = Now(*simulator, *name);
    EXPECT_TRUE(IsIn(Region::kLowerLeft, simulator->scene().geometry(),
                     {sheep.position_m.x(), sheep.position_m.y()}));
  }
}

TEST(SpawningTest, GoesByTheWatersOfTheMoment) {
  TestScene scene = Place();
  scene.water_depth_m = [](double x, double) { return x > 20.0 ? 3.0 : x < -20.0 ? 0.1 : 0.0; };
  const auto simulator = MakeSimulator(scene);
  const SpawnRequest sheep = At(AgentCategory::kSheep, -26.0, 0.0);
  const SpawnRequest whale = At(AgentCategory::kWhale, 26.0, 0.0);
  SpawnRequest any_whale;
  any_whale.category = AgentCategory::kWhale;
  const auto let_rise = [&simulator](double rise_m) {
    WeatherChange change;
    change.water_rise_m = rise_m;
    ASSERT_TRUE(simulator->SetWeather(change).ok());
  };
  let_rise(1.0);
  EXPECT_EQ(simulator->Spawn(sheep).status().code(), StatusCode::kFailedPrecondition);
  let_rise(-1.5);
  EXPECT_EQ(simulator->Spawn(whale).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(simulator->Spawn(any_whale).status().code(), StatusCode::kNotFound);
  EXPECT_TRUE(simulator->Spawn(sheep).ok());
  let_rise(0.0);
  EXPECT_TRUE(simulator->Spawn(whale).ok());
}

TEST(SpawningTest, HoldsNoMoreThanTheLimit) {
  TestScene scene;
  scene.size_m = 256.0;
  const auto simulator = MakeSimulator(scene);
  for (int i = 0; i < kMaxAgentStarts; ++i) {
    ASSERT_TRUE(simulator
                    ->Spawn(At(AgentCategory::kRoboticDog, -100.0 + 5.0 * (i % 40),
                               -100.0 + 5.0 * (i / 40)))
                    .ok());
  }
  const auto refused = simulator->Spawn(At(AgentCategory::kRoboticDog, 120.0, 120.0));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code(), StatusCode::kResourceExhausted);
  EXPECT_NE(refused.status().message().find(std::to_string(kMaxAgentStarts)), std::string::npos)
      << refused.status().message();
  // What is legal in no world is said first.
  const auto illegal = simulator->Spawn(At(AgentCategory::kRoboticDog, 120.0, 120.0, "7up"));
  EXPECT_EQ(illegal.status().code(), StatusCode::kInvalidArgument);
  simulator->Step();
}

TEST(SpawningTest, AStormOfRequestsFillsTheWorldAndIsThenRefused) {
  TestScene scene;
  scene.size_m = 128.0;
  const auto simulator = MakeSimulator(scene);
  int held = 0, exhausted = 0;
  for (int i = 0; i < 1200; ++i) {
    SpawnRequest request;
    request.category = AgentCategory::kGoblin;
    const auto name = simulator->Spawn(request);
    if (name.ok()) ++held;
    exhausted += name.status().code() == StatusCode::kResourceExhausted;
  }
  EXPECT_EQ(held, kMaxAgentStarts);
  EXPECT_EQ(exhausted, 1200 - kMaxAgentStarts);
  EXPECT_EQ(simulator->State()->agents.size(), static_cast<std::size_t>(kMaxAgentStarts));
  // Nobody stands in another.
  const auto state = simulator->State();
  double nearest_m = 1e9;
  for (std::size_t i = 0; i < state->agents.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      nearest_m = std::min(
          nearest_m, (state->agents[i].position_m - state->agents[j].position_m).head<2>().norm());
    }
  }
  EXPECT_GT(nearest_m, 0.8);
}

TEST(SpawningTest, SpeciesDecidesTheCategoryAndTheRestIsAsAsked) {
  const auto simulator = MakeSimulator(Place());
  SpawnRequest request = At(AgentCategory::kSheep, -10.0, -10.0);
  request.species = "ackermann_car";
  request.team = 7;
  request.policy = "guard";
  const auto name = simulator->Spawn(request);
  ASSERT_TRUE(name.ok()) << name.status().ToString();
  EXPECT_EQ(*name, "ackermann_car_1");
  const AgentSnapshot car = Now(*simulator, *name);
  EXPECT_EQ(car.category, AgentCategory::kWheeledRobot);
  EXPECT_EQ(car.species, "ackermann car");
  EXPECT_EQ(car.team, 7);
  EXPECT_EQ(car.policy, "guard");
  EXPECT_FALSE(car.controllable);
}

TEST(SpawningTest, TheScenesRobotsAreOfTheSpeciesOfTheOptions) {
  SimulatorOptions options;
  options.robot_species = "tractor";
  const auto simulator = MakeSimulator(Place(), 1, options);
  EXPECT_EQ(Now(*simulator, "robot").species, "tractor");
  for (const char* const bad : {"", "sheep", "flying carpet"}) {
    options.robot_species = bad;
    const std::vector<Violation> violations = Validate(options);
    ASSERT_EQ(violations.size(), 1u);
    EXPECT_EQ(violations[0].pointer, "robot_species");
    EXPECT_NE(violations[0].message.find("tractor"), std::string::npos);
  }
}

SimulatorOptions Tractors() {
  SimulatorOptions options;
  options.robot_species = "tractor";
  return options;
}

// The warnings of a simulation that has just begun.
std::vector<std::string> WarningsOf(const Simulator& simulator) {
  return StartWarnings(simulator.scene(), *simulator.State(), *simulator.options().species);
}

TEST(SpawningTest, ALargerRobotBeginsNearAStartThatIsTooNarrowForIt) {
  TestScene scene;
  scene.AddTree(1.0, 0.0);
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  scene.AddAgent("sheep_1", AgentCategory::kSheep, -5.0, 0.0);
  EXPECT_TRUE(WarningsOf(*MakeSimulator(scene)).empty()) << "a wheeled robot has room";

  const auto simulator = MakeSimulator(scene, 1, Tractors());
  const AgentSnapshot tractor = Now(*simulator, "robot");
  const double radius_m = simulator->options().species->Find("tractor")->radius_m;
  EXPECT_GE(std::hypot(tractor.position_m.x() - 1.0, tractor.position_m.y()), radius_m + 0.3);
  EXPECT_GE(std::hypot(tractor.position_m.x() + 5.0, tractor.position_m.y()), radius_m + 0.3);
  EXPECT_LT(tractor.position_m.head<2>().norm(), 20.0) << "near its start";
  ASSERT_EQ(WarningsOf(*simulator).size(), 1u);
  EXPECT_NE(WarningsOf(*simulator)[0].find("robot begins at"), std::string::npos);
  EXPECT_NE(WarningsOf(*simulator)[0].find("tractor"), std::string::npos);
  // Where it begins is the world's, and no matter of the episode.
  simulator->Reset(77);
  EXPECT_EQ(Now(*simulator, "robot").position_m, tractor.position_m);
}

TEST(SpawningTest, ALargerRobotKeepsAStartThatIsWideEnough) {
  TestScene scene;
  scene.AddTree(3.0, 0.0);
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  scene.AddAgent("sheep_1", AgentCategory::kSheep, 0.0, 3.0);
  const auto simulator = MakeSimulator(scene, 1, Tractors());
  EXPECT_LT(Now(*simulator, "robot").position_m.head<2>().norm(), 1e-6);
  EXPECT_TRUE(WarningsOf(*simulator).empty());
  // Not so where somebody who begins after it stands in its way.
  scene.AddAgent("sheep_2", AgentCategory::kSheep, 1.0, 0.0);
  EXPECT_GT(Now(*MakeSimulator(scene, 1, Tractors()), "robot").position_m.head<2>().norm(), 1.0);
}

TEST(SpawningTest, ALargerRobotWithoutRoomAnywhereBeginsAtItsStart) {
  TestScene scene;
  for (int i = -21; i <= 21; ++i) {
    for (int j = -21; j <= 21; ++j) scene.AddTree(1.5 * i + 0.75, 1.5 * j + 0.75);
  }
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  const auto simulator = MakeSimulator(scene, 1, Tractors());
  EXPECT_LT(Now(*simulator, "robot").position_m.head<2>().norm(), 1e-6);
  ASSERT_EQ(WarningsOf(*simulator).size(), 1u);
  EXPECT_NE(WarningsOf(*simulator)[0].find("no room"), std::string::npos);
}

TEST(SpawningTest, PropsComeAndGo) {
  const auto simulator = MakeSimulator(Place());
  Prop stone = UsualProp(PropKind::kLooseStone);
  stone.position = {-10.0, -10.0};
  const auto name = simulator->SpawnProp(stone);
  ASSERT_TRUE(name.ok()) << name.status().ToString();
  EXPECT_EQ(*name, "loose_stone_1");
  EXPECT_EQ(simulator->State()->props.size(), 2u);
  const std::string before = simulator->StateHash();
  stone.name = "robot";
  EXPECT_EQ(simulator->SpawnProp(stone).status().code(), StatusCode::kAlreadyExists);
  stone.name = "a b";
  EXPECT_EQ(simulator->SpawnProp(stone).status().code(), StatusCode::kInvalidArgument);
  stone.name = "";
  stone.position = {0.2, 0.0};  // on the robot
  EXPECT_EQ(simulator->SpawnProp(stone).status().code(), StatusCode::kFailedPrecondition);
  stone.position = {99.0, 0.0};
  EXPECT_EQ(simulator->SpawnProp(stone).status().code(), StatusCode::kOutOfRange);
  stone.position = {std::numeric_limits<double>::quiet_NaN(), 0.0};
  EXPECT_FALSE(simulator->SpawnProp(stone).ok());
  EXPECT_EQ(simulator->RemoveProp("boulder").code(), StatusCode::kNotFound);
  EXPECT_EQ(simulator->StateHash(), before);
  ASSERT_TRUE(simulator->RemoveProp(*name).ok());
  EXPECT_EQ(simulator->RemoveProp(*name).code(), StatusCode::kNotFound);
  const auto events = simulator->TakeEvents();
  EXPECT_EQ(Count(events, EventKind::kSpawned, *name), 1);
  EXPECT_EQ(Count(events, EventKind::kRemoved, *name), 1);
  RunFor(simulator.get(), 0.5);
}

TEST(SpawningTest, WhoIsRemovedUnderAttackIsGoneForItsAttackers) {
  TestScene scene;
  AgentStart& prey = scene.AddAgent("prey", AgentCategory::kHumanoidRobot, 0.0, 0.0);
  prey.controllable = true;
  prey.team = 1;
  for (int i = 0; i < 6; ++i) {
    scene
        .AddAgent("goblin_" + std::to_string(i), AgentCategory::kGoblin, 2.5 * std::cos(i),
                  2.5 * std::sin(i))
        .state = AgentState::kAttacking;
  }
  const auto simulator = MakeSimulator(scene);
  for (int i = 0; i < 500 && Now(*simulator, "prey").health == 1.0; ++i) simulator->Step();
  ASSERT_LT(Now(*simulator, "prey").health, 1.0);
  ASSERT_TRUE(simulator->Remove("prey").ok());
  ASSERT_TRUE(simulator->Remove("goblin_2").ok());
  simulator->TakeEvents();
  RunFor(simulator.get(), 6.0);
  for (const Event& event : simulator->TakeEvents()) EXPECT_NE(event.other, "prey");
  for (const AgentSnapshot& agent : simulator->State()->agents) {
    EXPECT_NE(agent.behaviour, Behaviour::kAttack);
    EXPECT_EQ(agent.health, 1.0);
  }
}

TEST(SpawningTest, RemovesOnceAndOnlyWhatIsThere) {
  const auto simulator = MakeSimulator(Place());
  EXPECT_EQ(simulator->Remove("nobody").code(), StatusCode::kNotFound);
  EXPECT_TRUE(simulator->Remove("robot").ok());
  EXPECT_EQ(simulator->Remove("robot").code(), StatusCode::kNotFound);
  EXPECT_EQ(simulator->Command("robot", Forward(1.0)).code(), StatusCode::kNotFound);
  EXPECT_TRUE(simulator->State()->agents.empty());
  RunFor(simulator.get(), 1.0);
}

TEST(SpawningTest, AnEmptyWorldRuns) {
  const auto simulator = MakeSimulator(TestScene());
  RunFor(simulator.get(), 1.0);
  EXPECT_EQ(simulator->State()->step, 100u);
  EXPECT_NEAR(simulator->State()->time_s, 1.0, 1e-12);
  EXPECT_TRUE(simulator->State()->agents.empty());
}

TEST(OptionsTest, EveryViolationIsNamedAtOnce) {
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {kNan, -1.0, 1e9, std::numeric_limits<double>::infinity()}) {
    SimulatorOptions options;
    options.step_s = options.command_timeout_s = options.pursuit_distance_m = bad;
    EXPECT_EQ(Validate(options).size(), 3u);
    const auto simulator = Simulator::Create(TestScene().Build(), options, 1);
    ASSERT_FALSE(simulator.ok());
    EXPECT_EQ(simulator.status().code(), StatusCode::kInvalidArgument);
  }
  EXPECT_TRUE(Validate(SimulatorOptions()).empty());
}

}  // namespace
}  // namespace latticeworld
