#include "latticeworld/layout/letter_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld::internal {
namespace {

constexpr double kRiverHalfWidth = 0.47;  // [layout cells]
constexpr double kRoadHalfWidth = 0.46;
constexpr int kAreaCells = 8;           // of area_, a layout cell
constexpr double kAreaRounding = 0.35;  // deviation of its blur [layout cells]

// The bands run on straight beyond the middles of the outermost cells: water at the edge of the
// layout leaves no bank between itself and the edge.
LayoutPoint Inside(LayoutPoint place) {
  constexpr double kLow = 0.5, kHigh = kLayoutSize - 0.5;
  return {std::clamp(place.u, kLow, kHigh), std::clamp(place.v, kLow, kHigh)};
}

Grid<unsigned char> MaskOf(const SymbolicLayout& layout, char letter) {
  Grid<unsigned char> mask(kLayoutSize, kLayoutSize);
  std::transform(layout.cells.begin(), layout.cells.end(), mask.begin(),
                 [letter](char cell) { return static_cast<unsigned char>(cell == letter); });
  return mask;
}

// Water, and what of it runs on below roads.
Grid<unsigned char> WaterMask(const SymbolicLayout& layout, const Grid<Crossing>& crossings) {
  Grid<unsigned char> mask = MaskOf(layout, class_letter::kWater);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (crossings.data()[i] != Crossing::kNone) mask.data()[i] = 1;
  }
  return mask;
}

Grid<unsigned char> RoadMask(const SymbolicLayout& layout) {
  if (layout.vocabulary == Vocabulary::kSuburb) return MaskOf(layout, suburb_letter::kRoad);
  return Grid<unsigned char>(kLayoutSize, kLayoutSize, 0);
}

bool Any(const Grid<unsigned char>& mask) {
  return std::find(mask.begin(), mask.end(), 1) != mask.end();
}

}  // namespace

LineShape::LineShape(const Grid<unsigned char>& mask, double half_width)
    : any_(Any(mask)), half_width_(half_width), lines_(mask) {
  const Grid<unsigned char> thick = ThickCells(mask);
  if (!Any(thick)) return;
  area_ = Grid<float>(kLayoutSize * kAreaCells, kLayoutSize * kAreaCells);
  for (int row = 0; row < area_.rows(); ++row) {
    for (int col = 0; col < area_.cols(); ++col) {
      area_(row, col) = thick(row / kAreaCells, col / kAreaCells);
    }
  }
  GaussianBlur(kAreaRounding * kAreaCells, &area_);
}

float LineShape::AreaShareAt(LayoutPoint place) const {
  const double row = std::clamp(place.v * kAreaCells - 0.5, 0.0, area_.rows() - 1.001);
  const double col = std::clamp(place.u * kAreaCells - 0.5, 0.0, area_.cols() - 1.001);
  const int r = static_cast<int>(row), c = static_cast<int>(col);
  const auto v = static_cast<float>(row - r), u = static_cast<float>(col - c);
  const float north = area_(r, c) + u * (area_(r, c + 1) - area_(r, c));
  const float south = area_(r + 1, c) + u * (area_(r + 1, c + 1) - area_(r + 1, c));
  return north + v * (south - north);
}

bool LineShape::Contains(LayoutPoint place, LayoutPoint area_place) const {
  if (!any_) return false;
  if (!area_.empty() && AreaShareAt(area_place) > 0.5f) return true;
  return lines_.NearestTo(Inside(place)).distance < half_width_;
}

LayoutPoint LineShape::ToCenterLine(LayoutPoint place) const {
  if (!any_ || (!area_.empty() && AreaShareAt(place) > 0.5f)) return {};
  const LayoutPoint inside = Inside(place);
  const CourseLines::Nearest nearest = lines_.NearestTo(inside);
  if (nearest.distance > 1.0) return {};
  return {nearest.point.u - inside.u, nearest.point.v - inside.v};
}

LetterField::LetterField(const SymbolicLayout& layout, bool fords)
    : layout_(layout),
      fords_(fords),
      crossings_(CrossingsOf(layout, fords)),
      corners_(CornerCrossingsOf(layout)),
      water_(WaterMask(layout, crossings_), kRiverHalfWidth),
      road_(RoadMask(layout), kRoadHalfWidth) {}

LetterField::Answer LetterField::At(const Places& places) const {
  const bool water = water_.Contains(places.water, places.shore);
  if (road_.Contains(places.road, places.road)) {
    const Crossing crossing = water ? CrossingNear(places.road) : Crossing::kNone;
    return {crossing == Crossing::kBridge ? class_letter::kWater : suburb_letter::kRoad, crossing};
  }
  if (water) return {class_letter::kWater, Crossing::kNone};
  return {GroundAt(places.ground), Crossing::kNone};
}

Crossing LetterField::CrossingNear(LayoutPoint place) const {
  const int row = static_cast<int>(std::floor(place.v)),
            col = static_cast<int>(std::floor(place.u));
  bool any = false;
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = col - 1; c <= col + 1; ++c) {
      const Crossing crossing = crossings_.Clamped(r, c);
      if (crossing == Crossing::kBridge) return crossing;
      any = any || crossing == Crossing::kFord;
    }
  }
  for (int r = row; r <= row + 1; ++r) {
    for (int c = col; c <= col + 1; ++c) any = any || corners_.Clamped(r, c) != 0;
  }
  // A road that runs beside water crosses none.
  if (!any) return Crossing::kNone;
  return fords_ ? Crossing::kFord : Crossing::kBridge;
}

char LetterField::GroundAt(LayoutPoint place) const {
  const auto is_line = [this](char letter) {
    return letter == class_letter::kWater || IsRoad(layout_.vocabulary, letter);
  };
  const int row = std::clamp(static_cast<int>(std::floor(place.v)), 0, kLayoutSize - 1);
  const int col = std::clamp(static_cast<int>(std::floor(place.u)), 0, kLayoutSize - 1);
  const char own = layout_.cells(row, col);
  if (!is_line(own)) return own;
  char best = own;
  double least = std::numeric_limits<double>::infinity();
  constexpr int kReach = 2;
  for (int r = std::max(0, row - kReach); r <= std::min(kLayoutSize - 1, row + kReach); ++r) {
    for (int c = std::max(0, col - kReach); c <= std::min(kLayoutSize - 1, col + kReach); ++c) {
      if (is_line(layout_.cells(r, c))) continue;
      const double du = std::max({c - place.u, place.u - (c + 1.0), 0.0});
      const double dv = std::max({r - place.v, place.v - (r + 1.0), 0.0});
      if (du * du + dv * dv < least) {
        least = du * du + dv * dv;
        best = layout_.cells(r, c);
      }
    }
  }
  return best;
}

}  // namespace latticeworld::internal
