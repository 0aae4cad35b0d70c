#include "latticeworld/exporting/gltf/world_glb.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/exporting/body_meshes.h"
#include "latticeworld/exporting/chosen_assets.h"
#include "latticeworld/exporting/gltf/model_library.h"
#include "latticeworld/exporting/gltf/model_mesh.h"
#include "latticeworld/exporting/ground_mesh.h"
#include "latticeworld/geometry/upright.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/ray_scene.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "glb";
constexpr float kThinnest_m = 1e-3f;  // nothing is flat
const Eigen::Vector4f kWaterColor(0.03f, 0.09f, 0.11f, 0.72f);
constexpr float kWaterRoughness = 0.08f;

Eigen::Quaternionf Turned(double yaw_rad) {
  return Eigen::Quaternionf(
      Eigen::AngleAxisf(static_cast<float>(yaw_rad), Eigen::Vector3f::UnitY()));
}

Eigen::Vector3f PlaceOf(const Asset& asset) {
  return YUp(Eigen::Vector3f(asset.x_m, asset.y_m, asset.z_m));
}

// Returns half of the asset's length, its height and half of its width, as x, y, z of glTF [m].
Eigen::Vector3f SizeOf(const Asset& asset) {
  return Eigen::Vector3f(asset.half_length_m, asset.height_m, asset.half_width_m)
      .cwiseMax(kThinnest_m);
}

// Builds the nodes of one file.
class WorldGlbBuilder {
 public:
  WorldGlbBuilder(const Scene& scene, const SpeciesCatalogue& species,
                  const WorldGlbOptions& options, const Progress& progress)
      : scene_(scene), species_(species), options_(options), progress_(progress) {
    region_ = options.region.value_or(WholeWorld(scene.geometry()));
  }

  Result<std::string> Build() {
    LW_RETURN_IF_ERROR(AddLand());
    AddSunlight();
    LW_RETURN_IF_ERROR(AddAssets());
    AddProps();
    AddBridges();
    if (options_.agents) AddAgents();
    LW_RETURN_IF_ERROR(Advance(0.9));
    return document_.Finish(roots_, "world");
  }

 private:
  Status Advance(double fraction) const {
    progress_.Report(kStage, fraction);
    return progress_.CheckCancelled();
  }

  int AddSurface(const SurfaceMesh& mesh, const std::string& name, const GlbMaterial& material,
                 bool textured) {
    std::vector<Eigen::Vector3f> positions, normals;
    positions.reserve(mesh.positions_m.size());
    normals.reserve(mesh.normals.size());
    for (const Eigen::Vector3f& position : mesh.positions_m) positions.push_back(YUp(position));
    for (const Eigen::Vector3f& normal : mesh.normals) normals.push_back(YUp(normal));
    GlbPrimitive primitive;
    primitive.positions = document_.AddPositions(positions);
    primitive.normals = document_.AddNormals(normals);
    if (textured)
      primitive.texture_coordinates = document_.AddTextureCoordinates(mesh.texture_coordinates);
    primitive.indices = document_.AddIndices(mesh.corners, positions.size());
    primitive.material = document_.AddMaterial(material);
    GlbNode node;
    node.name = name;
    node.extras.kind = name;
    node.mesh = document_.AddMesh(name, {primitive});
    return document_.AddNode(node);
  }

  Status AddLand() {
    LW_RETURN_IF_ERROR(Advance(0.0));
    const SurfaceLattice lattice =
        MakeLattice(region_, options_.ground_step_m.value_or(scene_.geometry().resolution_m()),
                    kMostGroundVertices);
    LW_ASSIGN_OR_RETURN(const std::string jpeg,
                        GroundTexture(scene_, region_, options_.texture_px));
    LW_RETURN_IF_ERROR(Advance(0.2));
    GlbMaterial earth;
    earth.name = "ground";
    earth.texture = document_.AddTexture(jpeg, "ground");
    roots_.push_back(AddSurface(GroundMesh(*scene_.terrain, lattice), "ground", earth, true));
    LW_RETURN_IF_ERROR(Advance(0.3));
    const SurfaceMesh water = WaterMesh(*scene_.terrain, lattice);
    if (!water.corners.empty()) {
      GlbMaterial look;
      look.name = "water";
      look.base_color = kWaterColor;
      look.roughness = kWaterRoughness;
      roots_.push_back(AddSurface(water, "water", look, false));
    }
    return Advance(0.4);
  }

