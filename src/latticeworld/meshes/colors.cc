#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/meshes/mesh.h"

namespace latticeworld {
namespace {

Rgb Mix(Rgb from, Rgb to, double share) {
  const auto channel = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + share * (b - a)));
  };
  return {channel(from.r, to.r), channel(from.g, to.g), channel(from.b, to.b)};
}

Rgb Pick(const ColorRange& range, double draw) { return Mix(range.from, range.to, draw); }

// A further draw from an individual's one, so that its parts vary apart from each other.
double Another(double draw, int which) {
  const double turned = draw + 0.61803398875 * which;
  return turned - std::floor(turned);
}

constexpr Rgb kWood = {100, 82, 62};

}  // namespace

std::array<Rgb, kMeshPartCount> ColorsOf(const Catalogue& catalogue, AssetType type,
                                         std::size_t season_variant, std::size_t material,
                                         Season season, double draw) {
  const auto& variants = catalogue.season_variants(type);
  const auto& materials = catalogue.materials(type);
  LW_CHECK(season_variant < variants.size(), "no such seasonal variant");
  LW_CHECK(material < materials.size(), "no such material");
  const Rgb worn =
      Pick(variants[season_variant].color[static_cast<std::size_t>(season)], Another(draw, 0));
  const Rgb made = Pick(materials[material].color, Another(draw, 1));
  std::array<Rgb, kMeshPartCount> colors;
  const auto set = [&](MeshPart part, Rgb color) {
    colors[static_cast<std::size_t>(part)] = color;
  };
  set(MeshPart::kLeaves, worn);
  set(MeshPart::kBark, made);
  set(MeshPart::kBlossom, made);
  set(MeshPart::kStone, made);
  set(MeshPart::kWall, made);
  set(MeshPart::kRoof, worn);
  set(MeshPart::kWindow, {54, 64, 76});
  set(MeshPart::kDoor, {92, 60, 38});
  set(MeshPart::kTrim, kWood);
  switch (type) {
    case AssetType::kGrass:
      // Bushes wear grass's variants too; their wood is brown, and so are the plumes of reed.
      set(MeshPart::kLeaves, Mix(worn, made, 0.2));
      set(MeshPart::kBark, Mix(kWood, worn, 0.25));
      set(MeshPart::kBlossom, {124, 100, 72});
      break;
    case AssetType::kFlower:
    case AssetType::kCrops: {
      // Stems are as green as leaves; blossom and ears wither with them.
      const double withered = 1.0 - variants[season_variant].foliage;
      set(MeshPart::kBark, Mix(worn, {70, 84, 44}, 0.25));
      set(MeshPart::kBlossom, Mix(made, worn, std::min(0.9, 0.1 + 1.5 * withered)));
      break;
    }
    case AssetType::kStone:
      set(MeshPart::kStone, Mix(made, worn, 0.35));
      break;
    case AssetType::kArchitecture: {
      // Tiles mostly, slate here and there; doors of painted wood; gravel on flat roofs.
      constexpr std::array<Rgb, 4> kDoors = {
          {{92, 60, 38}, {58, 76, 62}, {52, 62, 82}, {110, 44, 38}}};
      const double roof = Another(draw, 2);
      set(MeshPart::kRoof, roof < 0.25 ? Mix(worn, {78, 78, 82}, 0.8)
                                       : Mix(worn, {96, 70, 56}, 0.6 * (roof - 0.25)));
      set(MeshPart::kDoor, kDoors[static_cast<std::size_t>(4.0 * Another(draw, 3))]);
      set(MeshPart::kTrim, Mix(made, {226, 220, 208}, 0.7));
      set(MeshPart::kStone, {148, 145, 138});
      // Leaves are those of hedges, bark is that of benches and fences.
      set(MeshPart::kLeaves, {66, 92, 48});
      set(MeshPart::kBark, {122, 94, 66});
      break;
    }
    default:
      break;
  }
  return colors;
}

}  // namespace latticeworld
