#include "latticeworld/generation/bundle/rebuild.h"

#include <gtest/gtest.h>

#include "generation/test_world.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

GenerationRequest Request(const std::string& generator, const std::string& reader = "") {
  GenerationRequest request;
  request.layout_instruction = "A lake in the north.";
  request.environment_instruction = "Two sheep graze.";
  request.vocabulary = "suburb";
  request.reader = reader;
  request.generator = generator;
  request.seed = 7;
  request.size_m = 64.0;
  request.resolution_m = 1.0;
  return request;
}

// What a model could have said: a refused layout, a legal one, an environment.
std::vector<ModelReply> Replies() {
  std::string layout;
  for (int row = 0; row < kLayoutSize; ++row) {
    layout += row < 10 ? std::string(kLayoutSize, 'W') : std::string(kLayoutSize, 'G');
    layout += '\n';
  }
  EnvironmentConfig environment;
  environment.fine = DeriveFineAttributes(environment.coarse);
  environment.agents = {{AgentCategory::kSheep, 2, AgentState::kGrazing, Region::kLower}};
  return {{"layout", "m", "I cannot draw.", "stop", 0, 0, 0, 0.1},
          {"layout", "m", layout, "stop", 0, 0, 0, 0.1},
          {"environment", "m", ToJson(environment), "stop", 0, 0, 0, 0.1}};
}

std::shared_ptr<const World> Generate(const std::vector<ModelReply>& replies, const std::string& by,
                                      const std::string& reader = "") {
  WorldGenerator generator(MakeReplayStack(replies));
  auto world = generator.Generate(Request(by, reader), Progress());
  EXPECT_TRUE(world.ok()) << world.status().ToString();
  return *world;
}

TEST(RebuildTest, AWorldOfAModelIsMadeAgainWithoutTheModel) {
  const auto world = Generate(Replies(), "remote");
  ASSERT_EQ(world->replies.size(), 3u);
  EXPECT_EQ(world->layout.cells(0, 0), 'W');
  const TemporaryDirectory directory;
  ASSERT_TRUE(SaveBundle(*world, directory.path() / "lake").ok());
  const auto loaded = LoadBundle(directory.path() / "lake");
  ASSERT_TRUE(loaded.ok()) << loaded.status().ToString();
  const auto rebuilt = RebuildWorld(**loaded, Progress());
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
  ExpectSameWorld(*world, **rebuilt);
}

TEST(RebuildTest, AWorldThatAModelReadIsMadeAgainWithoutTheModel) {
  const std::string map = R"({"sentences": ["A lake in the south.", "No houses."]})";
  const std::string scene = R"({"sentences": ["Time: night.", "2 goblins attacking."]})";
  // The first is given twice, for good; the second was cut off by its server after once.
  const auto world = Generate({{"layout_words", "m", map, "stop"},
                               {"layout_words", "m", map, "stop"},
                               {"environment_words", "m", scene, "stop"}},
                              "grounded", "remote");
  ASSERT_EQ(world->replies.size(), 3u);
  EXPECT_EQ(world->environment.coarse.time_of_day, TimeOfDay::kNight);
  const auto rebuilt = RebuildWorld(*world, Progress());
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
  ExpectSameWorld(*world, **rebuilt);
}

TEST(RebuildTest, OtherRepliesMakeAnotherWorld) {
  std::vector<ModelReply> replies = Replies();
  replies[1].text[0] = 'F';
  EXPECT_NE(Generate(Replies(), "remote")->id, Generate(replies, "remote")->id);
}

// As a bundle of before failures were recorded: nothing tells that a model was asked.
TEST(RebuildTest, WhereNothingIsRecordedTheGroundedBackEndAnswers) {
  const auto world = Generate({}, "remote");
  EXPECT_TRUE(world->replies.empty());
  EXPECT_EQ(world->id, Generate({}, "grounded")->id);
  EXPECT_EQ(world->warnings, Generate({}, "grounded")->warnings);
}

TEST(RebuildTest, ARecordingOfAsManyTurnsAsAreLegalIsMadeAgain) {
  std::vector<ModelReply> replies = Replies();
  replies.insert(replies.begin(), kMostRepairTurns - 1, replies.front());
  replies.insert(replies.end() - 1, kMostRepairTurns, {"environment", "m", "{}", "stop"});
  const auto world = Generate(replies, "remote");
  EXPECT_EQ(world->replies.size(), 2u * (kMostRepairTurns + 1));
  EXPECT_EQ(world->id, Generate(Replies(), "remote")->id);
}

