#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <set>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

std::string MakePgm(int side) {
  std::string pgm = "P5\n" + std::to_string(side) + " " + std::to_string(side) + "\n255\n";
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) pgm.push_back(static_cast<char>(col * 255 / side));
  }
  return pgm;
}

// The first bytes of a PNG: signature and header chunk (its checksum is of 8-bit grey pictures of
// this size), then nothing.
std::string PngHeader(unsigned width, unsigned height, const std::string& checksum) {
  const auto big_endian = [](unsigned value) {
    return std::string{static_cast<char>(value >> 24), static_cast<char>(value >> 16),
                       static_cast<char>(value >> 8), static_cast<char>(value)};
  };
  return std::string("\x89PNG\r\n\x1a\n", 8) + big_endian(13) + "IHDR" + big_endian(width) +
         big_endian(height) + std::string("\x08\x00\x00\x00\x00", 5) + checksum;
}

// An uncompressed RGB TIFF, 64 x 64: a black stroke in the west, a blue one in the east.
std::string MakeSketch() {
  constexpr unsigned kSide = 64;
  const auto put = [](unsigned value, int size, std::string* bytes) {
    for (int i = 0; i < size; ++i) bytes->push_back(static_cast<char>(value >> (8 * i)));
  };
  constexpr unsigned kData = 8 + 2 + 10 * 12 + 4 + 6;  // after the header and three depths
  const unsigned fields[][4] = {
      // tag, type, count, value
      {256, 3, 1, kSide}, {257, 3, 1, kSide}, {258, 3, 3, kData - 6},
      {259, 3, 1, 1},     {262, 3, 1, 2},     {273, 4, 1, kData},
      {277, 3, 1, 3},     {278, 3, 1, kSide}, {279, 4, 1, 3 * kSide * kSide},
      {284, 3, 1, 1}};
  std::string bytes("II*\0\x08\0\0\0", 8);
  put(10, 2, &bytes);
  for (const auto& field : fields) {
    put(field[0], 2, &bytes);
    put(field[1], 2, &bytes);
    put(field[2], 4, &bytes);
    put(field[3], 4, &bytes);
  }
  put(0, 4, &bytes);
  for (int i = 0; i < 3; ++i) put(8, 2, &bytes);
  for (unsigned i = 0; i < kSide * kSide; ++i) {
    const unsigned col = i % kSide;
    const bool ridge = col >= 17 && col < 20, valley = col >= 43 && col < 46;
    bytes += ridge ? std::string(3, '\0') : valley ? "\x10\x30\xff" : "\xff\xff\xff";
  }
  return bytes;
}

// 100 x 100 samples of a thousandth of a degree, rising from 500 m in the west to 599 m.
std::string MakeElevation() {
  std::string text = "ncols 100\nnrows 100\nxllcorner -105.05\nyllcorner 39.95\ncellsize 0.001\n";
  for (int i = 0; i < 100 * 100; ++i) text += std::to_string(500 + i % 100) + " ";
  return text;
}

// 400 x 400 samples of 0.09, rising from 100 m in the west to 104 m: by its numbers in metres.
std::string MakeSurvey() {
  std::string text = "ncols 400\nnrows 400\nxllcorner 3\nyllcorner 4\ncellsize 0.09\n";
  for (int i = 0; i < 400 * 400; ++i) text += std::to_string(100.0 + 0.01 * (i % 400)) + " ";
  return text;
}

class GenerateCommandTest : public ProgramTest {
 protected:
  // generate for a small world, with these options besides.
  ProgramRun Generate(const std::vector<std::string>& options, const RunOptions& run_options = {}) {
    std::vector<std::string> arguments = {"generate"};
    const auto add_unless_given = [&](const std::string& name, const std::string& value) {
      for (const std::string& option : options) {
        if (option == name) return;
      }
      arguments.insert(arguments.end(), {name, value});
    };
    add_unless_given("--size", "64");
    add_unless_given("--resolution", "1");
    add_unless_given("--out", PathOf("world"));
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunProgram(arguments, run_options);
  }

