#include "latticeworld/exporting/simulators/sdf_world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/exporting/chosen_assets.h"
#include "latticeworld/exporting/gltf/media.h"
#include "latticeworld/exporting/ground_mesh.h"
#include "latticeworld/exporting/simulators/obj_mesh.h"
#include "latticeworld/exporting/simulators/sdf_text.h"
#include "latticeworld/exporting/simulators/sdf_things.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/motion/geodesy.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "sdf";
constexpr char kMedia[] = "latticeworld_media/";
constexpr double kStep_s = 0.004;  // usual of ODE in Gazebo
constexpr int kFewestVertices = 17, kMostVertices = 4097, kUsualMostVertices = 2049;
constexpr float kThinnest_m = 1e-3f;

std::string UriOf(const std::string& file) { return std::string("model://") + kMedia + file; }

// Ten decimals of a degree are a hundredth of a millimetre.
std::string DegreesText(double degrees) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.10f", degrees);
  return text;
}

bool IsHeightmapSize(int vertices) {
  const int cells = vertices - 1;
  return vertices >= kFewestVertices && vertices <= kMostVertices && (cells & (cells - 1)) == 0;
}

int HeightmapSizeFor(const ExportRegion& region, double resolution_m) {
  int vertices = kFewestVertices;
  while (vertices < kUsualMostVertices && region.width_m() / (vertices - 1) > resolution_m * 1.001)
    vertices = 2 * (vertices - 1) + 1;
  return vertices;
}

class SdfBuilder {
 public:
  SdfBuilder(const Scene& scene, const std::optional<GeoOrigin>& origin, const SdfOptions& options,
             const Progress& progress)
      : scene_(scene), names_(scene), origin_(origin), options_(options), progress_(progress) {
    region_ = options.region.value_or(WholeWorld(scene.geometry()));
    if (options.region) middle_m_ = {region_.center().x_m, region_.center().y_m, 0.0};
  }

  Result<std::vector<ExportFile>> Build(const std::string& name) {
    SdfText world;
    world.Open("world", name);
    AddWorldWide(&world);
    LW_RETURN_IF_ERROR(AddGround(&world));
    LW_RETURN_IF_ERROR(AddWater(&world));
    LW_RETURN_IF_ERROR(AddAssets(&world));
    AddProps(&world);
    AddBridges(&world);
    world.Close("world");
    files_.insert(files_.begin(), {"world.sdf", world.Take()});
    return std::move(files_);
  }

 private:
  Status Advance(double fraction) const {
    progress_.Report(kStage, fraction);
    return progress_.CheckCancelled();
  }
  void AddFile(const std::string& name, std::string content) {
    files_.push_back({kMedia + name, std::move(content)});
  }
  Eigen::Vector3d Local(double x_m, double y_m, double z_m) const {
    return Eigen::Vector3d(x_m, y_m, z_m) - middle_m_;
  }

  void AddWorldWide(SdfText* world) {
    const Atmosphere& air = scene_.atmosphere;
    world->Open("physics", "default", "ode");
    world->Numbers("max_step_size", {kStep_s});
    world->Numbers("real_time_factor", {1.0});
    world->Numbers("real_time_update_rate", {1.0 / kStep_s});
    world->Close("physics");
    world->Leaf("gravity", "0 0 -9.80665");
    const double ambient = std::clamp(air.ambient_intensity, 0.05, 1.0);
    world->Open("scene");
    world->Numbers("ambient", {ambient, ambient, ambient, 1.0});
    world->Numbers("background", {0.62, 0.74, 0.86, 1.0});
    world->Leaf("shadows", "true");
    world->Close("scene");
    if (origin_) {
      world->Open("spherical_coordinates");
      world->Leaf("surface_model", "EARTH_WGS84");
      world->Leaf("world_frame_orientation", "ENU");
      // The place is where the middle of the region lies on the ellipsoid.
      const GeoPoint middle = GeoPointAt(*origin_, {middle_m_.x(), middle_m_.y(), 0.0});
      world->Leaf("latitude_deg", DegreesText(middle.latitude_deg));
      world->Leaf("longitude_deg", DegreesText(middle.longitude_deg));
      world->Numbers("elevation", {origin_->altitude_m});
      world->Leaf("heading_deg", "0");
      world->Close("spherical_coordinates");
    }
    const Eigen::Vector3d sun = air.sun_direction;
    const double light = std::clamp(air.sun_intensity, 0.0, 1.0);
    world->Open("light", "sun", "directional");
    world->Leaf("cast_shadows", "true");
    world->Numbers("diffuse", {light, light, light, 1.0});
    world->Leaf("specular", "0.1 0.1 0.1 1");
    // At night the sun is below; light from there would be of no use.
    world->Numbers("direction", {-sun.x(), -sun.y(), -std::max(0.05, sun.z())});
    world->Close("light");
  }

