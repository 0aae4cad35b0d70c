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
  for (const char* word :
       {"world-", "seed         42", "5 sheep", "autumn", "rain", "assets", "stages", "scene"}) {
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
  for (const char* file : {"terrain.bin", "assets.csv", "agents.json", "environment.json",
                           "height.png", "world.bt", "preview.png"}) {
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
                {"163840", "4096"});
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
