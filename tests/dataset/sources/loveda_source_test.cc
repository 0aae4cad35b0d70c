#include "latticeworld/dataset/sources/loveda_source.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "dataset/source_pictures.h"
#include "latticeworld/common/random.h"
#include "latticeworld/dataset/sources/downsample.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 128;  // pixels

Grid<char> MaskOfSeed(std::uint64_t seed) {
  RandomStream random(seed, "loveda mask");
  Grid<char> mask(kSide, kSide, 'G');
  for (const char letter : std::string("FADBW")) DrawBlot(letter, 20.0, &random, &mask);
  DrawCurve('R', 2.5, seed % 2 == 0, &random, &mask);
  return mask;
}

void WritePair(const ScratchFolder& folder, const fs::path& domain, const std::string& name,
               const Grid<char>& mask) {
  folder.Write(domain / "masks_png" / name, LoveDaPng(mask));
  folder.Write(domain / "images_png" / name, PalettePng(mask, Vocabulary::kSuburb));
}

std::unique_ptr<InstanceSource> Open(const fs::path& folder,
                                     LoveDaScenes scenes = LoveDaScenes::kRural) {
  auto source = MakeLoveDaSource({folder, scenes});
  EXPECT_TRUE(source.ok()) << source.status().ToString();
  return source.ok() ? *std::move(source) : nullptr;
}

std::set<std::string> NamesOf(const InstanceSource& source) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < source.group_count(); ++i) names.insert(source.GroupName(i));
  return names;
}

// Of the only group that cannot be read, with the others read; OK where there is none.
Status OnlyFailure(const InstanceSource& source) {
  Status failure;
  for (std::size_t i = 0; i < source.group_count(); ++i) {
    const auto group = source.ReadGroup(i);
    if (group.ok()) {
      EXPECT_EQ(group->size(), 4u);
      continue;
    }
    EXPECT_TRUE(failure.ok()) << "a second one: " << group.status().ToString();
    failure = group.status();
  }
  return failure;
}

void ExpectSays(const Status& status, StatusCode code, const std::vector<std::string>& words) {
  EXPECT_EQ(status.code(), code) << status.ToString();
  for (const std::string& word : words) {
    EXPECT_NE(status.message().find(word), std::string::npos) << word << ": " << status.ToString();
  }
}

TEST(LoveDaSourceTest, ReadsThePublishedFoldersAndTheDomainThatIsAskedFor) {
  const ScratchFolder folder;
  WritePair(folder, "Train/Rural", "0.png", MaskOfSeed(0));
  WritePair(folder, "Val/Rural", "0.png", MaskOfSeed(1));
  WritePair(folder, "Train/Urban", "7.png", MaskOfSeed(2));
  folder.Write("Test/Rural/images_png/9.png", "never looked at");
  EXPECT_EQ(NamesOf(*Open(folder.path())),
            (std::set<std::string>{"loveda-train-rural-0", "loveda-val-rural-0"}));
  EXPECT_EQ(NamesOf(*Open(folder.path(), LoveDaScenes::kUrban)),
            (std::set<std::string>{"loveda-train-urban-7"}));
  EXPECT_EQ(Open(folder.path(), LoveDaScenes::kAll)->group_count(), 3u);
  EXPECT_EQ(NamesOf(*Open(folder.path() / "Train")), (std::set<std::string>{"loveda-rural-0"}));
  EXPECT_EQ(NamesOf(*Open(folder.path() / "Train/Urban")), (std::set<std::string>{"loveda-7"}));
}

TEST(LoveDaSourceTest, AGroupIsFourTurnsOfOneMask) {
  const ScratchFolder folder;
  const Grid<char> mask = MaskOfSeed(5);
  WritePair(folder, "", "12.png", mask);
  const auto source = Open(folder.path());
  const auto group = source->ReadGroup(0);
  ASSERT_TRUE(group.ok()) << group.status().ToString();
  ASSERT_EQ(group->size(), 4u);
  for (int turns = 0; turns < 4; ++turns) {
    const Instance& instance = (*group)[turns];
    EXPECT_EQ(instance.id, "loveda-12-r" + std::to_string(90 * turns));
    EXPECT_EQ(instance.group, "loveda-12");
    EXPECT_EQ(instance.relief, nullptr);
    // Turning first and reading then is the same.
    EXPECT_EQ(ToText(instance.layout),
              ToText(*Downsample(Turned(mask, turns), Vocabulary::kSuburb)));
  }
}

TEST(LoveDaSourceTest, ValuesMeanWhatThePublisherSays) {
  // A band of four rows of cells for each value from 0 to 7.
  Grid<std::uint8_t> values(kSide, kSide);
  for (int r = 0; r < kSide; ++r) {
    for (int c = 0; c < kSide; ++c) values(r, c) = static_cast<std::uint8_t>(r * 8 / kSide);
  }
  const ScratchFolder folder;
  folder.Write("masks_png/1.png", GreyPng(values));
  folder.Write("images_png/1.png", GreyPng(values));
  const auto group = Open(folder.path())->ReadGroup(0);
  ASSERT_TRUE(group.ok()) << group.status().ToString();
  std::string letters;
  for (int band = 0; band < 8; ++band) letters += group->front().layout.cells(4 * band + 1, 16);
  EXPECT_EQ(letters, "GGBRWDFA");  // no data is filled from the background beside it
}

