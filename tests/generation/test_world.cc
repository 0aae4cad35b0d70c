#include "generation/test_world.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "latticeworld/generation/bundle/props_json.h"
#include "latticeworld/generation/bundle/world_id.h"
#include "latticeworld/scene/props/props.h"

namespace latticeworld {
namespace {

SymbolicLayout MakeLayout() {
  SymbolicLayout layout;
  layout.vocabulary = Vocabulary::kSuburb;
  layout.cells = Grid<char>(kLayoutSize, kLayoutSize, 'G');
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (row < 10 && col < 10) layout.cells(row, col) = 'F';
      if (row > 20 && col > 20) layout.cells(row, col) = 'W';
    }
  }
  return layout;
}

EnvironmentConfig MakeEnvironment() {
  EnvironmentConfig environment;
  environment.coarse.season = Season::kAutumn;
  environment.coarse.weather = Weather::kRain;
  environment.fine = DeriveFineAttributes(environment.coarse);
  environment.agents = {{AgentCategory::kSheep, 2, AgentState::kGrazing, Region::kUpperRight}};
  return environment;
}

std::shared_ptr<Terrain> MakeTerrain(const SymbolicLayout& layout, const GridGeometry& geometry) {
  auto terrain = std::make_shared<Terrain>();
  const int cells = geometry.rows();
  Grid<float> height_m(cells, cells);
  terrain->water_level_m = Grid<float>(cells, cells, std::numeric_limits<float>::quiet_NaN());
  terrain->surface = Grid<SurfaceClass>(cells, cells, SurfaceClass::kGrass);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      height_m(row, col) = std::sin(0.1f * row) + 0.7f * std::cos(0.13f * col) - 1.0f / 3.0f;
      if (layout.cells(row / 2, col / 2) != 'W') continue;
      height_m(row, col) -= 3.0f;
      terrain->water_level_m(row, col) = -0.9f;
      terrain->surface(row, col) = SurfaceClass::kWaterBed;
    }
  }
  terrain->ground = HeightField(geometry, std::move(height_m));
  terrain->weights = ToWeights(DecodeLayout(layout, geometry, DecodeOptions(), 5).masks);
  return terrain;
}

std::vector<Asset> MakeAssets(const Terrain& terrain) {
  std::vector<Asset> assets;
  for (const auto& entry : EnumNames(AssetKind{})) {
    const float i = static_cast<float>(assets.size());
    Asset asset;
    asset.kind = entry.value;
    asset.model = Catalogue::BuiltIn()->models_of(entry.value).back();
    asset.season_variant = 1;
    asset.material = 1;
    asset.x_m = -14.0f + 1.7f * i;
    asset.y_m = 9.0f / 7.0f * i;
    asset.z_m = static_cast<float>(terrain.ground.HeightAt(asset.position()));
    asset.yaw_rad = -0.1f * i;
    asset.scale = 1.0f + i / 3.0f;
    asset.height_m = 0.1f + i;
    asset.half_length_m = 0.4f;
    asset.half_width_m = 0.3f;
    asset.trunk_radius_m = entry.value == AssetKind::kTree ? 1e-3f : 0.0f;
    assets.push_back(asset);
  }
  return assets;
}

// Every field another than its default.
Atmosphere MakeAtmosphere() {
  Atmosphere atmosphere;
  atmosphere.weather = Weather::kRain;
  atmosphere.intensity = 1.0 / 3.0;
  atmosphere.visibility_m = 1000.0 / 3.0;
  atmosphere.rain_mmph = 4.5;
  atmosphere.snowfall_mmph = 0.1;
  atmosphere.cloud_cover = 0.9;
  atmosphere.wind_mps = {0.1, -0.2, 0.0};
  atmosphere.gust_mps = 0.7;
  atmosphere.hour = 40.0 / 3.0;
  atmosphere.day_of_year = 266.0;
  atmosphere.latitude_deg = -12.1;
  atmosphere.direct_light = 0.3;
  atmosphere.diffuse_light = 0.6;
  atmosphere.sun_direction = {0.6, 0.0, 0.8};
  atmosphere.sun_intensity = 0.7;
  atmosphere.ambient_intensity = 0.2;
  atmosphere.ground_wetness = 0.95;
  atmosphere.snow_depth_m = 0.01;
  atmosphere.blown_sand = 0.2;
  atmosphere.water_rise_m = -0.3;
  return atmosphere;
}

