#include "latticeworld/generation/bundle/bundle.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>

#include "common/refused_threads.h"
#include "generation/test_world.h"
#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"
#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/generation/bundle/manifest.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 64u << 20;

std::vector<std::string> FilesBelow(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), directory).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void Rewrite(const fs::path& path, const std::string& content) {
  ASSERT_TRUE(WriteFile(path, content).ok());
}

// Changes a file and the manifest's entry for it, as someone would who knows the format.
void Forge(const fs::path& bundle, const std::string& name, const std::string& content) {
  Rewrite(bundle / name, content);
  Manifest manifest = *DecodeManifest(*ReadFile(bundle / "world.json", kMaxBytes));
  for (BundleFile& file : manifest.files) {
    if (file.name == name) file = {name, content.size(), Sha256Hex(content)};
  }
  Rewrite(bundle / "world.json", EncodeManifest(manifest));
}

void ExpectDamaged(const fs::path& bundle, const std::string& file, const std::string& why) {
  const auto loaded = LoadBundle(bundle);
  ASSERT_FALSE(loaded.ok()) << file;
  EXPECT_EQ(loaded.status().code(), StatusCode::kDataLoss) << loaded.status().ToString();
  EXPECT_NE(loaded.status().message().find(file), std::string::npos) << loaded.status().ToString();
  EXPECT_NE(loaded.status().message().find(why), std::string::npos) << loaded.status().ToString();
}

// One saved bundle of the hand-made world a test.
class BundleTest : public ::testing::Test {
 protected:
  void SetUp() override {
    world_ = MakeTestWorld();
    bundle_ = directory_.path() / "lake";
    const Status saved = SaveBundle(*world_, bundle_);
    ASSERT_TRUE(saved.ok()) << saved.ToString();
  }

  TemporaryDirectory directory_;
  std::shared_ptr<const World> world_;
  fs::path bundle_;
};

TEST_F(BundleTest, HasExactlyTheFilesOfTheFormat) {
  const std::vector<std::string> expected = {
      "agents.json",   "assets.csv",    "elements.json", "environment.json", "fidelity.json",
      "height.png",    "layout.txt",    "map.pgm",       "map.yaml",         "preview.png",
      "replies.json",  "terrain.bin",   "visual",        "water.png",        "weights/F.png",
      "weights/G.png", "weights/W.png", "world.bt",      "world.json"};
  EXPECT_EQ(FilesBelow(bundle_), expected);
  EXPECT_EQ(directory_.Entries(), std::vector<std::string>{"lake"});
}

TEST_F(BundleTest, GivesBackTheSameWorld) {
  const auto loaded = LoadBundle(bundle_);
  ASSERT_TRUE(loaded.ok()) << loaded.status().ToString();
  ExpectSameWorld(*world_, **loaded);
  ASSERT_EQ((*loaded)->stages.size(), 2u);
  EXPECT_EQ((*loaded)->stages[1].seconds, 1.0 / 3.0);
}

TEST_F(BundleTest, IsTheSameBytesWhenSavedAgain) {
  const auto loaded = LoadBundle(bundle_);
  ASSERT_TRUE(loaded.ok());
  ASSERT_TRUE(SaveBundle(**loaded, directory_.path() / "again").ok());
  for (const std::string& name : FilesBelow(bundle_)) {
    EXPECT_EQ(*ReadFile(bundle_ / name, kMaxBytes),
              *ReadFile(directory_.path() / "again" / name, kMaxBytes))
        << name;
  }
}

TEST_F(BundleTest, IsTheSameBytesWhereNoMoreThreadsCanBeHad) {
  {
    const RefusedThreads refused;
    const Status saved = SaveBundle(*world_, directory_.path() / "alone");
    ASSERT_TRUE(saved.ok()) << saved.ToString();
  }
  for (const std::string& name : FilesBelow(bundle_)) {
    EXPECT_EQ(*ReadFile(bundle_ / name, kMaxBytes),
              *ReadFile(directory_.path() / "alone" / name, kMaxBytes))
        << name;
  }
}

TEST_F(BundleTest, NamesAnyFileWithAChangedByte) {
  for (const std::string& name : FilesBelow(bundle_)) {
    const std::string content = *ReadFile(bundle_ / name, kMaxBytes);
    for (const std::size_t offset : {std::size_t{0}, content.size() / 2, content.size() - 1}) {
      std::string changed = content;
      changed[offset] ^= 1;
      Rewrite(bundle_ / name, changed);
      ExpectDamaged(bundle_, name, name == "world.json" ? "" : "SHA-256");
    }
    Rewrite(bundle_ / name, content);
  }
  EXPECT_TRUE(LoadBundle(bundle_).ok());
}

TEST_F(BundleTest, NamesAnyFileThatIsCutOrMissing) {
  for (const std::string& name : FilesBelow(bundle_)) {
    const std::string content = *ReadFile(bundle_ / name, kMaxBytes);
    Rewrite(bundle_ / name, content.substr(0, content.size() / 2));
    ExpectDamaged(bundle_, name, name == "world.json" ? "" : "bytes long");
    fs::remove(bundle_ / name);
    ExpectDamaged(bundle_, name, "is missing");
    Rewrite(bundle_ / name, content);
  }
}

