#include "latticeworld/generation/visual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

#include "generation/test_world.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/rebuild.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

// A ridge along the western third of a sheet, a valley along the eastern one.
std::string DrawnSketch() {
  cv::Mat sheet(200, 200, CV_8UC3, cv::Scalar(255, 255, 255));
  cv::line(sheet, {60, 10}, {60, 190}, cv::Scalar(0, 0, 0), 4);
  cv::line(sheet, {140, 10}, {140, 199}, cv::Scalar(255, 40, 20), 4);
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(".png", sheet, bytes));
  return std::string(bytes.begin(), bytes.end());
}

// A slope from 1500 m in the west to 1599 m in the east, 40 degrees north, 105 west, in degrees.
std::string SlopeOfLand() {
  std::string text = "ncols 100\nnrows 100\nxllcorner -105.05\nyllcorner 39.95\ncellsize 0.001\n";
  for (int row = 0; row < 100; ++row) {
    for (int col = 0; col < 100; ++col) text += std::to_string(1500 + col) + " ";
  }
  return text;
}

// An SRTM tile of 3 arc seconds: a slope from west to east, 1000 m in all.
std::string SrtmTile() {
  std::string bytes;
  for (int i = 0; i < 1201 * 1201; ++i) {
    const int height = (i % 1201) * 1000 / 1200;
    bytes.push_back(static_cast<char>(height >> 8));
    bytes.push_back(static_cast<char>(height & 0xff));
  }
  return bytes;
}

GenerationRequest Request(VisualKind kind, std::string visual) {
  GenerationRequest request;
  request.layout_instruction = "Grassland, a forest in the north.";
  request.environment_instruction = "Two sheep graze.";
  request.visual_kind = kind;
  request.visual = std::move(visual);
  request.seed = 11;
  request.size_m = 256.0;
  request.resolution_m = 4.0;
  return request;
}

std::shared_ptr<const World> Generate(const GenerationRequest& request) {
  auto world = MakeDefaultWorldGenerator().Generate(request, Progress());
  EXPECT_TRUE(world.ok()) << world.status().ToString();
  return world.ok() ? *world : nullptr;
}

double MeanHeight(const World& world, double x_m) {
  const HeightField& ground = world.scene->terrain->ground;
  double sum = 0.0;
  for (int i = -10; i <= 10; ++i) sum += ground.HeightAt({x_m, 10.0 * i});
  return sum / 21.0;
}

Status Refusal(const GenerationRequest& request) {
  return MakeDefaultWorldGenerator().Generate(request, Progress()).status();
}

TEST(VisualTest, ASketchShapesTheGroundAndItsHeightsAreTheRequests) {
  GenerationRequest request = Request(VisualKind::kSketch, DrawnSketch());
  request.height_map.height_scale_m = 40.0;
  request.height_map.height_offset_m = 25.0;
  const auto world = Generate(request);
  ASSERT_NE(world, nullptr);
  // The ridge lies 51 m west of the middle, the valley 51 m east.
  EXPECT_GT(MeanHeight(*world, -51.0), MeanHeight(*world, 51.0) + 8.0);
  EXPECT_GT(MeanHeight(*world, -51.0), MeanHeight(*world, -115.0));
  EXPECT_NEAR(world->scene->terrain->ground.min_m(), 25.0, 4.0);
  EXPECT_NEAR(world->scene->terrain->ground.max_m(), 65.0, 6.0);
  EXPECT_FALSE(world->geo.has_value());
  EXPECT_EQ(world->request.sketch_translator, "embedded");
}

TEST(VisualTest, ASketchIsAnotherLandWithAnotherSeed) {
  GenerationRequest request = Request(VisualKind::kSketch, DrawnSketch());
  const auto first = Generate(request);
  ++request.seed;
  const auto second = Generate(request);
  ASSERT_TRUE(first != nullptr && second != nullptr);
  EXPECT_NE(first->scene->terrain->ground.height_m(), second->scene->terrain->ground.height_m());
}