std::vector<AgentStart> MakeAgents() {
  std::vector<AgentStart> agents(3);
  agents[0] = {"sheep_1", AgentCategory::kSheep, AgentState::kGrazing, 0, false, {7.1, 8.3}, 0.0,
               1};
  agents[1] = {"sheep_2", AgentCategory::kSheep, AgentState::kGrazing, 0, false, {9.7, 9.1}, 0.0,
               -1.0 / 3.0};
  agents[2] = {"robot", AgentCategory::kWheeledRobot, AgentState::kIdle, 1, true, {-2, -3}, 0.05,
               1e-9};
  return agents;
}

std::vector<Prop> MakeProps() {
  Prop crate = UsualProp(PropKind::kCrate);
  crate.name = "crate_1";
  crate.position = {5.0 / 3.0, 9.1};
  crate.yaw_rad = 1.0 / 7.0;
  Prop post = UsualProp(PropKind::kPost);
  post.name = "post_1";
  post.position = {-7.25, 1.0 / 3.0};
  return {crate, post};
}

void ExpectSameBits(const Grid<float>& a, const Grid<float>& b, const char* what) {
  ASSERT_EQ(a.rows(), b.rows()) << what;
  ASSERT_EQ(a.cols(), b.cols()) << what;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0) << what;
}

void ExpectSameTerrain(const Terrain& a, const Terrain& b) {
  EXPECT_EQ(a.geometry().rows(), b.geometry().rows());
  EXPECT_EQ(a.geometry().resolution_m(), b.geometry().resolution_m());
  ExpectSameBits(a.ground.height_m(), b.ground.height_m(), "elevation");
  ExpectSameBits(a.water_level_m, b.water_level_m, "water level");
  EXPECT_EQ(a.surface, b.surface);
  EXPECT_EQ(a.weights.vocabulary, b.weights.vocabulary);
  ASSERT_EQ(a.weights.classes.size(), b.weights.classes.size());
  for (std::size_t i = 0; i < a.weights.classes.size(); ++i) {
    EXPECT_EQ(a.weights.classes[i].letter, b.weights.classes[i].letter);
    EXPECT_EQ(a.weights.classes[i].weight, b.weights.classes[i].weight) << "weight";
  }
}

void ExpectSameAssets(const std::vector<Asset>& a, const std::vector<Asset>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kind, b[i].kind);
    EXPECT_EQ(a[i].model, b[i].model);
    EXPECT_EQ(a[i].season_variant, b[i].season_variant);
    EXPECT_EQ(a[i].material, b[i].material);
    EXPECT_EQ(a[i].x_m, b[i].x_m);
    EXPECT_EQ(a[i].y_m, b[i].y_m);
    EXPECT_EQ(a[i].z_m, b[i].z_m);
    EXPECT_EQ(a[i].yaw_rad, b[i].yaw_rad);
    EXPECT_EQ(a[i].scale, b[i].scale);
    EXPECT_EQ(a[i].height_m, b[i].height_m);
    EXPECT_EQ(a[i].half_length_m, b[i].half_length_m);
    EXPECT_EQ(a[i].half_width_m, b[i].half_width_m);
    EXPECT_EQ(a[i].trunk_radius_m, b[i].trunk_radius_m);
  }
}

void ExpectSameAgents(const std::vector<AgentStart>& a, const std::vector<AgentStart>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].category, b[i].category);
    EXPECT_EQ(a[i].state, b[i].state);
    EXPECT_EQ(a[i].team, b[i].team);
    EXPECT_EQ(a[i].controllable, b[i].controllable);
    EXPECT_EQ(a[i].position.x_m, b[i].position.x_m);
    EXPECT_EQ(a[i].position.y_m, b[i].position.y_m);
    EXPECT_EQ(a[i].height_above_ground_m, b[i].height_above_ground_m);
    EXPECT_EQ(a[i].heading_rad, b[i].heading_rad);
  }
}

