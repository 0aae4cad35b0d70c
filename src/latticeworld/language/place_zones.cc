#include "latticeworld/language/place_zones.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

constexpr double kThird = 1.0 / 3.0;
// Steps of the staircase that stands for a slanted line.
constexpr int kSteps = 8;

std::string_view AdjectiveOf(const Heading& heading) {
  constexpr std::string_view kNames[3][3] = {{"north-western", "northern", "north-eastern"},
                                             {"western", "central", "eastern"},
                                             {"south-western", "southern", "south-eastern"}};
  return kNames[heading.south + 1][heading.east + 1];
}

std::string_view NounOf(const Heading& heading) {
  constexpr std::string_view kNames[3][3] = {{"north-west", "north", "north-east"},
                                             {"west", "center", "east"},
                                             {"south-west", "south", "south-east"}};
  return kNames[heading.south + 1][heading.east + 1];
}

std::string NameOf(const Heading& heading, std::string_view noun) {
  return std::string(AdjectiveOf(heading)) + " " + std::string(noun);
}

bool IsClose(double a, double b) { return std::abs(a - b) < 1e-6; }

bool IsSame(const std::vector<UnitBox>& a, const std::vector<UnitBox>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!IsClose(a[i].u_min, b[i].u_min) || !IsClose(a[i].u_max, b[i].u_max) ||
        !IsClose(a[i].v_min, b[i].v_min) || !IsClose(a[i].v_max, b[i].v_max)) {
      return false;
    }
  }
  return true;
}

const std::vector<Zone>& NamedZones() {
  static const std::vector<Zone> zones = [] {
    std::vector<Zone> found;
    for (const std::string_view name : ZoneNames()) found.push_back(*FindZone(name));
    return found;
  }();
  return zones;
}

UnitBox BoxAround(const std::vector<UnitBox>& boxes) {
  if (boxes.empty()) return {};
  UnitBox around = boxes.front();
  for (const UnitBox& box : boxes) {
    around.u_min = std::min(around.u_min, box.u_min);
    around.u_max = std::max(around.u_max, box.u_max);
    around.v_min = std::min(around.v_min, box.v_min);
    around.v_max = std::max(around.v_max, box.v_max);
  }
  return around;
}

Region NinthAt(double u, double v) {
  const auto step = [](double x) { return x < kThird ? -1 : x < 2 * kThird ? 0 : 1; };
  return RegionOf(Heading{step(u), step(v)});
}

// The ninths whose centres lie in one of the boxes; where there is none, the nearest ninth of each
// box.
std::vector<Region> NinthsOf(const std::vector<UnitBox>& boxes) {
  std::vector<Region> ninths;
  for (int south = -1; south <= 1; ++south) {
    for (int east = -1; east <= 1; ++east) {
      const double u = 0.5 + east * kThird;
      const double v = 0.5 + south * kThird;
      const auto holds = [&](const UnitBox& box) {
        return box.u_min < u && u < box.u_max && box.v_min < v && v < box.v_max;
      };
      if (std::any_of(boxes.begin(), boxes.end(), holds)) {
        ninths.push_back(RegionOf(Heading{east, south}));
      }
    }
  }
  if (!ninths.empty()) return ninths;
  for (const UnitBox& box : boxes) {
    const Region ninth = NinthAt((box.u_min + box.u_max) / 2, (box.v_min + box.v_max) / 2);
    if (std::find(ninths.begin(), ninths.end(), ninth) == ninths.end()) ninths.push_back(ninth);
  }
  return ninths;
}

Place PlaceOfZone(Zone zone) {
  Place place;
  place.box = BoxAround(zone.boxes);
  place.regions = NinthsOf(zone.boxes);
  place.main = zone.is_anywhere() ? Region::kAnywhere
                                  : NinthAt((place.box.u_min + place.box.u_max) / 2,
                                            (place.box.v_min + place.box.v_max) / 2);
  place.zone = std::move(zone);
  return place;
}

// Bounds along one axis: depth from the side that step names; step 0: all of it.
void SetBounds(int step, double depth, double* low, double* high) {
  *low = step > 0 ? 1.0 - depth : 0.0;
  *high = step < 0 ? depth : 1.0;
}

UnitBox SideBox(const Heading& heading, double depth) {
  UnitBox box;
  SetBounds(heading.east, depth, &box.u_min, &box.u_max);
  SetBounds(heading.south, depth, &box.v_min, &box.v_max);
  return box;
}

UnitBox MiddleBox(double side) {
  return {0.5 - side / 2, 0.5 + side / 2, 0.5 - side / 2, 0.5 + side / 2};
}

// The half of the square on the diagonal's side of `heading`.
std::vector<UnitBox> TriangleBoxes(const Heading& heading) {
  std::vector<UnitBox> boxes;
  for (int i = 0; i < kSteps; ++i) {
    UnitBox box;
    box.v_min = static_cast<double>(i) / kSteps;
    box.v_max = static_cast<double>(i + 1) / kSteps;
    // Width of this row of the half: full beside the corner, nothing at the opposite corner.
    const double from_corner =
        heading.south < 0 ? (box.v_min + box.v_max) / 2 : 1.0 - (box.v_min + box.v_max) / 2;
    SetBounds(heading.east, 1.0 - from_corner, &box.u_min, &box.u_max);
    boxes.push_back(box);
  }
  return boxes;
}

