#include "latticeworld/terrain/ways/street_field.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/slope.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/cover.h"

namespace latticeworld::internal {
namespace {

constexpr double kWaterMargin_m = 7.0;
constexpr double kBesideRoad_m = 10.0;  // road so near to built-up land belongs to its area
constexpr double kHeightSmoothing_m = 12.0;
constexpr double kFieldSmoothing_m = 14.0;
constexpr double kRoadReach_m = 55.0;  // over which the direction of a road fades
constexpr double kShoreReach_m = 40.0;
constexpr double kAxisWeight = 0.5;
constexpr double kRoadWeight = 1.5;
constexpr double kShoreWeight = 0.8;
constexpr double kContourWeight = 1.5;
constexpr double kSteep = 0.10;        // slope from which contours lead [m/m]
constexpr double kDistrict_m = 420.0;  // wavelength in which large areas turn their streets
constexpr double kDistrictTurn_rad = 0.7;
constexpr double kDistrictsFrom_m2 = 40000.0;

Grid<unsigned char> NearOf(const Grid<unsigned char>& of, const Grid<unsigned char>& near,
                           float reach_cells) {
  const Grid<float> distance = DistanceTo(true, near);
  Grid<unsigned char> both = near;
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (of.data()[i] != 0 && distance.data()[i] <= reach_cells) both.data()[i] = 1;
  }
  return both;
}

// Direction in which a field falls or rises at a cell; false where it is level.
bool GradientAt(const Grid<float>& values, int row, int col, double* east, double* north) {
  *east = values.Clamped(row, col + 1) - values.Clamped(row, col - 1);
  *north = values.Clamped(row - 1, col) - values.Clamped(row + 1, col);
  return std::isfinite(*east) && std::isfinite(*north) && std::hypot(*east, *north) > 1e-6;
}

}  // namespace

StreetField::StreetField(const StreetGround& ground, std::uint64_t seed)
    : ground_(ground),
      built_(MaskOf(suburb_letter::kBuilding, *ground.letters)),
      road_(MaskOf(suburb_letter::kRoad, *ground.letters)),
      to_road_(DistanceTo(true, road_)),
      to_water_(DistanceTo(true, *ground.wet)),
      smooth_m_(*ground.height_m) {
  GaussianBlur(kHeightSmoothing_m / lattice().resolution_m(), &smooth_m_);
  slope_ = GradientMagnitude(smooth_m_, lattice().resolution_m());
  const auto beside_cells = static_cast<float>(kBesideRoad_m / lattice().resolution_m());
  pieces_ = ComponentsOf(NearOf(road_, built_, beside_cells));
  FindAreas();
  BuildCrosses(seed);
}

void StreetField::FindAreas() {
  const double cell_m = lattice().resolution_m();
  const int cols = built_.cols();
  Grid<unsigned char> inside(built_.rows(), cols);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    inside.data()[i] = pieces_.label.data()[i] >= 0 ? 1 : 0;
  }
  // A cell's depth is its distance from the border of its piece.
  const Grid<float> depth = DistanceTo(false, inside);
  for (int piece = 0; piece < pieces_.count(); ++piece) {
    BuiltUpArea area;
    area.piece = piece;
    // The built-up cells give the middle, the size and, by their second moments, the main axis.
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, count = 0.0;
    for (int k = pieces_.begin[piece]; k < pieces_.begin[piece + 1]; ++k) {
      const std::int32_t cell = pieces_.cells[k];
      if (built_.data()[cell] == 0) continue;
      const WorldPoint at = lattice().CenterOf({cell / cols, cell % cols});
      x += at.x_m;
      y += at.y_m;
      xx += at.x_m * at.x_m;
      xy += at.x_m * at.y_m;
      yy += at.y_m * at.y_m;
      count += 1.0;
    }
    if (count == 0.0) continue;
    x /= count;
    y /= count;
    area.area_m2 = count * cell_m * cell_m;
    area.axis_rad =
        0.5 * std::atan2(2.0 * (xy / count - x * y), xx / count - x * x - yy / count + y * y);
    // The heart is deep inside and near the middle; an area without an open place has none and is
    // left out.
    double best = -1e9;
    for (int k = pieces_.begin[piece]; k < pieces_.begin[piece + 1]; ++k) {
      const std::int32_t cell = pieces_.cells[k];
      const CellIndex index = {cell / cols, cell % cols};
      if (built_[index] == 0) continue;
      const WorldPoint at = lattice().CenterOf(index);
      const double deep_m = std::min<double>(depth[index], built_.cols()) * cell_m;
      const double score = std::min(deep_m, 60.0) - 0.2 * std::hypot(at.x_m - x, at.y_m - y) -
                           (IsOpen(at) ? 0.0 : 1e6);
      if (score <= best) continue;
      best = score;
      area.heart = at;
      area.heart_depth_m = deep_m;
    }
    if (best > -1e5) areas_.push_back(area);
  }
}

