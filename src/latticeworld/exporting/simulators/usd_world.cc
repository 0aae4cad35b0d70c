#include "latticeworld/exporting/simulators/usd_world.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/exporting/chosen_assets.h"
#include "latticeworld/exporting/gltf/media.h"
#include "latticeworld/exporting/gltf/model_mesh.h"
#include "latticeworld/exporting/ground_mesh.h"
#include "latticeworld/exporting/simulators/usd_land.h"
#include "latticeworld/exporting/simulators/usd_text.h"
#include "latticeworld/exporting/simulators/usd_things.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "usd";
constexpr float kThinnest_m = 1e-3f;
constexpr double kSunIntensity = 3000.0, kSkyIntensity = 800.0;  // of a clear noon

Eigen::Vector3f SizeOf(const Asset& asset) {
  return Eigen::Vector3f(asset.half_length_m, asset.half_width_m, asset.height_m)
      .cwiseMax(kThinnest_m);
}

// What a PointInstancer is made of.
struct Instances {
  std::vector<std::string> prototypes;      // paths
  UsdText looks{4};                         // the prims of these
  std::vector<std::uint32_t> numbers, ids;  // of the prototype, of the asset
  std::vector<Eigen::Vector3f> places_m, sizes_m;
  std::vector<double> yaws_rad;
  UsdExtent extent;
};

std::string Turns(const std::vector<double>& yaws_rad) {
  std::string text = "[";
  for (const double yaw_rad : yaws_rad) {
    if (text.size() > 1) text += ", ";
    text += UsdTuple({std::cos(0.5 * yaw_rad), 0.0, 0.0, std::sin(0.5 * yaw_rad)});
  }
  return text + "]";
}

class UsdBuilder {
 public:
  UsdBuilder(const Scene& scene, const std::optional<GeoOrigin>& origin, const UsdOptions& options,
             const Progress& progress)
      : scene_(scene), names_(scene), origin_(origin), options_(options), progress_(progress) {
    region_ = options.region.value_or(WholeWorld(scene.geometry()));
  }

  Result<std::vector<ExportFile>> Build(const std::string& name) {
    const ExportRegion land =
        BetweenCenters(CellsIn(region_, scene_.geometry()), scene_.geometry());
    LW_RETURN_IF_ERROR(Advance(0.0));
    LW_ASSIGN_OR_RETURN(std::string jpeg, GroundTexture(scene_, land, options_.texture_px));
    const SurfaceLattice lattice = MakeLattice(
        land, options_.ground_step_m.value_or(scene_.geometry().resolution_m()), kMostUsdVertices);
    AddUsdGround(scene_, lattice, &looks_, &world_);
    LW_RETURN_IF_ERROR(Advance(0.3));
    AddUsdWater(scene_, lattice, &world_);
    AddLights();
    LW_RETURN_IF_ERROR(AddAssets());
    AddProps();
    AddStarts();
    std::vector<ExportFile> files;
    files.push_back({"world.usda", Stage(name)});
    files.push_back({"ground.jpg", std::move(jpeg)});
    return files;
  }

 private:
  Status Advance(double fraction) const {
    progress_.Report(kStage, fraction);
    return progress_.CheckCancelled();
  }
  // Returns the place of the stage's origin in the frame map [m].
  Eigen::Vector3d Middle() const {
    if (!options_.region) return Eigen::Vector3d::Zero();
    return {region_.center().x_m, region_.center().y_m, 0.0};
  }

  std::string Stage(const std::string& name) {
    std::string text = "#usda 1.0\n(\n  customLayerData = {\n    dictionary latticeworld = {\n";
    if (origin_) {
      text += "      double3 geo = " +
              UsdTuple({origin_->latitude_deg, origin_->longitude_deg, origin_->altitude_m}) + "\n";
    }
    text += "      double3 map_origin = " + UsdTuple(Middle()) +
            "\n      string world = " + UsdQuoted(name) +
            "\n    }\n  }\n  defaultPrim = \"World\"\n  doc = \"Metres, x east, y north, z up; "
            "children of /World are in the frame map.\"\n  kilogramsPerUnit = 1\n"
            "  metersPerUnit = 1\n  upAxis = \"Z\"\n)\n\n";
    UsdText stage;
    stage.Open({"Xform", "World"});
    if (options_.region) stage.Place(-Middle(), 0.0);
    stage.Open({"PhysicsScene", "physics"});
    stage.Value("vector3f physics:gravityDirection", "(0, 0, -1)");
    stage.Number("float physics:gravityMagnitude", 9.81);
    stage.Close();
    AddScope("looks", std::move(looks_), /*is_abstract=*/false, &stage);
    AddScope("models", std::move(models_), /*is_abstract=*/true, &stage);
    stage.Append(std::move(world_));
    AddScope("assets", std::move(assets_), /*is_abstract=*/false, &stage);
    AddScope("solids", std::move(solids_), /*is_abstract=*/false, &stage);
    AddScope("elements", std::move(props_), /*is_abstract=*/false, &stage);
    AddScope("starts", std::move(starts_), /*is_abstract=*/false, &stage);
    stage.Close();
    return text + stage.Take();
  }

