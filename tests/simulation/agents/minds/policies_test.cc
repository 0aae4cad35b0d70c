#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "latticeworld/simulation/agents/minds/behaviour_tree.h"
#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/pieces_fear.h"
#include "latticeworld/simulation/agents/minds/policy.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "simulation/agents/minds/mind_world.h"

namespace latticeworld {
namespace {

TestScene Wide() {
  TestScene scene;
  scene.size_m = 128.0;
  return scene;
}

// An agent that stands still, whatever happens.
class StatuePolicy : public Policy {
 public:
  Steering Decide(Agent* agent, Surroundings*) const override {
    TakeUp(agent, Behaviour::kIdle);
    return StandHere(*agent);
  }
};

TEST(PoliciesTest, ThereAreAdversariesOfManyKinds) {
  const std::vector<std::string> names = PolicyNames();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name :
       {"pursuer", "ambusher", "encircler", "guard", "raider", "interceptor", "external", "idler",
        "wanderer", "patroller", "grazer", "swimmer", "soarer"}) {
    EXPECT_NE(FindPolicy(name), nullptr) << name;
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  EXPECT_EQ(FindPolicy("saint"), nullptr);
  EXPECT_EQ(FindPolicy(""), nullptr);
}

TEST(PoliciesTest, EveryCategoryInEveryStateHasAUsualPolicy) {
  for (const auto& category : EnumNames(AgentCategory{})) {
    for (const auto& state : EnumNames(AgentState{})) {
      EXPECT_NE(FindPolicy(UsualPolicy(category.value, state.value)), nullptr)
          << category.name << ", " << state.name;
    }
  }
  EXPECT_EQ(UsualPolicy(AgentCategory::kGoblin, AgentState::kPatrolling), "pursuer");
  EXPECT_EQ(UsualPolicy(AgentCategory::kGoblin, AgentState::kIdle), "guard");
  EXPECT_EQ(UsualPolicy(AgentCategory::kHumanoidRobot, AgentState::kPatrolling), "patroller");
  EXPECT_EQ(UsualPolicy(AgentCategory::kSheep, AgentState::kGrazing), "grazer");
}

TEST(PoliciesTest, APolicyOfAProgramsOwnPlugsIn) {
  ASSERT_TRUE(RegisterPolicy("statue", std::make_unique<StatuePolicy>()));
  EXPECT_FALSE(RegisterPolicy("statue", std::make_unique<StatuePolicy>())) << "taken";
  EXPECT_FALSE(RegisterPolicy("pursuer", std::make_unique<StatuePolicy>())) << "taken";
  EXPECT_FALSE(RegisterPolicy("", std::make_unique<StatuePolicy>()));
  EXPECT_FALSE(RegisterPolicy("nothing", nullptr));
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  world.Add("humanoid robot", 1, 10.0, 0.0);
  world.Run(2.0, {{goblin.id, "statue"}});
  EXPECT_EQ(goblin.behaviour, Behaviour::kIdle);
  EXPECT_LT(DistanceBetween(goblin.place(), {0.0, 0.0}), 1e-6);
}

TEST(PoliciesTest, AnUnknownPolicyIsTheUsualOne) {
  MindWorld world(Wide());
  Agent& sheep = world.Add("sheep", 0, 0.0, 0.0);
  sheep.state = AgentState::kGrazing;
  world.Run(0.1, {{sheep.id, "no such policy"}});
  EXPECT_EQ(sheep.behaviour, Behaviour::kGraze);
}

TEST(PoliciesTest, EveryPolicyDecidesForEverySpecies) {
  const auto catalogue = SpeciesCatalogue::BuiltIn();
  for (const std::string& name : PolicyNames()) {
    MindWorld world(Wide());
    std::map<AgentId, std::string> policies;
    double x_m = -40.0;
    for (const Species& species : catalogue->all()) {
      policies[world.Add(species.name, 2, x_m, 0.0).id] = name;
      x_m += 6.0;
    }
    world.Add("humanoid robot", 1, 0.0, 8.0);
    world.Run(3.0, policies);
    for (const auto& [id, agent] : world.agents) {
      EXPECT_TRUE(std::isfinite(agent.mind.steering.heading_rad)) << name << ", " << agent.name;
      EXPECT_GE(agent.mind.steering.speed_mps, 0.0);
      EXPECT_LE(agent.mind.steering.speed_mps, agent.species->top_speed_mps + 1e-9);
      EXPECT_TRUE(agent.motion.position_m.allFinite()) << name << ", " << agent.name;
    }
  }
}

TEST(PoliciesTest, ThePicturesInTheDocsAreThoseOfTheTrees) {
  std::ifstream file(LATTICEWORLD_DOCS "/behaviours.md");
  ASSERT_TRUE(file.is_open());
  std::map<std::string, std::string> pictures;  // by policy, the heading above
  std::string heading, line;
  bool within = false;
  while (std::getline(file, line)) {
    if (line.rfind("### ", 0) == 0) heading = line.substr(4);
    if (within && line == "```") within = false;
    if (within) pictures[heading] += line + "\n";
    if (line == "```mermaid") within = true;
  }
  EXPECT_GE(pictures.size(), 7u);
  for (const auto& [name, picture] : pictures) {
    const Policy* policy = FindPolicy(name);
    ASSERT_NE(policy, nullptr) << name;
    ASSERT_NE(policy->tree(), nullptr) << name;
    EXPECT_EQ(picture, DrawTree(*policy->tree())) << name;
  }
}

TEST(PoliciesTest, PursuersSeePursueAndAttack) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& robot = world.Add("humanoid robot", 1, 20.0, 0.0, M_PI);
  robot.controllable = true;
  world.Run(1.0, {{goblin.id, "pursuer"}});
  EXPECT_EQ(goblin.behaviour, Behaviour::kPursue);
  EXPECT_EQ(world.Count(EventKind::kPursued, goblin.name), 1);
  world.Run(9.0, {{goblin.id, "pursuer"}});
  EXPECT_EQ(goblin.behaviour, Behaviour::kAttack);
  EXPECT_LT(robot.hit_points, robot.species->hit_points);
  EXPECT_EQ(world.Count(EventKind::kAttacked, goblin.name),
            world.Count(EventKind::kHit, robot.name));
  EXPECT_EQ(world.Count(EventKind::kPursued, goblin.name), 1) << "one target, one event";
}

TEST(PoliciesTest, PursuersSearchWhereTheyLostSightAndGiveUp) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& robot = world.Add("humanoid robot", 1, 15.0, 0.0);
  robot.controllable = true;
  world.Run(1.0, {{goblin.id, "pursuer"}});
  ASSERT_EQ(goblin.behaviour, Behaviour::kPursue);
  robot.motion.position_m.x() = -60.0;  // out of sight
  std::set<Behaviour> seen;
  double nearest_m = 1e9;
  for (int i = 0; i < 250; ++i) {
    world.Run(0.1, {{goblin.id, "pursuer"}});
    seen.insert(goblin.behaviour);
    nearest_m = std::min(nearest_m, DistanceBetween(goblin.place(), {15.0, 0.0}));
  }
  EXPECT_EQ(seen.count(Behaviour::kSearch), 1u);
  EXPECT_LT(nearest_m, 2.0) << "it went to where it had seen the robot";
  EXPECT_EQ(goblin.behaviour, Behaviour::kPatrol);
  EXPECT_EQ(goblin.mind.target, 0u);
}

