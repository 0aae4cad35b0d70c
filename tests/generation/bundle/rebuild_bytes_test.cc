#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "generation/test_world.h"
#include "language/remote/fake_chat_server.h"
#include "latticeworld/common/files.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/generation/bundle/rebuild.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpreting_reader.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr char kMap[] = R"({"sentences": ["A lake in the south.", "No houses."]})";
constexpr char kScene[] = R"({"sentences": ["Time: night.", "2 goblins attacking."]})";
// Legal JSON, of which nothing is a sentence of the small language.
constexpr char kZero[] = R"({"sentences": ["A lake\u0000."]})";

// What a server says to those that ask for a world, and what comes of it.
struct Talk {
  std::string name;
  std::string reader;
  std::string generator;
  std::function<void(FakeChatServer* server)> script;
  // Purposes of the replies in order, "!" before one: the record of a failure.
  std::vector<std::string> recorded;
  // Parts of the warnings that tell of the fallback, in order.
  std::vector<std::string> fallbacks;
};

std::ostream& operator<<(std::ostream& out, const Talk& talk) { return out << talk.name; }

std::vector<Talk> Talks() {
  using Server = FakeChatServer;
  const Status gone = Unavailable("127.0.0.1:9: \"connection refused\" after 0.25 s");
  const std::vector<std::string> both_unavailable = {"remote back end failed (UNAVAILABLE",
                                                     "remote back end failed (UNAVAILABLE"};
  return {
      {"RemoteAtOnce",
       "rules",
       "remote",
       [](Server* server) { server->Say(LegalMatrix()).Say(LegalEnvironment()); },
       {"layout", "environment"},
       {}},
      {"RemoteAfterARepairTurn",
       "rules",
       "remote",
       [](Server* server) {
         server->Say("I cannot draw.").Say(LegalMatrix()).Say("{}").Say(LegalEnvironment());
       },
       {"layout", "layout", "environment", "environment"},
       {}},
      {"RemoteRefused",
       "rules",
       "remote",
       [](Server* server) {
         server->Say("no").Say("never").Say("not \"at\" all\n").Say("{}").Say("{}").Say("1");
       },
       {"layout", "layout", "layout", "!layout", "environment", "environment", "environment",
        "!environment"},
       {"remote back end failed (DATA_LOSS", "remote back end failed (DATA_LOSS"}},
      {"RemoteRefusedForTheLayoutOnly",
       "rules",
       "remote",
       [](Server* server) { server->Say("no").Say("no").Say("no").Say(LegalEnvironment()); },
       {"layout", "layout", "layout", "!layout", "environment"},
       {"remote back end failed (DATA_LOSS"}},
      {"RemoteGoneAfterTheLayout",
       "rules",
       "remote",
       [gone](Server* server) { server->Say(LegalMatrix()).Say("{}").Fail(gone); },
       {"layout", "environment", "!environment"},
       {"remote back end failed (UNAVAILABLE: repair turn 1: "}},
      {"RemoteGone",
       "rules",
       "remote",
       [gone](Server* server) { server->Fail(gone).Fail(gone); },
       {"!layout", "!environment"},
       both_unavailable},
      {"InterpretedAtOnce",
       "remote",
       "grounded",
       [](Server* server) { server->Say(kMap).Say(kMap).Say(kScene).Say(kScene); },
       {"layout_words", "layout_words", "environment_words", "environment_words"},
       {}},
      {"InterpretedAfterARepairTurn",
       "remote",
       "grounded",
       [](Server* server) {
         server->Say("A lake?").Say(kMap).Say(kMap).Say("?").Say(kScene).Say(kScene);
       },
       {"layout_words", "layout_words", "layout_words", "environment_words", "environment_words",
        "environment_words"},
       {}},
      {"InterpretedToTheLastTurn",
       "remote",
       "grounded",
       [](Server* server) {
         server->Say(kScene).Say("?").Say(kMap).Say(kMap).Say(kScene).Say("?");
       },
       {"layout_words", "layout_words", "layout_words", "environment_words", "environment_words",
        "environment_words"},
       {}},
      {"InterpretedGoneOnceItHadSaidSomething",
       "remote",
       "grounded",
       [gone](Server* server) { server->Say(kMap).Fail(gone).Say(kScene).Fail(gone); },
       {"layout_words", "environment_words"},
       {}},
      {"InterpretedRefused",
       "remote",
       "grounded",
       [](Server* server) { server->Say("1").Say("2").Say("3").Say("4").Say("5").Say("6"); },
       {"layout_words", "layout_words", "layout_words", "!layout_words", "environment_words",
        "environment_words", "environment_words", "!environment_words"},
       {"reader remote failed (DATA_LOSS", "reader remote failed (DATA_LOSS"}},
      {"InterpretedInASentenceOfNoForm",
       "remote",
       "grounded",
       [](Server* server) { server->Say(kZero).Say(kZero).Say(kScene).Say(kScene); },
       {"layout_words", "layout_words", "environment_words", "environment_words"},
       {}},
      {"InterpretedGone",
       "remote",
       "grounded",
       [gone](Server* server) { server->Fail(gone).Fail(gone); },
       {"!layout_words", "!environment_words"},
       {"reader remote failed (UNAVAILABLE", "reader remote failed (UNAVAILABLE"}},
  };
}