Place CenterPlace(const PlaceExtent& extent) {
  switch (extent.depth) {
    case PlaceDepth::kThird:
    case PlaceDepth::kBand:
    case PlaceDepth::kRows:
      return PlaceOfName("middle rows");
    case PlaceDepth::kColumns:
      return PlaceOfName("middle columns");
    // Squares of about the share that is said.
    case PlaceDepth::kHalf:
      return PlaceOfBoxes("central half", {MiddleBox(0.7)});
    case PlaceDepth::kQuarter:
      return PlaceOfBoxes("central quarter", {MiddleBox(0.5)});
    case PlaceDepth::kFraction:
      return PlaceOfBoxes("central " + extent.fraction_name,
                          {MiddleBox(std::sqrt(extent.fraction))});
    default:
      return PlaceOfName("center");
  }
}

Place CardinalPlace(const Direction& direction, const PlaceExtent& extent) {
  const Heading& heading = direction.heading;
  const auto named = [&](std::string_view noun) { return PlaceOfName(NameOf(heading, noun)); };
  switch (extent.depth) {
    case PlaceDepth::kHalf:
      return named("half");
    case PlaceDepth::kQuarter:
    case PlaceDepth::kBand:
      return named("quarter");
    case PlaceDepth::kRows:
    case PlaceDepth::kColumns:
    case PlaceDepth::kEdge:
      return named("edge");
    case PlaceDepth::kFraction:
      return PlaceOfBoxes(NameOf(heading, extent.fraction_name),
                          {SideBox(heading, extent.fraction)});
    case PlaceDepth::kThird:
      return named("third");
    default:
      return named(direction.extreme ? "quarter" : "third");
  }
}

Place DiagonalPlace(const Direction& direction, const PlaceExtent& extent) {
  const Heading& heading = direction.heading;
  const std::string corner = std::string(NounOf(heading)) + " corner";
  switch (extent.depth) {
    case PlaceDepth::kHalf:
      return PlaceOfBoxes(NameOf(heading, "half"), TriangleBoxes(heading));
    case PlaceDepth::kQuarter:
      return PlaceOfName(NameOf(heading, "quarter"));
    case PlaceDepth::kCorner:
    case PlaceDepth::kEdge:
      return PlaceOfName(corner);
    case PlaceDepth::kFraction:
      return PlaceOfBoxes(NameOf(heading, extent.fraction_name),
                          {SideBox(heading, std::sqrt(extent.fraction))});
    default:
      if (direction.extreme) return PlaceOfName(corner);
      return PlaceOfName(latticeworld::NameOf(RegionOf(heading)));
  }
}

// The ninths of a side; of the middle and of a corner one, and of `one_ninth` ("middle left") one.
std::vector<Region> NinthsToward(const Heading& heading, bool one_ninth) {
  std::vector<Region> ninths;
  const bool corner = heading.IsDiagonal();
  const bool middle = heading.east == 0 && heading.south == 0;
  const bool one = one_ninth || corner || middle;
  for (int south = -1; south <= 1; ++south) {
    for (int east = -1; east <= 1; ++east) {
      const bool col = heading.east == east || (!one && heading.east == 0);
      const bool row = heading.south == south || (!one && heading.south == 0);
      if (col && row) ninths.push_back(RegionOf(Heading{east, south}));
    }
  }
  return ninths;
}

Place PlaceToward(const Direction& direction, const PlaceExtent& extent) {
  const Heading& heading = direction.heading;
  if (direction.between) {
    // A third deep toward the nearer wind, and half the width.
    const Heading& nearer = direction.nearer;
    UnitBox box;
    SetBounds(heading.east, nearer.east != 0 ? kThird : 0.5, &box.u_min, &box.u_max);
    SetBounds(heading.south, nearer.south != 0 ? kThird : 0.5, &box.v_min, &box.v_max);
    return PlaceOfBoxes(std::string(NounOf(nearer)) + "-" + std::string(NounOf(heading)), {box});
  }
  const bool middle = heading.east == 0 && heading.south == 0;
  if (middle) return CenterPlace(extent);
  const bool diagonal = heading.IsDiagonal();
  if (diagonal) return DiagonalPlace(direction, extent);
  if (!direction.center) return CardinalPlace(direction, extent);
  // "middle left": one ninth of the side, or of the edge.
  UnitBox box =
      CardinalPlace({heading},
                    extent.depth == PlaceDepth::kEdge ? extent : PlaceExtent{PlaceDepth::kThird})
          .box;
  if (heading.east != 0) {
    box.v_min = kThird;
    box.v_max = 2 * kThird;
  } else {
    box.u_min = kThird;
    box.u_max = 2 * kThird;
  }
  return PlaceOfBoxes("middle of the " + NameOf(heading, "edge"), {box});
}

}  // namespace