TEST(RebuildTest, NamesTheFilesInWhichBundlesDiffer) {
  const auto manifest_of = [](const World& world) { return MakeManifest(world).value(); };
  const auto world = Generate(Replies(), "remote");
  const Manifest recorded = manifest_of(*world);
  World other = *world;
  other.stages.clear();
  EXPECT_TRUE(DifferingFiles(recorded, manifest_of(other)).empty()) << "times are not told";
  other.warnings.push_back("another one");
  EXPECT_EQ(DifferingFiles(recorded, manifest_of(other)), std::vector<std::string>{"world.json"});
  other = *world;
  other.replies.pop_back();
  EXPECT_EQ(DifferingFiles(recorded, manifest_of(other)), std::vector<std::string>{"replies.json"});
  // A file that only one of them has, whichever it is.
  Manifest less = recorded;
  less.files.pop_back();
  const std::vector<std::string> missing = {recorded.files.back().name};
  EXPECT_EQ(DifferingFiles(recorded, less), missing);
  EXPECT_EQ(DifferingFiles(less, recorded), missing);
}

TEST(LoadLanguageTest, RemoteIsThereOnlyWhereItIsWanted) {
  RemoteModelOptions options;
  auto embedded = LoadLanguage(options);
  ASSERT_TRUE(embedded.ok());
  EXPECT_EQ(embedded->stack.readers.size(), 2u);
  EXPECT_EQ(embedded->stack.readers.count("controlled"), 1u);
  EXPECT_EQ(embedded->stack.generators.size(), 1u);
  EXPECT_EQ(embedded->server, nullptr);
  options.server.url = "http://127.0.0.1:9/v1";
  auto both = LoadLanguage(options);
  ASSERT_TRUE(both.ok()) << both.status().ToString();
  EXPECT_EQ(both->stack.readers.count("remote"), 1u);
  EXPECT_EQ(both->stack.default_reader, "rules");
  EXPECT_EQ(both->stack.generators.count("remote"), 1u);
  EXPECT_EQ(both->stack.default_generator, "remote");
  ASSERT_NE(both->server, nullptr);
  EXPECT_EQ(both->server->statistics().requests, 0u);
}

TEST(LoadLanguageTest, EveryIllegalOptionIsNamedAtOnce) {
  RemoteModelOptions options;
  options.server.url = "ftp://example.org";
  options.server.total_timeout_s = -1.0;
  options.model.repair_turns = 99;
  const auto language = LoadLanguage(options);
  ASSERT_FALSE(language.ok());
  EXPECT_EQ(language.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(language.status().violations().size(), 3u) << language.status().ToString();
}

// Each under the name of its kind, as the options of the programs are called.
TEST(LoadLanguageTest, TheIllegalOptionsOfEveryModelAreNamedTogether) {
  RemoteModelOptions remote;
  remote.server.url = "http://127.0.0.1:9/v1";
  remote.server.max_retries = 99;
  LocalModelOptions local;
  local.layout_model = "layouts.gguf";
  local.tries = 0;
  ReaderModelOptions reader;
  reader.model = "reader.gguf";
  reader.threads = -1;
  const Status status = LoadLanguage(remote, local, reader).status();
  ASSERT_EQ(status.violations().size(), 3u) << status.ToString();
  EXPECT_EQ(status.violations()[0].pointer, "remote_max_retries");
  EXPECT_EQ(status.violations()[1].pointer, "local_tries");
  EXPECT_EQ(status.violations()[2].pointer, "reader_threads");
}

// Nobody listens on the discard port: what a setting makes of a server that cannot be had.
TEST(LoadLanguageTest, AServerThatCannotBeHadIsAnErrorOrTheGroundedBackEnd) {
  RemoteModelOptions options;
  options.server.url = "http://127.0.0.1:9/v1";
  options.server.model = "m";
  options.server.max_retries = 0;
  for (const bool fallback : {false, true}) {
    options.fallback = fallback;
    LoadedLanguage language = *LoadLanguage(options);
    WorldGenerator generator(std::move(language.stack));
    const auto world = generator.Generate(Request(""), Progress());
    if (!fallback) {
      ASSERT_FALSE(world.ok());
      EXPECT_EQ(world.status().code(), StatusCode::kUnavailable) << world.status().ToString();
      continue;
    }
    ASSERT_TRUE(world.ok()) << world.status().ToString();
    EXPECT_EQ((*world)->id, Generate({}, "grounded")->id);
    ASSERT_FALSE((*world)->warnings.empty());
    EXPECT_NE((*world)->warnings[0].find("grounded"), std::string::npos) << (*world)->warnings[0];
  }
}

}  // namespace
}  // namespace latticeworld
