#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "latticeworld/terrain/cones.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/water/water_level.h"

namespace latticeworld::internal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kDry = std::numeric_limits<float>::quiet_NaN();
constexpr double kReachLength = 0.5;  // [layout cells]
constexpr double kLowShare = 0.05;    // of a shore may lie below its water, and is raised
constexpr int kSmoothingRounds = 12;
constexpr int kMaxRounds = 6;
constexpr float kAgreement_m = 0.01f;

// Rivers cut across their course into reaches of equal distance from the outlet, and lakes, each of
// which has one level; together a graph of who flows into whom.
class Reaches {
 public:
  Reaches(const WaterBodies& water, const Grid<float>& distance, float length)
      : water_(water), distance_(distance), length_(length) {
    NumberStillWater();
    NumberReaches();
    FindContacts();
  }

  // Levels [m] below `cap_m`, that of each cell's surroundings, falling along the course.
  Grid<float> Levels(const Grid<float>& land_m, const Grid<float>& cap_m, const GradedRule& rule,
                     float steepest_step_m) {
    FindShores(land_m, rule);
    for (const std::int32_t cell : water_.bodies.cells) {
      Reach& reach = reaches_[number_.data()[cell]];
      reach.level_m = std::min(reach.level_m, cap_m.data()[cell]);
    }
    // From the springs down nothing rises; from the outlets up nothing falls too steeply.
    for (const auto& [up, down] : contacts_) {
      reaches_[down].level_m = std::min(reaches_[down].level_m, reaches_[up].level_m);
    }
    for (auto it = contacts_.rbegin(); it != contacts_.rend(); ++it) {
      const auto [up, down] = *it;
      reaches_[up].level_m =
          std::min(reaches_[up].level_m, reaches_[down].level_m + steepest_step_m);
    }
    for (const auto& [up, down] : contacts_) {
      Join(down, &reaches_[up].below_m, &reaches_[up].below_is_still);
      Join(up, &reaches_[down].above_m, &reaches_[down].above_is_still);
    }
    Grid<float> level(number_.rows(), number_.cols(), kDry);
    for (const std::int32_t cell : water_.bodies.cells) level.data()[cell] = LevelAt(cell);
    Smooth(&level);
    return level;
  }

 private:
  struct Reach {
    float distance = 0.0f;  // of its downstream end
    bool is_still = false;
    float level_m = kInfinity;
    float below_m = kInfinity;  // the lowest reach that it flows into
    float above_m = kInfinity;  // the lowest that flows into it
    bool below_is_still = false;
    bool above_is_still = false;
  };

  void Join(int other, float* level_m, bool* is_still) const {
    if (reaches_[other].level_m >= *level_m) return;
    *level_m = reaches_[other].level_m;
    *is_still = reaches_[other].is_still;
  }

  void NumberStillWater() {
    number_ = Grid<std::int32_t>(distance_.rows(), distance_.cols(), -1);
    std::vector<std::int32_t> number(water_.still_count(), -1);
    std::int32_t sea = -1;
    for (const std::int32_t cell : water_.bodies.cells) {
      const std::int32_t still = water_.still.data()[cell];
      if (still < 0) continue;
      if (number[still] < 0) {
        // All of the sea is one water.
        if (water_.is_sea[still] && sea >= 0) {
          number[still] = sea;
        } else {
          number[still] = static_cast<std::int32_t>(reaches_.size());
          if (water_.is_sea[still]) sea = number[still];
          reaches_.emplace_back();
          reaches_.back().is_still = true;
          reaches_.back().distance = distance_.data()[cell];
        }
      }
      number_.data()[cell] = number[still];
    }
  }

  void NumberReaches() {
    std::vector<std::int32_t> queue;
    for (const std::int32_t seed : water_.bodies.cells) {
      if (number_.data()[seed] >= 0) continue;
      const auto number = static_cast<std::int32_t>(reaches_.size());
      const float band = Band(seed);
      reaches_.emplace_back();
      reaches_.back().distance = band * length_;
      number_.data()[seed] = number;
      queue.assign(1, seed);
      for (std::size_t next = 0; next < queue.size(); ++next) {
        ForEachNear(queue[next], [&](std::int32_t near) {
          if (number_.data()[near] >= 0 || water_.still.data()[near] >= 0) return;
          if (Band(near) != band) return;
          number_.data()[near] = number;
          queue.push_back(near);
        });
      }
    }
  }

  void FindContacts() {
    for (const std::int32_t cell : water_.bodies.cells) {
      const std::int32_t here = number_.data()[cell];
      ForEachNear(cell, [&](std::int32_t near) {
        const std::int32_t there = number_.data()[near];
        if (there != here && distance_.data()[near] < distance_.data()[cell]) {
          contacts_.emplace_back(here, there);
        }
      });
    }
    std::sort(contacts_.begin(), contacts_.end());
    contacts_.erase(std::unique(contacts_.begin(), contacts_.end()), contacts_.end());
    // Contacts are sorted from the springs down.
    std::sort(contacts_.begin(), contacts_.end(), [this](const auto& a, const auto& b) {
      const float distance_a = reaches_[a.first].distance;
      const float distance_b = reaches_[b.first].distance;
      return distance_a != distance_b ? distance_a > distance_b : a < b;
    });
  }

