#include "latticeworld/exporting/simulators/mjcf_world.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "generation/test_world.h"
#include "latticeworld/exporting/ground_mesh.h"
#include "latticeworld/exporting/simulators/mjcf_text.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/sensing/motion/geodesy.h"

namespace latticeworld {
namespace {

// Every tag of a text, and whether all are closed in order, in one root.
struct Tag {
  std::string name;
  std::map<std::string, std::string> attributes;
};
std::vector<Tag> TagsOf(const std::string& xml) {
  const std::regex markup(R"(<!--[^-]*-->|<(/?)(\w+)((?: \w+="[^"<>]*")*)(/?)>)");
  const std::regex attribute(R"re((\w+)="([^"]*)")re");
  std::vector<Tag> tags;
  std::vector<std::string> open;
  std::size_t roots = 0;
  std::string rest;
  for (std::sregex_iterator it(xml.begin(), xml.end(), markup), end; it != end; ++it) {
    rest += it->prefix();
    if (!(*it)[2].matched) continue;
    const std::string name = (*it)[2];
    if ((*it)[1].length() > 0) {
      EXPECT_FALSE(open.empty());
      if (open.empty()) break;
      EXPECT_EQ(open.back(), name);
      open.pop_back();
      continue;
    }
    roots += open.empty() ? 1 : 0;
    if ((*it)[4].length() == 0) open.push_back(name);
    Tag tag = {name, {}};
    const std::string text = (*it)[3];
    for (std::sregex_iterator at(text.begin(), text.end(), attribute); at != end; ++at)
      EXPECT_TRUE(tag.attributes.emplace((*at)[1], (*at)[2]).second) << text;
    tags.push_back(tag);
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(roots, 1u);
  EXPECT_EQ(rest.find_first_of("<>"), std::string::npos) << rest;
  return tags;
}

std::vector<double> NumbersOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number; stream >> number;) numbers.push_back(number);
  return numbers;
}

class MjcfWorldTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;

