#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/answering_server.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "tools/run_program.h"

namespace latticeworld {
namespace {

class ScoreCommandTest : public ProgramTest {
 protected:
  void ExpectUsageError(const std::vector<std::string>& arguments, const std::string& words) {
    const ProgramRun run = RunProgram(arguments);
    EXPECT_EQ(run.exit_status, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(words), std::string::npos) << words << " | " << run.err;
  }

  std::string MakeBundle() {
    const ProgramRun run =
        RunProgram({"generate", "--layout", "A lake in the center and a zorblax.", "--environment",
                    "A rainy night.", "--seed", "5", "--size", "64", "--resolution", "1", "--out",
                    PathOf("lake")});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return PathOf("lake");
  }
};

TEST_F(ScoreCommandTest, MeasuresABundleByItsOwnWords) {
  const ProgramRun run = RunProgram({"score", MakeBundle()});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* words :
       {"yes  layout present", "A lake in the center", "yes  environment coarse", "not understood",
        "zorblax", "satisfied", "of what was read; 1 phrase was not"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
  EXPECT_EQ(run.out.find("1.000"), std::string::npos) << "a word was lost: " << run.out;
}

// Whoever does not trust the reading brings claims of their own.
TEST_F(ScoreCommandTest, MeasuresABundleByClaimsWrittenByHand) {
  const std::string bundle = MakeBundle();
  Write("claims.json", R"([{"kind": "present", "subject": "W", "zone": "center"},
                           {"kind": "absent", "subject": "W"}])");
  Write("environment.json", R"([{"kind": "coarse", "attribute": "weather", "values": ["rain"]}])");
  const ProgramRun run = RunProgram({"score", bundle, "--claims", PathOf("claims.json"),
                                     "--environment-claims", PathOf("environment.json")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* words : {"yes  layout present", "NO   layout absent", "yes  environment coarse",
                            "2 of     3   0.667"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
  Write("wrong.json", R"([{"kind": "zorblax"}])");
  const ProgramRun wrong = RunProgram({"score", bundle, "--claims", PathOf("wrong.json")});
  EXPECT_NE(wrong.exit_status, 0);
  EXPECT_NE(wrong.err.find("--claims"), std::string::npos) << wrong.err;
}

TEST_F(ScoreCommandTest, MeasuresALayoutOfAnyOriginByAnyWords) {
  std::string layout;
  for (int row = 0; row < 32; ++row) layout += std::string(32, row < 16 ? 'F' : 'G') + "\n";
  Write("layout.txt", layout);
  const auto score = [&](const std::string& words) {
    return RunProgram({"score", "--symbols", PathOf("layout.txt"), "--layout", words});
  };
  const ProgramRun right = score("The northern half is forest.");
  EXPECT_EQ(right.exit_status, 0) << right.err;
  EXPECT_EQ(right.out.find("NO "), std::string::npos) << right.out;
  EXPECT_NE(right.out.find("1.000"), std::string::npos) << right.out;
  const ProgramRun wrong = score("A lake in the center.");
  EXPECT_NE(wrong.out.find("NO   layout present"), std::string::npos) << wrong.out;
  EXPECT_NE(wrong.out.find("0.000"), std::string::npos) << wrong.out;
}

TEST_F(ScoreCommandTest, RefusesWhatItCannotScore) {
  ExpectUsageError({"score"}, "one of a bundle, --symbols, --benchmark and --examples");
  ExpectUsageError({"score", PathOf("x"), "--benchmark", PathOf("y")}, "one of a bundle");
  ExpectUsageError({"score", "--symbols", PathOf("x")}, "--layout");
  ExpectUsageError({"score", "--benchmark", PathOf("x"), "--part", "all"},
                   "development, test, first_sight");
  ExpectUsageError({"score", "--benchmark", PathOf("x"), "--generator", "oracle"}, "oracle");
  ExpectUsageError({"score", "--benchmark", PathOf("x"), "--reader", "crystal ball"},
                   "controlled, rules");
  ExpectUsageError({"score", "--benchmark", PathOf("x"), "--remote-dialect", "latin"},
                   "llama.cpp, vllm, ollama, openai, none");
  Write("short.txt", "FFF\n");
  ExpectUsageError({"score", "--symbols", PathOf("short.txt"), "--layout", "Forest."}, "32");
  EXPECT_EQ(RunProgram({"score", PathOf("nothing")}).exit_status, 1);
  EXPECT_EQ(RunProgram({"score", "--benchmark", PathOf("nothing")}).exit_status, 1);
  const ProgramRun unseen =
      RunProgram({"score", "--benchmark", PathOf("nothing"), "--part", "first_sight"});
  EXPECT_EQ(unseen.exit_status, 1);
  EXPECT_NE(unseen.err.find("layout_first_sight.json"), std::string::npos) << unseen.err;
}

TEST_F(ScoreCommandTest, RebuildMakesTheSameWorldAgain) {
  const std::string bundle = MakeBundle();
  const ProgramRun run = RunProgram({"rebuild", bundle, "--out", PathOf("again")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("the same"), std::string::npos) << run.out;
  for (const char* file : {"layout.txt", "environment.json", "terrain.bin", "assets.csv",
                           "agents.json", "elements.json", "fidelity.json", "replies.json"}) {
    EXPECT_EQ(Read(std::string("lake/") + file), Read(std::string("again/") + file)) << file;
  }
}

TEST_F(ScoreCommandTest, MeasuresWhatAModelBehindAServerAnswers) {
  MakeBundle();  // of a rainy night
  std::string lake_in_the_north, meadow;
  for (int row = 0; row < 32; ++row) {
    lake_in_the_north += std::string(32, row < 10 ? 'W' : 'G') + "\n";
    meadow += std::string(32, 'G') + "\n";
  }
  std::filesystem::create_directories(PathOf("benchmark/layouts"));
  Write("benchmark/layouts/meadow.txt", meadow);
  Write("benchmark/layout_development.json", R"([
    {"id": "a", "vocabulary": "suburb", "voice": "plain",
     "instruction": "A lake in the north, a town in the south.", "claims": [
      {"kind": "present", "subject": "W", "zone": "northern third", "words": "A lake in the north"},
      {"kind": "present", "subject": "B", "zone": "southern third", "words": "a town in the south"}]}])");
  Write("benchmark/environment_development.json", R"([
    {"id": "b", "layout": "meadow", "vocabulary": "suburb", "voice": "plain",
     "instruction": "Rain at noon.", "claims": [
      {"kind": "coarse", "attribute": "weather", "values": ["rain"], "words": "Rain"},
      {"kind": "coarse", "attribute": "time_of_day", "values": ["noon"], "words": "at noon"}]}])");
  const AnsweringServer server({lake_in_the_north, Read("lake/environment.json")});
  const ProgramRun run =
      RunProgram({"score", "--benchmark", PathOf("benchmark"), "--generator", "remote",
                  "--remote-url", server.url(), "--remote-repair-turns", "0", "--misses"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* words :
       {"layout instructions, development part, read by rules, answered by remote\n  present       "
        "       1 of     2",
        "  a present: \"a town in the south\"",
        "environment instructions, development part, read by rules, answered by remote\n"
        "  coarse               1 of     2",
        "  b coarse: \"at noon\"", "  valid answers        1 of     1"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
  const auto requests = server.Requests();
  ASSERT_EQ(requests.size(), 2u);
  EXPECT_NE(requests[0].dump().find("A lake in the north, a town"), std::string::npos);
  EXPECT_NE(requests[1].dump().find("Rain at noon."), std::string::npos);
}

TEST_F(ScoreCommandTest, RebuildNamesTheFilesThatDiffer) {
  World world = *LoadBundle(MakeBundle()).value();
  world.warnings.push_back("nobody said this");
  ASSERT_TRUE(SaveBundle(world, PathOf("told")).ok());
  const ProgramRun told = RunProgram({"rebuild", PathOf("told"), "--out", PathOf("made")});
  EXPECT_EQ(told.exit_status, 1);
  EXPECT_EQ(told.out, "");
  EXPECT_NE(
      told.err.find("makes the same of its request and replies with other bytes in world.json"),
      std::string::npos)
      << told.err;
  EXPECT_EQ(Read("made/layout.txt"), Read("told/layout.txt")) << "it can be looked at";

  world.request.seed = 6;  // of another land
  ASSERT_TRUE(SaveBundle(world, PathOf("seeded")).ok());
  const ProgramRun seeded = RunProgram({"rebuild", PathOf("seeded")});
  EXPECT_EQ(seeded.exit_status, 1);
  for (const std::string& words : {"holds " + world.id + ", but", std::string("assets.csv, "),
                                   std::string("terrain.bin, "), std::string("world.json")}) {
    EXPECT_NE(seeded.err.find(words), std::string::npos) << words << " | " << seeded.err;
  }
  EXPECT_EQ(seeded.err.find("replies.json"), std::string::npos) << seeded.err;
}

TEST_F(ScoreCommandTest, AServerThatIsNotThereIsAFailureOrTheFallback) {
  const std::vector<std::string> generate = {"generate",
                                             "--layout",
                                             "A lake.",
                                             "--seed",
                                             "5",
                                             "--size",
                                             "64",
                                             "--resolution",
                                             "1",
                                             "--out",
                                             PathOf("w"),
                                             "--remote-url",
                                             "http://127.0.0.1:9/v1",
                                             "--remote-model",
                                             "m",
                                             "--remote-total-timeout",
                                             "0.5"};
  const ProgramRun refused = RunProgram(generate);
  EXPECT_EQ(refused.exit_status, 1) << refused.err;
  EXPECT_NE(refused.err.find("127.0.0.1:9"), std::string::npos) << refused.err;
  EXPECT_TRUE(Entries().empty());
  std::vector<std::string> fallback = generate;
  fallback.push_back("--remote-fallback");
  const ProgramRun made = RunProgram(fallback);
  EXPECT_EQ(made.exit_status, 0) << made.err;
  EXPECT_NE(made.out.find("warning"), std::string::npos) << made.out;
  const ProgramRun again = RunProgram({"rebuild", PathOf("w")});
  EXPECT_EQ(again.exit_status, 0) << again.err;
  EXPECT_NE(again.out.find("the same, from 0 recorded replies"), std::string::npos) << again.out;
}

TEST_F(ScoreCommandTest, ExamplesForReadersAreABenchmark) {
  Write(
      "examples.jsonl",
      R"({"kind": "layout", "author": "a", "voice": "v", "vocabulary": "suburb", "text": "A lake in the north.", "sentences": ["A lake in the north"]})"
      "\n"
      R"({"kind": "environment", "author": "a", "voice": "v", "text": "It rains, and nobody is there.", "sentences": ["Weather: rain", "No agents"]})"
      "\n");
  const ProgramRun run = RunProgram({"score", "--examples", PathOf("examples.jsonl")});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_NE(run.out.find("read by rules, answered by grounded"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("no_agents            1 of     1"), std::string::npos) << run.out;
  const ProgramRun told = RunProgram(
      {"score", "--examples", PathOf("examples.jsonl"), "--reader", "controlled", "--warnings"});
  EXPECT_EQ(told.exit_status, 0) << told.err;
  EXPECT_NE(told.out.find("examples 2 warning: not understood: \"It rains, and nobody is there\""),
            std::string::npos)
      << told.out;
  Write("wrong.jsonl", R"({"kind": "song"})"
                       "\n");
  const ProgramRun wrong = RunProgram({"score", "--examples", PathOf("wrong.jsonl")});
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_NE(wrong.err.find("wrong 1: kind"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace latticeworld
