#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/geomorphology/drainage.h"
#include "latticeworld/geomorphology/drainage_order.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/grid_threads.h"
#include "latticeworld/geomorphology/hillslope.h"

namespace latticeworld {
namespace {

constexpr float kDiagonal = 1.41421356f;

// area^m for whole numbers of cells: most areas are small, and a power is slow.
class AreaPower {
 public:
  AreaPower(double cell_area_m2, double exponent)
      : cell_area_m2_(cell_area_m2), exponent_(exponent), small_(kSmall) {
    for (int cells = 0; cells < kSmall; ++cells) small_[cells] = Compute(cells);
  }
  float operator()(std::int32_t cells) const {
    return cells < kSmall ? small_[cells] : Compute(cells);
  }

 private:
  static constexpr int kSmall = 4096;
  float Compute(std::int32_t cells) const {
    return static_cast<float>(std::pow(cells * cell_area_m2_, exponent_));
  }
  double cell_area_m2_;
  double exponent_;
  std::vector<float> small_;
};

}  // namespace

void ErodeFluvially(double resolution_m, const FluvialOptions& options,
                    const Grid<unsigned char>* outlet, const Grid<float>* uplift_m_per_yr,
                    const Grid<float>* erodibility_factor, int threads, Grid<float>* height_m) {
  if (height_m->empty()) return;
  LW_CHECK(resolution_m > 0.0 && options.time_step_yr > 0.0, "lengths and times are positive");
  for (const Grid<float>* layer : {uplift_m_per_yr, erodibility_factor}) {
    LW_CHECK(layer == nullptr || layer->size() == height_m->size(), "one value a cell");
  }
  const auto time_step_yr = static_cast<float>(options.time_step_yr);
  // This is the pace of a cell that drains 1 m^2, over a step of one cell.
  const auto pace = static_cast<float>(options.erodibility * options.time_step_yr / resolution_m);
  const float pace_of[2] = {pace, pace / kDiagonal};
  const double creep =
      options.diffusivity_m2_per_yr * options.time_step_yr / (resolution_m * resolution_m);
  const AreaPower area_power(resolution_m * resolution_m, options.area_exponent);
  internal::Drainage drainage(height_m->rows(), height_m->cols());
  internal::DrainageOrder order(height_m->rows(), height_m->cols());
  threads = internal::GridThreads(height_m->size(), threads);
  float* h = height_m->data();
  const std::uint8_t* directions = drainage.directions().data();
  const internal::NeighbourSteps steps = drainage.steps();
  const std::int32_t* area_cells = order.area_cells().data();
  const float* uplift = uplift_m_per_yr != nullptr ? uplift_m_per_yr->data() : nullptr;
  const float* factor = erodibility_factor != nullptr ? erodibility_factor->data() : nullptr;
  for (int step = 0; step < options.steps; ++step) {
    drainage.Route(*height_m, outlet, threads);
    order.Sort(drainage, threads);
    order.ForEachDownstreamFirst(threads, [=, &area_power](std::int32_t cell) {
      const std::uint8_t direction = directions[cell];
      if (direction == internal::kOutlet) return;
      const float below = h[cell + steps[direction]];
      float here = h[cell];
      if (uplift != nullptr) here += uplift[cell] * time_step_yr;
      // In a depression water runs up to the saddle, and nothing is cut.
      if (here > below) {
        float speed = pace_of[internal::IsDiagonal(direction)] * area_power(area_cells[cell]);
        if (factor != nullptr) speed *= factor[cell];
        // Solves result = here - speed * (result - below).
        here = below + (here - below) / (1.0f + speed);
      }
      h[cell] = here;
    });
    if (creep > 0.0) {
      internal::Diffuse(creep, drainage.directions(), step % 2 == 0, threads, height_m);
    }
  }
}

}  // namespace latticeworld