  void AddHeightmap(SdfText* text, double low_m, double range_m, bool textured) {
    text->Open("geometry");
    text->Open("heightmap");
    text->Leaf("uri", UriOf("heightmap.png"));
    text->Numbers("size", {region_.width_m(), region_.depth_m(), range_m});
    text->Numbers("pos", {0.0, 0.0, low_m});
    if (textured) {
      text->Open("texture");
      text->Numbers("size", {region_.width_m()});
      text->Leaf("diffuse", UriOf("ground.jpg"));
      text->Leaf("normal", UriOf("flat.png"));
      text->Close("texture");
    }
    text->Close("heightmap");
    text->Close("geometry");
  }

  void AddGroundModel(SdfText* text, double low_m, double range_m) {
    text->Open("model", "ground");
    text->Leaf("static", "true");
    text->Open("link", "link");
    text->Open("collision", "collision");
    AddHeightmap(text, low_m, range_m, false);
    text->Close("collision");
    text->Open("visual", "visual");
    AddHeightmap(text, low_m, range_m, true);
    text->Close("visual");
    text->Close("link");
    text->Close("model");
  }

  Status AddGround(SdfText* world) {
    LW_RETURN_IF_ERROR(Advance(0.0));
    // Heights are taken at the heightmap's vertices.
    const int vertices = options_.heightmap_vertices > 0
                             ? options_.heightmap_vertices
                             : HeightmapSizeFor(region_, scene_.geometry().resolution_m());
    const SurfaceLattice lattice = {region_, vertices, vertices};
    Grid<float> heights(vertices, vertices);
    for (int row = 0; row < vertices; ++row) {
      for (int col = 0; col < vertices; ++col)
        heights(row, col) =
            static_cast<float>(scene_.terrain->ground.HeightAt(lattice.PointOf(row, col)));
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const double low_m = *low;
    // Readers want some height; and the highest value has to be there for those that stretch.
    constexpr double kLeastRange_m = 0.01;
    const double range_m = std::max(kLeastRange_m, static_cast<double>(*high) - low_m);
    // The picture has their shares of the range.
    const int most = options_.heightmap_bits == 16 ? 65535 : 255;
    cv::Mat picture(vertices, vertices, options_.heightmap_bits == 16 ? CV_16UC1 : CV_8UC1);
    for (int row = 0; row < vertices; ++row) {
      for (int col = 0; col < vertices; ++col) {
        const long step = std::lround((heights(row, col) - low_m) / range_m * most);
        if (options_.heightmap_bits == 16)
          picture.at<std::uint16_t>(row, col) = static_cast<std::uint16_t>(step);
        else
          picture.at<std::uint8_t>(row, col) = static_cast<std::uint8_t>(step);
      }
    }
    // The files are heights, colours, a flat normal map, and a model that other worlds can use.
    LW_ASSIGN_OR_RETURN(std::string png, internal::EncodePng(picture));
    AddFile("heightmap.png", std::move(png));
    LW_ASSIGN_OR_RETURN(std::string jpeg, GroundTexture(scene_, region_, options_.texture_px));
    AddFile("ground.jpg", std::move(jpeg));
    LW_ASSIGN_OR_RETURN(std::string flat,
                        internal::EncodePng(cv::Mat(8, 8, CV_8UC3, cv::Scalar(255, 128, 128))));
    AddFile("flat.png", std::move(flat));
    AddGroundModel(world, low_m, range_m);
    SdfText model;
    AddGroundModel(&model, low_m, range_m);
    AddFile("model.sdf", model.Take());
    AddFile("model.config",
            "<?xml version=\"1.0\"?>\n<model>\n  <name>latticeworld_media</name>\n"
            "  <version>1.0</version>\n  <sdf version=\"1.7\">model.sdf</sdf>\n"
            "  <description>Ground, textures and meshes of a LatticeWorld.</description>\n"
            "</model>\n");
    return Advance(0.3);
  }

  Status AddWater(SdfText* world) {
    const SurfaceMesh water =
        WaterMesh(*scene_.terrain,
                  MakeLattice(region_, scene_.geometry().resolution_m(), kUsualMostVertices));
    if (water.corners.empty()) return Status();
    AddFile("meshes/water.obj", ToObj(water, -middle_m_.cast<float>()));
    world->Open("model", "water");
    world->Leaf("static", "true");
    world->Open("link", "link");
    world->Open("visual", "visual");
    world->Open("geometry");
    world->Open("mesh");
    world->Leaf("uri", UriOf("meshes/water.obj"));
    world->Close("mesh");
    world->Close("geometry");
    world->Open("material");
    world->Leaf("ambient", "0.1 0.22 0.26 0.75");
    world->Leaf("diffuse", "0.16 0.32 0.36 0.75");
    world->Leaf("specular", "0.4 0.4 0.4 1");
    world->Close("material");
    world->Numbers("transparency", {0.3});
    world->Close("visual");
    world->Close("link");
    world->Close("model");
    return Advance(0.4);
  }

  Status AddAssets(SdfText* world) {
    const auto chosen = ChooseAssets(scene_, region_, options_.small_plants);
    if (chosen.size() > kMostSdfThings)
      return TooMany(chosen.size(), "things", kMostSdfThings, options_.small_plants);
    std::set<std::string> meshes;
    const auto groups = GroupAssets(scene_, chosen);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      LW_RETURN_IF_ERROR(Advance(0.4 + 0.6 * static_cast<double>(i) / groups.size()));
      AddGroup(groups[i], static_cast<int>(i), world);
    }
    return Status();
  }