TEST(PoliciesTest, TheHurtRetreat) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& robot = world.Add("humanoid robot", 1, 5.0, 0.0, M_PI);
  robot.controllable = true;
  goblin.hit_points = 0.9 * goblin.species->hurt_share * goblin.species->hit_points;
  world.Run(3.0, {{goblin.id, "pursuer"}});
  EXPECT_GT(world.DistanceOf(goblin, robot), 9.0);
  EXPECT_EQ(world.Count(EventKind::kAttacked, goblin.name), 0);
}

TEST(PoliciesTest, EncirclersSpreadAroundTheirPreyBeforeTheyCloseIn) {
  MindWorld world(Wide());
  std::map<AgentId, std::string> policies;
  for (int i = 0; i < 4; ++i) {
    policies[world.Add("goblin", 2, -18.0, 3.0 * i - 4.5).id] = "encircler";
  }
  Agent& robot = world.Add("wheeled robot", 1, 0.0, 0.0);
  robot.controllable = true;
  double widest_gap_rad = 0.0;  // between neighbours' bearings, at the first blow
  bool encircled = false;
  for (int i = 0; i < 300 && world.Count(EventKind::kHit, robot.name) == 0; ++i) {
    world.Run(0.1, policies);
    std::vector<double> bearings_rad;
    for (const auto& [id, policy] : policies) {
      const Agent& goblin = world.agents.at(id);
      encircled = encircled || goblin.behaviour == Behaviour::kEncircle;
      bearings_rad.push_back(HeadingTo(robot.place(), goblin.place()));
    }
    std::sort(bearings_rad.begin(), bearings_rad.end());
    widest_gap_rad = bearings_rad.front() + 2.0 * M_PI - bearings_rad.back();
    for (std::size_t k = 1; k < bearings_rad.size(); ++k) {
      widest_gap_rad = std::max(widest_gap_rad, bearings_rad[k] - bearings_rad[k - 1]);
    }
  }
  EXPECT_TRUE(encircled);
  EXPECT_GE(world.Count(EventKind::kHit, robot.name), 1);
  EXPECT_LT(widest_gap_rad, 0.75 * M_PI) << "pursuers would all come from one side";
}

