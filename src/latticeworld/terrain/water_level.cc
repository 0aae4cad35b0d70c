#include "latticeworld/terrain/water_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "latticeworld/geomorphology/distance.h"

namespace latticeworld::internal {
namespace {

constexpr float kDry = std::numeric_limits<float>::quiet_NaN();
constexpr float kUnbounded = std::numeric_limits<float>::infinity();
// A level lies below all but this share of the shore; banks are raised at the rest.
constexpr double kLowShare = 0.05;
constexpr double kHighShare = 0.75;

// Water lies a little below its shore: a share of the world's size, up to a limit [m].
double IncisionOf_m(const GridGeometry& geometry) {
  return std::min(0.4, 0.002 * geometry.size_m());
}

// Heights of the dry cells beside the given wet ones; of the wet ones where there is no shore.
std::vector<float> ShoreHeights(const Components& bodies, const Grid<float>& land_m,
                                const std::int32_t* begin, const std::int32_t* end) {
  std::vector<float> heights;
  const int cols = land_m.cols();
  for (const std::int32_t* cell = begin; cell != end; ++cell) {
    ForEachNeighbour(land_m, *cell / cols, *cell % cols, [&](int r, int c) {
      if (bodies.label(r, c) < 0) heights.push_back(land_m(r, c));
    });
  }
  return heights;
}

std::vector<float> OwnHeights(const Grid<float>& land_m, const std::int32_t* begin,
                              const std::int32_t* end) {
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(end - begin));
  for (const std::int32_t* cell = begin; cell != end; ++cell) {
    heights.push_back(land_m.data()[*cell]);
  }
  return heights;
}

// Lowers bodies that lie above what a neighbour's banks reach at their place, until all agree. The
// reach is looked up on a coarse grid: it is smooth.
void ReconcileNeighbours(const GridGeometry& geometry, const Components& bodies,
                         double bank_curvature_per_m, std::vector<float>* level_m) {
  constexpr int kCoarseCells = 256;
  constexpr int kMaxRounds = 6;
  constexpr float kAgreement_m = 0.01f;
  const int factor = (bodies.label.rows() + kCoarseCells - 1) / kCoarseCells;
  const int rows = (bodies.label.rows() + factor - 1) / factor;
  const double cell_m = geometry.resolution_m() * factor;
  for (int round = 0; round < kMaxRounds; ++round) {
    Grid<float> reach(rows, rows, kNoFeature);
    for (int r = 0; r < bodies.label.rows(); ++r) {
      for (int c = 0; c < bodies.label.cols(); ++c) {
        const std::int32_t label = bodies.label(r, c);
        if (label < 0) continue;
        float& coarse = reach(r / factor, c / factor);
        coarse = std::min(coarse, (*level_m)[label]);
      }
    }
    LowerEnvelope(bank_curvature_per_m * cell_m * cell_m, &reach);
    bool changed = false;
    for (int r = 0; r < bodies.label.rows(); ++r) {
      for (int c = 0; c < bodies.label.cols(); ++c) {
        const std::int32_t label = bodies.label(r, c);
        if (label < 0) continue;
        const float limit = reach(r / factor, c / factor);
        changed = changed || limit < (*level_m)[label] - kAgreement_m;
        (*level_m)[label] = std::min((*level_m)[label], limit);
      }
    }
    if (!changed) break;
  }
}

// A water body that falls along its course. Its cells are cut across the course into reaches of
// equal distance from the outlet; each reach lies as low as its shore asks, and no lower reach lies
// above a higher one.
class Course {
 public:
  Course(const GridGeometry& geometry, const Components& bodies, const Grid<float>& land_m)
      : bodies_(bodies),
        land_m_(land_m),
        reach_length_(std::max(4, static_cast<int>(kUnit * geometry.size_m() / kReachesPerWorld /
                                                   geometry.resolution_m()))),
        steepest_step_m_(
            static_cast<float>(kSteepestWater * reach_length_ / kUnit * geometry.resolution_m())),
        distance_(land_m.rows(), land_m.cols(), -1),
        reach_(land_m.rows(), land_m.cols(), -1) {}