TEST(VisualTest, ASketchHearsACancelWhileItBecomesLand) {
  GenerationRequest request = Request(VisualKind::kSketch, DrawnSketch());
  request.size_m = 1024.0;
  request.resolution_m = 1.0;
  Progress* cancelled = nullptr;
  int reports = 0;
  Progress progress([&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "relief");
    EXPECT_LT(fraction, 1.0);
    ++reports;
    if (fraction > 0.0) cancelled->Cancel();
  });
  cancelled = &progress;
  const auto world = MakeDefaultWorldGenerator().Generate(request, progress);
  EXPECT_EQ(world.status().code(), StatusCode::kCancelled) << world.status().ToString();
  EXPECT_GE(reports, 2);
}

TEST(VisualTest, ElevationGivesTheGroundItsSlopeAndTheWorldItsPlace) {
  GenerationRequest request = Request(VisualKind::kElevation, SlopeOfLand());
  request.layout_instruction = "Grassland.";
  request.size_m = 2048.0;
  request.resolution_m = 16.0;
  auto world = Generate(request);
  ASSERT_NE(world, nullptr);
  ASSERT_TRUE(world->geo.has_value());
  EXPECT_NEAR(world->geo->latitude_deg, 40.0, 1e-6);
  EXPECT_NEAR(world->geo->longitude_deg, -105.0, 1e-6);
  // One metre a thousandth of a degree, which is 85.39 m there; 1549.5 m in the middle.
  EXPECT_NEAR(world->geo->altitude_m, 1549.5 - 1016.0 / 85.39, 0.3);
  EXPECT_NEAR(MeanHeight(*world, 500.0) - MeanHeight(*world, -500.0), 1000.0 / 85.39, 1.0);
  EXPECT_NEAR(world->scene->terrain->ground.min_m(), 0.0, 1.0);
  ASSERT_FALSE(world->warnings.empty());
  EXPECT_NE(world->warnings[0].find("taken for degrees"), std::string::npos);

  request.elevation.keep_altitude = true;
  world = Generate(request);
  ASSERT_NE(world, nullptr);
  EXPECT_EQ(world->geo->altitude_m, 0.0);
  EXPECT_NEAR(MeanHeight(*world, 0.0), 1549.5, 1.0);

  request.elevation.centered = false;
  request.elevation.latitude_deg = 40.01;
  request.elevation.longitude_deg = -104.99;
  world = Generate(request);
  ASSERT_NE(world, nullptr);
  EXPECT_EQ(world->geo->latitude_deg, 40.01);
  EXPECT_NEAR(MeanHeight(*world, 0.0), 1559.5, 1.0);
}

// 36 m of ground in cells of 9 cm, which rises by 4 m; by its numbers in metres.
std::string Survey() {
  std::string text = "ncols 400\nnrows 400\nxllcorner 3\nyllcorner 4\ncellsize 0.09\n";
  for (int i = 0; i < 400 * 400; ++i) text += std::to_string(100.0 + 0.01 * (i % 400)) + " ";
  return text;
}

TEST(VisualTest, TheUnitOfElevationReachesItsReaderAndIsRecorded) {
  GenerationRequest request = Request(VisualKind::kElevation, Survey());
  request.size_m = 32.0;
  request.resolution_m = 1.0;
  const auto judged = Generate(request);
  ASSERT_NE(judged, nullptr);
  EXPECT_FALSE(judged->geo.has_value());
  EXPECT_NE(judged->warnings[0].find("taken for metres"), std::string::npos);
  request.elevation.unit = ElevationUnit::kDegrees;
  const auto degrees = Generate(request);
  ASSERT_NE(degrees, nullptr);
  ASSERT_TRUE(degrees->geo.has_value());
  EXPECT_NEAR(degrees->geo->latitude_deg, 22.0, 1e-6);
  EXPECT_EQ(degrees->request.elevation.unit, ElevationUnit::kDegrees);
  const auto rebuilt = RebuildWorld(*degrees, Progress());
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
  ExpectSameWorld(*degrees, **rebuilt);
  // Of other kinds it is not looked at.
  request.visual_kind = VisualKind::kHeightMap;
  request.visual = MakePgm(40, 40);
  const auto other = Generate(request);
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(other->request.elevation.unit, ElevationUnit::kJudged);
}

