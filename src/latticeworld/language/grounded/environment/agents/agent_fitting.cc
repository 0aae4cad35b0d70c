#include "latticeworld/language/grounded/environment/agents/agent_fitting.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/feature_places.h"
#include "latticeworld/language/places.h"

namespace latticeworld {
namespace {

// Cells of a ninth (about 114) that a group needs to live there.
constexpr int kRoomCells = 6;
// A whale's body needs water that stays 2 m deep all around it. Beds fall off from the shore, and
// are that deep some 14 m out; the shore itself wavers by a little.
constexpr double kDeepFromShore_m = 16.0;

using Suits = std::function<bool(CellIndex)>;

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

// The first category of a kind that can be in the state ("robots fly").
AgentCategory CategoryOf(const AgentWish& wish) {
  for (const AgentCategory category : wish.categories) {
    if (!wish.state.has_value() || CanBe(category, *wish.state)) return category;
  }
  return wish.categories.front();
}

// Cells of water around a swimmer in a world of that size.
int ShoreCells(double size_m) {
  const double cells = std::ceil(kDeepFromShore_m * kLayoutSize / std::max(1.0, size_m) - 0.5);
  return static_cast<int>(std::clamp(cells, 1.0, static_cast<double>(kLayoutSize)));
}

class Fitter {
 public:
  Fitter(const SymbolicLayout& layout, double size_m, std::vector<std::string>* warnings)
      : layout_(layout), shore_cells_(ShoreCells(size_m)), warnings_(warnings) {}

  std::vector<AgentGroup> Fit(const std::vector<AgentWish>& wishes) {
    for (const AgentWish& wish : wishes) FitWish(wish);
    return std::move(groups_);
  }

 private:
  void Warn(const AgentWish& wish, const std::string& what) {
    warnings_->push_back(Quote(wish.words) + ": " + what);
  }

  void FitWish(const AgentWish& wish) {
    AgentGroup group;
    group.category = CategoryOf(wish);
    const std::string category(NameOf(group.category));
    if (!wish.exact) {
      warnings_->push_back("there is no " + Quote(wish.name) + "; " + category +
                           ", the nearest category, takes its place");
    }
    group.state = wish.state.value_or(UsualState(group.category));
    if (!CanBe(group.category, group.state)) {
      const AgentState legal = LegalState(group.category, group.state);
      Warn(wish, "a " + category + " cannot be " + std::string(NameOf(group.state)) + "; it is " +
                     std::string(NameOf(legal)));
      group.state = legal;
    }
    const std::vector<Region> regions = RegionsFor(wish);
    if (wish.each || regions.size() > 1) {
      Spread(wish, regions, group);
      return;
    }
    group.quantity = wish.quantity;
    if (!regions.empty()) group.position = regions.front();
    Add(wish, group);
  }

  // Returns where the wish wants its agents, a ninth for each group: none is anywhere.
  std::vector<Region> RegionsFor(const AgentWish& wish) {
    std::vector<Region> regions;
    if (wish.feature.has_value()) {
      const Region here = RegionFor(wish, *wish.feature);
      if (here != Region::kAnywhere) regions.push_back(here);
      for (const FeaturePlace& feature : wish.more_land) {
        const Region also = RegionFor(wish, feature);
        if (also != Region::kAnywhere) regions.push_back(also);
      }
      if (!regions.empty()) return regions;
      if (wish.feature->on.has_value()) return {RegionOf(*wish.feature->on)};
    }
    for (const Place& place : wish.places) {
      if (std::find(regions.begin(), regions.end(), place.main) == regions.end()) {
        regions.push_back(place.main);
      }
    }
    return regions;
  }

  // The ninth where most of the land is that the agents can live on; kAnywhere: there is none.
  Region RegionFor(const AgentWish& wish, const FeaturePlace& feature) {
    const std::vector<Region> regions = RegionsAt(feature, wish.places, layout_);
    if (regions.empty()) {
      Warn(wish, "there is no " + feature.name + " like that on this land");
      return Region::kAnywhere;
    }
    const Suits suits = GroundOf(CategoryOf(wish), wish.state.value_or(AgentState::kIdle));
    const auto fits = std::find_if(regions.begin(), regions.end(), [&](Region region) {
      return suits == nullptr || RoomIn(region, suits) > 0;
    });
    return fits == regions.end() ? regions.front() : *fits;
  }

  // Puts the wished number of agents into each place, or shares it out among all places.
  void Spread(const AgentWish& wish, const std::vector<Region>& regions, AgentGroup group) {
    const int places = std::max<int>(1, static_cast<int>(regions.size()));
    // If few are wished in many places, each place gets one at least.
    int left = wish.counted ? wish.quantity : std::max(wish.quantity, places);
    for (int i = 0; i < places; ++i) {
      const int remaining = places - i;
      group.quantity = wish.each ? wish.quantity : (left + remaining - 1) / remaining;
      left -= group.quantity;
      if (group.quantity < 1) continue;
      if (!regions.empty()) group.position = regions[static_cast<std::size_t>(i)];
      Add(wish, group);
    }
  }