  // Distance from the outlet to the farthest cell [cells]; call before Grade.
  double Measure(int body) {
    body_ = body;
    begin_ = bodies_.cells.data() + bodies_.begin[body];
    end_ = bodies_.cells.data() + bodies_.begin[body + 1];
    WalkFromOutlet();
    int farthest = 0;
    for (const std::int32_t* cell = begin_; cell != end_; ++cell) {
      farthest = std::max(farthest, distance_.data()[*cell]);
    }
    return static_cast<double>(farthest) / kUnit;
  }

  void Grade(float incision_m, Grid<float>* level_m) {
    FindReaches();
    FindLevels();
    for (const std::int32_t* cell = begin_; cell != end_; ++cell) {
      level_m->data()[*cell] = LevelAt(*cell) - incision_m;
    }
    Smooth(level_m);
  }

 private:
  static constexpr int kUnit = 5;      // distance of a step along a row or column
  static constexpr int kDiagonal = 7;  // of a diagonal step (chamfer distance, Borgefors 1986)
  static constexpr double kReachesPerWorld = 64.0;
  static constexpr double kSteepestWater = 0.5;  // [m/m]

  struct Reach {
    int index = 0;  // of its distance band, from the outlet
    float level_m = kUnbounded;
    float below_m = kUnbounded;  // the lowest reach that touches it downstream
    float above_m = kUnbounded;  // upstream
  };

  void WalkFromOutlet() {
    const std::int32_t outlet = *std::min_element(
        begin_, end_, [this](auto a, auto b) { return land_m_.data()[a] < land_m_.data()[b]; });
    const int cols = land_m_.cols();
    // Distances in the queue span at most one diagonal step: a ring of buckets orders them.
    std::array<std::vector<std::int32_t>, kDiagonal + 1> ring;
    distance_.data()[outlet] = 0;
    ring[0].push_back(outlet);
    std::size_t waiting = 1;
    for (int now = 0; waiting > 0; ++now) {
      std::vector<std::int32_t> bucket;
      bucket.swap(ring[now % ring.size()]);
      waiting -= bucket.size();
      for (const std::int32_t cell : bucket) {
        if (distance_.data()[cell] != now) continue;  // reached on a shorter way since
        const int row = cell / cols;
        const int col = cell % cols;
        ForEachNeighbour(land_m_, row, col, [&](int r, int c) {
          if (bodies_.label(r, c) != body_) return;
          const int there = now + (r != row && c != col ? kDiagonal : kUnit);
          if (distance_(r, c) >= 0 && distance_(r, c) <= there) return;
          distance_(r, c) = there;
          ring[there % ring.size()].push_back(r * cols + c);
          ++waiting;
        });
      }
    }
  }

  void FindReaches() {
    reaches_.clear();
    cells_.clear();
    first_.assign(1, 0);
    const int cols = land_m_.cols();
    for (const std::int32_t* seed = begin_; seed != end_; ++seed) {
      if (reach_.data()[*seed] >= 0) continue;
      const auto id = static_cast<std::int32_t>(reaches_.size());
      const int band = distance_.data()[*seed] / reach_length_;
      Reach reach;
      reach.index = band;
      reaches_.push_back(reach);
      reach_.data()[*seed] = id;
      std::size_t next = cells_.size();
      cells_.push_back(*seed);
      for (; next < cells_.size(); ++next) {
        const std::int32_t cell = cells_[next];
        ForEachNeighbour(land_m_, cell / cols, cell % cols, [&](int r, int c) {
          if (bodies_.label(r, c) != body_ || reach_(r, c) >= 0) return;
          if (distance_(r, c) / reach_length_ != band) return;
          reach_(r, c) = id;
          cells_.push_back(r * cols + c);
        });
      }
      first_.push_back(static_cast<std::int32_t>(cells_.size()));
    }
  }