  void AddSunlight() {
    const RaySky sky(scene_);
    Eigen::Vector3f color = sky.sunlight().matrix();
    color = color.maxCoeff() > 0.0f ? Eigen::Vector3f(color / color.maxCoeff())
                                    : Eigen::Vector3f(Eigen::Vector3f::Ones());
    GlbNode node;
    node.name = "sun";
    node.extras.kind = "sun";
    node.light = document_.AddSun(
        "sun", color, kSunIlluminance_lux * std::max(0.0, scene_.atmosphere.sun_intensity));
    node.rotation = TurnFromUp(YUp(sky.sun_direction()).cast<double>()).cast<float>();
    roots_.push_back(document_.AddNode(node));
  }

  int ModelOf(const LookGroup& group) {
    const Asset& example = scene_.assets[group.members.front()];
    auto found = geometries_.find(group.model);
    if (found == geometries_.end()) {
      const auto& variants = scene_.catalogue->season_variants(TypeOf(example.kind));
      const Mesh mesh = BuildMesh(scene_.catalogue->models()[example.model],
                                  variants[example.season_variant].foliage, options_.detail,
                                  MeshVariationOf(example));
      found = geometries_.emplace(group.model, AddGeometry(mesh, /*quantized=*/false, &document_))
                  .first;
    }
    const ModelGeometry& geometry = found->second;
    const auto materials =
        AddMaterials(group.name, MeanColors(scene_, group.members), geometry, &document_);
    return AddModel(group.name, geometry, materials, &document_);
  }

  GlbExtras ExtrasOf(const Asset& asset) const {
    return {std::string(NameOf(asset.kind)), scene_.catalogue->models()[asset.model].name, {}};
  }

  int AddInstances(const LookGroup& group, int mesh) {
    std::vector<Eigen::Vector3f> places, sizes;
    std::vector<Eigen::Quaternionf> turns;
    for (const std::uint32_t number : group.members) {
      const Asset& asset = scene_.assets[number];
      places.push_back(PlaceOf(asset));
      turns.push_back(Turned(asset.yaw_rad));
      sizes.push_back(SizeOf(asset));
    }
    GlbNode node;
    node.name = group.name;
    node.mesh = mesh;
    node.instances = GlbInstances{document_.AddVectors(places), document_.AddRotations(turns),
                                  document_.AddVectors(sizes), document_.AddNumbers(group.members)};
    node.extras = ExtrasOf(scene_.assets[group.members.front()]);
    return document_.AddNode(node);
  }

  int AddThing(std::uint32_t number, int mesh) {
    const Asset& asset = scene_.assets[number];
    GlbNode node;
    node.name = scene_.catalogue->models()[asset.model].name + "_" + std::to_string(number);
    node.extras = ExtrasOf(asset);
    node.extras.asset = number;
    node.mesh = mesh;
    node.translation_m = PlaceOf(asset);
    node.rotation = Turned(asset.yaw_rad);
    node.scale = SizeOf(asset);
    return document_.AddNode(node);
  }

