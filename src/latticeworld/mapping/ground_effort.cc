#include "latticeworld/mapping/ground_effort.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace latticeworld {
namespace {

constexpr int kPiece = 256;  // columns at a time

// arctan of x >= 0 within 2e-7, without branches: Abramowitz and Stegun 1964, 4.4.49.
inline float ArcTangent(float x) {
  const bool steep = x > 1.0f;
  const float t = steep ? 1.0f / x : x;
  const float s = t * t;
  float sum = 0.0028662257f;
  sum = sum * s - 0.0161657367f;
  sum = sum * s + 0.0429096138f;
  sum = sum * s - 0.0752896400f;
  sum = sum * s + 0.1065626393f;
  sum = sum * s - 0.1420889944f;
  sum = sum * s + 0.1999355085f;
  sum = sum * s - 0.3333314528f;
  const float angle = t + t * s * sum;
  return steep ? 1.57079633f - angle : angle;
}

// The rows around one row; at the world's edge the row itself stands for the missing one.
struct Rows {
  Rows(const Grid<float>& height_m, int row)
      : north(height_m.row(std::max(row - 1, 0))),
        here(height_m.row(row)),
        south(height_m.row(std::min(row + 1, height_m.rows() - 1))),
        distance(row > 0 && row + 1 < height_m.rows() ? 2.0f : 1.0f) {}

  const float* north;
  const float* here;
  const float* south;
  float distance;  // from north to south [cells]
};

// west, east: columns beside col; at the edge col itself.
inline float GradientAt(const Rows& rows, int col, int west, int east, float per_x, float per_y) {
  const float dz_dx = (rows.here[east] - rows.here[west]) * per_x;
  const float dz_dy = (rows.north[col] - rows.south[col]) * per_y;
  return std::sqrt(dz_dx * dz_dx + dz_dy * dz_dy);
}

// Calls cell(col, west, east, 1 / distance from west to east [m]) for the columns [begin, end) of
// `cols`; the inner ones in a loop that compilers vectorise.
template <typename Cell>
inline void ForEachColumn(int begin, int end, int cols, float resolution_m, const Cell& cell) {
  const float per_one = 1.0f / resolution_m, per_two = 0.5f / resolution_m;
  if (begin == 0) cell(0, 0, 1, per_one);
  const int inner_end = std::min(end, cols - 1);
  for (int col = std::max(begin, 1); col < inner_end; ++col) cell(col, col - 1, col + 1, per_two);
  if (end == cols) cell(cols - 1, cols - 2, cols - 1, per_one);
}

}  // namespace

bool AreLegal(const RobotLimits& limits) {
  return limits.radius_m >= 0.0 && limits.max_slope_rad > 0.0 && limits.max_slope_rad < 1.5708 &&
         limits.max_step_m >= 0.0 && limits.max_fording_depth_m >= 0.0 &&
         limits.clearance_m >= 0.0 && limits.mass_kg >= 0.0 && limits.grip > 0.0;
}

double SteepestSlope(const RobotLimits& limits, const SurfaceProperties& surface) {
  return std::min(limits.max_slope_rad, ClimbableSlope(surface, limits.grip, limits.on_wheels));
}

GroundEffort::GroundEffort(const Terrain& terrain, const RobotLimits& limits,
                           const SurfaceTable& surfaces)
    : terrain_(terrain),
      max_difference_m_(static_cast<float>(std::max(
          limits.max_step_m, std::tan(limits.max_slope_rad) * terrain.geometry().resolution_m()))),
      max_depth_m_(static_cast<float>(limits.max_fording_depth_m)) {
  for (std::size_t i = 0; i < climbs_.size(); ++i) {
    const double steepest_rad = SteepestSlope(limits, surfaces.Of(static_cast<SurfaceClass>(i)));
    climbs_[i].max_gradient = static_cast<float>(std::tan(steepest_rad));
    climbs_[i].slope_shares = steepest_rad > 0.0 ? static_cast<float>(1.0 / steepest_rad) : 0.0f;
  }
}

void GroundEffort::Row(int row, float* effort) const {
  Row(row, 0, terrain_.geometry().cols(), effort);
}

void GroundEffort::Row(int row, int col_begin, int col_end, float* effort) const {
  for (int begin = col_begin; begin < col_end; begin += kPiece) {
    Piece(row, begin, std::min(begin + kPiece, col_end), effort + (begin - col_begin));
  }
}

void GroundEffort::Piece(int row, int col_begin, int col_end, float* effort) const {
  // Looked up beforehand, so that the loop below is without branches and tables.
  float max_gradient[kPiece], slope_shares[kPiece];
  const SurfaceClass* const surface = terrain_.surface.row(row);
  for (int col = col_begin; col < col_end; ++col) {
    const Climb& climb = climbs_[static_cast<std::size_t>(surface[col])];
    max_gradient[col - col_begin] = climb.max_gradient;
    slope_shares[col - col_begin] = climb.slope_shares;
  }
  const Grid<float>& height_m = terrain_.ground.height_m();
  const float* level_m = terrain_.water_level_m.row(row);
  const float resolution_m = static_cast<float>(terrain_.geometry().resolution_m());
  const Rows rows(height_m, row);
  const float per_y = 1.0f / (rows.distance * resolution_m);
  const float depth_shares = max_depth_m_ > 0.0f ? 1.0f / max_depth_m_ : 0.0f;
  const float max_difference_m = max_difference_m_, max_depth_m = max_depth_m_;
  const auto measure = [&](int col, int west, int east, float per_x) {
    const int i = col - col_begin;
    const float here = rows.here[col];
    const float gradient = GradientAt(rows, col, west, east, per_x, per_y);
    const float depth_m = level_m[col] > here ? level_m[col] - here : 0.0f;  // NaN: dry
    const float difference_m =
        std::max(std::max(std::abs(rows.north[col] - here), std::abs(rows.south[col] - here)),
                 std::max(std::abs(rows.here[west] - here), std::abs(rows.here[east] - here)));
    const float share = std::max(ArcTangent(gradient) * slope_shares[i], depth_m * depth_shares);
    const bool impassable =
        (gradient > max_gradient[i]) | (depth_m > max_depth_m) | (difference_m > max_difference_m);
    effort[i] = impassable ? kImpassable : std::min(share, 1.0f);
  };
  ForEachColumn(col_begin, col_end, height_m.cols(), resolution_m, measure);
}

void SlopeOfRow(const Terrain& terrain, int row, float* slope_rad) {
  const Grid<float>& height_m = terrain.ground.height_m();
  const float resolution_m = static_cast<float>(terrain.geometry().resolution_m());
  const Rows rows(height_m, row);
  const float per_y = 1.0f / (rows.distance * resolution_m);
  const int cols = height_m.cols();
  ForEachColumn(0, cols, cols, resolution_m, [&](int col, int west, int east, float per_x) {
    slope_rad[col] = ArcTangent(GradientAt(rows, col, west, east, per_x, per_y));
  });
}

}  // namespace latticeworld
