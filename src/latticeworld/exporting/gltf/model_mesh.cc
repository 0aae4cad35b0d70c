#include "latticeworld/exporting/gltf/model_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <unordered_map>

#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr std::array<const char*, kMeshPartCount> kPartNames = {
    "leaves", "bark", "blossom", "stone", "wall", "roof", "window", "door", "trim"};

constexpr double kDeepSnow_m = 0.1;  // from which on it covers all that faces up
const Eigen::Vector3f kSnow(.84f, .88f, .94f);

// Share of a part that faces up.
float FacingUp(MeshPart part) {
  switch (part) {
    case MeshPart::kLeaves:
    case MeshPart::kStone:
      return 0.5f;
    case MeshPart::kRoof:
      return 0.9f;
    case MeshPart::kBark:
    case MeshPart::kBlossom:
      return 0.25f;
    default:
      return 0.0f;
  }
}

Eigen::Vector3f LinearOf(const Rgb& color) {
  return {ToLinear(color.r / 255.0f), ToLinear(color.g / 255.0f), ToLinear(color.b / 255.0f)};
}

// A place, in coordinates of which none is a negative zero.
using WeldKey = std::array<float, 3>;

struct WeldHash {
  std::size_t operator()(const WeldKey& key) const {
    std::uint64_t hash = 0;
    for (const float value : key) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

struct Welded {
  std::vector<Eigen::Vector3f> positions;  // y up, in the order in which they first come
  std::vector<std::uint32_t> numbers;      // in positions, one a vertex
};

// per_unit: steps within which vertices are at one place; 0: only where they are the same.
Welded Weld(const std::vector<Eigen::Vector3f>& vertices, float per_unit) {
  Welded welded;
  std::unordered_map<WeldKey, std::uint32_t, WeldHash> known;
  known.reserve(vertices.size());
  welded.numbers.reserve(vertices.size());
  for (const Eigen::Vector3f& vertex : vertices) {
    const Eigen::Vector3f position = YUp(vertex);
    WeldKey key = {position.x(), position.y(), position.z()};
    for (float& value : key) {
      if (per_unit > 0.0f) value = std::round(value * per_unit);
      value += 0.0f;  // no negative zero
    }
    const auto number = static_cast<std::uint32_t>(welded.positions.size());
    const auto [at, is_first] = known.emplace(key, number);
    if (is_first) welded.positions.push_back(position);
    welded.numbers.push_back(at->second);
  }
  return welded;
}

}  // namespace

const char* NameOf(MeshPart part) { return kPartNames[static_cast<std::size_t>(part)]; }

MeshPart MainPartOf(AssetKind kind) {
  switch (kind) {
    case AssetKind::kStone:
      return MeshPart::kStone;
    case AssetKind::kBuilding:
      return MeshPart::kWall;
    case AssetKind::kDeadBranch:
      return MeshPart::kBark;
    case AssetKind::kFlower:
      return MeshPart::kBlossom;
    default:
      return MeshPart::kLeaves;
  }
}

ModelColors MeanColors(const Scene& scene, const std::vector<std::uint32_t>& assets) {
  // Thousands of individuals have the mean of a few hundred.
  constexpr std::size_t kMostSamples = 256;
  const std::size_t step = (assets.size() + kMostSamples - 1) / kMostSamples;
  ModelColors colors;
  colors.fill(Eigen::Vector3f::Zero());
  float samples = 0.0f;
  for (std::size_t i = 0; i < assets.size(); i += step, samples += 1.0f) {
    const auto parts = PartColors(scene, scene.assets[assets[i]]);
    for (int part = 0; part < kMeshPartCount; ++part) colors[part] += LinearOf(parts[part]);
  }
  const Asset& example = scene.assets[assets.front()];
  const SeasonVariant& variant =
      scene.catalogue->season_variants(TypeOf(example.kind))[example.season_variant];
  const auto snow = static_cast<float>(
      std::clamp(std::max(variant.snow, scene.atmosphere.snow_depth_m / kDeepSnow_m), 0.0, 1.0));
  for (int part = 0; part < kMeshPartCount; ++part) {
    const float white = snow * FacingUp(static_cast<MeshPart>(part));
    colors[part] = colors[part] / samples * (1.0f - white) + kSnow * white;
  }
  return colors;
}

ModelGeometry AddGeometry(const Mesh& mesh, bool quantized, GlbDocument* document) {
  float reach = 0.0f;
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    reach = std::max(reach, vertex.cwiseAbs().maxCoeff());
  const bool steps = quantized && reach <= 1.0f;
  const Welded welded = Weld(mesh.vertices, steps ? 32767.0f : 0.0f);
  std::array<std::vector<std::uint32_t>, kMeshPartCount> corners;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& triangle = mesh.triangles[i];
    const std::uint32_t a = welded.numbers[triangle[0]], b = welded.numbers[triangle[1]],
                        c = welded.numbers[triangle[2]];
    if (a == b || b == c || c == a) continue;  // smaller than a step
    auto& list = corners[static_cast<std::size_t>(mesh.parts[i])];
    list.insert(list.end(), {a, b, c});
  }
  ModelGeometry geometry;
  geometry.indices.fill(-1);
  geometry.positions = steps ? document->AddUnitPositions(welded.positions)
                             : document->AddPositions(welded.positions);
  for (int part = 0; part < kMeshPartCount; ++part) {
    if (!corners[part].empty())
      geometry.indices[part] = document->AddIndices(corners[part], welded.positions.size());
  }
  return geometry;
}

std::array<int, kMeshPartCount> AddMaterials(const std::string& name, const ModelColors& colors,
                                             const ModelGeometry& geometry, GlbDocument* document) {
  std::array<int, kMeshPartCount> materials;
  materials.fill(-1);
  for (int i = 0; i < kMeshPartCount; ++i) {
    if (geometry.indices[i] < 0) continue;
    const auto part = static_cast<MeshPart>(i);
    GlbMaterial material;
    material.name = name + "/" + NameOf(part);
    material.base_color << colors[i].cwiseMax(0.0f).cwiseMin(1.0f), 1.0f;
    material.roughness = part == MeshPart::kWindow ? 0.2f : 0.95f;
    material.both_sides =
        part == MeshPart::kLeaves || part == MeshPart::kBlossom || part == MeshPart::kBark;
    materials[i] = document->AddMaterial(material);
  }
  return materials;
}

int AddModel(const std::string& name, const ModelGeometry& geometry,
             const std::array<int, kMeshPartCount>& materials, GlbDocument* document) {
  std::vector<GlbPrimitive> primitives;
  for (int part = 0; part < kMeshPartCount; ++part) {
    if (geometry.indices[part] < 0) continue;
    GlbPrimitive primitive;
    primitive.positions = geometry.positions;
    primitive.indices = geometry.indices[part];
    primitive.material = materials[part];
    primitives.push_back(primitive);
  }
  return document->AddMesh(name, primitives);
}

}  // namespace latticeworld
