// What a user adds to the built-in catalogue.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "catalogue/larch.h"
#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

std::shared_ptr<const Catalogue> Extend(const std::string& text) {
  auto catalogue = Catalogue::Extended({{"user.json", text}});
  EXPECT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  return catalogue.ok() ? *catalogue : Catalogue::BuiltIn();
}

int ModelNamed(const Catalogue& catalogue, std::string_view name) {
  for (std::size_t i = 0; i < catalogue.models().size(); ++i) {
    if (catalogue.models()[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

TEST(ExtendedCatalogueTest, AddsASpeciesAfterThoseBuiltIn) {
  const auto catalogue = Extend(LarchFile());
  const Catalogue& base = *Catalogue::BuiltIn();
  ASSERT_EQ(catalogue->models().size(), base.models().size() + 1);
  for (std::size_t i = 0; i < base.models().size(); ++i) {
    EXPECT_EQ(catalogue->models()[i].name, base.models()[i].name);
  }
  const AssetModel& larch = catalogue->models().back();
  EXPECT_EQ(larch.name, "larch");
  EXPECT_EQ(larch.type, AssetType::kForest);
  EXPECT_EQ(larch.kind, AssetKind::kTree);
  EXPECT_EQ(larch.shape, Shape::kConiferTree);
  EXPECT_EQ(larch.height_m.mean, 24.0);
  EXPECT_EQ(larch.height_m.high, 36.0);
  EXPECT_EQ(larch.crown_per_trunk, 18.5);
  EXPECT_EQ(larch.habitat.altitude.low, 0.5);
  EXPECT_EQ(larch.habitat.shade_tolerance, 0.1);
  EXPECT_EQ(larch.letters_suburb, "FG");
  EXPECT_EQ(larch.letters_wild, "F");
  EXPECT_EQ(larch.wood.bending_strength_pa, 5.3e7);
  EXPECT_EQ(catalogue->models_of(AssetKind::kTree).back(), catalogue->models().size() - 1);

  const auto& names = catalogue->ValuesOf(AssetType::kForest).season_variants;
  ASSERT_EQ(names.size(), 21u);
  EXPECT_EQ(names[18], "green larch");
  EXPECT_EQ(names[20], "bare larch");
  EXPECT_EQ(catalogue->ValuesOf(AssetType::kForest).materials.back(), "larch bark");
  EXPECT_TRUE(catalogue->ValuesOf(AssetType::kForest).has_rotation);
  const SeasonVariant& golden = catalogue->season_variants(AssetType::kForest)[19];
  EXPECT_TRUE(golden.color[static_cast<std::size_t>(Season::kAutumn)].from ==
              (Rgb{0xc4, 0x9a, 0x35}));
  EXPECT_EQ(golden.ground.friction, 1.0);
}

TEST(ExtendedCatalogueTest, OnlyTheNewSpeciesWearsItsValues) {
  const auto catalogue = Extend(LarchFile());
  const auto larch = static_cast<std::uint8_t>(ModelNamed(*catalogue, "larch"));
  const auto oak = static_cast<std::uint8_t>(ModelNamed(*catalogue, "oak"));
  for (std::size_t v = 0; v < catalogue->season_variants(AssetType::kForest).size(); ++v) {
    EXPECT_EQ(catalogue->CanWear(larch, v), v >= 18) << v;
    if (v >= 18) {
      EXPECT_FALSE(catalogue->CanWear(oak, v)) << v;
    }
  }
  for (std::size_t m = 0; m < catalogue->materials(AssetType::kForest).size(); ++m) {
    EXPECT_EQ(catalogue->CanBeOf(larch, m), m == 4) << m;
  }
  EXPECT_FALSE(catalogue->CanBeOf(oak, 4));
}

TEST(ExtendedCatalogueTest, ChangesTheDensitiesItNamesAndNoOthers) {
  const auto catalogue = Extend(LarchFile());
  EXPECT_EQ(catalogue->PerHectare(AssetKind::kTree, "suburb", 'G'), 8.0);
  EXPECT_EQ(catalogue->PerHectare(AssetKind::kTree, "wild", 'F'), 900.0);
  EXPECT_EQ(catalogue->PerHectare(AssetKind::kTree, "suburb", 'F'), 800.0);
  const auto added = Extend(R"({"type": "architecture",
                               "density": [{"kind": "building", "wild": {"B": 0.5}}]})");
  EXPECT_EQ(added->PerHectare(AssetKind::kBuilding, "wild", 'B'), 0.5);
  EXPECT_EQ(added->PerHectare(AssetKind::kBuilding, "suburb", 'B'), 40.0);
}

TEST(ExtendedCatalogueTest, TakesThePlaceOfWhatHasItsName) {
  const auto catalogue = Extend(R"({"type": "grass",
    "season_variants": [
      {"name": "dry", "seasons": ["summer"], "color": {"summer": ["#ffeeaa", "#ffffbb"]},
       "foliage": 0.5, "growth": 0.5, "snow": 0, "lidar_reflectance": 0.9, "radar_sigma0_db": 1}],
    "models": [
      {"name": "reed", "kind": "grass_tuft", "shape": "reed", "collision": "none",
       "height_m": {"mean": 3, "deviation": 0.1, "low": 2, "high": 4},
       "spread": {"mean": 0.2, "deviation": 0.0, "low": 0.2, "high": 0.2}, "share": 2}]})");
  const Catalogue& base = *Catalogue::BuiltIn();
  EXPECT_EQ(catalogue->ValuesOf(AssetType::kGrass).season_variants,
            base.ValuesOf(AssetType::kGrass).season_variants);
  EXPECT_EQ(catalogue->season_variants(AssetType::kGrass)[1].reflectivity.lidar, 0.9);
  EXPECT_EQ(base.season_variants(AssetType::kGrass)[1].reflectivity.lidar, 0.42);
  ASSERT_EQ(catalogue->models().size(), base.models().size());
  const int reed = ModelNamed(base, "reed");
  ASSERT_EQ(ModelNamed(*catalogue, "reed"), reed);
  EXPECT_EQ(catalogue->models()[static_cast<std::size_t>(reed)].height_m.mean, 3.0);
  // Its letters were not given again: it stands where tufts do.
  EXPECT_EQ(catalogue->models()[static_cast<std::size_t>(reed)].letters_wild, "");
}

TEST(ExtendedCatalogueTest, FilesMayReferToOneAnother) {
  Json models = Json::parse(LarchFile()), values = Json::parse(LarchFile());
  models.erase("season_variants");
  models.erase("materials");
  values.erase("models");
  values.erase("density");
  EXPECT_EQ(FaultsOf({{"a.json", values.dump()}, {"b.json", models.dump()}}), Strings());
  EXPECT_EQ(FaultsOf({{"b.json", models.dump()}, {"a.json", values.dump()}}), Strings());
}

TEST(ExtendedCatalogueTest, AReferenceToAModelOfAnotherTypeIsRefused) {
  Json models = Json::parse(LarchFile()), stone = {{"type", "stone"}};
  models.erase("materials");
  for (Json& value : models["season_variants"]) value.erase("models");
  stone["materials"] = Json::parse(LarchFile())["materials"];
  stone["materials"][0]["name"] = "larch stone";
  EXPECT_EQ(FaultsOf({{"forest.json", models.dump()}, {"stone.json", stone.dump()}}),
            Strings({"unknown_value stone.json#/materials/0/models/0"}));
  // What keeps the model itself from being read is the only fault, but in its own type only.
  models["models"][0].erase("share");
  models["materials"] = Json::parse(LarchFile())["materials"];
  EXPECT_EQ(FaultsOf(models.dump()), Strings({"missing_key user.json#/models/0/share"}));
  EXPECT_EQ(FaultsOf({{"forest.json", models.dump()}, {"stone.json", stone.dump()}}),
            Strings({"missing_key forest.json#/models/0/share",
                     "unknown_value stone.json#/materials/0/models/0"}));
}

TEST(ExtendedCatalogueTest, RefusesWhatAListSaysTwice) {
  Json larch = Json::parse(LarchFile());
  larch["season_variants"][0]["seasons"] = {"spring", "summer", "spring"};
  larch["season_variants"][1]["models"] = {"larch", "oak", "larch"};
  larch["materials"][0]["models"] = {"larch", "larch", "larch"};
  EXPECT_EQ(FaultsOf(larch.dump()), Strings({"duplicate_value user.json#/season_variants/0/seasons",
                                             "duplicate_value user.json#/season_variants/1/models",
                                             "duplicate_value user.json#/materials/0/models"}));
}

TEST(ExtendedCatalogueTest, ASpreadIsARatioAndGrowthIsSeen) {
  Json larch = Json::parse(LarchFile());
  larch["season_variants"][0]["growth"] = 0.001;
  Json tuft = {{"type", "grass"}};
  tuft["models"] = Json::parse(R"([{"name": "plate", "kind": "grass_tuft", "shape": "grass_tuft",
      "collision": "none", "height_m": {"mean": 1, "deviation": 0, "low": 1, "high": 1},
      "spread": {"mean": 1, "deviation": 0, "low": 1, "high": 11}, "share": 1}])");
  EXPECT_EQ(FaultsOf({{"larch.json", larch.dump()}, {"tuft.json", tuft.dump()}}),
            Strings({"out_of_range larch.json#/season_variants/0/growth",
                     "out_of_range tuft.json#/models/0/spread/high"}));
}

