#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "dataset/answering_server.h"
#include "tools/run_program.h"

namespace latticeworld {
namespace {

// The words of this text that begin with a prefix and go on with a-z and one joining letter.
std::set<std::string> WordsWith(const std::string& prefix, char joint, const std::string& text) {
  std::set<std::string> words;
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
    std::size_t end = at + prefix.size();
    while (end < text.size() && (text[end] == joint || (text[end] >= 'a' && text[end] <= 'z')))
      ++end;
    words.insert(text.substr(at + prefix.size(), end - at - prefix.size()));
    at = end;
  }
  return words;
}

class LanguageArgumentsTest : public ProgramTest {
 protected:
  // A small world in the directory `world`, with these options besides.
  ProgramRun Generate(const std::vector<std::string>& options, const std::string& world = "world") {
    std::vector<std::string> arguments = {"generate",
                                          "--layout",
                                          "A lake in the north.",
                                          "--vocabulary",
                                          "suburb",
                                          "--seed",
                                          "5",
                                          "--size",
                                          "64",
                                          "--resolution",
                                          "1",
                                          "--out",
                                          PathOf(world)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunProgram(arguments);
  }

  void ExpectUsageError(const std::vector<std::string>& options,
                        const std::vector<std::string>& words) {
    const ProgramRun run = Generate(options);
    EXPECT_EQ(run.exit_status, 2) << run.err;
    for (const std::string& word : words) {
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " | " << run.err;
    }
    EXPECT_TRUE(Entries().empty());
  }
};

TEST_F(LanguageArgumentsTest, EveryRemoteParameterOfTheNodeIsAnOption) {
  std::string parameters;
  std::ifstream file(LATTICEWORLD_NODE_PARAMETERS);
  for (std::string line; std::getline(file, line);)
    parameters += line.substr(0, line.find(':')) + "\n";
  std::set<std::string> wanted;
  for (std::string name : WordsWith("remote_", '_', parameters)) {
    for (char& letter : name) letter = letter == '_' ? '-' : letter;
    wanted.insert(name);
  }
  EXPECT_EQ(wanted.count("max-retries"), 1u);
  for (const char* command : {"generate", "score"}) {
    const ProgramRun help = RunProgram({command, "--help"});
    EXPECT_EQ(WordsWith("--remote-", '-', help.out), wanted) << command;
  }
}

TEST_F(LanguageArgumentsTest, RefusesUnusableOptionsOfAServer) {
  const std::vector<std::string> server = {"--remote-url", "http://127.0.0.1:9/v1"};
  const std::vector<std::vector<std::string>> rows = {
      // option, values, what the message says is legal
      {"--remote-max-retries", "-1", "21", "0.5", "from 0 to 20"},
      {"--remote-backoff", "-0.1", "60.5", "from 0 to 60 s"},
      {"--remote-max-answer-bytes", "1023", "67108865", "1e6", "from 1024 to 67108864"},
      {"--remote-layout-max-tokens", "63", "65537", "from 64 to 65536"},
      {"--remote-environment-max-tokens", "63", "65537", "from 64 to 65536"}};
  for (const std::vector<std::string>& row : rows) {
    const std::string& option = row.front();
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      std::vector<std::string> options = server;
      options.insert(options.end(), {option, row[i]});
      ExpectUsageError(options, {option + ": must be", row.back(), row[i]});
    }
    ExpectUsageError({option, "64"}, {option, "only beside --remote-url"});
  }
}

TEST_F(LanguageArgumentsTest, OptionsOfAServerReachItsClient) {
  const ProgramRun embedded = Generate({"--environment", "A rainy night."}, "embedded");
  ASSERT_EQ(embedded.exit_status, 0) << embedded.err;
  const std::string layout = Read("embedded/layout.txt");
  const std::string environment = Read("embedded/environment.json");
  {
    const AnsweringServer server({503, layout, environment});
    const ProgramRun run = Generate({"--remote-url", server.url(), "--remote-max-retries", "1",
                                     "--remote-backoff", "0", "--remote-layout-max-tokens", "1500",
                                     "--remote-environment-max-tokens", "2500"});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_EQ(Read("world/layout.txt"), layout);
    EXPECT_EQ(Read("world/environment.json"), environment);
    std::vector<int> max_tokens;
    for (const auto& body : server.Requests()) max_tokens.push_back(body.at("max_tokens"));
    EXPECT_EQ(max_tokens, (std::vector<int>{1500, 1500, 2500}));
  }
  {
    const AnsweringServer server({503, layout, environment});
    const ProgramRun run =
        Generate({"--remote-url", server.url(), "--remote-max-retries", "0"}, "none");
    EXPECT_EQ(run.exit_status, 1) << run.err;
    EXPECT_NE(run.err.find("gave up after 1 try"), std::string::npos) << run.err;
  }
  {
    const AnsweringServer server({503, layout, environment});
    // The next try would be due after 30 s at the earliest.
    const ProgramRun run = Generate(
        {"--remote-url", server.url(), "--remote-backoff", "60", "--remote-total-timeout", "20"},
        "none");
    EXPECT_EQ(run.exit_status, 1) << run.err;
    EXPECT_NE(run.err.find("beyond the total timeout of 20 s"), std::string::npos) << run.err;
  }
  {
    const AnsweringServer server({layout, environment});
    const ProgramRun run =
        Generate({"--remote-url", server.url(), "--remote-max-answer-bytes", "1024"}, "none");
    EXPECT_EQ(run.exit_status, 1) << run.err;
    EXPECT_NE(run.err.find("at most 1024 bytes"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace latticeworld
