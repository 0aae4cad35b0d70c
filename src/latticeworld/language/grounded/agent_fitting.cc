#include "latticeworld/language/grounded/agent_fitting.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/canvas.h"
#include "latticeworld/language/grounded/places.h"

namespace latticeworld {
namespace {

// Cells of a ninth (about 114) that a group needs to live there.
constexpr int kRoomCells = 6;
// A whale needs water that stays 2 m deep all around it. The bed falls off from the shore, so that
// a river of one cell never gets there however long it is, but the middle of three by three cells
// of water does: 2.7 m in a world of the usual 512 m, where a cell has 16 m. Smaller worlds have
// shallower lakes; whether one suits is then for the scene to find out.
constexpr int kOpenWaterCells = 1;

AgentState UsualState(AgentCategory category) {
  switch (category) {
    case AgentCategory::kSheep:
    case AgentCategory::kHorse:
      return AgentState::kGrazing;
    case AgentCategory::kEagle:
    case AgentCategory::kAerialRobot:
      return AgentState::kFlying;
    case AgentCategory::kWhale:
      return AgentState::kSwimming;
    case AgentCategory::kGoblin:
    case AgentCategory::kAncientWarrior:
    case AgentCategory::kRoboticDog:
      return AgentState::kPatrolling;
    case AgentCategory::kHumanoidRobot:
    case AgentCategory::kWheeledRobot:
      return AgentState::kIdle;
  }
  return AgentState::kIdle;
}

// The state nearest to one that the category cannot be in.
AgentState LegalState(AgentCategory category, AgentState wanted) {
  const auto first_legal = [&](std::initializer_list<AgentState> states) {
    for (const AgentState state : states) {
      if (CanBe(category, state)) return state;
    }
    return UsualState(category);
  };
  switch (wanted) {
    case AgentState::kPursuing:
    case AgentState::kAttacking:
      return first_legal({AgentState::kPursuing, AgentState::kPatrolling, AgentState::kFlying,
                          AgentState::kSwimming});
    case AgentState::kPatrolling:
      return first_legal({AgentState::kFlying, AgentState::kSwimming, AgentState::kGrazing});
    default:
      return UsualState(category);
  }
}

class Fitter {
 public:
  Fitter(const SymbolicLayout& layout, std::vector<std::string>* warnings)
      : layout_(layout), warnings_(warnings) {}

  std::vector<AgentGroup> Fit(const std::vector<AgentWish>& wishes) {
    int total = 0;
    for (const AgentWish& wish : wishes) {
      std::optional<AgentGroup> group = FitGroup(wish);
      if (!group.has_value()) continue;
      const int room = std::min(kMaxGroupQuantity, kMaxAgents - total);
      if (room <= 0) {
        Warn(wish, "left out: a world holds at most " + std::to_string(kMaxAgents) + " agents");
        continue;
      }
      if (group->quantity > room) {
        Warn(wish, "cut to " + std::to_string(room) + ": a group holds at most " +
                       std::to_string(kMaxGroupQuantity) + " and a world " +
                       std::to_string(kMaxAgents) + " agents");
        group->quantity = room;
      }
      total += group->quantity;
      groups_.push_back(*group);
    }
    return std::move(groups_);
  }

 private:
  void Warn(const AgentWish& wish, const std::string& what) {
    warnings_->push_back(Quote(wish.words) + ": " + what);
  }

  std::optional<AgentGroup> FitGroup(const AgentWish& wish) {
    AgentGroup group;
    group.category = wish.category;
    group.quantity = wish.quantity;
    group.position = wish.position;
    group.state = wish.state.value_or(UsualState(wish.category));
    if (!CanBe(group.category, group.state)) {
      const AgentState legal = LegalState(group.category, group.state);
      Warn(wish, "a " + std::string(NameOf(group.category)) + " cannot be " +
                     std::string(NameOf(group.state)) + "; it is " + std::string(NameOf(legal)));
      group.state = legal;
    }
    const auto is_open_water = [&](CellIndex cell) { return IsOpenWater(cell); };
    switch (LocomotionOf(group.category)) {
      case Locomotion::kFins:
        if (RoomIn(Region::kAnywhere, is_open_water) < kOpenWaterCells) {
          Warn(wish, "left out: there is no water large enough for a " +
                         std::string(NameOf(group.category)));
          return std::nullopt;
        }
        Settle(wish, "open water", kOpenWaterCells, &group, is_open_water);
        return group;
      case Locomotion::kWings:
        return group;
      case Locomotion::kLegs:
      case Locomotion::kWheels:
        break;
    }
    const char grass = layout_.vocabulary == Vocabulary::kSuburb ? 'G' : 'B';
    const auto is_grass = [&](CellIndex cell) { return layout_.cells[cell] == grass; };
    if (group.state == AgentState::kGrazing) {
      if (RoomIn(Region::kAnywhere, is_grass) >= kRoomCells) {
        Settle(wish, "grass", kRoomCells, &group, is_grass);
        return group;
      }
      Warn(wish, "there is no grass to graze on; it is idle");
      group.state = AgentState::kIdle;
    }
    const auto is_land = [&](CellIndex cell) { return layout_.cells[cell] != 'W'; };
    if (RoomIn(Region::kAnywhere, is_land) < kRoomCells) {
      Warn(wish, "left out: there is no land to stand on");
      return std::nullopt;
    }
    Settle(wish, "land", kRoomCells, &group, is_land);
    return group;
  }

  // Water in the cell and all around it; the land beyond the map's edge is no shore.
  bool IsOpenWater(CellIndex cell) const {
    if (layout_.cells[cell] != 'W') return false;
    for (const auto& step : kNeighbours8) {
      const CellIndex next{cell.row + step[0], cell.col + step[1]};
      if (layout_.cells.Contains(next) && layout_.cells[next] != 'W') return false;
    }
    return true;
  }

  template <typename Suits>
  int RoomIn(Region region, const Suits& suits) const {
    int room = 0;
    const UnitBox box = BoxOf(region);
    for (int row = 0; row < kLayoutSize; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) {
        const CellIndex cell{row, col};
        room += IsIn(box, cell) && suits(cell) ? 1 : 0;
      }
    }
    return room;
  }

  // Moves the group to the nearest ninth with room where its own has none.
  template <typename Suits>
  void Settle(const AgentWish& wish, std::string_view ground, int least_room, AgentGroup* group,
              const Suits& suits) {
    if (RoomIn(group->position, suits) >= least_room) return;
    const Heading from = HeadingOf(group->position);
    Region best = Region::kAnywhere;
    int best_score = -1;
    for (const auto& entry : EnumNames(Region{})) {
      if (entry.value == Region::kAnywhere) continue;
      const int room = RoomIn(entry.value, suits);
      if (room < least_room) continue;
      const Heading to = HeadingOf(entry.value);
      const int east = to.east - from.east;
      const int south = to.south - from.south;
      const int score = 1000 * (9 - east * east - south * south) + room;
      if (score > best_score) {
        best_score = score;
        best = entry.value;
      }
    }
    Warn(wish, "there is no " + std::string(ground) + " in the " +
                   std::string(NameOf(group->position)) + "; moved to " +
                   std::string(NameOf(best)));
    group->position = best;
  }

  const SymbolicLayout& layout_;
  std::vector<std::string>* warnings_;
  std::vector<AgentGroup> groups_;
};

}  // namespace

std::vector<AgentGroup> FitAgents(const std::vector<AgentWish>& wishes,
                                  const SymbolicLayout& layout,
                                  std::vector<std::string>* warnings) {
  return Fitter(layout, warnings).Fit(wishes);
}

}  // namespace latticeworld