TEST(ExtendedCatalogueTest, NamesHaveNoSpacesThatNobodySees) {
  const auto faults = [](const std::string& name) {
    Json larch = Json::parse(LarchFile());
    larch["season_variants"][0]["name"] = name;
    return FaultsOf(larch.dump());
  };
  for (const std::string& name : {std::string("green larch 2"), std::string(48, 'a')}) {
    EXPECT_EQ(faults(name), Strings()) << name;
  }
  for (const std::string& name :
       {std::string("green larch "), std::string("green  larch"), std::string(" green larch"),
        std::string(49, 'a'), std::string("a b c d e f g h i j k l m n o p q r s t u v w x y")}) {
    EXPECT_EQ(faults(name), Strings({"bad_format user.json#/season_variants/0/name"})) << name;
  }
}

TEST(ExtendedCatalogueTest, KeepsTheTextsForBundles) {
  const auto catalogue =
      Catalogue::Extended({{"a.json", R"({"type": "road"})"}, {"larch.json", LarchFile()}});
  ASSERT_TRUE(catalogue.ok());
  ASSERT_EQ((*catalogue)->added_files().size(), 2u);
  EXPECT_EQ((*catalogue)->added_files()[1].name, "larch.json");
  EXPECT_EQ((*catalogue)->added_files()[1].text, LarchFile());
  const auto again = Catalogue::Extended((*catalogue)->added_files());
  ASSERT_TRUE(again.ok());
  EXPECT_EQ((*again)->models().back().name, "larch");
}