  // Fails with the status, says every one of the words, and leaves nothing at --out.
  void ExpectFailure(int exit_status, const std::vector<std::string>& options,
                     const std::vector<std::string>& words) {
    const std::vector<std::string> before = Entries();
    const ProgramRun run = Generate(options);
    EXPECT_EQ(run.exit_status, exit_status) << run.err;
    EXPECT_EQ(run.out, "");
    for (const std::string& word : words) {
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " | " << run.err;
    }
    EXPECT_EQ(Entries(), before);
  }
};

TEST_F(GenerateCommandTest, MakesABundleAndSaysWhatIsInIt) {
  const ProgramRun run =
      Generate({"--layout", "A lake in the center and a forest in the upper left.", "--environment",
                "Five sheep graze on a rainy autumn morning.", "--seed", "42"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  for (const char* word : {"world-", "seed         42", "5 sheep", "autumn", "rain", "assets",
                           "elements", "stages", "scene"}) {
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " | " << run.out;
  }
  EXPECT_NE(run.out.find(PathOf("world")), std::string::npos);
  for (const char* stage : {"relief", "layout", "environment", "terrain", "scene", "save"}) {
    EXPECT_NE(run.err.find(stage), std::string::npos) << stage << " | " << run.err;
  }
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')).size(), 32u) << "the first line of the layout";
  EXPECT_EQ(Entries(), std::vector<std::string>{"world"});
  EXPECT_EQ(Read("world/layout.txt"), run.out.substr(0, Read("world/layout.txt").size()));
}

TEST_F(GenerateCommandTest, ToldOfABridgeAreItsKindLoadAndClearance) {
  const ProgramRun run = RunProgram(
      {"generate", "--layout",
       "A river runs from the north to the south. A road runs from the west to the east.",
       "--environment", "A sunny summer noon.", "--seed", "3", "--size", "150", "--out",
       PathOf("bridged")});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("bridges      plank bridge, "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("carries 3.5 t, clears the water by 0.5 m"), std::string::npos) << run.out;
}

TEST_F(GenerateCommandTest, MakesTheSameWorldFromTheSameSeed) {
  const std::vector<std::string> options = {"--layout", "Forest, and a road from left to right.",
                                            "--seed", "9", "--out"};
  std::set<std::string> ids;
  for (const char* name : {"a", "b"}) {
    std::vector<std::string> arguments = options;
    arguments.push_back(PathOf(name));
    const ProgramRun run = Generate(arguments);
    ASSERT_EQ(run.exit_status, 0) << run.err;
    ids.insert(run.out.substr(run.out.find("world-"), 18));
  }
  EXPECT_EQ(ids.size(), 1u);
  for (const char* file : {"terrain.bin", "assets.csv", "agents.json", "elements.json",
                           "environment.json", "height.png", "world.bt", "preview.png"}) {
    EXPECT_EQ(Read(std::string("a/") + file), Read(std::string("b/") + file)) << file;
  }
}

TEST_F(GenerateCommandTest, DrawsASeedWhenNoneIsGiven) {
  std::set<std::string> seeds;
  for (const char* name : {"a", "b", "c"}) {
    std::vector<std::string> options = {"--layout", "Grassland.", "--out", PathOf(name)};
    if (std::string(name) == "c") options.insert(options.end(), {"--seed", "0"});
    const ProgramRun run = Generate(options);
    ASSERT_EQ(run.exit_status, 0) << run.err;
    const std::size_t begin = run.out.find("seed         ") + 13;
    seeds.insert(run.out.substr(begin, run.out.find('\n', begin) - begin));
  }
  EXPECT_EQ(seeds.size(), 3u);
  EXPECT_EQ(seeds.count("0"), 0u);
}

TEST_F(GenerateCommandTest, ReadsTextsFromFiles) {
  Write("layout.txt", "A lake in the center.\n");
  Write("environment.txt", "Snow at night.");
  const ProgramRun run = Generate({"--layout", "@" + PathOf("layout.txt"), "--environment",
                                   "@" + PathOf("environment.txt"), "--seed", "3"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("A lake in the center."), std::string::npos);
  EXPECT_NE(run.out.find("night"), std::string::npos);
}

TEST_F(GenerateCommandTest, TakesAHeightMapAlone) {
  Write("relief.pgm", MakePgm(64));
  const ProgramRun run = Generate({"--height-map", PathOf("relief.pgm"), "--height-scale", "20",
                                   "--height-offset", "-5", "--seed", "3"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("20 m from black to white"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("from -5 m"), std::string::npos) << run.out;
  EXPECT_EQ(Read("world/visual"), MakePgm(64));
}

TEST_F(GenerateCommandTest, SaysWhichPixelsOfAWideHeightMapItKept) {
  std::string pgm = "P5\n80 64\n255\n";
  for (int i = 0; i < 80 * 64; ++i) pgm.push_back(static_cast<char>(i % 80));
  Write("wide.pgm", pgm);
  const ProgramRun run = Generate({"--height-map", PathOf("wide.pgm"), "--seed", "3"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("columns 8 to 71 of 0 to 79"), std::string::npos) << run.out;
}

TEST_F(GenerateCommandTest, TakesASketch) {
  Write("sketch.tif", MakeSketch());
  const ProgramRun run = Generate({"--sketch", PathOf("sketch.tif"), "--height-scale", "25",
                                   "--height-offset", "40", "--seed", "3"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  for (const char* word : {"sketch, ", "25 m from lowest to highest", "from 40 m", "embedded"}) {
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " | " << run.out;
  }
  EXPECT_EQ(Read("world/visual"), MakeSketch());
  const ProgramRun again = RunProgram({"rebuild", PathOf("world")});
  EXPECT_EQ(again.exit_status, 0) << again.err;
}

TEST_F(GenerateCommandTest, TakesElevationAroundItsMiddleOrAPlace) {
  Write("land.asc", MakeElevation());
  const ProgramRun middle = Generate({"--elevation", PathOf("land.asc"), "--seed", "3"});
  ASSERT_EQ(middle.exit_status, 0) << middle.err;
  for (const char* word : {"latitude 40.000000, longitude -105.000000", "z = 0 at 549",
                           "elevation, ", "lowest point at 0 m", "taken for degrees"}) {
    EXPECT_NE(middle.out.find(word), std::string::npos) << word << " | " << middle.out;
  }
  const ProgramRun place = Generate({"--elevation", PathOf("land.asc"), "--at", "40.02,-104.97",
                                     "--keep-altitude", "--seed", "3", "--out", PathOf("place")});
  ASSERT_EQ(place.exit_status, 0) << place.err;
  for (const char* word : {"latitude 40.020000, longitude -104.970000", "z = 0 at 0.0 m",
                           "altitudes kept", "ground       from 57"}) {
    EXPECT_NE(place.out.find(word), std::string::npos) << word << " | " << place.out;
  }
  const ProgramRun shown = RunProgram({"show", PathOf("place")});
  EXPECT_EQ(shown.exit_status, 0) << shown.err;
  EXPECT_NE(shown.out.find("latitude 40.020000"), std::string::npos) << shown.out;
}

TEST_F(GenerateCommandTest, TakesTheUnitOfElevationThatSaysNone) {
  Write("survey.asc", MakeSurvey());
  const std::vector<std::string> options = {
      "--elevation", PathOf("survey.asc"), "--size", "32", "--resolution", "1", "--seed", "3",
      "--out"};
  const auto run_with = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = options;
    arguments.push_back(PathOf(out));
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = Generate(arguments);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return run.out;
  };
  const std::string judged = run_with("judged", {});
  for (const char* word : {"taken for metres", "--elevation-unit"}) {
    EXPECT_NE(judged.find(word), std::string::npos) << word << " | " << judged;
  }
  EXPECT_EQ(judged.find("longitude"), std::string::npos) << judged;
  const std::string metres = run_with("metres", {"--elevation-unit", "metres"});
  EXPECT_EQ(metres.find("taken for"), std::string::npos) << metres;
  EXPECT_EQ(metres.find("longitude"), std::string::npos) << metres;
  const std::string degrees = run_with("degrees", {"--elevation-unit", "degrees"});
  EXPECT_EQ(degrees.find("taken for"), std::string::npos) << degrees;
  EXPECT_NE(degrees.find("latitude 22.000000, longitude 21.000000"), std::string::npos) << degrees;
  const ProgramRun again = RunProgram({"rebuild", PathOf("degrees")});
  EXPECT_EQ(again.exit_status, 0) << again.err;

  ExpectFailure(2, {"--elevation", PathOf("survey.asc"), "--elevation-unit", "feet"},
                {"--elevation-unit", "feet", "degrees, metres"});
  ExpectFailure(2, {"--layout", "Forest.", "--elevation-unit", "metres"},
                {"--elevation-unit", "--elevation"});
  // A refusal says how the coordinates were taken.
  ExpectFailure(2, {"--elevation", PathOf("survey.asc"), "--size", "64"},
                {"legal is a size of at most", "taken for metres", "--elevation-unit"});
}

TEST_F(GenerateCommandTest, RefusesUnusableSketchesAndElevation) {
  Write("good.pgm", MakePgm(64));
  Write("land.asc", MakeElevation());
  Write("sketch.tif", MakeSketch());
  ExpectFailure(2, {"--sketch", PathOf("land.asc")}, {"relief", "PNG"});
  ExpectFailure(2, {"--elevation", PathOf("good.pgm")}, {"PGM", "GeoTIFF"});
  ExpectFailure(2, {"--elevation", PathOf("sketch.tif")}, {"3 bands"});
  ExpectFailure(1, {"--sketch", PathOf("no.png")}, {"--sketch", "no.png"});
  ExpectFailure(1, {"--elevation", PathOf("no.tif")}, {"--elevation", "no.tif"});
  ExpectFailure(2, {"--sketch", PathOf("sketch.tif"), "--height-scale", "0.5"}, {"height_scale"});
  ExpectFailure(1, {"--sketch", PathOf("sketch.tif"), "--sketch-model", PathOf("no.onnx")},
                {"--sketch-model", "no.onnx"});
  ExpectFailure(2, {"--sketch", PathOf("sketch.tif"), "--sketch-model", PathOf("good.pgm")},
                {"--sketch-model"});
  ExpectFailure(2,
                {"--elevation", PathOf("land.asc"), "--at", "40.04,-105", "--size", "4096",
                 "--resolution", "16"},
                {"4096 m", "legal is a size of at most"});
  for (const char* place : {"40", "40,", "40,-105,3", "north,-105", "nan,-105", ""}) {
    ExpectFailure(2, {"--elevation", PathOf("land.asc"), "--at", place}, {"--at", "comma"});
  }
  ExpectFailure(2, {"--elevation", PathOf("land.asc"), "--at", "95,-105"}, {"latitude", "95"});
  ExpectFailure(2, {"--elevation", PathOf("land.asc"), "--at", "50,8"}, {"outside", "39.95"});
}

TEST_F(GenerateCommandTest, TakesOneReliefAndOnlyItsOwnOptions) {
  Write("good.pgm", MakePgm(64));
  Write("land.asc", MakeElevation());
  ExpectFailure(2, {"--height-map", PathOf("good.pgm"), "--elevation", PathOf("land.asc")},
                {"--elevation", "beside --height-map", "--sketch"});
  ExpectFailure(2, {"--elevation", PathOf("land.asc"), "--height-scale", "3"},
                {"--height-scale", "--height-map or --sketch"});
  ExpectFailure(2, {"--height-map", PathOf("good.pgm"), "--at", "1,2", "--keep-altitude"},
                {"--at", "--keep-altitude", "--elevation"});
  ExpectFailure(2, {"--layout", "Forest.", "--sketch-model", "x.onnx"},
                {"--sketch-model", "--sketch"});
}

TEST_F(GenerateCommandTest, TakesTextsThatLookLikeSyntax) {
  for (const char* text :
       {"[forest, lake]", "{forest}", "- a forest", "\"forest\" = %% 'lake' #"}) {
    const ProgramRun run = Generate({"--layout", text, "--seed", "3", "--out",
                                     PathOf(std::to_string(std::string(text).size()))});
    EXPECT_EQ(run.exit_status, 0) << text << " | " << run.err;
    EXPECT_NE(run.out.find("layout       \"" + std::string(text)), std::string::npos) << run.out;
  }
}

TEST_F(GenerateCommandTest, RefusesUnusableTexts) {
  ExpectFailure(2, {}, {"empty"});
  ExpectFailure(2, {"--layout", ""}, {"empty"});
  ExpectFailure(2, {"--layout", "a\xff"}, {"UTF-8"});
  ExpectFailure(2, {"--layout", "Forest.", "--environment", "\xc3("}, {"UTF-8"});
  Write("long.txt", std::string(1 << 20, 'a'));
  ExpectFailure(2, {"--layout", "@" + PathOf("long.txt")}, {"1048576", "16384"});
  ExpectFailure(2, {"--layout", "x", "--environment", "@" + PathOf("long.txt")},
                {"1048576", "16384"});
  Write("nul.txt", std::string("a\0b", 3));
  ExpectFailure(2, {"--layout", "@" + PathOf("nul.txt")}, {"NUL"});
  ExpectFailure(1, {"--layout", "@" + PathOf("no.txt")}, {"--layout", "no.txt"});
  ExpectFailure(2, {"--layout", "@/"}, {"--layout", "not a regular file"});
  ExpectFailure(1, {"--layout", "@"}, {"--layout"});
}

TEST_F(GenerateCommandTest, RefusesUnusablePictures) {
  Write("text.png", "This is no picture.");
  ExpectFailure(2, {"--height-map", PathOf("text.png")}, {"PNG", "PGM", "TIFF"});
  Write("empty.png", "");
  ExpectFailure(2, {"--height-map", PathOf("empty.png")}, {});
  Write("cut.pgm", MakePgm(64).substr(0, 2000));
  ExpectFailure(2, {"--height-map", PathOf("cut.pgm")}, {});
  Write("dot.pgm", "P5\n1 1\n255\nx");
  ExpectFailure(2, {"--height-map", PathOf("dot.pgm")}, {"33", "8193"});
  Write("dot.png", PngHeader(1, 1, "\x3a\x7e\x9b\x55"));
  ExpectFailure(2, {"--height-map", PathOf("dot.png")}, {"33", "8193"});
  Write("huge.png", PngHeader(30000, 30000, "\x43\x4c\xa7\x66"));
  ExpectFailure(2, {"--height-map", PathOf("huge.png")}, {"30000", "8193"});
  ExpectFailure(1, {"--height-map", PathOf("no.png")}, {"--height-map", "no.png"});
  Write("good.pgm", MakePgm(64));
  ExpectFailure(2, {"--height-map", PathOf("good.pgm"), "--height-scale", "1e5"}, {"9000"});
  ExpectFailure(2, {"--height-map", PathOf("good.pgm"), "--height-offset", "-1e5"}, {"9000"});
}

TEST_F(GenerateCommandTest, RefusesATruncatedPng) {
  // height.png of a world is a PNG that height maps are read from; then half of it.
  ASSERT_EQ(Generate({"--layout", "Forest.", "--seed", "1"}).exit_status, 0);
  const std::string png = Read("world/height.png");
  Write("whole.png", png);
  EXPECT_EQ(Generate({"--height-map", PathOf("whole.png"), "--seed", "1", "--out", PathOf("again")})
                .exit_status,
            0);
  Write("cut.png", png.substr(0, png.size() / 2));
  ExpectFailure(2, {"--height-map", PathOf("cut.png"), "--out", PathOf("third")}, {});
}

TEST_F(GenerateCommandTest, RefusesUnusableSizes) {
  for (const char* option : {"--size", "--resolution"}) {
    const std::string name = std::string(option).substr(2);
    for (const char* value : {"0", "-1", "nan", "1e300", "1e-300"}) {
      ExpectFailure(2, {"--layout", "Forest.", option, value}, {name});
    }
  }
  ExpectFailure(2, {"--layout", "Forest.", "--size", "8192", "--resolution", "0.05"},
                {"163840", "8192"});
  ExpectFailure(2, {"--layout", "Forest.", "--size", "0", "--resolution", "-2"},
                {"size", "not 0", "resolution", "not -2"});
}

TEST_F(GenerateCommandTest, RefusesUnknownNames) {
  ExpectFailure(2, {"--layout", "Forest.", "--vocabulary", "sea"}, {"\"sea\"", "suburb, wild"});
  ExpectFailure(2, {"--layout", "Forest.", "--generator", "oracle"}, {"\"oracle\"", "grounded"});
}

TEST_F(GenerateCommandTest, NeverReplacesWhatIsThere) {
  Write("world", "a file");
  ExpectFailure(1, {"--layout", "Forest."}, {"--out", "already exists"});
  EXPECT_EQ(Read("world"), "a file");
}

TEST_F(GenerateCommandTest, FailsBeforeItsWorkWhenTheBundleCannotBeMade) {
  for (const std::string& out : {PathOf("no/world"), std::string("/sys/world")}) {
    const ProgramRun run = Generate({"--layout", "Forest.", "--out", out});
    EXPECT_EQ(run.exit_status, 1);
    EXPECT_NE(run.err.find("--out"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("terrain"), std::string::npos) << run.err;
  }
  ExpectFailure(2, {"--layout", "Forest.", "--out", ""}, {"--out"});
  EXPECT_TRUE(Entries().empty());
}

TEST_F(GenerateCommandTest, TakesATrailingSlash) {
  EXPECT_EQ(Generate({"--layout", "Forest.", "--out", PathOf("world/")}).exit_status, 0);
  EXPECT_EQ(Entries(), std::vector<std::string>{"world"});
}

TEST_F(GenerateCommandTest, LeavesNothingWhenTheDiskIsFull) {
  for (const long limit : {0L, 2000L, 20000L}) {
    RunOptions options;
    options.max_file_bytes = limit;
    const ProgramRun run = Generate({"--layout", "Forest and a lake."}, options);
    EXPECT_EQ(run.exit_status, 1) << limit;
    EXPECT_NE(run.err.find("cannot save"), std::string::npos) << run.err;
    EXPECT_TRUE(Entries().empty()) << limit;
  }
}

TEST_F(GenerateCommandTest, LeavesNothingWhenItIsInterrupted) {
  for (const int signal : {SIGINT, SIGTERM}) {
    RunOptions options;
    options.signal = signal;
    const ProgramRun run = Generate(
        {"--layout", "Forest and a lake.", "--size", "512", "--resolution", "0.5"}, options);
    EXPECT_EQ(run.exit_status, 1);
    EXPECT_NE(run.err.find("cancelled"), std::string::npos) << run.err;
    EXPECT_TRUE(Entries().empty());
  }
}

}  // namespace
}  // namespace latticeworld
