#include <gtest/gtest.h>

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
        "zorblax", "satisfied", "1.000"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << " | " << run.out;
  }
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
  ExpectUsageError({"score"}, "one of a bundle, --symbols and --benchmark");
  ExpectUsageError({"score", PathOf("x"), "--benchmark", PathOf("y")}, "one of a bundle");
  ExpectUsageError({"score", "--symbols", PathOf("x")}, "--layout");
  ExpectUsageError({"score", "--benchmark", PathOf("x"), "--part", "all"}, "development, test");
  ExpectUsageError({"score", "--benchmark", PathOf("x"), "--generator", "oracle"}, "oracle");
  ExpectUsageError({"score", "--benchmark", PathOf("x"), "--remote-dialect", "latin"},
                   "llama.cpp, vllm, ollama, openai, none");
  Write("short.txt", "FFF\n");
  ExpectUsageError({"score", "--symbols", PathOf("short.txt"), "--layout", "Forest."}, "32");
  EXPECT_EQ(RunProgram({"score", PathOf("nothing")}).exit_status, 1);
  EXPECT_EQ(RunProgram({"score", "--benchmark", PathOf("nothing")}).exit_status, 1);
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
}

}  // namespace
}  // namespace latticeworld
