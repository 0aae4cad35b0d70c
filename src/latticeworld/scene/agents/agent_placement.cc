#include "latticeworld/scene/agents/agent_placement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/agents/spawn_rules.h"
#include "latticeworld/scene/agents/spawn_search.h"
#include "latticeworld/scene/weather/water_depth.h"

namespace latticeworld {
namespace {

constexpr double kLowestFlight_m = 8.0, kHighestFlight_m = 15.0;
constexpr double kCentreSpread_m = 10.0;  // of the robot that nobody asked for

// Hands out names: "sheep_1", "sheep_2"; the first wheeled robot is "robot".
class Names {
 public:
  std::string Next(AgentCategory category) {
    const int number = ++count_[static_cast<int>(category)];
    if (category == AgentCategory::kWheeledRobot && number == 1) return "robot";
    std::string name(NameOf(category));
    std::replace(name.begin(), name.end(), ' ', '_');
    return name + "_" + std::to_string(number);
  }
  int CountOf(AgentCategory category) const { return count_[static_cast<int>(category)]; }

 private:
  std::array<int, EnumNames(AgentCategory{}).size()> count_{};
};

AgentStart MakeStart(const Scene& scene, AgentCategory category, AgentState state,
                     WorldPoint position, RandomStream* random, Names* names) {
  AgentStart start;
  start.name = names->Next(category);
  start.category = category;
  start.state = state;
  start.team = TeamOf(category);
  start.controllable = category == AgentCategory::kWheeledRobot;
  start.position = position;
  const double flight_m = random->Uniform(kLowestFlight_m, kHighestFlight_m);
  if (LocomotionOf(category) == Locomotion::kWings) {
    start.height_above_ground_m = flight_m;
  } else if (LocomotionOf(category) == Locomotion::kFins) {
    start.height_above_ground_m = 0.25 * WaterDepthAt(*scene.terrain, scene.atmosphere, position);
  }
  start.heading_rad = random->Uniform(-M_PI, M_PI);
  return start;
}

// Spread of a herd that leaves every animal a few square clearances.
double HerdSpread(int quantity, double body_radius_m) {
  return 1.2 * SpawnClearance(body_radius_m) * std::sqrt(static_cast<double>(quantity));
}

std::string SlidingWarning(int count, AgentCategory category, Region region) {
  return std::to_string(count) + " " + std::string(NameOf(category)) +
         (count == 1 ? " agent stands" : " agents stand") +
         " on ground that is steeper than it holds, and may slide: " + std::string(NameOf(region)) +
         " has no other place";
}

// A place for the robot that nobody asked for: near the centre, else anywhere, and where it stands
// still rather than where it slides.
Result<WorldPoint> FindForRobot(const Scene& scene, const std::vector<WorldPoint>& taken,
                                RandomStream* random, std::vector<std::string>* warnings) {
  constexpr AgentCategory kRobot = AgentCategory::kWheeledRobot;
  const double radius_m = BodyRadius(kRobot);
  Result<WorldPoint> position = NotFound("nothing was tried");
  for (const auto slopes : {SpawnSearch::Slopes::kHeld, SpawnSearch::Slopes::kLegal}) {
    position =
        SpawnSearch(scene, scene.atmosphere, kRobot, radius_m, Region::kCenter, nullptr, slopes)
            .FindNear({0.0, 0.0}, kCentreSpread_m, taken, random);
    if (!position.ok()) {
      position =
          SpawnSearch(scene, scene.atmosphere, kRobot, radius_m, Region::kAnywhere, nullptr, slopes)
              .Find(taken, random);
    }
    if (!position.ok()) continue;
    if (slopes == SpawnSearch::Slopes::kLegal) {
      warnings->push_back(SlidingWarning(1, kRobot, Region::kAnywhere));
    }
    break;
  }
  return position;
}

}  // namespace

int TeamOf(AgentCategory category) {
  switch (category) {
    case AgentCategory::kGoblin:
    case AgentCategory::kAncientWarrior:
      return 2;
    case AgentCategory::kHumanoidRobot:
    case AgentCategory::kRoboticDog:
    case AgentCategory::kAerialRobot:
    case AgentCategory::kWheeledRobot:
      return 1;
    case AgentCategory::kSheep:
    case AgentCategory::kHorse:
    case AgentCategory::kEagle:
    case AgentCategory::kWhale:
      return 0;
  }
  return 0;
}

AgentState UsualState(AgentCategory category) {
  switch (category) {
    case AgentCategory::kSheep:
    case AgentCategory::kHorse:
      return AgentState::kGrazing;
    case AgentCategory::kEagle:
      return AgentState::kFlying;
    case AgentCategory::kWhale:
      return AgentState::kSwimming;
    case AgentCategory::kGoblin:
    case AgentCategory::kAncientWarrior:
      return AgentState::kPatrolling;
    case AgentCategory::kHumanoidRobot:
    case AgentCategory::kRoboticDog:
    case AgentCategory::kAerialRobot:
    case AgentCategory::kWheeledRobot:
      return AgentState::kIdle;
  }
  return AgentState::kIdle;
}

std::vector<AgentStart> PlaceAgents(const Scene& scene, std::uint64_t seed,
                                    std::vector<std::string>* warnings) {
  std::vector<AgentStart> agents;
  std::vector<WorldPoint> taken;
  // Single things that can be moved stand already.
  for (const Prop& prop : scene.props) taken.push_back(prop.position);
  Names names;
  const auto add = [&](AgentCategory category, AgentState state, WorldPoint position,
                       RandomStream* random) {
    taken.push_back(position);
    agents.push_back(MakeStart(scene, category, state, position, random, &names));
  };

  // A stream a group, so that a group that grows leaves the draws of the others alone.
  for (std::size_t i = 0; i < scene.environment.agents.size(); ++i) {
    const AgentGroup& group = scene.environment.agents[i];
    RandomStream random(seed, "scene/agents/" + std::to_string(i));
    const double radius_m = BodyRadius(group.category);
    SpawnSearch held(scene, scene.atmosphere, group.category, radius_m, group.position, nullptr,
                     SpawnSearch::Slopes::kHeld);
    SpawnSearch legal(scene, scene.atmosphere, group.category, radius_m, group.position);
    const bool herd = group.state == AgentState::kGrazing;
    WorldPoint herd_centre;
    int sliding = 0;
    for (int placed = 0; placed < group.quantity; ++placed) {
      const auto find = [&](SpawnSearch* search) {
        return herd && placed > 0
                   ? search->FindNear(herd_centre, HerdSpread(group.quantity, radius_m), taken,
                                      &random)
                   : search->Find(taken, &random);
      };
      Result<WorldPoint> position = find(&held);
      if (!position.ok()) {
        position = find(&legal);
        sliding += position.ok() ? 1 : 0;
      }
      if (!position.ok()) {
        warnings->push_back(
            "placed " + std::to_string(placed) + " of " + std::to_string(group.quantity) + " " +
            std::string(NameOf(group.category)) + " agents: " + position.status().message());
        break;
      }
      if (placed == 0) herd_centre = *position;
      add(group.category, group.state, *position, &random);
    }
    if (sliding > 0) warnings->push_back(SlidingWarning(sliding, group.category, group.position));
  }

  if (names.CountOf(AgentCategory::kWheeledRobot) > 0) return agents;
  RandomStream random(seed, "scene/robot");
  const Result<WorldPoint> position = FindForRobot(scene, taken, &random, warnings);
  if (position.ok()) {
    add(AgentCategory::kWheeledRobot, AgentState::kIdle, *position, &random);
  } else {
    warnings->push_back("the world has no wheeled robot: " + position.status().message());
  }
  return agents;
}

}  // namespace latticeworld
