#include "latticeworld/exporting/body_meshes.h"

#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/rendering/looks/body_looks.h"
#include "latticeworld/rendering/looks/bridge_looks.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/sensing/solids/agent_body.h"
#include "latticeworld/sensing/solids/prop_body.h"
#include "latticeworld/species/species.h"

namespace latticeworld {
namespace {

constexpr std::array<const char*, kBodyPartCount> kPartNames = {"coat", "limb", "head", "detail"};
constexpr float kRoughness = 0.8f;

std::vector<Eigen::Vector3f> Placed(const std::vector<Eigen::Vector3f>& vertices,
                                    const Eigen::Affine3d& frame_from_mesh) {
  std::vector<Eigen::Vector3f> placed;
  placed.reserve(vertices.size());
  for (const Eigen::Vector3f& vertex : vertices) {
    const Eigen::Vector3d point = frame_from_mesh * vertex.cast<double>();
    placed.push_back(YUp(point.cast<float>()));
  }
  return placed;
}

int AddPlain(const std::string& name, const Light& color, GlbDocument* document) {
  GlbMaterial material;
  material.name = name;
  material.base_color << color.matrix().cwiseMax(0.0f).cwiseMin(1.0f), 1.0f;
  material.roughness = kRoughness;
  return document->AddMaterial(material);
}

}  // namespace

int AddBody(const Species& species, ArtisticStyle style, GlbDocument* document) {
  const std::string name = "agent/" + species.name;
  const BodyMesh body = BuildBody(species.category);
  const auto vertices =
      Placed(body.vertices, BaseFromBody(species.category, species.height_m, species.radius_m));
  std::array<std::vector<std::uint32_t>, kBodyPartCount> corners;
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    auto& list = corners[static_cast<std::size_t>(body.parts[i])];
    list.insert(list.end(), body.triangles[i].begin(), body.triangles[i].end());
  }
  const int positions = document->AddPositions(vertices);
  std::vector<GlbPrimitive> primitives;
  for (int part = 0; part < kBodyPartCount; ++part) {
    if (corners[part].empty()) continue;
    RayHit hit;
    hit.part = static_cast<std::uint8_t>(part);
    GlbPrimitive primitive;
    primitive.positions = positions;
    primitive.indices = document->AddIndices(corners[part], vertices.size());
    primitive.material = AddPlain(name + "/" + kPartNames[part],
                                  LookOfBody(species.category, style, hit).albedo, document);
    primitives.push_back(primitive);
  }
  return document->AddMesh(name, primitives);
}

int AddProp(PropKind kind, ArtisticStyle style, GlbDocument* document) {
  const std::string name = "element/" + std::string(NameOf(kind));
  const PropMesh mesh = BuildProp(FormOf(kind));
  const Eigen::Vector3d size_m = UsualProp(kind).size_m;
  const Eigen::Affine3d unit =
      Eigen::Affine3d(Eigen::Scaling(size_m.cwiseInverse().eval())) * PropFromMesh(kind, size_m);
  const auto vertices = Placed(mesh.vertices, unit);
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : mesh.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  // From so far away, grain and joints are not seen.
  constexpr float kFar_m = 1.0f;
  const SurfaceLook look = LookOfProp(kind, style, RayHit(), Eigen::Vector3f::Zero(), kFar_m);
  GlbPrimitive primitive;
  primitive.positions = document->AddPositions(vertices);
  primitive.indices = document->AddIndices(corners, vertices.size());
  primitive.material =
      AddPlain(name + (kind == PropKind::kLooseStone ? "/stone" : "/bark"), look.albedo, document);
  return document->AddMesh(name, {primitive});
}

int AddBridgePart(BridgeKind kind, BridgePartKind part, ArtisticStyle style,
                  GlbDocument* document) {
  constexpr std::array<const char*, 4> kNames = {"deck", "railing", "pier", "arch"};
  const std::string name =
      "bridge/" + std::string(NameOf(kind)) + "/" + kNames[static_cast<std::size_t>(part)];
  const PropMesh mesh = BuildProp(PropForm::kBox);
  const auto vertices = Placed(mesh.vertices, Eigen::Affine3d::Identity());
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : mesh.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  const Color color = ColorOfBridge(kind, part, part == BridgePartKind::kDeck);
  GlbPrimitive primitive;
  primitive.positions = document->AddPositions(vertices);
  primitive.indices = document->AddIndices(corners, vertices.size());
  primitive.material = AddPlain(name, LightOf(InStyle(style, color)), document);
  return document->AddMesh(name, {primitive});
}

}  // namespace latticeworld