  std::map<std::string, std::string> Make(const MjcfOptions& options = {}) const {
    auto files =
        MjcfFiles(scene_, "lake & <wood>", GeoOrigin{47.0, 8.0, 400.0}, options, Progress());
    EXPECT_TRUE(files.ok()) << files.status().ToString();
    std::map<std::string, std::string> by_name;
    for (const ExportFile& file : *files) {
      EXPECT_TRUE(by_name.emplace(file.name, file.content).second) << file.name;
    }
    return by_name;
  }
  static const Tag& Find(const std::vector<Tag>& tags, const std::string& tag,
                         const std::string& name) {
    for (const Tag& candidate : tags) {
      const auto found = candidate.attributes.find("name");
      if (candidate.name == tag && found != candidate.attributes.end() && found->second == name)
        return candidate;
    }
    ADD_FAILURE() << "no " << tag << " of name " << name;
    static const Tag none;
    return none;
  }
  static std::string At(const Tag& tag, const std::string& attribute) {
    const auto found = tag.attributes.find(attribute);
    return found == tag.attributes.end() ? "" : found->second;
  }
};

// As MuJoCo reads it: columns along x and rows along y of the geom's frame, from its lower ends.
TEST_F(MjcfWorldTest, TheTurnedHeightFieldIsTheGroundAtEveryCell) {
  for (const auto& region : {std::optional<ExportRegion>(),
                             std::optional<ExportRegion>(ExportRegion{-4.0, -2.0, 6.1, 3.0})}) {
    MjcfOptions options;
    options.region = region;
    auto files = Make(options);
    const std::vector<Tag> tags = TagsOf(files["world.xml"]);
    const std::string& bytes = files["ground.hfield"];
    std::int32_t shape[2];
    ASSERT_GT(bytes.size(), sizeof shape);
    std::memcpy(shape, bytes.data(), sizeof shape);
    ASSERT_EQ(bytes.size(), sizeof shape + sizeof(float) * shape[0] * shape[1]);
    const Tag& field = Find(tags, "hfield", "ground");
    EXPECT_EQ(At(field, "nrow"), std::to_string(shape[0]));
    EXPECT_EQ(At(field, "ncol"), std::to_string(shape[1]));
    const auto size = NumbersOf(At(field, "size"));
    const Tag& geom = Find(tags, "geom", "ground");
    const auto pos = NumbersOf(At(geom, "pos")), quat = NumbersOf(At(geom, "quat"));
    const auto map = NumbersOf(At(Find(tags, "numeric", "map_origin"), "data"));
    const Eigen::Quaterniond turn(quat[0], quat[1], quat[2], quat[3]);
    std::set<float> values;
    for (int row = 0; row < shape[0]; ++row) {
      for (int col = 0; col < shape[1]; ++col) {
        float value;
        std::memcpy(
            &value,
            bytes.data() + sizeof shape + sizeof value * (std::size_t(row) * shape[1] + col),
            sizeof value);
        values.insert(value);
        const Eigen::Vector3d local(size[0] * (2.0 * col / (shape[1] - 1) - 1.0),
                                    size[1] * (2.0 * row / (shape[0] - 1) - 1.0),
                                    size[2] * static_cast<double>(value));
        const Eigen::Vector3d place =
            turn * local + Eigen::Vector3d(pos[0], pos[1], pos[2]) + Eigen::Vector3d(map.data());
        const WorldPoint point = {place.x(), place.y()};
        EXPECT_TRUE(!region || region->Holds(point));
        EXPECT_NEAR(place.z(), scene_.terrain->ground.HeightAt(point), 1e-5);
      }
    }
    EXPECT_EQ(*values.begin(), 0.0f);  // MuJoCo stretches them to 0 .. 1
    EXPECT_EQ(*values.rbegin(), 1.0f);
    const int cells = scene_.geometry().rows();
    EXPECT_EQ(shape[0], region ? 20 : cells);
    EXPECT_EQ(shape[1], region ? 10 : cells);
  }
}

// MuJoCo splits quads from the corner of the lowest column and row to the opposite one: between
// four values that is HeightField's surface.
TEST_F(MjcfWorldTest, ItsQuadsAreSplitFromNorthWestToSouthEast) {
  const std::vector<Tag> tags = TagsOf(Make()["world.xml"]);
  const auto quat = NumbersOf(At(Find(tags, "geom", "ground"), "quat"));
  const Eigen::Quaterniond turn(quat[0], quat[1], quat[2], quat[3]);
  const Eigen::Vector3d diagonal = turn * Eigen::Vector3d(1.0, 1.0, 0.0);
  EXPECT_NEAR(diagonal.x(), -1.0, 1e-12);
  EXPECT_NEAR(diagonal.y(), 1.0, 1e-12);
}

TEST_F(MjcfWorldTest, AllThatItNamesIsThereAndNothingElse) {
  MjcfOptions options;
  options.small_plants = true;
  auto files = Make(options);
  const std::vector<Tag> tags = TagsOf(files["world.xml"]);
  std::set<std::string> named = {"world.xml"};
  std::map<std::string, std::set<std::string>> names;
  for (const Tag& tag : tags) {
    if (tag.attributes.count("file") > 0) named.insert(At(tag, "file"));
    if (tag.attributes.count("name") == 0) continue;
    EXPECT_TRUE(names[tag.name].insert(At(tag, "name")).second) << At(tag, "name");
  }
  for (const std::string& file : named) EXPECT_EQ(files.count(file), 1u) << file;
  EXPECT_EQ(named.size(), files.size());
  // An attribute names a prop of that tag.
  for (const Tag& tag : tags) {
    for (const char* kind : {"mesh", "material", "texture", "hfield"}) {
      if (tag.attributes.count(kind) == 0) continue;
      EXPECT_EQ(names[kind].count(At(tag, kind)), 1u) << At(tag, kind);
    }
  }
  EXPECT_EQ(At(tags.front(), "model"), "lake &amp; &lt;wood&gt;");
}

// MuJoCo refuses meshes of fewer than four vertices, and open ones that are not said to be shells.
TEST_F(MjcfWorldTest, MeshesAreSuchAsMuJoCoTakes) {
  MjcfOptions options;
  options.small_plants = true;
  auto files = Make(options);
  for (const Tag& tag : TagsOf(files["world.xml"])) {
    if (tag.name != "mesh") continue;
    EXPECT_EQ(At(tag, "inertia"), "shell") << At(tag, "name");
    std::istringstream lines(files[At(tag, "file")]);
    int vertices = 0;
    for (std::string line; std::getline(lines, line);) vertices += line.rfind("v ", 0) == 0 ? 1 : 0;
    EXPECT_GE(vertices, 4) << At(tag, "file");
  }
}

TEST_F(MjcfWorldTest, EveryThingIsSeenAtItsPlaceByItsNumberAndSolidOnesCollideExactly) {
  MjcfOptions options;
  options.small_plants = true;
  const std::vector<Tag> tags = TagsOf(Make(options)["world.xml"]);
  for (std::size_t i = 0; i < scene_.assets.size(); ++i) {
    const Asset& asset = scene_.assets[i];
    const std::string name = "asset_" + std::to_string(i);
    const Tag& seen = Find(tags, "geom", name);
    const auto pos = NumbersOf(At(seen, "pos"));
    ASSERT_EQ(pos.size(), 3u);
    EXPECT_NEAR(pos[0], asset.x_m, 1e-6);
    EXPECT_NEAR(pos[1], asset.y_m, 1e-6);
    EXPECT_NEAR(pos[2], asset.z_m, 1e-6);
    EXPECT_NEAR(2.0 * std::atan2(NumbersOf(At(seen, "quat"))[3], NumbersOf(At(seen, "quat"))[0]),
                asset.yaw_rad, 1e-6);
    const auto scale = NumbersOf(At(Find(tags, "mesh", At(seen, "mesh")), "scale"));
    const Collision form = scene_.catalogue->models()[asset.model].collision;
    const double share = form == Collision::kBox ? 1e-6 : std::sqrt(kMjcfSizeStep) - 1.0 + 1e-6;
    EXPECT_NEAR(scale[0], asset.half_length_m, share * asset.half_length_m);
    EXPECT_NEAR(scale[1], asset.half_width_m, share * asset.half_width_m);
    EXPECT_NEAR(scale[2], asset.height_m, share * asset.height_m);
    if (form == Collision::kNone) continue;
    const Tag& solid = Find(tags, "geom", name + "_solid");
    EXPECT_EQ(At(solid, "type"), form == Collision::kBox ? "box" : "cylinder");
    EXPECT_NEAR(NumbersOf(At(solid, "size")).back(), 0.5 * asset.height_m, 1e-6);
    EXPECT_NEAR(NumbersOf(At(solid, "pos"))[2], asset.z_m + 0.5 * asset.height_m, 1e-5);
  }
  const Tag& crate = Find(tags, "body", "crate_1");
  EXPECT_NEAR(NumbersOf(At(crate, "pos"))[0], scene_.props[0].position.x_m, 1e-9);
  Find(tags, "freejoint", "crate_1");
  Find(tags, "geom", "post_1");
}

TEST_F(MjcfWorldTest, AgentsBeginAtSites) {
  const std::vector<Tag> tags = TagsOf(Make()["world.xml"]);
  for (const AgentStart& agent : scene_.agents) {
    const auto pos = NumbersOf(At(Find(tags, "site", "start_" + agent.name), "pos"));
    ASSERT_EQ(pos.size(), 3u);
    EXPECT_NEAR(pos[0], agent.position.x_m, 1e-9);
    EXPECT_NEAR(pos[1], agent.position.y_m, 1e-9);
    EXPECT_NEAR(pos[2],
                scene_.terrain->ground.HeightAt(agent.position) + agent.height_above_ground_m,
                1e-9);
  }
}

// What touches the ground has mostly MuJoCo's own friction, 1, and of equals the greater one wins.
TEST_F(MjcfWorldTest, TheGroundsFrictionIsTheMeanOfItsCellsAndWins) {
  const std::vector<Tag> tags = TagsOf(Make()["world.xml"]);
  const SurfaceTable surfaces(scene_, scene_.atmosphere.ground());
  double sum = 0.0;
  for (const SurfaceClass surface : scene_.terrain->surface) sum += surfaces.Of(surface).friction;
  const Tag& ground = Find(tags, "geom", "ground");
  EXPECT_NEAR(NumbersOf(At(ground, "friction"))[0], sum / scene_.terrain->surface.size(), 1e-9);
  EXPECT_EQ(At(ground, "priority"), "1");
  EXPECT_EQ(NumbersOf(At(Find(tags, "numeric", "friction_water_bed"), "data"))[0],
            surfaces.Of(SurfaceClass::kWaterBed).friction);
}

TEST_F(MjcfWorldTest, TheMiddleOfARegionIsTheOriginAndLiesWhereItDoesOnTheEarth) {
  MjcfOptions options;
  options.region = ExportRegion{-12.0, 2.0, -2.0, 14.0};
  options.small_plants = true;
  const std::vector<Tag> tags = TagsOf(Make(options)["world.xml"]);
  const WorldPoint middle = options.region->center();
  const auto map = NumbersOf(At(Find(tags, "numeric", "map_origin"), "data"));
  EXPECT_EQ(map, (std::vector<double>{middle.x_m, middle.y_m, 0.0}));
  const GeoPoint wanted = GeoPointAt({47.0, 8.0, 400.0}, {middle.x_m, middle.y_m, 0.0});
  const auto geo = NumbersOf(At(Find(tags, "numeric", "geo"), "data"));
  ASSERT_EQ(geo.size(), 3u);
  EXPECT_NEAR(geo[0], wanted.latitude_deg, 1e-12);
  EXPECT_NEAR(geo[1], wanted.longitude_deg, 1e-12);
  int things = 0;
  for (std::size_t i = 0; i < scene_.assets.size(); ++i) {
    const Asset& asset = scene_.assets[i];
    if (!options.region->Holds(asset.position())) continue;
    ++things;
    const auto pos = NumbersOf(At(Find(tags, "geom", "asset_" + std::to_string(i)), "pos"));
    EXPECT_NEAR(pos[0] + middle.x_m, asset.x_m, 1e-6);
    EXPECT_NEAR(pos[1] + middle.y_m, asset.y_m, 1e-6);
  }
  EXPECT_GT(things, 0);
}

// MuJoCo lays it upright into the geom's frame, whose x points north here and whose y west.
TEST_F(MjcfWorldTest, ThePictureOfTheGroundIsTurnedAsItsHeightFieldIs) {
  const auto decode = [](const std::string& bytes) {
    return cv::imdecode(std::vector<unsigned char>(bytes.begin(), bytes.end()), cv::IMREAD_COLOR);
  };
  const ExportRegion region = {-12.0, 2.0, -2.0, 14.0};
  MjcfOptions options;
  options.region = region;
  const cv::Mat turned = decode(Make(options)["ground.png"]);
  const cv::Mat upright = decode(*GroundTexture(
      scene_, BetweenCenters(CellsIn(region, scene_.geometry()), scene_.geometry()), 2048));
  ASSERT_EQ(turned.rows, upright.cols);
  ASSERT_EQ(turned.cols, upright.rows);
  for (int row = 0; row < upright.rows; ++row) {  // from the north
    for (int col = 0; col < upright.cols; ++col) {
      EXPECT_EQ(turned.at<cv::Vec3b>(col, upright.rows - 1 - row), upright.at<cv::Vec3b>(row, col));
    }
  }
}

TEST_F(MjcfWorldTest, UnusableOptionsAreRefused) {
  MjcfOptions options;
  options.detail = 3;
  options.texture_px = 1;
  EXPECT_EQ(MjcfFiles(scene_, "w", std::nullopt, options, Progress()).status().violations().size(),
            2u);
  options.region = ExportRegion{-50.0, 0.0, 10.0, 10.0};
  EXPECT_EQ(MjcfFiles(scene_, "w", std::nullopt, options, Progress()).status().violations().size(),
            3u);
}

TEST_F(MjcfWorldTest, TheSameWorldGivesTheSameBytes) { EXPECT_EQ(Make(), Make()); }

TEST_F(MjcfWorldTest, NamesAreNoMarkupAndNumbersReadBackTheSame) {
  MjcfText text;
  text.Leaf("geom", {{"name", "a\"<b"}, {"pos", MjcfNumbers({0.1, -1.0 / 3.0, 1e-300})}});
  const std::string xml = text.Take();
  EXPECT_NE(xml.find("name=\"a&quot;&lt;b\""), std::string::npos) << xml;
  const auto numbers = NumbersOf(At(TagsOf(xml).front(), "pos"));
  EXPECT_EQ(numbers, (std::vector<double>{0.1, -1.0 / 3.0, 1e-300}));
}

}  // namespace
}  // namespace latticeworld
