#include <gtest/gtest.h>

#include <filesystem>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

class CommandLineTest : public ProgramTest {
 protected:
  // Unusable arguments: status 2, nothing on stdout, and stderr holds every one of the words.
  void ExpectUsageError(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& words) {
    const ProgramRun run = RunProgram(arguments);
    EXPECT_EQ(run.exit_status, 2) << run.err;
    EXPECT_EQ(run.out, "");
    for (const std::string& word : words) {
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " | " << run.err;
    }
  }

  // A small world.
  std::string MakeBundle() {
    const ProgramRun run =
        RunProgram({"generate", "--layout", "A lake in the center, forest in the upper left.",
                    "--environment", "Two sheep graze.", "--seed", "5", "--size", "64",
                    "--resolution", "1", "--out", PathOf("lake")});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return PathOf("lake");
  }
};

TEST_F(CommandLineTest, TellsItsCommandsAndTheirOptions) {
  const ProgramRun top = RunProgram({"--help"});
  EXPECT_EQ(top.exit_status, 0);
  EXPECT_EQ(top.err, "");
  for (const char* word : {"generate", "show", "picture", "--version", "Exit status"}) {
    EXPECT_NE(top.out.find(word), std::string::npos) << word << " | " << top.out;
  }
  const std::vector<std::pair<std::string, std::vector<std::string>>> commands = {
      {"generate",
       {"--layout", "--environment", "--height-map", "--height-scale", "--height-offset",
        "--vocabulary", "--generator", "grounded", "--seed", "--size", "--resolution", "--out",
        "@FILE"}},
      {"show", {"DIR"}},
      {"picture", {"DIR", "--out", "--width", "--view"}},
      {"score", {"DIR", "--symbols", "--benchmark", "--part", "--misses", "--remote-url"}},
      {"measure", {"PATH", "--size", "--height-scale", "--json"}},
      {"rebuild", {"DIR", "--out"}}};
  for (const auto& [command, words] : commands) {
    const ProgramRun run = RunProgram({command, "--help"});
    EXPECT_EQ(run.exit_status, 0);
    for (const std::string& word : words) {
      EXPECT_NE(run.out.find(word), std::string::npos) << command << ": " << word;
    }
  }
}

TEST_F(CommandLineTest, SaysEveryViolationOnALineOfItsOwnByItsOption) {
  const ProgramRun run = RunProgram({"generate", "--layout", "Forest.", "--vocabulary", "sea",
                                     "--size", "0", "--out", PathOf("w")});
  EXPECT_EQ(run.err.rfind("latticeworld generate: unusable arguments\n  --vocabulary: ", 0), 0u)
      << run.err;
  EXPECT_NE(run.err.find("\n  --size: "), std::string::npos) << run.err;
}