TEST(ExtendedCatalogueTest, ReportsEveryFaultOfEveryFileAtOnce) {
  Json larch = Json::parse(LarchFile());
  larch["models"][0]["height_m"]["low"] = 30;                               // above its mean
  larch["models"][0]["habitat"]["wetness"]["low"] = 0.8;                    // above its high
  larch["models"][0]["share"] = 0;                                          // out of range
  larch["models"][0]["bark"] = "red";                                       // no such key
  larch["models"][0]["letters"]["wild"] = "FX";                             // no such class
  larch["season_variants"][0]["models"] = {"larch", "elm"};                 // no such model
  larch["season_variants"][1]["color"].erase("autumn");                     // its own season
  larch["season_variants"][2]["color"]["summer"] = {"#000000", "#ffffff"};  // never seen then
  larch["season_variants"][2]["name"] = "golden larch";                     // a second one
  larch["materials"][0]["density_kgpm3"] = -1;                              // out of range
  const std::string stone = R"({"type": "stone", "density": [{"kind": "tree"}],
    "materials": [{"name": "Chalk"}],
    "models": [{"name": "oak", "kind": "stone", "shape": "tower", "collision": "box",
                "height_m": {"mean": 1, "deviation": 0, "low": 1, "high": 1}, "share": 1,
                "storey_m": 3}]})";
  Strings faults = FaultsOf({{"larch.json", larch.dump()}, {"stone.json", stone}});
  std::sort(faults.begin(), faults.end());
  Strings expected = {"out_of_range larch.json#/models/0/height_m",
                      "out_of_range larch.json#/models/0/habitat/wetness",
                      "out_of_range larch.json#/models/0/share",
                      "unknown_key larch.json#/models/0/bark",
                      "unknown_value larch.json#/models/0/letters/wild",
                      "unknown_value larch.json#/season_variants/0/models/1",
                      "missing_key larch.json#/season_variants/1/color/autumn",
                      "unknown_key larch.json#/season_variants/2/color/summer",
                      "duplicate_name larch.json#/season_variants/2",
                      "out_of_range larch.json#/materials/0/density_kgpm3",
                      "wrong_kind stone.json#/density/0/kind",
                      "bad_format stone.json#/materials/0/name",
                      "missing_key stone.json#/materials/0/color",
                      "missing_key stone.json#/materials/0/density_kgpm3",
                      "missing_key stone.json#/materials/0/elastic_modulus_pa",
                      "missing_key stone.json#/materials/0/bending_strength_pa",
                      "missing_key stone.json#/materials/0/lidar_reflectance",
                      "missing_key stone.json#/materials/0/radar_sigma0_db",
                      "missing_key stone.json#/models/0/spread",
                      "wrong_kind stone.json#/models/0/shape",
                      "wrong_kind stone.json#/models/0/collision",
                      "unknown_key stone.json#/models/0/storey_m",
                      "wrong_kind stone.json#/models/0/kind"};
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(faults, expected);
}