void ExpectSameAtmosphere(const Atmosphere& a, const Atmosphere& b) {
  EXPECT_EQ(a.weather, b.weather);
  EXPECT_EQ(a.intensity, b.intensity);
  EXPECT_EQ(a.visibility_m, b.visibility_m);
  EXPECT_EQ(a.rain_mmph, b.rain_mmph);
  EXPECT_EQ(a.snowfall_mmph, b.snowfall_mmph);
  EXPECT_EQ(a.cloud_cover, b.cloud_cover);
  EXPECT_EQ(a.wind_mps, b.wind_mps);
  EXPECT_EQ(a.gust_mps, b.gust_mps);
  EXPECT_EQ(a.hour, b.hour);
  EXPECT_EQ(a.day_of_year, b.day_of_year);
  EXPECT_EQ(a.latitude_deg, b.latitude_deg);
  EXPECT_EQ(a.direct_light, b.direct_light);
  EXPECT_EQ(a.diffuse_light, b.diffuse_light);
  EXPECT_EQ(a.sun_direction, b.sun_direction);
  EXPECT_EQ(a.sun_intensity, b.sun_intensity);
  EXPECT_EQ(a.ambient_intensity, b.ambient_intensity);
  EXPECT_EQ(a.ground_wetness, b.ground_wetness);
  EXPECT_EQ(a.snow_depth_m, b.snow_depth_m);
  EXPECT_EQ(a.blown_sand, b.blown_sand);
  EXPECT_EQ(a.water_rise_m, b.water_rise_m);
}

void ExpectSameRequest(const GenerationRequest& a, const GenerationRequest& b) {
  EXPECT_EQ(a.layout_instruction, b.layout_instruction);
  EXPECT_EQ(a.environment_instruction, b.environment_instruction);
  EXPECT_EQ(a.visual_kind, b.visual_kind);
  EXPECT_EQ(a.visual, b.visual);
  EXPECT_EQ(a.visual_name, b.visual_name);
  EXPECT_EQ(a.sketch_translator, b.sketch_translator);
  EXPECT_EQ(a.elevation.centered, b.elevation.centered);
  EXPECT_EQ(a.elevation.latitude_deg, b.elevation.latitude_deg);
  EXPECT_EQ(a.elevation.longitude_deg, b.elevation.longitude_deg);
  EXPECT_EQ(a.elevation.keep_altitude, b.elevation.keep_altitude);
  EXPECT_EQ(a.height_map.height_scale_m, b.height_map.height_scale_m);
  EXPECT_EQ(a.height_map.height_offset_m, b.height_map.height_offset_m);
  EXPECT_EQ(a.vocabulary, b.vocabulary);
  EXPECT_EQ(a.generator, b.generator);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.size_m, b.size_m);
  EXPECT_EQ(a.resolution_m, b.resolution_m);
}

void ExpectSameFidelity(const FidelityReport& a, const FidelityReport& b) {
  EXPECT_EQ(a.not_understood, b.not_understood);
  ASSERT_EQ(a.claims.size(), b.claims.size());
  for (std::size_t i = 0; i < a.claims.size(); ++i) {
    EXPECT_EQ(a.claims[i].part, b.claims[i].part);
    EXPECT_EQ(a.claims[i].kind, b.claims[i].kind);
    EXPECT_EQ(a.claims[i].words, b.claims[i].words);
    EXPECT_EQ(a.claims[i].satisfied, b.claims[i].satisfied);
    EXPECT_EQ(a.claims[i].distance, b.claims[i].distance);
    EXPECT_EQ(a.claims[i].explanation, b.claims[i].explanation);
  }
}

void ExpectSameReplies(const std::vector<ModelReply>& a, const std::vector<ModelReply>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].purpose, b[i].purpose);
    EXPECT_EQ(a[i].model, b[i].model);
    EXPECT_EQ(a[i].text, b[i].text);
    EXPECT_EQ(a[i].finish_reason, b[i].finish_reason);
    EXPECT_EQ(a[i].prompt_tokens, b[i].prompt_tokens);
    EXPECT_EQ(a[i].completion_tokens, b[i].completion_tokens);
    EXPECT_EQ(a[i].retries, b[i].retries);
    EXPECT_EQ(a[i].seconds, b[i].seconds);
    EXPECT_EQ(a[i].failure.ToString(), b[i].failure.ToString());
  }
}

}  // namespace