TEST(PoliciesTest, EncirclersComeWhenAMateCalls) {
  TestScene scene = Wide();
  scene.AddBuilding(-10.0, -12.0, 1.0, 6.0);
  MindWorld world(scene);
  Agent& seer = world.Add("goblin", 2, -15.0, 0.0);
  Agent& blind = world.Add("goblin", 2, -15.0, -15.0);
  Agent& robot = world.Add("wheeled robot", 1, 0.0, 0.0);
  robot.controllable = true;
  blind.motion.orientation = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ());
  world.Run(0.5, {{seer.id, "encircler"}, {blind.id, "encircler"}});
  EXPECT_EQ(seer.mind.target, robot.id);
  EXPECT_EQ(blind.mind.target, robot.id);
}

TEST(PoliciesTest, GuardsKeepIntrudersOutAndDoNotGoFar) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& robot = world.Add("humanoid robot", 1, 22.0, 0.0);
  robot.controllable = true;
  world.Run(10.0, {{goblin.id, "guard"}});
  EXPECT_EQ(goblin.behaviour, Behaviour::kGuard);
  EXPECT_LT(DistanceBetween(goblin.place(), {0.0, 0.0}), 2.0);

  robot.motion.position_m = {8.0, 0.0, 0.0};
  goblin.motion.orientation = Eigen::Quaterniond::Identity();
  world.Run(0.2, {{goblin.id, "guard"}});
  EXPECT_EQ(goblin.behaviour, Behaviour::kPursue);
  double farthest_m = 0.0;
  for (int i = 0; i < 300; ++i) {  // the intruder flees, a little slower than the guard
    robot.motion.position_m.x() = std::min(60.0, robot.motion.position_m.x() + 0.32);
    world.Run(0.1, {{goblin.id, "guard"}});
    farthest_m = std::max(farthest_m, DistanceBetween(goblin.place(), {0.0, 0.0}));
  }
  EXPECT_LT(farthest_m, 25.0);
  EXPECT_LT(DistanceBetween(goblin.place(), {0.0, 0.0}), 2.0) << "back at its post";
}

TEST(PoliciesTest, RaidersHitWithdrawAndComeBack) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& robot = world.Add("humanoid robot", 1, 6.0, 0.0, M_PI);
  robot.controllable = true;
  int withdrawals = 0;
  Behaviour last = Behaviour::kIdle;
  double farthest_m = 0.0;
  for (int i = 0; i < 200; ++i) {
    world.Run(0.1, {{goblin.id, "raider"}});
    if (goblin.behaviour == Behaviour::kRetreat && last != Behaviour::kRetreat) ++withdrawals;
    if (goblin.behaviour == Behaviour::kRetreat) {
      farthest_m = std::max(farthest_m, world.DistanceOf(goblin, robot));
    }
    last = goblin.behaviour;
  }
  EXPECT_GE(withdrawals, 2);
  EXPECT_GT(farthest_m, 5.0);
  EXPECT_EQ(world.Count(EventKind::kAttacked, goblin.name), withdrawals) << "one blow a raid";
}