TEST(LoveDaSourceTest, AMissingHalfFailsItsGroupAlone) {
  const ScratchFolder folder;
  for (int i = 0; i < 3; ++i) WritePair(folder, "", std::to_string(i) + ".png", MaskOfSeed(i));
  fs::remove(folder.path() / "masks_png/1.png");
  ExpectSays(OnlyFailure(*Open(folder.path())), StatusCode::kNotFound,
             {"masks_png/1.png is missing", "images_png/1.png is there"});
  WritePair(folder, "", "1.png", MaskOfSeed(1));
  fs::remove(folder.path() / "images_png/2.png");
  ExpectSays(OnlyFailure(*Open(folder.path())), StatusCode::kNotFound,
             {"images_png/2.png is missing"});
}

TEST(LoveDaSourceTest, SizesThatDifferFailTheirGroupAlone) {
  const ScratchFolder folder;
  for (int i = 0; i < 2; ++i) WritePair(folder, "", std::to_string(i) + ".png", MaskOfSeed(i));
  folder.Write("images_png/1.png", GreyPng(Grid<std::uint8_t>(64, 100)));
  ExpectSays(OnlyFailure(*Open(folder.path())), StatusCode::kInvalidArgument,
             {"images_png/1.png has 100 x 64", "masks_png/1.png 128 x 128"});
}

TEST(LoveDaSourceTest, AnUnknownValueIsNamedWithItsPlaceAndNumber) {
  const ScratchFolder folder;
  for (int i = 0; i < 2; ++i) WritePair(folder, "", std::to_string(i) + ".png", MaskOfSeed(i));
  Grid<std::uint8_t> values(kSide, kSide, 1);
  values(2, 6) = values(2, 7) = values(90, 0) = 9;
  values(50, 50) = 255;
  folder.Write("masks_png/0.png", GreyPng(values));
  const Status failure = OnlyFailure(*Open(folder.path()));
  ExpectSays(failure, StatusCode::kInvalidArgument,
             {"masks_png/0.png", "row 3, column 7", "value 9 (3 of 16384 pixels)",
              "value 255 (1 of", "legal are value 0, value 1"});
  EXPECT_EQ(failure.violations().size(), 2u);
}

TEST(LoveDaSourceTest, ABrokenFileFailsItsGroupAlone) {
  const std::string whole = LoveDaPng(MaskOfSeed(1));
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 0x55);
  for (const std::string& bytes :
       {std::string(), std::string("no picture"), whole.substr(0, whole.size() / 2), damaged}) {
    for (const std::string side : {"masks_png", "images_png"}) {
      const ScratchFolder folder;
      for (int i = 0; i < 2; ++i) WritePair(folder, "", std::to_string(i) + ".png", MaskOfSeed(i));
      folder.Write(fs::path(side) / "1.png", bytes);
      ExpectSays(OnlyFailure(*Open(folder.path())), StatusCode::kDataLoss, {side + "/1.png"});
    }
  }
}

TEST(LoveDaSourceTest, AMaskOfNoDataFailsItsGroupAlone) {
  const ScratchFolder folder;
  for (int i = 0; i < 2; ++i) WritePair(folder, "", std::to_string(i) + ".png", MaskOfSeed(i));
  folder.Write("masks_png/1.png", GreyPng(Grid<std::uint8_t>(kSide, kSide, 0)));
  ExpectSays(OnlyFailure(*Open(folder.path())), StatusCode::kInvalidArgument,
             {"masks_png/1.png", "no data at 16384 of 16384"});
}

TEST(LoveDaSourceTest, RefusesFoldersThatAreNotLoveDa) {
  const ScratchFolder folder;
  const auto failure = [&folder](const fs::path& below) {
    return MakeLoveDaSource({folder.path() / below, LoveDaScenes::kRural}).status();
  };
  ExpectSays(failure("absent"), StatusCode::kNotFound, {"absent"});
  ExpectSays(failure(""), StatusCode::kInvalidArgument, {"it holds no folders", "Train or Val"});
  folder.Write("holidays/1.png", "x");
  ExpectSays(failure(""), StatusCode::kInvalidArgument, {"it holds \"holidays\""});
  ExpectSays(failure("holidays/1.png"), StatusCode::kInvalidArgument, {"is not a folder"});
  fs::create_directories(folder.path() / "empty/Train/Rural/images_png");
  ExpectSays(failure("empty"), StatusCode::kInvalidArgument, {"holds no images", "rural"});
}

}  // namespace
}  // namespace latticeworld
