#include "latticeworld_ros/conversion/request_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "latticeworld_ros/server/bundle_name.h"
#include "latticeworld_ros/server/progress_estimate.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class RequestConversionTest : public testing::Test {
 protected:
  RequestConversionTest() : generator_(MakeDefaultWorldGenerator()) {
    std::string pattern = (fs::temp_directory_path() / "latticeworld_ros_test_XXXXXX").string();
    EXPECT_NE(mkdtemp(pattern.data()), nullptr);
    directory_ = pattern;
    defaults_ = {"", "grounded", {directory_}};
    fields_.layout_instruction = "a lake in the center";
  }
  ~RequestConversionTest() override { fs::remove_all(directory_); }

  Result<GenerationRequest> Convert(std::uint64_t drawn_seed = 99) {
    LW_ASSIGN_OR_RETURN(AcceptedRequest accepted,
                        ToGenerationRequest(fields_, defaults_, generator_, drawn_seed));
    return std::move(accepted).Take();
  }
  void ExpectRefused(StatusCode code, std::size_t violations) {
    const auto request = Convert();
    ASSERT_FALSE(request.ok());
    EXPECT_EQ(request.status().code(), code) << request.status().ToString();
    EXPECT_EQ(request.status().violations().size(), violations) << request.status().ToString();
  }

  WorldGenerator generator_;
  fs::path directory_;
  RequestDefaults defaults_;
  latticeworld_msgs::GenerateWorld::Request fields_;
};

TEST_F(RequestConversionTest, EmptyFieldsHaveTheirMeaning) {
  const auto request = Convert();
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_EQ(request->reader, "");  // the generator's own default
  EXPECT_EQ(request->generator, "grounded");
  EXPECT_EQ(request->seed, 99u);
  EXPECT_EQ(request->size_m, 512.0);
  EXPECT_EQ(request->resolution_m, 0.5);
  EXPECT_EQ(request->visual_kind, VisualKind::kNone);
}

TEST_F(RequestConversionTest, GivenFieldsAreTaken) {
  fields_.seed = 5;
  fields_.size = 128.0;
  fields_.resolution = 1.0;
  fields_.visual_kind = 1;
  fields_.visual.data = {1, 2, 3};
  fields_.height_offset = -20.0;
  const auto request = Convert();
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_EQ(request->seed, 5u);
  EXPECT_EQ(request->size_m, 128.0);
  EXPECT_EQ(request->visual, std::string("\1\2\3"));
  EXPECT_EQ(request->height_map.height_scale_m, 100.0);
  EXPECT_EQ(request->height_map.height_offset_m, -20.0);
}

TEST_F(RequestConversionTest, ASketchTakesTheHeightsOfTheRequest) {
  fields_.visual_kind = 2;
  fields_.visual.data = {1, 2, 3};
  fields_.height_offset = -20.0;
  auto request = Convert(5);
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_EQ(request->visual_kind, VisualKind::kSketch);
  EXPECT_EQ(request->height_map.height_scale_m, 100.0);
  EXPECT_EQ(request->height_map.height_offset_m, -20.0);
  fields_.height_scale = 0.5;
  request = Convert(5);
  ASSERT_FALSE(request.ok());
  EXPECT_EQ(request.status().violations()[0].pointer, "height_scale");
}

// What the action asks for is read as what the service asks for.
TEST_F(RequestConversionTest, AGoalIsReadAsARequest) {
  latticeworld_msgs::GenerateWorldTaskGoal goal;
  goal.layout_instruction = fields_.layout_instruction = "hills in the north";
  goal.environment_instruction = fields_.environment_instruction = "a winter morning";
  goal.visual_kind = fields_.visual_kind = 3;
  goal.visual.data = fields_.visual.data = {1, 2, 3};
  goal.visual.format = fields_.visual.format = "N40W106.hgt";
  goal.latitude = fields_.latitude = 40.5;
  goal.longitude = fields_.longitude = -105.25;
  goal.vocabulary = fields_.vocabulary = "wild";
  goal.size = fields_.size = 256.0;
  const auto asked = Convert();
  const auto accepted = ToGenerationRequest(goal, defaults_, generator_, 99);
  ASSERT_TRUE(asked.ok() && accepted.ok()) << asked.status().ToString();
  const GenerationRequest& read = **accepted;
  EXPECT_EQ(read.layout_instruction, asked->layout_instruction);
  EXPECT_EQ(read.environment_instruction, asked->environment_instruction);
  EXPECT_EQ(read.visual_kind, asked->visual_kind);
  EXPECT_EQ(read.visual, asked->visual);
  EXPECT_EQ(read.visual_name, asked->visual_name);
  EXPECT_EQ(read.elevation.latitude_deg, asked->elevation.latitude_deg);
  EXPECT_EQ(read.elevation.longitude_deg, asked->elevation.longitude_deg);
  EXPECT_EQ(read.vocabulary, asked->vocabulary);
  EXPECT_EQ(read.generator, asked->generator);
  EXPECT_EQ(read.seed, asked->seed);
  EXPECT_EQ(read.size_m, asked->size_m);

  goal.size = fields_.size = -1.0;
  goal.visual_kind = fields_.visual_kind = 9;
  EXPECT_EQ(ToGenerationRequest(goal, defaults_, generator_, 99).status().ToString(),
            Convert().status().ToString());
}

TEST_F(RequestConversionTest, AReaderIsTheRequestsOwn) {
  fields_.reader = "controlled";
  EXPECT_EQ(Convert()->reader, "controlled");
}