TEST(PoliciesTest, InterceptorsMeetTheirPreyEarlierThanPursuers) {
  const auto seconds_to_blow = [](const std::string& policy) {
    MindWorld world(Wide());
    Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
    Agent& robot = world.Add("humanoid robot", 1, 15.0, -18.0, M_PI / 2);
    robot.controllable = true;
    world.pursuit_distance_m = 60.0;
    for (int i = 0; i < 400; ++i) {
      if (world.Count(EventKind::kHit, robot.name) > 0) return 0.1 * i;
      robot.motion.position_m.y() += 0.3;
      robot.motion.linear_velocity_mps = {0.0, 3.0, 0.0};
      world.Run(0.1, {{goblin.id, policy}});
      robot.motion.linear_velocity_mps = {0.0, 3.0, 0.0};
    }
    return 40.0;
  };
  EXPECT_LT(seconds_to_blow("interceptor"), 0.8 * seconds_to_blow("pursuer"));
}

TEST(PoliciesTest, SheepFleeFromAdversariesAndTheAlarmSpreads) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& near = world.Add("sheep", 0, 6.0, 0.0, M_PI);
  Agent& mate = world.Add("sheep", 0, 12.0, 0.0, 0.0);  // looks away, and the goblin is far
  Agent& far = world.Add("sheep", 0, 40.0, 0.0, M_PI);
  const std::map<AgentId, std::string> policies = {
      {goblin.id, "idler"}, {near.id, "grazer"}, {mate.id, "grazer"}, {far.id, "grazer"}};
  world.Run(0.5, policies);
  EXPECT_EQ(near.behaviour, Behaviour::kFlee);
  EXPECT_EQ(mate.behaviour, Behaviour::kFlee);
  EXPECT_EQ(far.behaviour, Behaviour::kGraze);
  world.Run(15.0, policies);
  EXPECT_GT(world.DistanceOf(near, goblin), 12.0);
  EXPECT_EQ(near.behaviour, Behaviour::kGraze) << "the alarm is over";
  EXPECT_EQ(mate.behaviour, Behaviour::kGraze);
}

TEST(PoliciesTest, RobotsThatCanStrikeDefendThemselvesAndOthersFlee) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& fighter = world.Add("humanoid robot", 1, 5.0, 0.0, M_PI);
  world.Run(6.0, {{goblin.id, "pursuer"}, {fighter.id, "patroller"}});
  EXPECT_GT(world.Count(EventKind::kAttacked, fighter.name), 0);
  EXPECT_GT(world.Count(EventKind::kHit, goblin.name), 0);

  MindWorld other(Wide());
  Agent& hunter = other.Add("goblin", 2, 0.0, 0.0);
  Agent& car = other.Add("ackermann car", 1, 6.0, 0.0);
  other.Run(1.0, {{hunter.id, "pursuer"}, {car.id, "idler"}});
  EXPECT_EQ(car.behaviour, Behaviour::kFlee);
  EXPECT_GT(DistanceBetween(car.place(), {6.0, 0.0}), 4.0);
}

TEST(PoliciesTest, TheAlarmReachesThoseThatRememberTheThreat) {
  MindWorld world(Wide());
  Agent& near = world.Add("sheep", 0, 0.0, 0.0);
  Agent& other = world.Add("sheep", 0, 4.0, 0.0);
  Agent& goblin = world.Add("goblin", 2, -5.0, 0.0);
  world.step = 2000;
  Sighting sighting;
  sighting.who = goblin.id;
  sighting.team = goblin.team;
  sighting.position_m = goblin.motion.position_m;
  sighting.step = 500;  // 15 s ago
  Remember(&other, sighting);
  near.behaviour = Behaviour::kFlee;
  Remember(&near, sighting);
  EXPECT_FALSE(Flee(&other, &world.Now()).has_value()) << "neither knows of it lately";
  sighting.step = 1990;
  Remember(&near, sighting);
  EXPECT_TRUE(Flee(&other, &world.Now()).has_value());
}

TEST(PoliciesTest, WhoIsCommandedFromOutsideIsAfterNobodyInParticular) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  goblin.mind.target = 7;
  Think(&goblin, "external", &world.Now());
  EXPECT_EQ(goblin.mind.target, 0u);
}

}  // namespace
}  // namespace latticeworld