  void FindLevels() {
    const int count = static_cast<int>(reaches_.size());
    for (int i = 0; i < count; ++i) {
      std::vector<float> shore =
          ShoreHeights(bodies_, land_m_, cells_.data() + first_[i], cells_.data() + first_[i + 1]);
      if (!shore.empty()) reaches_[i].level_m = Quantile(kLowShare, &shore);
    }
    // Pairs (upstream, downstream) of touching reaches.
    std::vector<std::pair<std::int32_t, std::int32_t>> touching;
    const int cols = land_m_.cols();
    for (const std::int32_t cell : cells_) {
      const std::int32_t here = reach_.data()[cell];
      ForEachNeighbour(land_m_, cell / cols, cell % cols, [&](int r, int c) {
        if (bodies_.label(r, c) != body_) return;
        const std::int32_t there = reach_(r, c);
        if (reaches_[there].index < reaches_[here].index) touching.emplace_back(here, there);
      });
    }
    std::sort(touching.begin(), touching.end());
    touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
    // From the springs down; a reach without shore or source takes its own ground.
    std::sort(touching.begin(), touching.end(), [this](const auto& a, const auto& b) {
      const int index_a = reaches_[a.first].index;
      const int index_b = reaches_[b.first].index;
      return index_a != index_b ? index_a > index_b : a < b;
    });
    for (const auto& [up, down] : touching) {
      EnsureLevel(up);
      reaches_[down].level_m = std::min(reaches_[down].level_m, reaches_[up].level_m);
    }
    for (int i = 0; i < count; ++i) EnsureLevel(i);
    // From the outlet up: no falls, and a nook that leads nowhere lies as low as the water before
    // it.
    std::vector<bool> has_source(count, false);
    for (const auto& [up, down] : touching) has_source[down] = true;
    const int nook_cells = reach_length_ * reach_length_ / (2 * kUnit * kUnit);
    for (auto it = touching.rbegin(); it != touching.rend(); ++it) {
      const auto [up, down] = *it;
      const bool nook = !has_source[up] && first_[up + 1] - first_[up] < nook_cells;
      const float most_m = reaches_[down].level_m + (nook ? 0.0f : steepest_step_m_);
      reaches_[up].level_m = std::min(reaches_[up].level_m, most_m);
    }
    for (const auto& [up, down] : touching) {
      reaches_[up].below_m = std::min(reaches_[up].below_m, reaches_[down].level_m);
      reaches_[down].above_m = std::min(reaches_[down].above_m, reaches_[up].level_m);
    }
  }

  void EnsureLevel(int i) {
    if (reaches_[i].level_m != kUnbounded) return;
    std::vector<float> own =
        OwnHeights(land_m_, cells_.data() + first_[i], cells_.data() + first_[i + 1]);
    reaches_[i].level_m = Quantile(kLowShare, &own);
  }

  // Between the middles of reaches the level is interpolated along the course.
  float LevelAt(std::int32_t cell) const {
    const Reach& reach = reaches_[reach_.data()[cell]];
    const float place =
        static_cast<float>(distance_.data()[cell]) / static_cast<float>(reach_length_) -
        static_cast<float>(reach.index) - 0.5f;
    const float next_m = place < 0.0f ? reach.below_m : reach.above_m;
    if (next_m == kUnbounded) return reach.level_m;
    return reach.level_m + std::abs(place) * (next_m - reach.level_m);
  }

  // Where branches of unlike levels meet, a step is left: mean levels of neighbours, several times.
  void Smooth(Grid<float>* level_m) const {
    constexpr int kRounds = 6;
    const int cols = land_m_.cols();
    std::vector<float> smooth(static_cast<std::size_t>(end_ - begin_));
    for (int round = 0; round < kRounds; ++round) {
      for (const std::int32_t* cell = begin_; cell != end_; ++cell) {
        float sum = level_m->data()[*cell];
        int count = 1;
        ForEachNeighbour(land_m_, *cell / cols, *cell % cols, [&](int r, int c) {
          if (bodies_.label(r, c) != body_) return;
          sum += (*level_m)(r, c);
          ++count;
        });
        smooth[cell - begin_] = sum / static_cast<float>(count);
      }
      for (const std::int32_t* cell = begin_; cell != end_; ++cell) {
        level_m->data()[*cell] = smooth[cell - begin_];
      }
    }
  }