TEST(ExtendedCatalogueTest, RefusesAModelThatCouldNotBeShown) {
  Json larch = Json::parse(LarchFile());
  larch["season_variants"].erase(2);  // the winter one
  EXPECT_EQ(FaultsOf(larch.dump()), Strings({"incomplete user.json#/models/0"}));
  larch = Json::parse(LarchFile());
  larch["season_variants"][2]["snow"] = 0.9;  // in winter snow can lie
  EXPECT_EQ(FaultsOf(larch.dump()), Strings());
  larch["season_variants"][1]["snow"] = 0.9;  // in autumn it need not
  EXPECT_EQ(FaultsOf(larch.dump()), Strings({"incomplete user.json#/models/0"}));
}

TEST(ExtendedCatalogueTest, RefusesAReplacementThatLeavesASeasonEmpty) {
  const std::string lush = R"({"type": "grass", "season_variants": [
      {"name": "dry", "seasons": ["winter"], "color": {"winter": ["#ffeeaa", "#ffffbb"]},
       "foliage": 0.5, "growth": 0.5, "snow": 0, "lidar_reflectance": 0.9, "radar_sigma0_db": 1},
      {"name": "lush", "seasons": ["winter"], "color": {"winter": ["#ffeeaa", "#ffffbb"]},
       "foliage": 0.5, "growth": 0.5, "snow": 0, "lidar_reflectance": 0.9, "radar_sigma0_db": 1}
      ]})";
  const Strings faults = FaultsOf(lush);
  EXPECT_EQ(std::count(faults.begin(), faults.end(), "incomplete grass"), 3);
}

TEST(ExtendedCatalogueTest, RefusesGroundWithModels) {
  EXPECT_EQ(FaultsOf(R"({"type": "road", "models": [
      {"name": "kerb", "kind": "stone", "shape": "slab", "collision": "cylinder",
       "height_m": {"mean": 1, "deviation": 0, "low": 1, "high": 1},
       "spread": {"mean": 1, "deviation": 0, "low": 1, "high": 1}, "share": 1}]})"),
            Strings({"wrong_kind user.json#/models/0/kind"}));
}