  static void AddScope(const char* name, UsdText content, bool is_abstract, UsdText* stage) {
    UsdPrim scope = {"Scope", name};
    scope.is_abstract = is_abstract;
    stage->Open(scope);
    stage->Append(std::move(content));
    stage->Close();
  }

  void AddLights() {
    // At night the sun is below; light from there would be of no use.
    Eigen::Vector3d sun = scene_.atmosphere.sun_direction;
    sun.z() = std::max(0.05, sun.z());
    sun.normalize();
    const double light = std::clamp(scene_.atmosphere.sun_intensity, 0.0, 1.0);
    world_.Open({"DistantLight", "sun"});
    world_.Number("float inputs:angle", 0.53);
    world_.Number("float inputs:intensity", kSunIntensity * light);
    // It shines along its -z: turned from z to the sun, about y and then about z.
    world_.Number("double xformOp:rotateZ", std::atan2(sun.y(), sun.x()) * 180.0 / M_PI);
    world_.Number("double xformOp:rotateY", std::acos(sun.z()) * 180.0 / M_PI);
    world_.Value("uniform token[] xformOpOrder", R"(["xformOp:rotateZ", "xformOp:rotateY"])");
    world_.Close();
    world_.Open({"DomeLight", "sky"});
    world_.Value("color3f inputs:color", "(0.62, 0.74, 0.86)");
    world_.Number("float inputs:intensity",
                  kSkyIntensity * std::clamp(scene_.atmosphere.ambient_intensity, 0.05, 1.0));
    world_.Close();
  }