  // Returns on which cells a category lives when it is in that state; nullptr: on any.
  Suits GroundOf(AgentCategory category, AgentState state) const {
    switch (LocomotionOf(category)) {
      case Locomotion::kFins:
        return [this](CellIndex cell) { return IsOpenWater(cell); };
      case Locomotion::kWings:
        return nullptr;
      case Locomotion::kLegs:
      case Locomotion::kWheels:
        break;
    }
    if (state == AgentState::kGrazing) {
      const char grass = layout_.vocabulary == Vocabulary::kSuburb ? 'G' : 'B';
      return [this, grass](CellIndex cell) { return layout_.cells[cell] == grass; };
    }
    return [this](CellIndex cell) { return layout_.cells[cell] != 'W'; };
  }

  void Add(const AgentWish& wish, AgentGroup group) {
    const std::string category(NameOf(group.category));
    Suits suits = GroundOf(group.category, group.state);
    // Whom nobody asked to graze rests where it is asked to be.
    if (group.state == AgentState::kGrazing && suits != nullptr && !wish.state.has_value() &&
        RoomIn(group.position, suits) < kRoomCells &&
        RoomIn(group.position, GroundOf(group.category, AgentState::kIdle)) >= kRoomCells) {
      group.state = AgentState::kIdle;
      suits = GroundOf(group.category, group.state);
    }
    if (group.state == AgentState::kGrazing && suits != nullptr &&
        RoomIn(Region::kAnywhere, suits) < kRoomCells) {
      Warn(wish, "there is no grass to graze on; it is idle");
      group.state = AgentState::kIdle;
      suits = GroundOf(group.category, group.state);
    }
    // Who is not said to graze rather stays where it is asked for.
    if (group.state == AgentState::kGrazing && suits != nullptr && !wish.state.has_value() &&
        RoomIn(group.position, suits) < kRoomCells) {
      group.state = AgentState::kIdle;
      suits = GroundOf(group.category, group.state);
    }
    if (LocomotionOf(group.category) == Locomotion::kFins) {
      if (RoomIn(Region::kAnywhere, suits) == 0) {
        return Warn(wish, "left out: there is no water wide and deep enough for a " + category);
      }
      Settle(wish, "open water", 1, suits, &group);
    } else if (suits != nullptr) {
      if (RoomIn(Region::kAnywhere, suits) < kRoomCells) {
        return Warn(wish, "left out: there is no land to stand on");
      }
      Settle(wish, group.state == AgentState::kGrazing ? "grass" : "land", kRoomCells, suits,
             &group);
    }
    AddWithinLimits(wish, group);
  }

  // Groups of at most kMaxGroupQuantity, as many as the world can hold.
  void AddWithinLimits(const AgentWish& wish, AgentGroup group) {
    const int wanted = group.quantity;
    const int fitting = std::min(wanted, kMaxAgents - total_);
    if (fitting <= 0) {
      return Warn(wish,
                  "left out: a world holds at most " + std::to_string(kMaxAgents) + " agents");
    }
    if (fitting < wanted) {
      Warn(wish, "cut to " + std::to_string(fitting) + ": a world holds at most " +
                     std::to_string(kMaxAgents) + " agents");
    }
    total_ += fitting;
    for (int left = fitting; left > 0; left -= kMaxGroupQuantity) {
      group.quantity = std::min(left, kMaxGroupQuantity);
      groups_.push_back(group);
    }
  }

  // Water in the cell and all around it; the land beyond the map's edge is no shore.
  bool IsOpenWater(CellIndex cell) const {
    for (int row = cell.row - shore_cells_; row <= cell.row + shore_cells_; ++row) {
      for (int col = cell.col - shore_cells_; col <= cell.col + shore_cells_; ++col) {
        const CellIndex next{row, col};
        if (layout_.cells.Contains(next) && layout_.cells[next] != 'W') return false;
      }
    }
    return true;
  }

  int RoomIn(Region region, const Suits& suits) const {
    int room = 0;
    const UnitBox box = BoxOf(region);
    for (int row = 0; row < kLayoutSize; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) {
        if (!box.Contains((col + 0.5) / kLayoutSize, (row + 0.5) / kLayoutSize)) continue;
        room += suits({row, col}) ? 1 : 0;
      }
    }
    return room;
  }

  // Moves the group to the nearest ninth with room where its own has none.
  void Settle(const AgentWish& wish, std::string_view ground, int least_room, const Suits& suits,
              AgentGroup* group) {
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
  int shore_cells_;  // water around a swimmer
  std::vector<std::string>* warnings_;
  std::vector<AgentGroup> groups_;
  int total_ = 0;
};

}  // namespace

std::vector<AgentGroup> FitAgents(const std::vector<AgentWish>& wishes,
                                  const SymbolicLayout& layout, double size_m,
                                  std::vector<std::string>* warnings) {
  return Fitter(layout, size_m, warnings).Fit(wishes);
}

}  // namespace latticeworld