TEST_F(CommandLineTest, TellsItsVersion) {
  const ProgramRun run = RunProgram({"--version"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_EQ(run.out.rfind("latticeworld ", 0), 0u);
  EXPECT_NE(run.out.find('.'), std::string::npos);
}

TEST_F(CommandLineTest, RefusesWhatIsNoCommand) {
  ExpectUsageError(
      {}, {"generate, show, query, picture, export, measure, score, rebuild, catalogue, species"});
  ExpectUsageError(
      {"grow"},
      {"grow",
       "generate, show, query, picture, export, measure, score, rebuild, catalogue, species"});
  ExpectUsageError(
      {"--frobnicate"},
      {"--frobnicate",
       "generate, show, query, picture, export, measure, score, rebuild, catalogue, species"});
}

TEST_F(CommandLineTest, RefusesUnusableOptions) {
  const std::string out = PathOf("w");
  ExpectUsageError({"generate", "--layout", "x", "--out", out, "--colour", "red"},
                   {"--colour", "--layout", "--resolution"});
  ExpectUsageError({"generate", "--layout", "x"}, {"--out"});
  ExpectUsageError({"generate", "--layout", "x", "--out"}, {"--out"});
  ExpectUsageError({"generate", "--layout", "--out", out}, {"--layout", "--out"});
  ExpectUsageError({"generate", "--layout", "x", "--out", out, "--seed", "1", "--seed", "2"},
                   {"--seed"});
  ExpectUsageError({"generate", "--layout", "x", "--out", out, "more"}, {"more"});
  ExpectUsageError({"show"}, {"DIR"});
  ExpectUsageError({"show", "a", "b"}, {"b"});
  ExpectUsageError({"picture", "a"}, {"--out"});
  EXPECT_TRUE(Entries().empty());
}

TEST_F(CommandLineTest, RefusesEveryUnusableNumberAtOnce) {
  ExpectUsageError({"generate", "--layout", "x", "--out", PathOf("w"), "--seed", "-1", "--size",
                    "wide", "--resolution", "nan", "--height-scale", "inf"},
                   {"--seed", "\"-1\"", "--size", "\"wide\"", "--resolution", "\"nan\"",
                    "--height-scale", "\"inf\"", "--height-map"});
  ExpectUsageError({"generate", "--layout", "x", "--out", PathOf("w"), "--size", ""}, {"--size"});
  ExpectUsageError({"generate", "--layout", "x", "--out", PathOf("w"), "--size", "64m"}, {"64m"});
  ExpectUsageError({"generate", "--layout", "x", "--out", PathOf("w"), "--size", "1e999"},
                   {"1e999"});
  ExpectUsageError(
      {"generate", "--layout", "x", "--out", PathOf("w"), "--seed", "18446744073709551616"},
      {"18446744073709551615"});
  EXPECT_TRUE(Entries().empty());
}

TEST_F(CommandLineTest, ShowsWhatABundleHolds) {
  const ProgramRun run = RunProgram({"show", MakeBundle()});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* word : {"world-", "seed         5", "A lake in the center", "64 x 64 cells",
                           "sheep", "suburb", "grounded", "terrain"}) {
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " | " << run.out;
  }
  EXPECT_EQ(run.out.find('\033'), std::string::npos) << "colours belong on a terminal only";
}

TEST_F(CommandLineTest, DrawsEveryView) {
  const std::string bundle = MakeBundle();
  const std::string signature = "\x89PNG";
  std::vector<std::string> pictures;
  for (const char* view : {"top", "oblique", "world"}) {
    const ProgramRun run = RunProgram({"picture", bundle, "--out", PathOf("p.png"), "--view", view,
                                       "--width", "128"});  // the second replaces the first
    EXPECT_EQ(run.exit_status, 0) << run.err;
    pictures.push_back(Read("p.png"));
    EXPECT_EQ(pictures.back().substr(0, 4), signature) << view;
  }
  EXPECT_NE(pictures[0], pictures[1]);
  EXPECT_NE(pictures[1], pictures[2]);
  const ProgramRun run =
      RunProgram({"picture", bundle, "--out", PathOf("p.png"), "--width", "128"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(Read("p.png"), pictures[2]) << "world is the default";
  EXPECT_EQ(Entries(), (std::vector<std::string>{"lake", "p.png"}));
}

TEST_F(CommandLineTest, RefusesUnusablePictures) {
  const std::string bundle = MakeBundle();
  const std::string out = PathOf("p.png");
  ExpectUsageError({"picture", bundle, "--out", out, "--width", "63"}, {"--width", "64", "4096"});
  ExpectUsageError({"picture", bundle, "--out", out, "--width", "1e3"}, {"--width"});
  ExpectUsageError({"picture", bundle, "--out", out, "--view", "below"},
                   {"below", "world, top, oblique"});
  ProgramRun run = RunProgram({"picture", bundle, "--out", PathOf("no/where.png")});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.err.find("no/where.png"), std::string::npos) << run.err;
  RunOptions full_disk;
  full_disk.max_file_bytes = 100;
  run = RunProgram({"picture", bundle, "--out", out}, full_disk);
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.err.find("p.png"), std::string::npos) << run.err;
  EXPECT_EQ(Entries(), std::vector<std::string>{"lake"});
}

TEST_F(CommandLineTest, NamesTheDamagedFileOfABundle) {
  const std::string bundle = MakeBundle();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(bundle)) {
    if (!entry.is_regular_file()) continue;
    names.push_back(std::filesystem::relative(entry.path(), bundle).string());
  }
  EXPECT_GE(names.size(), 14u);
  for (const std::string& name : names) {
    const std::string content = Read("lake/" + name);
    std::string changed = content;
    changed[changed.size() / 2] ^= 4;
    Write("lake/" + name, changed);
    const ProgramRun run = RunProgram({"show", bundle});
    EXPECT_EQ(run.exit_status, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(name + ": "), std::string::npos) << name << " | " << run.err;
    Write("lake/" + name, content);
  }
  const ProgramRun run = RunProgram({"show", PathOf("nowhere")});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.err.find("nowhere"), std::string::npos);
}

TEST_F(CommandLineTest, FailsWhenItsAnswerCannotBeWritten) {
  RunOptions options;
  options.out_path = "/dev/full";
  const ProgramRun run = RunProgram({"show", MakeBundle()}, options);
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.err.find("standard output"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace latticeworld