TEST(VisualTest, SrtmIsFoundByItsNameWhereverTheFileLies) {
  GenerationRequest request = Request(VisualKind::kElevation, SrtmTile());
  request.visual_name = "some/where/S13E130.hgt";
  const auto world = Generate(request);
  ASSERT_NE(world, nullptr);
  EXPECT_NEAR(world->geo->latitude_deg, -12.5, 1e-9);
  EXPECT_EQ(world->request.visual_name, "S13E130.hgt") << "no directories are recorded";
  request.visual_name.clear();
  EXPECT_EQ(Refusal(request).code(), StatusCode::kInvalidArgument);
}

TEST(VisualTest, GivenHeightsStayWhateverWordsAskOfTheLandAndThatIsTold) {
  for (const auto& [kind, visual] :
       {std::pair<VisualKind, std::string>{VisualKind::kHeightMap, MakePgm(64, 64)},
        {VisualKind::kSketch, DrawnSketch()},
        {VisualKind::kElevation, SlopeOfLand()}}) {
    GenerationRequest request = Request(kind, visual);
    const std::shared_ptr<const World> plain = Generate(request);
    request.layout_instruction += " The land is rugged. The land rises by 30 m to the south.";
    const std::shared_ptr<const World> world = Generate(request);
    ASSERT_TRUE(plain && world);
    EXPECT_EQ(world->scene->terrain->ground.height_m(), plain->scene->terrain->ground.height_m());
    for (const char* words : {"The land is rugged", "The land rises by 30 m to the south"}) {
      const std::string told = "the heights are given: the land stays as it is, whatever \"" +
                               std::string(words) + "\" asks of it";
      EXPECT_EQ(std::count(world->warnings.begin(), world->warnings.end(), told), 1) << words;
      // What the land is like is measured all the same.
      EXPECT_TRUE(std::any_of(world->fidelity.claims.begin(), world->fidelity.claims.end(),
                              [&](const ClaimOutcome& claim) { return claim.words == words; }))
          << words;
    }
  }
}

TEST(VisualTest, ABundleKeepsEveryKindAndItIsMadeAgainFromIt) {
  const TemporaryDirectory directory;
  GenerationRequest sketch = Request(VisualKind::kSketch, DrawnSketch());
  sketch.height_map.height_scale_m = 33.0;
  GenerationRequest land = Request(VisualKind::kElevation, SlopeOfLand());
  land.elevation.centered = false;
  land.elevation.latitude_deg = 40.0 + 1.0 / 300.0;
  land.elevation.longitude_deg = -105.01;
  land.elevation.keep_altitude = true;
  GenerationRequest tile = Request(VisualKind::kElevation, SrtmTile());
  tile.visual_name = "N40W106.hgt";
  int number = 0;
  for (const GenerationRequest& request : {sketch, land, tile}) {
    const auto world = Generate(request);
    ASSERT_NE(world, nullptr);
    const auto bundle = directory.path() / std::to_string(number++);
    const Status saved = SaveBundle(*world, bundle);
    ASSERT_TRUE(saved.ok()) << saved.ToString();
    const auto loaded = LoadBundle(bundle);
    ASSERT_TRUE(loaded.ok()) << loaded.status().ToString();
    ExpectSameWorld(*world, **loaded);
    const auto rebuilt = RebuildWorld(**loaded, Progress());
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
    ExpectSameWorld(*world, **rebuilt);
  }
}