TEST_F(BundleTest, NamesAFileThatIsADirectory) {
  fs::remove(bundle_ / "layout.txt");
  fs::create_directory(bundle_ / "layout.txt");
  const auto loaded = LoadBundle(bundle_);
  ASSERT_FALSE(loaded.ok());
  EXPECT_NE(loaded.status().message().find("layout.txt"), std::string::npos);
}

TEST_F(BundleTest, TrustsNoContentBecauseItsDigestIsRight) {
  const std::string layout = *ReadFile(bundle_ / "layout.txt", kMaxBytes);
  Forge(bundle_, "layout.txt", "Z" + layout.substr(1));
  ExpectDamaged(bundle_, "layout.txt", "Z");
  Forge(bundle_, "layout.txt", "A" + layout.substr(1));  // legal, but another world
  ExpectDamaged(bundle_, "world.json", "the files hold world-");
  Forge(bundle_, "layout.txt", layout);
  for (const char* name :
       {"environment.json", "terrain.bin", "assets.csv", "agents.json", "elements.json"}) {
    const std::string content = *ReadFile(bundle_ / name, kMaxBytes);
    Forge(bundle_, name, "no such content");
    ExpectDamaged(bundle_, name, "");
    Forge(bundle_, name, "");
    ExpectDamaged(bundle_, name, "");
    Forge(bundle_, name, content);
  }
  EXPECT_TRUE(LoadBundle(bundle_).ok());
}

TEST_F(BundleTest, TrustsNoManifestBecauseItsDigestIsRight) {
  const Manifest good = *DecodeManifest(*ReadFile(bundle_ / "world.json", kMaxBytes));
  const auto expect_damaged = [&](const std::string& why, auto&& change) {
    Manifest manifest = good;
    change(&manifest);
    Rewrite(bundle_ / "world.json", EncodeManifest(manifest));
    ExpectDamaged(bundle_, "world.json", why);
  };
  expect_damaged("/etc/passwd", [](Manifest* m) { m->files[0].name = "/etc/passwd"; });
  expect_damaged("../x", [](Manifest* m) { m->files[0].name = "../x"; });
  expect_damaged("twice", [](Manifest* m) { m->files.push_back(m->files[0]); });
  expect_damaged("does not list layout.txt", [](Manifest* m) { m->files.erase(m->files.begin()); });
  expect_damaged("size", [](Manifest* m) { m->request.size_m = 1e9; });
  expect_damaged("resolution", [](Manifest* m) { m->request.resolution_m = 0.0; });
  expect_damaged("9000", [](Manifest* m) { m->request.height_map.height_scale_m = 1e9; });
  expect_damaged("world-feedfeedfeed", [](Manifest* m) { m->world_id = "world-feedfeedfeed"; });

  Manifest manifest = good;
  manifest.files[0].bytes = ~std::uint64_t{0};
  Rewrite(bundle_ / "world.json", EncodeManifest(manifest));
  ExpectDamaged(bundle_, "layout.txt", "18446744073709551615");
}

TEST_F(BundleTest, IsRefusedWhenItsFormatIsAnother) {
  Rewrite(bundle_ / "world.json", "{\"format_version\": 8}");
  const auto loaded = LoadBundle(bundle_);
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(loaded.status().message().find("version 8"), std::string::npos);
}

TEST_F(BundleTest, AManifestThatNobodyNeedsIsNeitherReadNorWritten) {
  const std::string manifest = *ReadFile(bundle_ / "world.json", kMaxBytes);
  Rewrite(bundle_ / "world.json", manifest + std::string(kMaxManifestBytes, ' '));
  const Status loaded = LoadBundle(bundle_).status();
  EXPECT_EQ(loaded.code(), StatusCode::kResourceExhausted) << loaded.ToString();
  EXPECT_NE(loaded.message().find("world.json"), std::string::npos) << loaded.ToString();

  World long_winded = *world_;
  long_winded.warnings.assign(kMaxManifestBytes / 1000, std::string(1000, 'w'));
  const Status saved = SaveBundle(long_winded, directory_.path() / "long");
  EXPECT_EQ(saved.code(), StatusCode::kResourceExhausted) << saved.ToString();
  EXPECT_NE(saved.message().find("world.json"), std::string::npos) << saved.ToString();
  EXPECT_FALSE(fs::exists(directory_.path() / "long"));
}

TEST_F(BundleTest, TheLongestInstructionsHaveRoomInAManifest) {
  World talkative = *world_;
  // Every byte escaped, and every word of both in a warning of its own.
  talkative.request.layout_instruction = std::string(kMaxInstructionBytes, '\x01');
  talkative.request.environment_instruction = std::string(kMaxInstructionBytes, '\x01');
  talkative.warnings.assign(kMaxInstructionBytes, "not understood: \"a\"");
  const fs::path bundle = directory_.path() / "talkative";
  const Status saved = SaveBundle(talkative, bundle);
  ASSERT_TRUE(saved.ok()) << saved.ToString();
  EXPECT_TRUE(ReadManifest(bundle).ok());
}

