#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <tuple>

#include "latticeworld/meshes/mesh.h"

namespace latticeworld {
namespace {

std::size_t Index(MeshPart part) { return static_cast<std::size_t>(part); }

bool Between(Rgb color, const ColorRange& range) {
  const auto channel = [](int v, int a, int b) {
    return v >= std::min(a, b) && v <= std::max(a, b);
  };
  return channel(color.r, range.from.r, range.to.r) && channel(color.g, range.from.g, range.to.g) &&
         channel(color.b, range.from.b, range.to.b);
}

TEST(ColorsTest, LeavesOfTreesAreOfTheirVariantAndBarkOfTheirMaterial) {
  const auto catalogue = Catalogue::BuiltIn();
  const auto& variants = catalogue->season_variants(AssetType::kForest);
  const auto& materials = catalogue->materials(AssetType::kForest);
  for (std::size_t variant = 0; variant < variants.size(); ++variant) {
    for (std::size_t material = 0; material < materials.size(); ++material) {
      for (const auto& season : EnumNames(Season{})) {
        for (const double draw : {0.0, 0.3, 0.61, 0.999}) {
          const auto colors =
              ColorsOf(*catalogue, AssetType::kForest, variant, material, season.value, draw);
          EXPECT_TRUE(Between(colors[Index(MeshPart::kLeaves)],
                              variants[variant].color[static_cast<std::size_t>(season.value)]));
          EXPECT_TRUE(Between(colors[Index(MeshPart::kBark)], materials[material].color));
        }
      }
    }
  }
}

TEST(ColorsTest, IndividualsDifferAndTheSameDrawIsTheSame) {
  const auto catalogue = Catalogue::BuiltIn();
  std::set<std::tuple<int, int, int>> walls, roofs;
  for (int i = 0; i < 40; ++i) {
    const double draw = i / 40.0;
    const auto colors = ColorsOf(*catalogue, AssetType::kArchitecture, 1, 0, Season::kSummer, draw);
    EXPECT_EQ(colors, ColorsOf(*catalogue, AssetType::kArchitecture, 1, 0, Season::kSummer, draw));
    const Rgb wall = colors[Index(MeshPart::kWall)], roof = colors[Index(MeshPart::kRoof)];
    EXPECT_TRUE(Between(wall, catalogue->materials(AssetType::kArchitecture)[0].color));
    walls.insert({wall.r, wall.g, wall.b});
    roofs.insert({roof.r, roof.g, roof.b});
  }
  EXPECT_GE(walls.size(), 15u);
  EXPECT_GE(roofs.size(), 15u);
}

TEST(ColorsTest, GlassIsDarkerThanTheFramesAroundIt) {
  const auto catalogue = Catalogue::BuiltIn();
  const auto light = [](Rgb c) { return c.r + c.g + c.b; };
  for (std::size_t material = 0; material < 3; ++material) {
    const auto colors =
        ColorsOf(*catalogue, AssetType::kArchitecture, 1, material, Season::kSummer, 0.4);
    EXPECT_LT(light(colors[Index(MeshPart::kWindow)]) + 150, light(colors[Index(MeshPart::kTrim)]));
  }
}

TEST(ColorsTest, WitheredBlossomLosesItsColor) {
  const auto catalogue = Catalogue::BuiltIn();
  const auto& variants = catalogue->season_variants(AssetType::kFlower);
  const auto& petals = catalogue->materials(AssetType::kFlower)[0].color;
  const auto distance = [&](std::size_t variant) {
    const Rgb c = ColorsOf(*catalogue, AssetType::kFlower, variant, 0, Season::kSummer,
                           0.0)[Index(MeshPart::kBlossom)];
    return std::abs(c.r - petals.from.r) + std::abs(c.g - petals.from.g) +
           std::abs(c.b - petals.from.b);
  };
  ASSERT_EQ(variants.size(), 2u);
  EXPECT_LT(distance(0) + 30, distance(1));
}

}  // namespace
}  // namespace latticeworld