  void FindShores(const Grid<float>& land_m, const GradedRule& rule) {
    std::vector<std::vector<float>> shore(reaches_.size()), own(reaches_.size());
    const int cols = land_m.cols();
    for (const std::int32_t cell : water_.bodies.cells) {
      const std::int32_t number = number_.data()[cell];
      own[number].push_back(land_m.data()[cell]);
      ForEachNeighbour(land_m, cell / cols, cell % cols, [&](int r, int c) {
        if (water_.wet(r, c) == 0) shore[number].push_back(land_m(r, c));
      });
    }
    for (std::size_t i = 0; i < reaches_.size(); ++i) {
      Reach& reach = reaches_[i];
      reach.level_m = Quantile(kLowShare, shore[i].empty() ? &own[i] : &shore[i]) -
                      static_cast<float>(rule.incision_m);
      reach.below_m = reach.above_m = kInfinity;
      reach.below_is_still = reach.above_is_still = false;
    }
  }

  // Returns the level, interpolated along the course between the middles of reaches; a lake lies
  // level up to its mouths.
  float LevelAt(std::int32_t cell) const {
    const Reach& reach = reaches_[number_.data()[cell]];
    if (reach.is_still) return reach.level_m;
    const float place = (distance_.data()[cell] - reach.distance) / length_ - 0.5f;
    const float next_m = place < 0.0f ? reach.below_m : reach.above_m;
    if (next_m == kInfinity) return reach.level_m;
    const bool to_still = place < 0.0f ? reach.below_is_still : reach.above_is_still;
    const float share = std::min(1.0f, std::abs(place) * (to_still ? 2.0f : 1.0f));
    return reach.level_m + share * (next_m - reach.level_m);
  }

  // Smooths the step that is left where branches of unlike levels meet: mean levels of neighbours,
  // several times.
  void Smooth(Grid<float>* level_m) const {
    std::vector<std::int32_t> cells;
    for (const std::int32_t cell : water_.bodies.cells) {
      if (water_.still.data()[cell] < 0) cells.push_back(cell);
    }
    std::vector<float> smooth(cells.size());
    for (int round = 0; round < kSmoothingRounds; ++round) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        float sum = level_m->data()[cells[i]];
        int count = 1;
        ForEachNear(cells[i], [&](std::int32_t near) {
          sum += level_m->data()[near];
          ++count;
        });
        smooth[i] = sum / static_cast<float>(count);
      }
      for (std::size_t i = 0; i < cells.size(); ++i) level_m->data()[cells[i]] = smooth[i];
    }
  }

  template <typename Visit>
  void ForEachNear(std::int32_t cell, Visit visit) const {
    const int cols = distance_.cols();
    ForEachNeighbour(distance_, cell / cols, cell % cols, [&](int r, int c) {
      if (water_.wet(r, c) != 0) visit(r * cols + c);
    });
  }

  float Band(std::int32_t cell) const { return std::floor(distance_.data()[cell] / length_); }

  const WaterBodies& water_;
  const Grid<float>& distance_;
  float length_;  // of a reach [cells]
  Grid<std::int32_t> number_;
  std::vector<Reach> reaches_;
  std::vector<std::pair<std::int32_t, std::int32_t>> contacts_;  // (upstream, downstream)
};

}  // namespace

Grid<float> GradedLevels(const GridGeometry& geometry, const WaterBodies& water,
                         const Grid<float>& land_m, const GradedRule& rule) {
  const Grid<float> distance = FlowDistance(water, OutletsOf(water, land_m),
                                            Grid<float>(land_m.rows(), land_m.cols(), 1.0f));
  const auto length = static_cast<float>(kReachLength * LatticeCellsPerLayoutCell(geometry));
  Reaches reaches(water, distance, length);
  const auto steepest_step_m = static_cast<float>(rule.steepest * length * geometry.resolution_m());
  // No water stands higher above other water than the land between them can fall.
  Grid<float> cap_m(land_m.rows(), land_m.cols(), kInfinity);
  Grid<float> level_m;
  for (int round = 0; round < kMaxRounds; ++round) {
    level_m = reaches.Levels(land_m, cap_m, rule, steepest_step_m);
    for (std::size_t i = 0; i < cap_m.size(); ++i) {
      cap_m.data()[i] = water.wet.data()[i] != 0 ? level_m.data()[i] : kInfinity;
    }
    LowerCones(static_cast<float>(rule.neighbour_slope * geometry.resolution_m()), &cap_m);
    bool agreed = true;
    for (const std::int32_t cell : water.bodies.cells) {
      agreed = agreed && level_m.data()[cell] <= cap_m.data()[cell] + kAgreement_m;
    }
    if (agreed) break;
  }
  return level_m;
}

}  // namespace latticeworld::internal
