#include "latticeworld/layout/zone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace latticeworld {
namespace {

constexpr double kEdge = 0.125;
constexpr double kThird = 1.0 / 3.0;
constexpr double kTwoThirds = 2.0 / 3.0;

struct NamedBoxes {
  std::string_view name;
  int boxes;
  std::array<UnitBox, 4> box;
};

// u_min, u_max, v_min, v_max: u from west to east, v from north to south.
constexpr std::array<NamedBoxes, 28> kNamed = {{
    {"northern half", 1, {{{0, 1, 0, 0.5}}}},
    {"southern half", 1, {{{0, 1, 0.5, 1}}}},
    {"western half", 1, {{{0, 0.5, 0, 1}}}},
    {"eastern half", 1, {{{0.5, 1, 0, 1}}}},
    {"northern third", 1, {{{0, 1, 0, kThird}}}},
    {"southern third", 1, {{{0, 1, kTwoThirds, 1}}}},
    {"western third", 1, {{{0, kThird, 0, 1}}}},
    {"eastern third", 1, {{{kTwoThirds, 1, 0, 1}}}},
    {"middle rows", 1, {{{0, 1, kThird, kTwoThirds}}}},
    {"middle columns", 1, {{{kThird, kTwoThirds, 0, 1}}}},
    {"northern quarter", 1, {{{0, 1, 0, 0.25}}}},
    {"southern quarter", 1, {{{0, 1, 0.75, 1}}}},
    {"western quarter", 1, {{{0, 0.25, 0, 1}}}},
    {"eastern quarter", 1, {{{0.75, 1, 0, 1}}}},
    {"northern edge", 1, {{{0, 1, 0, kEdge}}}},
    {"southern edge", 1, {{{0, 1, 1 - kEdge, 1}}}},
    {"western edge", 1, {{{0, kEdge, 0, 1}}}},
    {"eastern edge", 1, {{{1 - kEdge, 1, 0, 1}}}},
    {"edges",
     4,
     {{{0, 1, 0, kEdge}, {0, 1, 1 - kEdge, 1}, {0, kEdge, 0, 1}, {1 - kEdge, 1, 0, 1}}}},
    {"interior", 1, {{{kEdge, 1 - kEdge, kEdge, 1 - kEdge}}}},
    {"north-western quarter", 1, {{{0, 0.5, 0, 0.5}}}},
    {"north-eastern quarter", 1, {{{0.5, 1, 0, 0.5}}}},
    {"south-western quarter", 1, {{{0, 0.5, 0.5, 1}}}},
    {"south-eastern quarter", 1, {{{0.5, 1, 0.5, 1}}}},
    {"north-west corner", 1, {{{0, 0.25, 0, 0.25}}}},
    {"north-east corner", 1, {{{0.75, 1, 0, 0.25}}}},
    {"south-west corner", 1, {{{0, 0.25, 0.75, 1}}}},
    {"south-east corner", 1, {{{0.75, 1, 0.75, 1}}}},
}};

bool Same(const UnitBox& a, const UnitBox& b) {
  return a.u_min == b.u_min && a.u_max == b.u_max && a.v_min == b.v_min && a.v_max == b.v_max;
}

// The cells, 0 to kLayoutSize - 1, whose centres lie in [low, high]: first to last.
int FirstCellFrom(double low) {
  return static_cast<int>(std::clamp(std::ceil(low * kLayoutSize - 0.5), 0.0, 1.0 * kLayoutSize));
}
int LastCellTo(double high) {
  return static_cast<int>(
      std::clamp(std::floor(high * kLayoutSize - 0.5), -1.0, kLayoutSize - 1.0));
}

Zone ZoneOf(const NamedBoxes& named) {
  return {std::string(named.name), {named.box.begin(), named.box.begin() + named.boxes}};
}

}  // namespace

bool operator==(const Zone& a, const Zone& b) {
  return a.name == b.name &&
         std::equal(a.boxes.begin(), a.boxes.end(), b.boxes.begin(), b.boxes.end(), Same);
}

LayoutMask MaskOf(const Zone& zone) {
  if (zone.is_anywhere()) return LayoutMask::All();
  LayoutMask mask;
  for (const UnitBox& box : zone.boxes) {
    const int first = FirstCellFrom(box.u_min), last = LastCellTo(box.u_max);
    if (first > last) continue;
    const std::uint32_t bits = (~0u >> (kLayoutSize - 1 - (last - first))) << first;
    const int last_row = LastCellTo(box.v_max);
    for (int row = FirstCellFrom(box.v_min); row <= last_row; ++row) {
      mask.set_row(row, mask.row(row) | bits);
    }
  }
  return mask;
}

Zone ZoneOf(Region region) {
  Zone zone{std::string(NameOf(region)), {}};
  if (region != Region::kAnywhere) zone.boxes.push_back(BoxOf(region));
  return zone;
}

Region RegionOf(const Zone& zone) {
  const LayoutMask mask = MaskOf(zone);
  if (zone.is_anywhere() || mask.empty()) return Region::kAnywhere;
  const LayoutMask::Point middle = mask.Centroid();
  const auto third = [](double cells) {
    return std::clamp(static_cast<int>((cells + 0.5) / kLayoutSize * 3.0), 0, 2);
  };
  return static_cast<Region>(third(middle.row) * 3 + third(middle.col));
}

std::optional<Zone> FindZone(std::string_view name) {
  if (const auto region = FromName<Region>(name)) return ZoneOf(*region);
  for (const NamedBoxes& named : kNamed) {
    if (named.name == name) return ZoneOf(named);
  }
  return std::nullopt;
}

std::vector<std::string_view> ZoneNames() {
  std::vector<std::string_view> names = {NameOf(Region::kAnywhere)};
  for (const auto& entry : EnumNames(Region{})) {
    if (entry.value != Region::kAnywhere) names.push_back(entry.name);
  }
  for (const NamedBoxes& named : kNamed) names.push_back(named.name);
  return names;
}

}  // namespace latticeworld