  Status AddAssets() {
    const auto chosen = ChooseAssets(scene_, region_, options_.small_plants);
    if (options_.expand && chosen.size() > kMostNodes)
      return TooMany(chosen.size(), "expanded things", kMostNodes, options_.small_plants);
    const auto groups = GroupAssets(scene_, chosen);
    std::vector<int> children;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      LW_RETURN_IF_ERROR(Advance(0.4 + 0.5 * static_cast<double>(i) / groups.size()));
      const int mesh = ModelOf(groups[i]);
      if (!options_.expand) {
        children.push_back(AddInstances(groups[i], mesh));
        continue;
      }
      for (const std::uint32_t number : groups[i].members)
        children.push_back(AddThing(number, mesh));
    }
    AddParent("assets", std::move(children));
    return Status();
  }

  void AddProps() {
    std::map<PropKind, int> meshes;
    std::vector<int> children;
    for (const Prop& prop : scene_.props) {
      if (!region_.Holds(prop.position)) continue;
      auto found = meshes.find(prop.kind);
      if (found == meshes.end()) {
        const int mesh = AddProp(prop.kind, scene_.environment.coarse.artistic_style, &document_);
        found = meshes.emplace(prop.kind, mesh).first;
      }
      GlbNode node;
      node.name = prop.name;
      node.extras = {"element", std::string(NameOf(prop.kind)), {}};
      node.mesh = found->second;
      node.translation_m =
          YUp(Eigen::Vector3d(prop.position.x_m, prop.position.y_m, prop.z_m).cast<float>());
      node.rotation = Turned(prop.yaw_rad);
      const Eigen::Vector3f size = prop.size_m.cast<float>();
      node.scale = Eigen::Vector3f(size.x(), size.z(), size.y());
      children.push_back(document_.AddNode(node));
    }
    AddParent("elements", std::move(children));
  }

  void AddBridges() {
    std::map<std::pair<BridgeKind, BridgePartKind>, int> meshes;
    std::vector<int> children;
    const std::vector<Bridge>& bridges = scene_.terrain->bridges;
    for (std::size_t i = 0; i < bridges.size(); ++i) {
      const Bridge& bridge = bridges[i];
      for (const BridgePart& part : PartsOf(bridge, scene_.terrain->ground)) {
        if (!region_.Holds(part.middle)) continue;
        auto found = meshes.find({bridge.kind, part.kind});
        if (found == meshes.end()) {
          const int mesh = AddBridgePart(bridge.kind, part.kind,
                                         scene_.environment.coarse.artistic_style, &document_);
          found = meshes.emplace(std::make_pair(bridge.kind, part.kind), mesh).first;
        }
        GlbNode node;
        node.name = "road_bridge_" + std::to_string(i + 1);
        node.extras = {"bridge", std::string(NameOf(bridge.kind)), {}};
        node.mesh = found->second;
        node.translation_m =
            YUp(Eigen::Vector3d(part.middle.x_m, part.middle.y_m, part.middle_z_m()).cast<float>());
        node.rotation = Turned(part.yaw_rad);
        const Eigen::Vector3f size = part.size_m().cast<float>();
        node.scale = Eigen::Vector3f(size.x(), size.z(), size.y());
        children.push_back(document_.AddNode(node));
      }
    }
    if (!children.empty()) AddParent("bridges", std::move(children));
  }

  void AddAgents() {
    std::map<std::string, int> meshes;
    std::vector<int> children;
    for (const AgentStart& agent : scene_.agents) {
      if (!region_.Holds(agent.position)) continue;
      const Species& species = species_.Of(agent.category);
      auto found = meshes.find(species.name);
      if (found == meshes.end()) {
        const int mesh = AddBody(species, scene_.environment.coarse.artistic_style, &document_);
        found = meshes.emplace(species.name, mesh).first;
      }
      GlbNode node;
      node.name = agent.name;
      node.extras = {"agent", species.name, {}};
      node.mesh = found->second;
      const double z_m =
          scene_.terrain->ground.HeightAt(agent.position) + agent.height_above_ground_m;
      node.translation_m =
          YUp(Eigen::Vector3d(agent.position.x_m, agent.position.y_m, z_m).cast<float>());
      node.rotation = Turned(agent.heading_rad);
      children.push_back(document_.AddNode(node));
    }
    AddParent("agents", std::move(children));
  }

  // Nothing where it would be childless: glTF has no empty lists.
  void AddParent(const char* name, std::vector<int> children) {
    if (children.empty()) return;
    GlbNode parent;
    parent.name = name;
    parent.children = std::move(children);
    roots_.push_back(document_.AddNode(parent));
  }

  const Scene& scene_;
  const SpeciesCatalogue& species_;
  const WorldGlbOptions& options_;
  const Progress& progress_;
  ExportRegion region_;
  GlbDocument document_{GlbNames::kPlain};
  std::vector<int> roots_;
  std::map<std::string, ModelGeometry> geometries_;  // by model
};

}  // namespace

Status Validate(const WorldGlbOptions& options, const Scene& scene) {
  std::vector<Violation> violations = Validate(options.region, scene.geometry());
  if (options.ground_step_m)
    CheckRange("ground_step_m", *options.ground_step_m, {0.05, 100.0}, " m", &violations);
  CheckRange("texture_px", options.texture_px, {16, 8192}, " px", &violations);
  CheckRange("detail", options.detail, {0, kMeshDetails - 1}, "", &violations);
  return Status::FromViolations("glTF", std::move(violations));
}

Result<std::string> WorldGlb(const Scene& scene, const SpeciesCatalogue& species,
                             const WorldGlbOptions& options, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, scene));
  return WorldGlbBuilder(scene, species, options, progress).Build();
}

}  // namespace latticeworld