Place MakePlace(const Direction& direction, const PlaceExtent& extent) {
  Place place = PlaceToward(direction, extent);
  const Heading& heading = direction.heading;
  if (heading.east != 0 || heading.south != 0) {
    place.main = RegionOf(heading);
    place.regions = NinthsToward(heading, direction.center);
  }
  return place;
}

Place PlaceOfBoxes(std::string name, std::vector<UnitBox> boxes) {
  for (const Zone& zone : NamedZones()) {
    if (!zone.is_anywhere() && IsSame(zone.boxes, boxes)) return PlaceOfZone(zone);
  }
  Zone zone;
  zone.name = std::move(name);
  zone.boxes = std::move(boxes);
  return PlaceOfZone(std::move(zone));
}

Place PlaceOfName(std::string_view name) {
  std::optional<Zone> zone = FindZone(name);
  LW_CHECK(zone.has_value(), name);
  return PlaceOfZone(*std::move(zone));
}

Place Everywhere() { return PlaceOfZone(Zone()); }

Place AllEdges() {
  Place place = PlaceOfName("edges");
  place.regions.clear();
  for (int south = -1; south <= 1; ++south) {
    for (int east = -1; east <= 1; ++east) {
      if (east != 0 || south != 0) place.regions.push_back(RegionOf(Heading{east, south}));
    }
  }
  place.main = Region::kUpper;
  return place;
}

Place AllCorners() {
  std::vector<UnitBox> boxes;
  for (const Heading heading : kCornerHeadings) {
    boxes.push_back(SideBox(heading, 0.25));
  }
  Place place = PlaceOfBoxes("corners", std::move(boxes));
  place.main = Region::kUpperLeft;
  return place;
}

Place Diagonal(bool falling) {
  std::vector<UnitBox> boxes;
  for (int i = 0; i < kSteps; ++i) {
    // A step wider than it is high on either side, so that the band is one piece.
    UnitBox box;
    const int col = falling ? i : kSteps - 1 - i;
    box.u_min = std::max(0.0, (col - 0.5) / kSteps);
    box.u_max = std::min(1.0, (col + 1.5) / kSteps);
    box.v_min = static_cast<double>(i) / kSteps;
    box.v_max = static_cast<double>(i + 1) / kSteps;
    boxes.push_back(box);
  }
  return PlaceOfBoxes(falling ? "diagonal" : "rising diagonal", std::move(boxes));
}

Place BesideCenter(Heading heading) {
  UnitBox box = MiddleBox(kThird);
  box.u_min += 0.2 * heading.east;
  box.u_max += 0.2 * heading.east;
  box.v_min += 0.2 * heading.south;
  box.v_max += 0.2 * heading.south;
  return PlaceOfBoxes("just " + std::string(NounOf(heading)) + " of the center", {box});
}

Place AroundCenter() { return PlaceOfBoxes("around the center", {MiddleBox(0.6)}); }

Place Between(const Place& a, const Place& b) {
  // Along each axis this is the gap between the two. Where they overlap it is what they share, and
  // where they touch, a third of the map about that line.
  const auto bounds = [](double a_min, double a_max, double b_min, double b_max) {
    const double low = std::min(a_max, b_max);
    const double high = std::max(a_min, b_min);
    const double begin = std::min(low, high);
    const double end = std::max(low, high);
    if (end - begin > 0.1) return std::make_pair(begin, end);
    const double middle = std::clamp((begin + end) / 2, kThird / 2, 1.0 - kThird / 2);
    return std::make_pair(middle - kThird / 2, middle + kThird / 2);
  };
  UnitBox box;
  std::tie(box.u_min, box.u_max) = bounds(a.box.u_min, a.box.u_max, b.box.u_min, b.box.u_max);
  std::tie(box.v_min, box.v_max) = bounds(a.box.v_min, a.box.v_max, b.box.v_min, b.box.v_max);
  return PlaceOfBoxes("between " + a.zone.name + " and " + b.zone.name, {box});
}

Place PartOf(const Direction& part, const Place& part_place, const Place& whole) {
  UnitBox in = part_place.box;
  const double width = whole.box.u_max - whole.box.u_min;
  const double height = whole.box.v_max - whole.box.v_min;
  if (part.center && part.heading.east == 0 && part.heading.south == 0) {
    // The middle of a narrow side is as wide as the side.
    const double u = std::min(1.0, std::max(kThird, kThird / width));
    const double v = std::min(1.0, std::max(kThird, kThird / height));
    in = {0.5 - u / 2, 0.5 + u / 2, 0.5 - v / 2, 0.5 + v / 2};
  }
  const UnitBox box = {whole.box.u_min + in.u_min * width, whole.box.u_min + in.u_max * width,
                       whole.box.v_min + in.v_min * height, whole.box.v_min + in.v_max * height};
  return PlaceOfBoxes(part_place.zone.name + " of " + whole.zone.name, {box});
}

}  // namespace latticeworld
