#include "latticeworld/exporting/simulators/mjcf_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/exporting/bytes.h"
#include "latticeworld/exporting/chosen_assets.h"
#include "latticeworld/exporting/gltf/media.h"
#include "latticeworld/exporting/ground_mesh.h"
#include "latticeworld/exporting/simulators/mjcf_text.h"
#include "latticeworld/exporting/simulators/mjcf_things.h"
#include "latticeworld/exporting/simulators/obj_mesh.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/sensing/motion/geodesy.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "mjcf";
constexpr double kStep_s = 0.002;           // usual of MuJoCo
constexpr double kGroundThickness_m = 2.0;  // below its lowest height
constexpr double kLeastRange_m = 0.01;      // of heights: MuJoCo wants some
constexpr double kNearest_m = 0.1;          // that cameras see
constexpr int kMostWaterVertices = 513;     // a side
constexpr float kThinnest_m = 1e-3f;
// Torsional and rolling, usual of MuJoCo.
constexpr double kTorsion_m = 0.005, kRolling_m = 0.0001;

// A JPEG of the ground, north up, as the turned height field wears it.
Result<std::string> TurnedPng(const std::string& jpeg) {
  cv::Mat turned;
  try {
    const cv::Mat picture =
        cv::imdecode(std::vector<unsigned char>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
    cv::rotate(picture, turned, cv::ROTATE_90_CLOCKWISE);
  } catch (const cv::Exception& error) {
    return Internal(std::string("cannot turn the ground's colours: ") + error.what());
  }
  return internal::EncodePng(turned);
}

// The columns of ToPaletteObj; readers blend columns that are too narrow.
Result<std::string> PalettePng(const ModelColors& colors) {
  constexpr int kColumn_px = 4;
  cv::Mat picture(kColumn_px, kMeshPartCount * kColumn_px, CV_8UC3);
  const auto byte = [](float linear) {
    return static_cast<std::uint8_t>(
        std::lround(255.0f * std::clamp(FromLinear(linear), 0.0f, 1.0f)));
  };
  for (int part = 0; part < kMeshPartCount; ++part) {
    const Eigen::Vector3f& color = colors[part];
    picture.colRange(part * kColumn_px, (part + 1) * kColumn_px)
        .setTo(cv::Scalar(byte(color.z()), byte(color.y()), byte(color.x())));
  }
  return internal::EncodePng(picture);
}

// The nearest step of a tenth.
float Stepped(float size_m) {
  const double step = std::log(kMjcfSizeStep);
  const double steps = std::round(std::log(std::max(kThinnest_m, size_m)) / step);
  return static_cast<float>(std::exp(steps * step));
}

class MjcfBuilder {
 public:
  MjcfBuilder(const Scene& scene, const std::optional<GeoOrigin>& origin,
              const MjcfOptions& options, const Progress& progress)
      : scene_(scene), names_(scene), origin_(origin), options_(options), progress_(progress) {
    region_ = options.region.value_or(WholeWorld(scene.geometry()));
    cells_ = CellsIn(region_, scene.geometry());
    centers_ = BetweenCenters(cells_, scene.geometry());
    if (options.region) middle_m_ = {region_.center().x_m, region_.center().y_m, 0.0};
  }

  Result<std::vector<ExportFile>> Build(const std::string& name) {
    LW_RETURN_IF_ERROR(AddGround());
    LW_RETURN_IF_ERROR(AddWater());
    LW_RETURN_IF_ERROR(AddAssets());
    AddProps();
    AddBridges();
    AddStarts();
    MjcfText model;
    model.Open("mujoco", {{"model", name}});
    model.Comment("Metres, x east, y north, z up; map_origin is where the origin lies in the map.");
    AddWorldWide(&model);
    model.Open("asset");
    model.Append(std::move(asset_));
    model.Close("asset");
    model.Open("worldbody");
    AddSun(&model);
    model.Append(std::move(body_));
    model.Close("worldbody");
    model.Close("mujoco");
    files_.insert(files_.begin(), {"world.xml", model.Take()});
    return std::move(files_);
  }

 private:
  Status Advance(double fraction) const {
    progress_.Report(kStage, fraction);
    return progress_.CheckCancelled();
  }
  Eigen::Vector3d Local(double x_m, double y_m, double z_m) const {
    return Eigen::Vector3d(x_m, y_m, z_m) - middle_m_;
  }
  // Half of what there is to be seen.
  double Extent() const { return 0.5 * std::max(region_.width_m(), region_.depth_m()); }
  Eigen::Vector3d Center() const {
    const WorldPoint middle = region_.center();
    return Local(middle.x_m, middle.y_m, 0.5 * (low_m_ + high_m_));
  }

  void AddWorldWide(MjcfText* model) const {
    model->Leaf("compiler", {{"angle", "radian"}});
    model->Leaf("option", {{"timestep", MjcfNumbers({kStep_s})}, {"gravity", "0 0 -9.81"}});
    model->Leaf("statistic",
                {{"extent", MjcfNumbers({Extent()})}, {"center", MjcfNumbers(Center())}});
    const double ambient = std::clamp(scene_.atmosphere.ambient_intensity, 0.05, 1.0);
    model->Open("visual");
    model->Leaf("global", {{"offwidth", "1280"}, {"offheight", "720"}});
    model->Leaf("headlight", {{"ambient", MjcfNumbers({ambient, ambient, ambient})},
                              {"diffuse", "0 0 0"},
                              {"specular", "0 0 0"}});
    // MuJoCo takes znear as a share of the extent.
    model->Leaf("map", {{"znear", MjcfNumbers({kNearest_m / Extent()})}});
    model->Close("visual");
    model->Open("default");
    AddClass("seen", {{"type", "mesh"}, {"contype", "0"}, {"conaffinity", "0"}, {"group", "2"}},
             model);
    AddClass("solid", {{"group", "3"}}, model);
    AddClass("element", {{"group", "1"}}, model);
    model->Close("default");
    AddCustom(model);
  }

  static void AddClass(const char* name, const MjcfAttributes& geom, MjcfText* model) {
    model->Open("default", {{"class", name}});
    model->Leaf("geom", geom);
    model->Close("default");
  }

  void AddCustom(MjcfText* model) const {
    model->Open("custom");
    model->Leaf("numeric", {{"name", "map_origin"}, {"data", MjcfNumbers(middle_m_)}});
    if (origin_) {
      const GeoPoint middle = GeoPointAt(*origin_, {middle_m_.x(), middle_m_.y(), 0.0});
      model->Leaf("numeric", {{"name", "geo"},
                              {"data", MjcfNumbers({middle.latitude_deg, middle.longitude_deg,
                                                    origin_->altitude_m})}});
    }
    const SurfaceTable surfaces(scene_, scene_.atmosphere.ground());
    for (const auto& entry : EnumNames(SurfaceClass{})) {
      if (cells_of_class_[static_cast<std::size_t>(entry.value)] == 0) continue;
      model->Leaf("numeric", {{"name", "friction_" + internal::PlainName(std::string(entry.name))},
                              {"data", MjcfNumbers({surfaces.Of(entry.value).friction})}});
    }
    model->Close("custom");
  }

  void AddSun(MjcfText* model) const {
    // At night the sun is below; light from there would be of no use.
    Eigen::Vector3d sun = scene_.atmosphere.sun_direction;
    sun.z() = std::max(0.05, sun.z());
    const double light = std::clamp(scene_.atmosphere.sun_intensity, 0.0, 1.0);
    model->Leaf("light", {{"name", "sun"},
                          {"directional", "true"},
                          {"pos", MjcfNumbers(Center() + Extent() * sun)},
                          {"dir", MjcfNumbers(-sun)},
                          {"diffuse", MjcfNumbers({light, light, light})},
                          {"specular", "0.1 0.1 0.1"}});
  }

  // Encodes heights as shares of their range, the world's columns from east to west, each from
  // south to north.
  std::string HeightFieldBytes() const {
    const Grid<float>& height_m = scene_.terrain->ground.height_m();
    std::string content;
    content.reserve(8 + sizeof(float) * static_cast<std::size_t>(cells_.rows()) * cells_.cols());
    Bytes bytes(&content);
    bytes.Add(static_cast<std::int32_t>(cells_.cols()));
    bytes.Add(static_cast<std::int32_t>(cells_.rows()));
    const double range_m = high_m_ - low_m_;
    for (int col = cells_.last_col; col >= cells_.first_col; --col) {
      for (int row = cells_.last_row; row >= cells_.first_row; --row) {
        bytes.Add(range_m > 0.0 ? static_cast<float>((height_m(row, col) - low_m_) / range_m)
                                : 0.0f);
      }
    }
    return content;
  }

  void LookAtCells() {
    const Terrain& terrain = *scene_.terrain;
    const Grid<float>& height_m = terrain.ground.height_m();
    low_m_ = high_m_ = height_m(cells_.first_row, cells_.first_col);
    for (int row = cells_.first_row; row <= cells_.last_row; ++row) {
      for (int col = cells_.first_col; col <= cells_.last_col; ++col) {
        low_m_ = std::min<double>(low_m_, height_m(row, col));
        high_m_ = std::max<double>(high_m_, height_m(row, col));
        ++cells_of_class_[static_cast<std::size_t>(terrain.surface(row, col))];
      }
    }
  }

  double MeanFriction() const {
    const SurfaceTable surfaces(scene_, scene_.atmosphere.ground());
    double sum = 0.0, cells = 0.0;
    for (const auto& entry : EnumNames(SurfaceClass{})) {
      const double of_class = cells_of_class_[static_cast<std::size_t>(entry.value)];
      sum += of_class * surfaces.Of(entry.value).friction;
      cells += of_class;
    }
    return sum / cells;
  }

  Status AddGround() {
    LW_RETURN_IF_ERROR(Advance(0.0));
    LookAtCells();
    files_.push_back({"ground.hfield", HeightFieldBytes()});
    LW_ASSIGN_OR_RETURN(const std::string jpeg,
                        GroundTexture(scene_, centers_, options_.texture_px));
    LW_ASSIGN_OR_RETURN(std::string png, TurnedPng(jpeg));
    files_.push_back({"ground.png", std::move(png)});
    asset_.Leaf("texture", {{"name", "sky"},
                            {"type", "skybox"},
                            {"builtin", "gradient"},
                            {"rgb1", "0.62 0.74 0.86"},
                            {"rgb2", "0.32 0.45 0.66"},
                            {"width", "256"},
                            {"height", "256"}});
    asset_.Leaf("texture", {{"name", "ground"}, {"type", "2d"}, {"file", "ground.png"}});
    asset_.Leaf("material", {{"name", "ground"}, {"texture", "ground"}, {"specular", "0"}});
    // The file says rows and columns too; newton wants them here.
    asset_.Leaf(
        "hfield",
        {{"name", "ground"},
         {"file", "ground.hfield"},
         {"nrow", std::to_string(cells_.cols())},
         {"ncol", std::to_string(cells_.rows())},
         {"size", MjcfNumbers({0.5 * centers_.depth_m(), 0.5 * centers_.width_m(),
                               std::max(kLeastRange_m, high_m_ - low_m_), kGroundThickness_m})}});
    const WorldPoint middle = centers_.center();
    body_.Leaf("geom", {{"name", "ground"},
                        {"type", "hfield"},
                        {"hfield", "ground"},
                        {"pos", MjcfNumbers(Local(middle.x_m, middle.y_m, low_m_))},
                        {"quat", MjcfYaw(M_PI / 2.0)},
                        {"material", "ground"},
                        {"friction", MjcfNumbers({MeanFriction(), kTorsion_m, kRolling_m})},
                        {"priority", "1"}});
    return Advance(0.3);
  }

  Status AddWater() {
    const SurfaceMesh water =
        WaterMesh(*scene_.terrain,
                  MakeLattice(region_, scene_.geometry().resolution_m(), kMostWaterVertices));
    if (water.corners.empty()) return Status();
    files_.push_back({"meshes/water.obj", ToObj(water, -middle_m_.cast<float>())});
    // Nothing flat has a volume.
    asset_.Leaf("mesh", {{"name", "water"}, {"file", "meshes/water.obj"}, {"inertia", "shell"}});
    body_.Leaf(
        "geom",
        {{"class", "seen"}, {"name", "water"}, {"mesh", "water"}, {"rgba", "0.16 0.32 0.36 0.7"}});
    return Advance(0.4);
  }

  Status AddAssets() {
    const auto chosen = ChooseAssets(scene_, region_, options_.small_plants);
    if (chosen.size() > kMostMjcfThings)
      return TooMany(chosen.size(), "things", kMostMjcfThings, options_.small_plants);
    const auto groups = GroupAssets(scene_, chosen);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      LW_RETURN_IF_ERROR(Advance(0.4 + 0.6 * static_cast<double>(i) / groups.size()));
      LW_RETURN_IF_ERROR(AddGroup(groups[i], static_cast<int>(i)));
    }
    return Status();
  }

  // Things of one mesh and look: each a geom to be seen and, where it is solid, one that collides.
  Status AddGroup(const LookGroup& group, int number) {
    const std::string look = internal::PlainName(group.name) + "_" + std::to_string(number);
    LW_ASSIGN_OR_RETURN(std::string palette, PalettePng(MeanColors(scene_, group.members)));
    files_.push_back({"looks/" + look + ".png", std::move(palette)});
    asset_.Leaf("texture", {{"name", look}, {"type", "2d"}, {"file", "looks/" + look + ".png"}});
    asset_.Leaf("material", {{"name", look}, {"texture", look}, {"specular", "0"}});
    for (const std::uint32_t member : group.members) {
      const Asset& asset = scene_.assets[member];
      const Collision form = scene_.catalogue->models()[asset.model].collision;
      const Eigen::Vector3d base_m = Local(asset.x_m, asset.y_m, asset.z_m);
      const std::string name = names_.Of(member);
      body_.Leaf("geom", {{"class", "seen"},
                          {"name", name},
                          {"mesh", SizedMesh(group.model, asset)},
                          {"material", look},
                          {"pos", MjcfNumbers(base_m)},
                          {"quat", MjcfYaw(asset.yaw_rad)}});
      if (form != Collision::kNone) AddMjcfCollision(asset, form, base_m, name + "_solid", &body_);
    }
    return Status();
  }

  // File of a model's mesh, which is written when it first comes.
  const std::string& MeshFile(const std::string& model_name, const Asset& asset) {
    std::string& file = mesh_files_[model_name];
    if (!file.empty()) return file;
    file = "meshes/" + internal::PlainName(model_name) + "_" +
           std::to_string(mesh_files_.size() - 1) + ".obj";
    const AssetModel& model = scene_.catalogue->models()[asset.model];
    const auto& variants = scene_.catalogue->season_variants(TypeOf(asset.kind));
    files_.push_back({file, ToPaletteObj(BuildMesh(model, variants[asset.season_variant].foliage,
                                                   options_.detail, MeshVariationOf(asset)))});
    return file;
  }

  // Name of a model's mesh in about an asset's size: MuJoCo scales meshes, not geoms.
  const std::string& SizedMesh(const std::string& model_name, const Asset& asset) {
    std::array<float, 3> size_m = {asset.half_length_m, asset.half_width_m, asset.height_m};
    const bool exact =
        scene_.catalogue->models()[asset.model].collision == Collision::kBox;  // the two coincide
    for (float& value : size_m) value = exact ? std::max(kThinnest_m, value) : Stepped(value);
    std::string& name = sized_meshes_[{model_name, size_m}];
    if (!name.empty()) return name;
    name = internal::PlainName(model_name) + "_mesh_" + std::to_string(sized_meshes_.size() - 1);
    // Leaves are open surfaces, which have no volume.
    asset_.Leaf("mesh", {{"name", name},
                         {"file", MeshFile(model_name, asset)},
                         {"scale", MjcfNumbers({size_m[0], size_m[1], size_m[2]})},
                         {"inertia", "shell"}});
    return name;
  }

  void AddProps() {
    for (const Prop& prop : scene_.props) {
      if (region_.Holds(prop.position)) {
        AddMjcfProp(prop, names_.Of(prop), Local(prop.position.x_m, prop.position.y_m, prop.z_m),
                    &body_);
      }
    }
  }

  void AddBridges() {
    const std::vector<Bridge>& bridges = scene_.terrain->bridges;
    for (std::size_t i = 0; i < bridges.size(); ++i) {
      const Bridge& bridge = bridges[i];
      if (!region_.Holds(PlaceOn(bridge, 0.5 * bridge.length_m()).point)) continue;
      AddMjcfBridge(bridge, PartsOf(bridge, scene_.terrain->ground),
                    "road_bridge_" + std::to_string(i + 1), -Local(0.0, 0.0, 0.0), &body_);
    }
  }

  void AddStarts() {
    for (const AgentStart& agent : scene_.agents) {
      if (!region_.Holds(agent.position)) continue;
      const double z_m =
          scene_.terrain->ground.HeightAt(agent.position) + agent.height_above_ground_m;
      body_.Leaf("site", {{"name", "start_" + agent.name},
                          {"pos", MjcfNumbers(Local(agent.position.x_m, agent.position.y_m, z_m))},
                          {"quat", MjcfYaw(agent.heading_rad)},
                          {"size", "0.1"},
                          {"group", "4"}});
    }
  }

  const Scene& scene_;
  const PartNames names_;
  const std::optional<GeoOrigin>& origin_;
  const MjcfOptions& options_;
  const Progress& progress_;
  ExportRegion region_, centers_;  // centers_: of the outermost cells
  CellRange cells_;
  Eigen::Vector3d middle_m_ = Eigen::Vector3d::Zero();
  double low_m_ = 0.0, high_m_ = 0.0;
  std::array<std::int64_t, kSurfaceClassCount> cells_of_class_ = {};
  MjcfText asset_{2}, body_{2};
  std::map<std::string, std::string> mesh_files_;  // by model
  std::map<std::pair<std::string, std::array<float, 3>>, std::string> sized_meshes_;
  std::vector<ExportFile> files_;
};

}  // namespace

Status Validate(const MjcfOptions& options, const Scene& scene) {
  std::vector<Violation> violations =
      ValidateGround(options.region, scene.geometry(), "a height field has at least two values");
  CheckRange("texture_px", options.texture_px, {16, 8192}, " px", &violations);
  CheckRange("detail", options.detail, {0, kMeshDetails - 1}, "", &violations);
  return Status::FromViolations("MJCF", std::move(violations));
}

Result<std::vector<ExportFile>> MjcfFiles(const Scene& scene, const std::string& name,
                                          const std::optional<GeoOrigin>& origin,
                                          const MjcfOptions& options, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, scene));
  return MjcfBuilder(scene, origin, options, progress).Build(name);
}

}  // namespace latticeworld