// Who reads and who answers over a server, with the embedded ones to fall back on.
LanguageStack StackOver(const std::shared_ptr<ChatServer>& server, const Talk& talk) {
  LanguageStack stack;
  stack.default_reader = talk.reader;
  stack.default_generator = talk.generator;
  stack.readers["rules"] = MakeRuleReader();
  stack.readers["remote"] =
      MakeFallbackReader(MakeInterpretingReader(server, {}), MakeRuleReader());
  stack.generators["grounded"] = {MakeGroundedLayoutGenerator(),
                                  MakeGroundedEnvironmentGenerator()};
  stack.generators["remote"] = {
      MakeFallbackLayoutGenerator(MakeRemoteLayoutGenerator(server, {}),
                                  MakeGroundedLayoutGenerator()),
      MakeFallbackEnvironmentGenerator(MakeRemoteEnvironmentGenerator(server, {}),
                                       MakeGroundedEnvironmentGenerator())};
  return stack;
}

std::shared_ptr<const World> Generate(const Talk& talk) {
  const auto server = std::make_shared<FakeChatServer>();
  talk.script(server.get());
  GenerationRequest request;
  request.layout_instruction = "A lake in the north.";
  request.environment_instruction = "Two sheep graze.";
  request.vocabulary = "suburb";
  request.seed = 7;
  request.size_m = 64.0;
  request.resolution_m = 1.0;
  auto world = WorldGenerator(StackOver(server, talk)).Generate(request, Progress());
  EXPECT_TRUE(world.ok()) << world.status().ToString();
  return world.ok() ? *world : nullptr;
}

// The bytes of every file of a bundle, by its name.
std::map<std::string, std::string> FilesOf(const fs::path& bundle) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(bundle)) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), bundle).string()] =
        ReadFile(entry.path(), kMaxBundleFileBytes).value();
  }
  return files;
}

// world.json tells how long each stage took, which no two runs have in common; nothing else in a
// bundle does. What it says without these times.
std::string WithoutTimes(const std::string& manifest_json) {
  Manifest manifest = DecodeManifest(manifest_json).value();
  for (StageTime& stage : manifest.stages) stage.seconds = 0.0;
  return EncodeManifest(manifest);
}

class RebuildBytesTest : public testing::TestWithParam<Talk> {};

TEST_P(RebuildBytesTest, EveryFileIsTheSameWithoutTheServer) {
  const auto world = Generate(GetParam());
  ASSERT_NE(world, nullptr);
  std::vector<std::string> recorded;
  for (const ModelReply& reply : world->replies)
    recorded.push_back((reply.failure.ok() ? "" : "!") + reply.purpose);
  EXPECT_EQ(recorded, GetParam().recorded);
  std::vector<std::string> told;
  for (const std::string& warning : world->warnings)
    if (warning.find(" failed (") != std::string::npos) told.push_back(warning);
  ASSERT_EQ(told.size(), GetParam().fallbacks.size());
  for (std::size_t i = 0; i < told.size(); ++i)
    EXPECT_NE(told[i].find(GetParam().fallbacks[i]), std::string::npos) << told[i];

  const TemporaryDirectory directory;
  ASSERT_TRUE(SaveBundle(*world, directory.path() / "made").ok());
  const auto loaded = LoadBundle(directory.path() / "made");
  ASSERT_TRUE(loaded.ok()) << loaded.status().ToString();
  const auto rebuilt = RebuildWorld(**loaded, Progress());
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
  ASSERT_TRUE(SaveBundle(**rebuilt, directory.path() / "again").ok());

  auto made = FilesOf(directory.path() / "made");
  auto again = FilesOf(directory.path() / "again");
  EXPECT_GE(made.size(), 15u);
  for (auto* files : {&made, &again})
    files->at(kManifestFile) = WithoutTimes(files->at(kManifestFile));
  EXPECT_EQ(made.size(), again.size());
  for (const auto& [name, bytes] : made) {
    ASSERT_EQ(again.count(name), 1u) << name;
    EXPECT_TRUE(again.at(name) == bytes) << name << " differs";
  }
  // What the command line compares finds nothing either.
  const auto manifest = ReadManifest(directory.path() / "made");
  ASSERT_TRUE(manifest.ok()) << manifest.status().ToString();
  EXPECT_EQ(DifferingFiles(*manifest, MakeManifest(**rebuilt).value()), std::vector<std::string>());
}

INSTANTIATE_TEST_SUITE_P(Talks, RebuildBytesTest, testing::ValuesIn(Talks()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace latticeworld