TEST_F(RequestConversionTest, AnElevationsUnitIsDegreesOrMetres) {
  fields_.visual_kind = 3;
  fields_.visual.data = {1, 2, 3};
  fields_.elevation_unit = "metres";
  EXPECT_EQ(Convert()->elevation.unit, ElevationUnit::kMetres);
  fields_.elevation_unit = "feet";
  const auto refused = Convert();
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().violations()[0].pointer, "elevation_unit");
}

TEST_F(RequestConversionTest, ElevationIsTheMiddleOfTheDataUnlessAPlaceIsGiven) {
  fields_.visual_kind = 3;
  fields_.visual.data = {1, 2, 3};
  fields_.visual.format = "N40W106.hgt";
  auto request = Convert(5);
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_EQ(request->visual_kind, VisualKind::kElevation);
  EXPECT_EQ(request->visual_name, "N40W106.hgt");
  EXPECT_TRUE(request->elevation.centered);
  EXPECT_FALSE(request->elevation.keep_altitude);

  fields_.latitude = 40.5;
  fields_.longitude = -105.25;
  fields_.keep_altitude = true;
  request = Convert(5);
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_FALSE(request->elevation.centered);
  EXPECT_EQ(request->elevation.latitude_deg, 40.5);
  EXPECT_EQ(request->elevation.longitude_deg, -105.25);
  EXPECT_TRUE(request->elevation.keep_altitude);
  fields_.latitude = 0.0;  // on the equator
  EXPECT_FALSE(Convert(5)->elevation.centered);

  for (const double illegal : {90.5, std::nan(""), -HUGE_VAL}) {
    fields_.latitude = illegal;
    request = Convert(5);
    ASSERT_FALSE(request.ok());
    EXPECT_EQ(request.status().violations()[0].pointer, "latitude");
  }
}

TEST_F(RequestConversionTest, IllegalVisualKindNamesTheLegalOnes) {
  fields_.visual_kind = 4;
  const auto request = Convert();
  ASSERT_FALSE(request.ok());
  EXPECT_NE(request.status().message().find("0 (NONE), 1 (HEIGHT_MAP), 2 (SKETCH), 3 (ELEVATION)"),
            std::string::npos);
}

TEST_F(RequestConversionTest, APictureNeedsItsKindAndOneSource) {
  fields_.visual.data = {1};
  ExpectRefused(StatusCode::kInvalidArgument, 1);  // kind NONE
  fields_.visual_kind = 1;
  fields_.visual_path = "a.png";
  ExpectRefused(StatusCode::kInvalidArgument, 1);  // both
  fields_.visual.data.clear();
  fields_.visual_path.clear();
  ExpectRefused(StatusCode::kInvalidArgument, 1);  // neither
}

TEST_F(RequestConversionTest, ViolationsOfBothSidesAreToldAtOnce) {
  fields_.visual_kind = 77;
  fields_.size = -1.0;
  fields_.resolution = std::numeric_limits<double>::quiet_NaN();
  fields_.vocabulary = "moon";
  fields_.generator = "oracle";
  ExpectRefused(StatusCode::kInvalidArgument, 5);
}

TEST_F(RequestConversionTest, APathIsLookedForBelowTheAllowedDirectories) {
  std::ofstream(directory_ / "a.pgm") << "P5";
  fields_.visual_kind = 1;
  for (const std::string& path : {std::string("a.pgm"), (directory_ / "a.pgm").string()}) {
    fields_.visual_path = path;
    const auto request = Convert();
    ASSERT_TRUE(request.ok()) << request.status().ToString();
    EXPECT_EQ(request->visual, "P5");
  }
  fields_.visual_path = "b.pgm";
  ExpectRefused(StatusCode::kNotFound, 0);
  for (const char* path : {"/etc/passwd", "../../../../etc/passwd"}) {
    fields_.visual_path = path;
    const auto request = Convert();
    ASSERT_FALSE(request.ok()) << path;
    EXPECT_EQ(request.status().code(), StatusCode::kPermissionDenied)
        << request.status().ToString();
  }
  fields_.visual_path = std::string("a\0.pgm", 6);
  ExpectRefused(StatusCode::kInvalidArgument, 0);
}

TEST(DrawSeedTest, IsNeverZeroAndNotTheSameTwice) {
  const std::uint64_t one = DrawSeed(), two = DrawSeed();
  EXPECT_NE(one, 0u);
  EXPECT_NE(one, two);
}

TEST(BundleNameTest, PathsAndOddNamesAreRefused) {
  for (const char* name : {"world-1", "A.b_c-9", "0"}) EXPECT_TRUE(CheckBundleName(name).ok());
  for (const char* name : {"", ".", "..", "../a", "a/b", "/a", ".a", "-a", "a b", "a\n", "\xff"}) {
    EXPECT_EQ(CheckBundleName(name).code(), StatusCode::kInvalidArgument) << name;
  }
  EXPECT_TRUE(CheckBundleName(std::string(128, 'a')).ok());
  EXPECT_FALSE(CheckBundleName(std::string(129, 'a')).ok());
}

TEST(ProgressEstimateTest, FallsToZeroAndIsUnknownAtFirst) {
  EXPECT_EQ(EstimateTimeLeft("relief", 0.0, 0.1), -1.0);
  EXPECT_EQ(EstimateTimeLeft("no stage of ours", 0.5, 0.1), -1.0);
  EXPECT_GT(EstimateTimeLeft("terrain", 0.5, 1.0), EstimateTimeLeft("scene", 0.5, 1.0));
  EXPECT_NEAR(EstimateTimeLeft("maps", 1.0, 1.0), 0.0, 1e-9);
}

}  // namespace
}  // namespace latticeworld