TEST(ExtendedCatalogueTest, RefusesTwoFilesOfOneName) {
  EXPECT_EQ(FaultsOf({{"a.json", R"({"type": "road"})"}, {"a.json", R"({"type": "lake"})"}}),
            Strings({"duplicate_file a.json#"}));
}

std::string ManyLarches(int count) {
  Json larch = Json::parse(LarchFile());
  const Json model = larch["models"][0];
  larch["models"] = Json::array();
  for (int i = 0; i < count; ++i) {
    larch["models"].push_back(model);
    larch["models"].back()["name"] = "larch " + std::to_string(i);
  }
  for (const char* list : {"season_variants", "materials"}) {
    for (Json& value : larch[list]) value.erase("models");
  }
  return larch.dump();
}

TEST(ExtendedCatalogueTest, HoldsAsManyModelsAsAByteTellsApart) {
  const int room = 255 - static_cast<int>(Catalogue::BuiltIn()->models().size());
  EXPECT_EQ(FaultsOf(ManyLarches(room)), Strings());
  EXPECT_EQ(FaultsOf(ManyLarches(room + 1)),
            Strings({"wrong_count user.json#/models/" + std::to_string(room)}));
}

class LoadTest : public ::testing::Test {
 protected:
  LoadTest() {
    std::string pattern = (fs::temp_directory_path() / "catalogue-XXXXXX").string();
    directory_ = mkdtemp(pattern.data());
  }
  ~LoadTest() override { fs::remove_all(directory_); }

  fs::path Write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_ / name) << text;
    return directory_ / name;
  }

  fs::path directory_;
};

TEST_F(LoadTest, ReadsTheFilesOfADirectoryByName) {
  Write("b.json", LarchFile());
  Write("a.json", R"({"type": "road"})");
  Write("notes.txt", "no catalogue");
  const auto catalogue = Catalogue::Load({directory_});
  ASSERT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  ASSERT_EQ((*catalogue)->added_files().size(), 2u);
  EXPECT_EQ((*catalogue)->added_files()[0].name, "a.json");  // and no path of this machine
  EXPECT_EQ((*catalogue)->added_files()[1].name, "b.json");
  EXPECT_EQ((*catalogue)->models().back().name, "larch");
}

TEST_F(LoadTest, ReadsOneFile) {
  const auto catalogue = Catalogue::Load({Write("larch.json", LarchFile())});
  ASSERT_TRUE(catalogue.ok()) << catalogue.status().ToString();
  EXPECT_EQ((*catalogue)->models().back().name, "larch");
}

TEST_F(LoadTest, SaysWhatIsNotThere) {
  EXPECT_EQ(Catalogue::Load({directory_ / "none.json"}).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(Catalogue::Load({directory_}).status().code(), StatusCode::kNotFound);
  const auto broken = Catalogue::Load({Write("broken.json", "{")});
  ASSERT_EQ(broken.status().violations().size(), 1u);
  EXPECT_EQ(broken.status().violations()[0].pointer, "broken.json#");
}

TEST_F(LoadTest, SaysEverythingThatIsNotThere) {
  const Status status =
      Catalogue::Load({directory_ / "a.json", Write("larch.json", LarchFile()),
                       Write("long.json", std::string((4 << 20) + 1, ' ')), directory_ / "b.json"})
          .status();
  EXPECT_EQ(status.code(), StatusCode::kNotFound);  // as the first of them
  ASSERT_EQ(status.violations().size(), 3u);
  for (const char* name : {"a.json", "long.json", "b.json"}) {
    EXPECT_NE(status.message().find(name), std::string::npos) << name << status.message();
  }
}

TEST_F(LoadTest, NothingIsTheBuiltInCatalogue) {
  const auto catalogue = Catalogue::Load({});
  ASSERT_TRUE(catalogue.ok());
  EXPECT_EQ((*catalogue)->models().size(), Catalogue::BuiltIn()->models().size());
}

}  // namespace
}  // namespace latticeworld