void StreetField::BuildCrosses(std::uint64_t seed) {
  const int rows = built_.rows(), cols = built_.cols();
  const double cell_m = lattice().resolution_m();
  // Crosses follow the main axis of their area, turned a little by district in large ones.
  NoiseOptions districts;
  districts.wavelength_m = kDistrict_m;
  districts.octaves = 1;
  const Grid<float> turn =
      FractalNoise(lattice(), districts, StreamSeed(seed, "streets/districts"));
  Grid<float> axis(rows, cols, 0.0f);
  for (const BuiltUpArea& area : areas_) {
    for (int k = pieces_.begin[area.piece]; k < pieces_.begin[area.piece + 1]; ++k) {
      const std::int32_t cell = pieces_.cells[k];
      const double districts_turn =
          area.area_m2 >= kDistrictsFrom_m2 ? kDistrictTurn_rad * turn.data()[cell] : 0.0;
      axis.data()[cell] = static_cast<float>(area.axis_rad + districts_turn);
    }
  }
  // A cross has four equal arms: directions add up as cosine and sine of four times their angle.
  cosine4_ = Grid<float>(rows, cols, 0.0f);
  sine4_ = Grid<float>(rows, cols, 0.0f);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      if (pieces_.label(row, col) < 0) continue;
      double c4 = 0.0, s4 = 0.0;
      const auto add = [&c4, &s4](double weight, double angle_rad) {
        c4 += weight * std::cos(4.0 * angle_rad);
        s4 += weight * std::sin(4.0 * angle_rad);
      };
      add(kAxisWeight, axis(row, col));
      // Roads and shores weigh more the nearer they are, contours the steeper the ground is.
      double east = 0.0, north = 0.0;
      if (GradientAt(to_road_, row, col, &east, &north)) {
        add(kRoadWeight * std::exp(-to_road_(row, col) * cell_m / kRoadReach_m),
            std::atan2(north, east));
      }
      if (GradientAt(to_water_, row, col, &east, &north)) {
        add(kShoreWeight * std::exp(-to_water_(row, col) * cell_m / kShoreReach_m),
            std::atan2(north, east));
      }
      if (GradientAt(smooth_m_, row, col, &east, &north)) {
        const double steep = std::min(1.0, slope_(row, col) / kSteep);
        add(kContourWeight * steep * steep, std::atan2(north, east));
      }
      cosine4_(row, col) = static_cast<float>(c4);
      sine4_(row, col) = static_cast<float>(s4);
    }
  }
  GaussianBlur(kFieldSmoothing_m / cell_m, &cosine4_);
  GaussianBlur(kFieldSmoothing_m / cell_m, &sine4_);
}

bool StreetField::IsOpen(WorldPoint place) const {
  if (!lattice().Contains(place)) return false;
  const CellIndex cell = lattice().CellAt(place);
  return built_[cell] != 0 && ToWater_m(cell) >= WaterMargin_m();
}

bool StreetField::IsRoad(WorldPoint place) const {
  return lattice().Contains(place) && road_[lattice().CellAt(place)] != 0;
}

int StreetField::PieceAt(WorldPoint place) const {
  return lattice().Contains(place) ? pieces_.label[lattice().CellAt(place)] : -1;
}

double StreetField::ToRoad_m(CellIndex cell) const {
  return to_road_[cell] * lattice().resolution_m();
}

double StreetField::ToWater_m(CellIndex cell) const {
  return to_water_[cell] * lattice().resolution_m();
}

double StreetField::WaterMargin_m() const {
  // Coarse lattices see shores to a cell.
  return kWaterMargin_m + 0.5 * lattice().resolution_m();
}

WorldPoint StreetField::RoadCentreAt(WorldPoint place) const {
  const CellIndex cell = lattice().CellAt(place);
  const double cell_m = lattice().resolution_m();
  return {place.x_m + ground_.lines->to_road_center_cols[cell] * cell_m,
          place.y_m - ground_.lines->to_road_center_rows[cell] * cell_m};
}

bool StreetField::HasRoadAlong(WorldPoint place, double heading_rad, double radius_m) const {
  constexpr double kAcross_rad = 50.0 * M_PI / 180.0;
  const CellIndex cell = lattice().CellAt(place);
  double east = 0.0, north = 0.0;
  if (!(ToRoad_m(cell) < radius_m) || !GradientAt(to_road_, cell.row, cell.col, &east, &north)) {
    return false;
  }
  return std::abs(std::remainder(std::atan2(north, east) - heading_rad, M_PI)) > kAcross_rad;
}

double StreetField::DirectionAt(WorldPoint place, double heading_rad) const {
  const int n = cosine4_.rows();
  const double row = std::clamp(lattice().RowOf(place.y_m), 0.0, n - 1.0);
  const double col = std::clamp(lattice().ColOf(place.x_m), 0.0, n - 1.0);
  const int r = std::min(static_cast<int>(row), n - 2), c = std::min(static_cast<int>(col), n - 2);
  const double v = row - r, u = col - c;
  const auto at = [&](const Grid<float>& grid) {
    return (1.0 - v) * ((1.0 - u) * grid(r, c) + u * grid(r, c + 1)) +
           v * ((1.0 - u) * grid(r + 1, c) + u * grid(r + 1, c + 1));
  };
  const double c4 = at(cosine4_), s4 = at(sine4_);
  // A field whose parts cancel out has no direction: the street goes straight on.
  if (std::hypot(c4, s4) < 0.02) return heading_rad;
  const double direction_rad = 0.25 * std::atan2(s4, c4);
  return heading_rad + std::remainder(direction_rad - heading_rad, 0.5 * M_PI);
}

}  // namespace latticeworld::internal
