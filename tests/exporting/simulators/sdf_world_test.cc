#include "latticeworld/exporting/simulators/sdf_world.h"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <regex>

#include "generation/test_world.h"
#include "latticeworld/exporting/simulators/sdf_text.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/motion/geodesy.h"

namespace latticeworld {
namespace {

class SdfWorldTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;

  std::map<std::string, std::string> Make(const SdfOptions& options) const {
    auto files =
        SdfFiles(scene_, "lake & <wood>", GeoOrigin{47.0, 8.0, 400.0}, options, Progress());
    EXPECT_TRUE(files.ok()) << files.status().ToString();
    std::map<std::string, std::string> by_name;
    for (const ExportFile& file : *files) by_name[file.name] = file.content;
    return by_name;
  }
  static int Count(const std::string& text, const std::string& what) {
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
      ++count;
    return count;
  }
};

TEST_F(SdfWorldTest, TheHeightMapIsTheGround) {
  for (const int bits : {8, 16}) {
    SdfOptions options;
    options.heightmap_bits = bits;
    options.heightmap_vertices = 129;
    auto files = Make(options);
    const std::string& png = files["latticeworld_media/heightmap.png"];
    const cv::Mat picture =
        cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(picture.rows, 129);
    ASSERT_EQ(picture.cols, 129);
    ASSERT_EQ(picture.type(), bits == 16 ? CV_16UC1 : CV_8UC1);
    std::smatch size, pos;
    const std::string& text = files["world.sdf"];
    ASSERT_TRUE(std::regex_search(text, size, std::regex("<size>32 32 ([0-9.e-]+)</size>")));
    ASSERT_TRUE(std::regex_search(text, pos, std::regex("<pos>0 0 ([0-9.e-]+)</pos>")));
    const double range_m = std::stod(size[1]), low_m = std::stod(pos[1]);
    const int most = bits == 16 ? 65535 : 255;
    for (int row = 0; row < 129; row += 8) {
      for (int col = 0; col < 129; col += 8) {
        const WorldPoint point = {-16.0 + col * 0.25, 16.0 - row * 0.25};
        const int value =
            bits == 16 ? picture.at<std::uint16_t>(row, col) : picture.at<std::uint8_t>(row, col);
        EXPECT_NEAR(low_m + range_m * value / most, scene_.terrain->ground.HeightAt(point),
                    0.51 * range_m / most + 1e-5);
      }
    }
  }
}

TEST_F(SdfWorldTest, EveryThingIsOneVisualAndSolidOnesCollide) {
  SdfOptions options;
  options.small_plants = true;
  auto files = Make(options);
  const std::string& text = files["world.sdf"];
  int solid = 0;
  for (const Asset& asset : scene_.assets)
    solid += scene_.catalogue->models()[asset.model].collision != Collision::kNone ? 1 : 0;
  ASSERT_GT(solid, 0);
  EXPECT_EQ(Count(text, "<visual name=\"asset_"), static_cast<int>(scene_.assets.size()));
  EXPECT_EQ(Count(text, "<collision name=\"asset_"), solid);
  for (const Prop& prop : scene_.props)
    EXPECT_EQ(Count(text, "<model name=\"" + prop.name + "\">"), 1);
}

// The middle of a region lies where the ellipsoid has it: a degree of longitude is 76.1 km here and
// no sphere's, and a ten-millionth of a degree is a centimetre.
TEST_F(SdfWorldTest, TheMiddleOfARegionLiesWhereItDoesOnTheEarth) {
  SdfOptions options;
  const ExportRegion whole = WholeWorld(scene_.terrain->ground.geometry());
  const double quarter_m = whole.width_m() / 4.0;
  options.region = ExportRegion{whole.east_m - quarter_m, whole.north_m - quarter_m, whole.east_m,
                                whole.north_m};
  const std::string text = Make(options)["world.sdf"];
  const auto number = [&text](const std::string& name) {
    const std::size_t at = text.find("<" + name + ">") + name.size() + 2;
    return text.substr(at, text.find('<', at) - at);
  };
  const WorldPoint middle = options.region->center();
  const GeoPoint wanted = GeoPointAt({47.0, 8.0, 400.0}, {middle.x_m, middle.y_m, 0.0});
  EXPECT_NEAR(std::stod(number("latitude_deg")), wanted.latitude_deg, 1e-9);
  EXPECT_NEAR(std::stod(number("longitude_deg")), wanted.longitude_deg, 1e-9);
  EXPECT_GE(number("longitude_deg").size() - number("longitude_deg").find('.'), 10u);
}

TEST_F(SdfWorldTest, EveryFileThatItNamesIsThere) {
  auto files = Make({});
  const std::string text = files["world.sdf"];
  const std::regex uri("<(?:uri|diffuse|normal)>model://([^<]+)<");
  int uris = 0;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), uri); it != std::sregex_iterator();
       ++it, ++uris) {
    EXPECT_EQ(files.count((*it)[1]), 1u) << (*it)[1];
  }
  EXPECT_GT(uris, 3);
  EXPECT_NE(text.find("lake &amp; &lt;wood&gt;"), std::string::npos);
  EXPECT_NE(text.find("<latitude_deg>47"), std::string::npos);
}

TEST_F(SdfWorldTest, UnusableOptionsAreRefused) {
  SdfOptions options;
  options.heightmap_vertices = 100;
  options.heightmap_bits = 12;
  options.region = ExportRegion{-4.0, -4.0, 4.0, 6.0};
  const Status status = SdfFiles(scene_, "w", std::nullopt, options, Progress()).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.violations().size(), 3u);
}

TEST_F(SdfWorldTest, AnElementIsNotCalledAsAnotherModel) {
  Scene scene = scene_;
  scene.props.front().name = "ground";
  SdfOptions options;
  options.heightmap_vertices = 17;
  options.texture_px = 16;
  const auto files = SdfFiles(scene, "lake", std::nullopt, options, Progress());
  ASSERT_TRUE(files.ok()) << files.status().ToString();
  EXPECT_EQ(files->front().name, "world.sdf");
  EXPECT_EQ(Count(files->front().content, "<model name=\"ground\">"), 1);
  EXPECT_EQ(Count(files->front().content, "<model name=\"element_ground\">"), 1);
}

TEST_F(SdfWorldTest, NamesAndTextsAreNoMarkup) {
  SdfText text;
  text.Open("model", "a\"b");
  text.Leaf("uri", "x<y\x01");
  text.Close("model");
  const std::string sdf = text.Take();
  EXPECT_NE(sdf.find("<model name=\"a&quot;b\">"), std::string::npos) << sdf;
  EXPECT_NE(sdf.find("<uri>x&lt;y?</uri>"), std::string::npos) << sdf;
}

}  // namespace
}  // namespace latticeworld