TEST_F(BundleTest, NeverReplacesWhatIsThere) {
  const auto before = FilesBelow(directory_.path());
  EXPECT_EQ(SaveBundle(*world_, bundle_).code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(SaveBundle(*world_, bundle_ / "").code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(SaveBundle(*world_, bundle_ / "layout.txt").code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(FilesBelow(directory_.path()), before);
}

TEST_F(BundleTest, IsMadeBelowADirectoryThatIsThereAndCanBeWritten) {
  EXPECT_EQ(SaveBundle(*world_, directory_.path() / "no" / "where").code(), StatusCode::kNotFound);
  EXPECT_EQ(SaveBundle(*world_, bundle_ / "layout.txt" / "x").code(), StatusCode::kNotFound);
  // Nobody can make a directory in /sys, whoever runs the test.
  const Status status = SaveBundle(*world_, "/sys/lake");
  EXPECT_EQ(status.code(), StatusCode::kPermissionDenied) << status.ToString();
  EXPECT_NE(status.message().find("/sys/lake"), std::string::npos);
  EXPECT_EQ(directory_.Entries(), std::vector<std::string>{"lake"});
}

TEST_F(BundleTest, TakesATrailingSlash) {
  ASSERT_TRUE(SaveBundle(*world_, directory_.path() / "other" / "").ok());
  EXPECT_TRUE(LoadBundle(directory_.path() / "other" / "").ok());
}

// A limit on the size of files stands for a full disk: both refuse to write more.
TEST_F(BundleTest, LeavesNothingWhenTheDiskIsFull) {
  rlimit previous;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &previous), 0);
  const auto previous_handler = ::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t limit : {rlim_t{0}, rlim_t{1000}, rlim_t{3000}, rlim_t{10000}}) {
    const rlimit small = {limit, previous.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Status status = SaveBundle(*world_, directory_.path() / "full");
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &previous), 0);
    EXPECT_EQ(status.code(), StatusCode::kResourceExhausted) << status.ToString();
    EXPECT_EQ(directory_.Entries(), std::vector<std::string>{"lake"});
  }
  ::signal(SIGXFSZ, previous_handler);
}

TEST_F(BundleTest, IsFoundByListing) {
  fs::create_directory(directory_.path() / "empty");
  Rewrite(directory_.path() / "file", "x");
  fs::copy(bundle_, directory_.path() / ".hidden");
  fs::copy(bundle_, directory_.path() / "broken");
  Rewrite(directory_.path() / "broken" / "world.json", "{}");
  ASSERT_TRUE(SaveBundle(*world_, directory_.path() / "a copy").ok());
  const auto bundles = ListBundles(directory_.path());
  ASSERT_TRUE(bundles.ok());
  ASSERT_EQ(bundles->size(), 2u);
  EXPECT_EQ((*bundles)[0].name, "a copy");
  EXPECT_EQ((*bundles)[1].name, "lake");
  EXPECT_EQ((*bundles)[1].world_id, world_->id);
  EXPECT_EQ((*bundles)[1].layout_instruction, world_->request.layout_instruction);
}

TEST(BundleErrorsTest, WhatIsNotThereIsNotFound) {
  const TemporaryDirectory directory;
  EXPECT_EQ(LoadBundle(directory.path() / "no").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(ListBundles(directory.path() / "no").status().code(), StatusCode::kNotFound);
  EXPECT_TRUE(ListBundles(directory.path())->empty());
  const auto loaded = LoadBundle(directory.path());
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.status().code(), StatusCode::kDataLoss);
  EXPECT_NE(loaded.status().message().find("world.json: is missing"), std::string::npos);
}

TEST(BundleOfGeneratedWorldTest, GivesBackTheSameWorldForManySeeds) {
  const TemporaryDirectory directory;
  WorldGenerator generator = MakeDefaultWorldGenerator();
  const std::vector<std::string> texts = {
      "A river from the upper left to the lower right, buildings along a road in the center.",
      "Snow-capped mountains in the upper part, forest below, a lake in the lower left."};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    GenerationRequest request;
    request.layout_instruction = texts[seed % 2];
    request.environment_instruction = "A rainy autumn day, five sheep and two goblins.";
    request.seed = seed;
    request.size_m = 64.0;
    request.resolution_m = 1.0;
    const auto world = generator.Generate(request, Progress());
    ASSERT_TRUE(world.ok()) << world.status().ToString();
    const fs::path bundle = directory.path() / std::to_string(seed);
    const Status saved = SaveBundle(**world, bundle);
    ASSERT_TRUE(saved.ok()) << saved.ToString();
    const auto loaded = LoadBundle(bundle);
    ASSERT_TRUE(loaded.ok()) << loaded.status().ToString();
    ExpectSameWorld(**world, **loaded);
  }
}

}  // namespace
}  // namespace latticeworld
