#include "latticeworld/layout/zone.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace latticeworld {
namespace {

TEST(ZoneTest, NamesMeanTheirBoxes) {
  const double third = 1.0 / 3.0, two_thirds = 2.0 / 3.0;
  // u_min, u_max, v_min, v_max.
  const std::map<std::string, std::array<double, 4>> boxes = {
      {"upper left", {0, third, 0, third}},
      {"upper", {third, two_thirds, 0, third}},
      {"upper right", {two_thirds, 1, 0, third}},
      {"middle left", {0, third, third, two_thirds}},
      {"center", {third, two_thirds, third, two_thirds}},
      {"middle right", {two_thirds, 1, third, two_thirds}},
      {"lower left", {0, third, two_thirds, 1}},
      {"lower", {third, two_thirds, two_thirds, 1}},
      {"lower right", {two_thirds, 1, two_thirds, 1}},
      {"northern half", {0, 1, 0, 0.5}},
      {"southern half", {0, 1, 0.5, 1}},
      {"western half", {0, 0.5, 0, 1}},
      {"eastern half", {0.5, 1, 0, 1}},
      {"northern third", {0, 1, 0, third}},
      {"southern third", {0, 1, two_thirds, 1}},
      {"western third", {0, third, 0, 1}},
      {"eastern third", {two_thirds, 1, 0, 1}},
      {"middle rows", {0, 1, third, two_thirds}},
      {"middle columns", {third, two_thirds, 0, 1}},
      {"northern quarter", {0, 1, 0, 0.25}},
      {"southern quarter", {0, 1, 0.75, 1}},
      {"western quarter", {0, 0.25, 0, 1}},
      {"eastern quarter", {0.75, 1, 0, 1}},
      {"north-western quarter", {0, 0.5, 0, 0.5}},
      {"north-eastern quarter", {0.5, 1, 0, 0.5}},
      {"south-western quarter", {0, 0.5, 0.5, 1}},
      {"south-eastern quarter", {0.5, 1, 0.5, 1}},
      {"north-west corner", {0, 0.25, 0, 0.25}},
      {"north-east corner", {0.75, 1, 0, 0.25}},
      {"south-west corner", {0, 0.25, 0.75, 1}},
      {"south-east corner", {0.75, 1, 0.75, 1}},
      {"northern edge", {0, 1, 0, 0.125}},
      {"southern edge", {0, 1, 0.875, 1}},
      {"western edge", {0, 0.125, 0, 1}},
      {"eastern edge", {0.875, 1, 0, 1}},
      {"interior", {0.125, 0.875, 0.125, 0.875}},
  };
  std::set<std::string> named = {"anywhere", "edges"};
  for (const auto& [name, box] : boxes) {
    const auto zone = FindZone(name);
    ASSERT_TRUE(zone.has_value()) << name;
    EXPECT_EQ(zone->name, name);
    const LayoutMask mask = MaskOf(*zone);
    for (int row = 0; row < kLayoutSize; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) {
        const UnitBox unit{box[0], box[1], box[2], box[3]};
        const bool in = unit.Contains((col + 0.5) / kLayoutSize, (row + 0.5) / kLayoutSize);
        ASSERT_EQ(mask.Contains({row, col}), in) << name << " " << row << " " << col;
      }
    }
    named.insert(name);
  }
  std::set<std::string> listed;
  for (const std::string_view name : ZoneNames()) listed.insert(std::string(name));
  EXPECT_EQ(listed, named);
  EXPECT_EQ(ZoneNames().size(), named.size()) << "a name is listed twice";
}

TEST(ZoneTest, EdgesAndInteriorShareTheLayout) {
  const LayoutMask edges = MaskOf(*FindZone("edges")), interior = MaskOf(*FindZone("interior"));
  EXPECT_EQ(edges, ~interior);
  EXPECT_EQ(interior.count(), 24 * 24);
  EXPECT_EQ(MaskOf(*FindZone("anywhere")), LayoutMask::All());
  EXPECT_EQ(MaskOf(Zone{}), LayoutMask::All());
}

TEST(ZoneTest, NinthsAreThoseOfTheRegions) {
  LayoutMask all;
  for (const auto& entry : EnumNames(Region{})) {
    const Zone zone = ZoneOf(entry.value);
    EXPECT_EQ(zone.name, entry.name);
    EXPECT_EQ(FindZone(entry.name), zone);
    EXPECT_EQ(RegionOf(zone), entry.value);
    if (entry.value == Region::kAnywhere) continue;
    const LayoutMask mask = MaskOf(zone);
    EXPECT_TRUE((all & mask).empty()) << entry.name;
    all = all | mask;
  }
  EXPECT_EQ(all, LayoutMask::All());
}

TEST(ZoneTest, ARegionIsThatOfTheMiddle) {
  EXPECT_EQ(RegionOf(*FindZone("northern half")), Region::kUpper);
  EXPECT_EQ(RegionOf(*FindZone("eastern edge")), Region::kMiddleRight);
  EXPECT_EQ(RegionOf(*FindZone("south-west corner")), Region::kLowerLeft);
  EXPECT_EQ(RegionOf(*FindZone("middle rows")), Region::kCenter);
  EXPECT_EQ(RegionOf(*FindZone("edges")), Region::kCenter);
}

TEST(ZoneTest, UnknownNamesAreNone) {
  for (const char* name : {"", "north", "Upper", "upper  left", "edge"}) {
    EXPECT_FALSE(FindZone(name).has_value()) << name;
  }
}

TEST(ZoneTest, BoxesOfAnySizeAreCut) {
  EXPECT_EQ(MaskOf(Zone{"wide", {{-3.0, 1e300, -1e300, 7.0}}}), LayoutMask::All());
  EXPECT_TRUE(MaskOf(Zone{"thin", {{0.501, 0.502, 0.0, 1.0}}}).empty());
  EXPECT_TRUE(MaskOf(Zone{"backward", {{0.9, 0.1, 0.0, 1.0}}}).empty());
  EXPECT_EQ(MaskOf(Zone{"one", {{0.5 / 32, 0.5 / 32, 0.5 / 32, 0.5 / 32}}}).count(), 1);
  EXPECT_EQ(MaskOf(Zone{"two", {{0, 0.25, 0, 0.25}, {0.75, 1, 0.75, 1}}}).count(), 128);
}

}  // namespace
}  // namespace latticeworld