  const Components& bodies_;
  const Grid<float>& land_m_;
  int reach_length_;             // in kUnit-ths of a cell
  float steepest_step_m_;        // from a reach to the next
  Grid<std::int32_t> distance_;  // from the outlet of its body, in kUnit-ths of a cell
  Grid<std::int32_t> reach_;     // number of the reach of its body
  int body_ = -1;
  const std::int32_t* begin_ = nullptr;
  const std::int32_t* end_ = nullptr;
  std::vector<Reach> reaches_;
  std::vector<std::int32_t> cells_;  // reach after reach, as in Components
  std::vector<std::int32_t> first_;
};

// Whether a body is a lake, level whatever its shore: compact, or level enough along its length.
bool IsLake(double rise_m, double length_m, double area_m2) {
  constexpr double kAlwaysLevel_m = 1.5;
  constexpr double kLevelSlope = 0.01;
  constexpr double kCompact = 0.2;  // a square seen from its corner has 0.5, a strip of 5:1 0.2
  return rise_m <= std::max(kAlwaysLevel_m, kLevelSlope * length_m) ||
         area_m2 > kCompact * length_m * length_m;
}

// No water stands higher above other water than the bank between them is high: a lake goes down as
// a whole, a course where it is too high.
void LowerToNeighbours(const GridGeometry& geometry, const Components& bodies,
                       const std::vector<bool>& is_lake, double bank_curvature_per_m,
                       Grid<float>* level_m) {
  Grid<float> reach(level_m->rows(), level_m->cols());
  for (std::size_t i = 0; i < reach.size(); ++i) {
    reach.data()[i] = bodies.label.data()[i] >= 0 ? level_m->data()[i] : kNoFeature;
  }
  const double resolution_m = geometry.resolution_m();
  LowerEnvelope(bank_curvature_per_m * resolution_m * resolution_m, &reach);
  for (int i = 0; i < bodies.count(); ++i) {
    const std::int32_t* begin = bodies.cells.data() + bodies.begin[i];
    const std::int32_t* end = bodies.cells.data() + bodies.begin[i + 1];
    float lowest_m = kUnbounded;
    for (const std::int32_t* cell = begin; cell != end; ++cell) {
      lowest_m = std::min(lowest_m, reach.data()[*cell]);
    }
    for (const std::int32_t* cell = begin; cell != end; ++cell) {
      level_m->data()[*cell] = is_lake[i] ? lowest_m : reach.data()[*cell];
    }
  }
}

}  // namespace

Grid<float> WaterLevels(const GridGeometry& geometry, const Components& bodies,
                        const Grid<float>& land_m, WaterRule rule, double bank_curvature_per_m) {
  const double resolution_m = geometry.resolution_m();
  const auto incision_m = static_cast<float>(IncisionOf_m(geometry));
  const int count = bodies.count();
  std::vector<float> low_m(count);
  std::vector<float> rise_m(count);
  for (int i = 0; i < count; ++i) {
    const std::int32_t* begin = bodies.cells.data() + bodies.begin[i];
    const std::int32_t* end = bodies.cells.data() + bodies.begin[i + 1];
    std::vector<float> heights = ShoreHeights(bodies, land_m, begin, end);
    if (heights.empty()) heights = OwnHeights(land_m, begin, end);
    const float low = Quantile(kLowShare, &heights);
    rise_m[i] = Quantile(kHighShare, &heights) - low;
    low_m[i] = low - incision_m;
  }
  if (rule == WaterRule::kLevel && count > 1) {
    ReconcileNeighbours(geometry, bodies, bank_curvature_per_m, &low_m);
  }

  Grid<float> level_m(land_m.rows(), land_m.cols(), kDry);
  for (int i = 0; i < count; ++i) {
    for (int k = bodies.begin[i]; k < bodies.begin[i + 1]; ++k) {
      level_m.data()[bodies.cells[k]] = low_m[i];
    }
  }
  if (rule == WaterRule::kLevel) return level_m;

  Course course(geometry, bodies, land_m);
  std::vector<bool> is_lake(count);
  for (int i = 0; i < count; ++i) {
    const double length_m = course.Measure(i) * resolution_m;
    const double area_m2 = (bodies.begin[i + 1] - bodies.begin[i]) * resolution_m * resolution_m;
    is_lake[i] = IsLake(rise_m[i], length_m, area_m2);
    if (!is_lake[i]) course.Grade(incision_m, &level_m);
  }
  LowerToNeighbours(geometry, bodies, is_lake, bank_curvature_per_m, &level_m);
  return level_m;
}

}  // namespace latticeworld::internal