TEST(VisualTest, AWorldOfAModelIsNotMadeAgainWithoutIt) {
  World world = *Generate(Request(VisualKind::kSketch, DrawnSketch()));
  world.request.sketch_translator = "onnx-0123456789ab";
  const auto rebuilt = RebuildWorld(world, Progress());
  EXPECT_EQ(rebuilt.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(rebuilt.status().message().find("onnx-0123456789ab"), std::string::npos);
  const Status refusal = Refusal(world.request);
  EXPECT_EQ(refusal.code(), StatusCode::kInvalidArgument);
  ASSERT_EQ(refusal.violations().size(), 1u);
  EXPECT_EQ(refusal.violations()[0].pointer, "sketch_translator");
}

TEST(VisualTest, OptionsOfOtherKindsAreNeitherLookedAtNorRecorded) {
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  GenerationRequest request = Request(VisualKind::kNone, "");
  request.height_map.height_scale_m = kNan;
  request.elevation.centered = false;
  request.elevation.latitude_deg = kNan;
  request.elevation.size_m = -1.0;
  request.visual_name = "a/b.png";
  for (const VisualKind kind : {VisualKind::kNone, VisualKind::kHeightMap}) {
    request.visual_kind = kind;
    if (kind == VisualKind::kHeightMap) {
      request.visual = MakePgm(40, 40);
      request.height_map.height_scale_m = 7.0;
    }
    const auto world = Generate(request);
    ASSERT_NE(world, nullptr);
    EXPECT_EQ(world->request.height_map.height_scale_m, kind == VisualKind::kNone ? 100.0 : 7.0);
    EXPECT_TRUE(world->request.elevation.centered);
    EXPECT_EQ(world->request.elevation.latitude_deg, 0.0);
    EXPECT_EQ(world->request.visual_name, "");
    EXPECT_EQ(world->request.sketch_translator, "");
    EXPECT_FALSE(world->geo.has_value());
  }
}

TEST(VisualTest, EveryKindSaysWhatItIsReadFromAndWhatIsLegal) {
  const SketchTranslator embedded;
  const auto words_of = [&](const GenerationRequest& request) {
    std::string words;
    for (const Violation& violation : ValidateVisual(request, embedded)) {
      words += violation.pointer + ": " + violation.message + "\n";
    }
    return words;
  };
  const auto expect = [&](const GenerationRequest& request, const std::string& word) {
    EXPECT_NE(words_of(request).find(word), std::string::npos)
        << word << " | " << words_of(request);
  };
  expect(Request(VisualKind::kHeightMap, ""), "PNG, PGM or TIFF");
  expect(Request(VisualKind::kSketch, ""), "PNG, JPEG or TIFF");
  expect(Request(VisualKind::kElevation, ""), "GeoTIFF");
  expect(Request(VisualKind::kNone, "x"), "height_map, sketch or elevation");
  expect(Request(static_cast<VisualKind>(9), "x"), "none, height_map, sketch, elevation");
  GenerationRequest request = Request(VisualKind::kSketch, "x");
  request.height_map.height_scale_m = 0.5;
  request.height_map.height_offset_m = 1e5;
  expect(request, "height_scale");
  expect(request, "height_offset");
  EXPECT_EQ(ValidateVisual(request, embedded).size(), 2u) << words_of(request);
  request = Request(VisualKind::kElevation, "x");
  request.elevation.centered = false;
  request.elevation.latitude_deg = 91.0;
  request.elevation.longitude_deg = -181.0;
  request.elevation.size_m = -5.0;  // the request's size counts
  request.visual_name = "\xff";
  expect(request, "latitude");
  expect(request, "longitude");
  expect(request, "visual_name");
  EXPECT_EQ(ValidateVisual(request, embedded).size(), 3u) << words_of(request);
}

TEST(VisualTest, RefusesWhatIsNoSketchAndNoElevation) {
  for (const VisualKind kind : {VisualKind::kSketch, VisualKind::kElevation}) {
    const Status status = Refusal(Request(kind, "neither of them"));
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_EQ(status.message().rfind("relief: ", 0), 0u) << status.ToString();
  }
  // A world larger than the data: 256 m around the middle of 8.5 km are there, 8192 m are not.
  GenerationRequest request = Request(VisualKind::kElevation, SlopeOfLand());
  request.size_m = 8192.0;
  request.resolution_m = 16.0;
  request.elevation.centered = false;
  request.elevation.latitude_deg = 40.04;
  request.elevation.longitude_deg = -105.04;
  const Status status = Refusal(request);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_NE(status.message().find("legal is a size of at most"), std::string::npos);
}

TEST(SketchTranslatorTest, IsTheEmbeddedOneWithoutAFile) {
  const auto translator = SketchTranslator::Load("");
  ASSERT_TRUE(translator.ok());
  EXPECT_EQ(translator->name(), "embedded");
  EXPECT_EQ(SketchTranslator::Load("/no/such/model.onnx").status().code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace latticeworld