  // Static things of one mesh and look: each a visual and, where it is solid, a collision.
  void AddGroup(const LookGroup& group, int number, SdfText* world) {
    const Asset& example = scene_.assets[group.members.front()];
    const AssetModel& model = scene_.catalogue->models()[example.model];
    const auto& variants = scene_.catalogue->season_variants(TypeOf(example.kind));
    const Mesh mesh = BuildMesh(model, variants[example.season_variant].foliage, options_.detail,
                                MeshVariationOf(example));
    const std::string name =
        names_.Unlike(internal::PlainName(group.name) + "_" + std::to_string(number));
    AddFile("meshes/" + name + ".obj", ToObj(mesh, name + ".mtl"));
    AddFile("meshes/" + name + ".mtl", ToMtl(MeanColors(scene_, group.members)));
    world->Open("model", name);
    world->Leaf("static", "true");
    world->Open("link", "link");
    for (const std::uint32_t member : group.members) {
      const Asset& asset = scene_.assets[member];
      const Eigen::Vector3d base = Local(asset.x_m, asset.y_m, asset.z_m);
      world->Open("visual", names_.Of(member));
      world->Pose(base, asset.yaw_rad);
      world->Open("geometry");
      world->Open("mesh");
      world->Leaf("uri", UriOf("meshes/" + name + ".obj"));
      world->Numbers("scale", {std::max(kThinnest_m, asset.half_length_m),
                               std::max(kThinnest_m, asset.half_width_m),
                               std::max(kThinnest_m, asset.height_m)});
      world->Close("mesh");
      world->Close("geometry");
      world->Close("visual");
      if (model.collision != Collision::kNone) {
        AddSdfCollision(asset, model.collision, base, names_.Of(member) + "_solid", world);
      }
    }
    world->Close("link");
    world->Close("model");
  }

  void AddProps(SdfText* world) {
    for (const Prop& prop : scene_.props) {
      if (region_.Holds(prop.position)) {
        AddSdfProp(prop, names_.Of(prop), Local(prop.position.x_m, prop.position.y_m, prop.z_m),
                   world);
      }
    }
  }

  void AddBridges(SdfText* world) {
    const std::vector<Bridge>& bridges = scene_.terrain->bridges;
    for (std::size_t i = 0; i < bridges.size(); ++i) {
      const Bridge& bridge = bridges[i];
      if (!region_.Holds(PlaceOn(bridge, 0.5 * bridge.length_m()).point)) continue;
      AddSdfBridge(bridge, PartsOf(bridge, scene_.terrain->ground),
                   "road_bridge_" + std::to_string(i + 1), -Local(0.0, 0.0, 0.0), world);
    }
  }

  const Scene& scene_;
  const PartNames names_;
  const std::optional<GeoOrigin>& origin_;
  const SdfOptions& options_;
  const Progress& progress_;
  ExportRegion region_;
  Eigen::Vector3d middle_m_ = Eigen::Vector3d::Zero();
  std::vector<ExportFile> files_;
};

}  // namespace

Status Validate(const SdfOptions& options, const Scene& scene) {
  std::vector<Violation> violations = Validate(options.region, scene.geometry());
  if (options.region && violations.empty() &&
      std::abs(options.region->width_m() - options.region->depth_m()) > 1e-6) {
    violations.push_back({"not_square", "region",
                          "a height map is square: legal is a region as wide as it is deep", ""});
  }
  if (options.heightmap_vertices != 0 && !IsHeightmapSize(options.heightmap_vertices)) {
    violations.push_back({"not_legal", "heightmap_vertices",
                          std::to_string(options.heightmap_vertices) +
                              " is no legal size; legal are 2^n + 1 from 17 to 4097, or 0",
                          std::to_string(options.heightmap_vertices)});
  }
  if (options.heightmap_bits != 8 && options.heightmap_bits != 16) {
    violations.push_back({"not_legal", "heightmap_bits",
                          std::to_string(options.heightmap_bits) + " given; legal are 8 and 16",
                          std::to_string(options.heightmap_bits)});
  }
  CheckRange("texture_px", options.texture_px, {16, 8192}, " px", &violations);
  CheckRange("detail", options.detail, {0, kMeshDetails - 1}, "", &violations);
  return Status::FromViolations("SDF", std::move(violations));
}

Result<std::vector<ExportFile>> SdfFiles(const Scene& scene, const std::string& name,
                                         const std::optional<GeoOrigin>& origin,
                                         const SdfOptions& options, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, scene));
  return SdfBuilder(scene, origin, options, progress).Build(name);
}

}  // namespace latticeworld