std::shared_ptr<World> MakeTestWorld() {
  auto world = std::make_shared<World>();
  world->request.layout_instruction = "A wood in the upper left, a lake: \"Königssee\".";
  world->request.environment_instruction = "autumn";
  world->request.visual_kind = VisualKind::kHeightMap;
  world->request.visual = MakePgm(40, 50);
  world->request.height_map = {12.5, -0.1};
  world->request.vocabulary = "suburb";
  world->request.generator = "a model that is not here";
  world->request.seed = 18446744073709551557u;
  world->request.size_m = 32.0;
  world->request.resolution_m = 0.5;
  const GridGeometry geometry = *GridGeometry::Create(32.0, 0.5);

  world->layout = MakeLayout();
  world->environment = MakeEnvironment();
  auto scene = std::make_shared<Scene>();
  scene->terrain = MakeTerrain(world->layout, geometry);
  scene->environment = world->environment;
  scene->assets = MakeAssets(*scene->terrain);
  scene->index = AssetIndex(geometry.size_m(), scene->assets);
  scene->atmosphere = MakeAtmosphere();
  scene->agents = MakeAgents();
  scene->props = MakeProps();
  world->scene = scene;
  world->fidelity.claims = {
      {InstructionPart::kLayout, "present", "A wood in the upper left", true, 0.0, "it is there"},
      {InstructionPart::kEnvironment, "coarse", "autumn", false, 1.0 / 3.0,
       "season is \"summer\""}};
  world->fidelity.not_understood = {"Königssee"};
  world->replies = {
      {"layout", "a model", "FFF\nGGG <think>\xF0\x9F\x8C\xB2", "length", 700, 2048, 1, 0.1},
      {"environment", "a model", "{}", "stop", 0, 0, 0, 1.0 / 7.0},
      {"environment", "", "", "", 0, 0, 0, 0.0, 0.0, {}, Unavailable("\"Königssee\" is\nfar")}};
  world->warnings = {"not understood: \"Königssee\"", "a second one"};
  world->stages = {{"relief", 0.001}, {"layout", 1.0 / 3.0}};
  world->geo = GeoOrigin{40.0 / 3.0, -105.1, 1999.9};
  world->id = ContentId(world->layout, *scene, world->geo);
  return world;
}

std::string MakePgm(int rows, int cols) {
  std::string pgm = "P5\n" + std::to_string(cols) + " " + std::to_string(rows) + "\n255\n";
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) pgm.push_back(static_cast<char>(col * 255 / (cols - 1)));
  }
  return pgm;
}

void ExpectSameWorld(const World& a, const World& b) {
  EXPECT_EQ(a.id, b.id);
  ExpectSameRequest(a.request, b.request);
  EXPECT_EQ(a.layout.vocabulary, b.layout.vocabulary);
  EXPECT_EQ(a.layout.cells, b.layout.cells);
  EXPECT_EQ(ToJson(a.environment), ToJson(b.environment));
  EXPECT_EQ(ToJson(a.scene->environment), ToJson(b.scene->environment));
  ExpectSameTerrain(*a.scene->terrain, *b.scene->terrain);
  ExpectSameAssets(a.scene->assets, b.scene->assets);
  EXPECT_EQ(a.scene->index.largest_solid_radius_m(), b.scene->index.largest_solid_radius_m());
  ExpectSameAtmosphere(a.scene->atmosphere, b.scene->atmosphere);
  ExpectSameAgents(a.scene->agents, b.scene->agents);
  EXPECT_EQ(EncodeProps(a.scene->props), EncodeProps(b.scene->props));
  ExpectSameFidelity(a.fidelity, b.fidelity);
  ExpectSameReplies(a.replies, b.replies);
  EXPECT_EQ(a.warnings, b.warnings);
  ASSERT_EQ(a.geo.has_value(), b.geo.has_value());
  if (!a.geo) return;
  EXPECT_EQ(a.geo->latitude_deg, b.geo->latitude_deg);
  EXPECT_EQ(a.geo->longitude_deg, b.geo->longitude_deg);
  EXPECT_EQ(a.geo->altitude_m, b.geo->altitude_m);
}

TemporaryDirectory::TemporaryDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "lw-generation-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) ADD_FAILURE() << "cannot make " << name;
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryDirectory::Entries() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace latticeworld