  Status AddAssets() {
    const auto chosen = ChooseAssets(scene_, region_, options_.small_plants);
    std::size_t prims = 0;
    for (const std::uint32_t number : chosen) {
      const Asset& asset = scene_.assets[number];
      const Collision form = scene_.catalogue->models()[asset.model].collision;
      if (options_.expand || form != Collision::kNone) ++prims;
      if (form != Collision::kNone)
        AddUsdSolid(asset, form, names_.Of(number) + "_solid", &solids_);
    }
    if (prims > kMostUsdThings)
      return TooMany(prims, "things with prims of their own", kMostUsdThings,
                     options_.expand && options_.small_plants);
    const auto groups = GroupAssets(scene_, chosen);
    std::map<std::string, Instances> kinds;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      LW_RETURN_IF_ERROR(Advance(0.4 + 0.5 * static_cast<double>(i) / groups.size()));
      const std::string kind =
          internal::PlainName(std::string(NameOf(scene_.assets[groups[i].members[0]].kind)));
      const std::string look = internal::PlainName(groups[i].name) + "_" + std::to_string(i);
      if (options_.expand) {
        AddExpanded(groups[i], look);
      } else {
        AddInstances(groups[i], look, kind, &kinds[kind]);
      }
    }
    for (auto& [kind, instances] : kinds) AddInstancer(kind, &instances);
    return Status();
  }

  // Path of a model's mesh, which is written when it first comes, in its unit box.
  const std::string& ModelPath(const LookGroup& group) {
    std::string& path = model_paths_[group.model];
    if (!path.empty()) return path;
    const std::string name =
        internal::PlainName(group.model) + "_" + std::to_string(model_paths_.size() - 1);
    path = "/World/models/" + name;
    const Asset& example = scene_.assets[group.members.front()];
    const auto& variants = scene_.catalogue->season_variants(TypeOf(example.kind));
    const Mesh mesh = BuildMesh(scene_.catalogue->models()[example.model],
                                variants[example.season_variant].foliage, options_.detail,
                                MeshVariationOf(example));
    UsdExtent& extent = extents_[path];
    for (const Eigen::Vector3f& vertex : mesh.vertices) extent.Add(vertex);
    std::vector<std::uint32_t> corners, parts;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      corners.insert(corners.end(), mesh.triangles[i].begin(), mesh.triangles[i].end());
      parts.push_back(static_cast<std::uint32_t>(mesh.parts[i]));
    }
    models_.Open({"Mesh", name});
    models_.Value("uniform bool doubleSided", "true");  // leaves are open surfaces
    models_.Value("float3[] extent", extent.Text());
    models_.Value("int[] faceVertexCounts",
                  UsdArray(std::vector<std::uint32_t>(mesh.triangles.size(), 3)));
    models_.Value("int[] faceVertexIndices", UsdArray(corners));
    models_.Value("point3f[] points", UsdArray(mesh.vertices));
    models_.Value("int[] primvars:displayColor:indices", UsdArray(parts));
    models_.Value("uniform token subdivisionScheme", "\"none\"");
    models_.Close();
    return path;
  }

  // An Xform with the mesh in its colours, one a part.
  void AddLook(const LookGroup& group, const UsdPrim& prim, UsdText* text) {
    UsdPrim mesh = {"Mesh", "mesh"};
    mesh.reference = ModelPath(group);
    const ModelColors colors = MeanColors(scene_, group.members);
    text->Open(prim);
    text->Label(NameOf(scene_.assets[group.members.front()].kind));
    text->Open(mesh);
    text->Primvar("color3f[] primvars:displayColor", "uniform",
                  UsdArray(std::vector<Eigen::Vector3f>(colors.begin(), colors.end())));
    text->Close();
    text->Close();
  }

  void AddInstances(const LookGroup& group, const std::string& look, const std::string& kind,
                    Instances* instances) {
    AddLook(group, {"Xform", look, {"SemanticsLabelsAPI:class"}}, &instances->looks);
    const auto prototype = static_cast<std::uint32_t>(instances->prototypes.size());
    instances->prototypes.push_back("/World/assets/" + kind + "/prototypes/" + look);
    const UsdExtent& unit = extents_[ModelPath(group)];
    for (const std::uint32_t number : group.members) {
      const Asset& asset = scene_.assets[number];
      instances->numbers.push_back(prototype);
      instances->ids.push_back(number);
      instances->places_m.emplace_back(asset.x_m, asset.y_m, asset.z_m);
      instances->sizes_m.push_back(SizeOf(asset));
      instances->yaws_rad.push_back(asset.yaw_rad);
      const Eigen::AngleAxisf turn(asset.yaw_rad, Eigen::Vector3f::UnitZ());
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3f at((corner & 1 ? unit.high : unit.low).x(),
                                 (corner & 2 ? unit.high : unit.low).y(),
                                 (corner & 4 ? unit.high : unit.low).z());
        instances->extent.Add(instances->places_m.back() +
                              turn * at.cwiseProduct(instances->sizes_m.back()));
      }
    }
  }

  void AddInstancer(const std::string& kind, Instances* instances) {
    assets_.Open({"PointInstancer", kind, {"SemanticsLabelsAPI:class"}});
    assets_.Value("float3[] extent", instances->extent.Text());
    assets_.Value("int64[] ids", UsdArray(instances->ids));
    // Halves, for readers of before 2025, turn a long house by a millimetre or two.
    assets_.Value("quath[] orientations", Turns(instances->yaws_rad));
    assets_.Value("quatf[] orientationsf", Turns(instances->yaws_rad));
    assets_.Value("point3f[] positions", UsdArray(instances->places_m));
    assets_.Value("int[] protoIndices", UsdArray(instances->numbers));
    assets_.Relation("prototypes", instances->prototypes);
    assets_.Value("float3[] scales", UsdArray(instances->sizes_m));
    assets_.Label(NameOf(scene_.assets[instances->ids.front()].kind));
    assets_.Open({"Scope", "prototypes"});
    assets_.Append(std::move(instances->looks));
    assets_.Close();
    assets_.Close();
  }

  void AddExpanded(const LookGroup& group, const std::string& look) {
    UsdPrim prim = {"Xform", look, {"SemanticsLabelsAPI:class"}};
    AddLook(group, prim, &models_);
    for (const std::uint32_t number : group.members) {
      const Asset& asset = scene_.assets[number];
      UsdPrim thing = {"Xform", names_.Of(number)};
      thing.reference = "/World/models/" + look;
      thing.is_instance = true;
      assets_.Open(thing);
      assets_.Place({asset.x_m, asset.y_m, asset.z_m}, asset.yaw_rad, SizeOf(asset).cast<double>());
      assets_.Close();
    }
  }

  void AddProps() {
    for (const Prop& prop : scene_.props) {
      if (region_.Holds(prop.position)) AddUsdProp(prop, &props_);
    }
  }

  void AddStarts() {
    for (const AgentStart& agent : scene_.agents) {
      if (!region_.Holds(agent.position)) continue;
      const double z_m =
          scene_.terrain->ground.HeightAt(agent.position) + agent.height_above_ground_m;
      starts_.Open({"Xform", "start_" + agent.name});
      starts_.Place({agent.position.x_m, agent.position.y_m, z_m}, agent.heading_rad);
      starts_.Close();
    }
  }

  const Scene& scene_;
  const PartNames names_;
  const std::optional<GeoOrigin>& origin_;
  const UsdOptions& options_;
  const Progress& progress_;
  ExportRegion region_;
  UsdText looks_{2}, models_{2}, world_{1}, assets_{2}, solids_{2}, props_{2}, starts_{2};
  std::map<std::string, std::string> model_paths_;  // by model
  std::map<std::string, UsdExtent> extents_;        // by path
};

}  // namespace

Status Validate(const UsdOptions& options, const Scene& scene) {
  std::vector<Violation> violations =
      ValidateGround(options.region, scene.geometry(), "a ground has at least two vertices");
  if (options.ground_step_m)
    CheckRange("ground_step_m", *options.ground_step_m, {0.05, 100.0}, " m", &violations);
  CheckRange("texture_px", options.texture_px, {16, 8192}, " px", &violations);
  CheckRange("detail", options.detail, {0, kMeshDetails - 1}, "", &violations);
  return Status::FromViolations("USD", std::move(violations));
}

Result<std::vector<ExportFile>> UsdFiles(const Scene& scene, const std::string& name,
                                         const std::optional<GeoOrigin>& origin,
                                         const UsdOptions& options, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, scene));
  return UsdBuilder(scene, origin, options, progress).Build(name);
}

}  // namespace latticeworld
