// The catalogue that ships: the method's table, and that each of its values means something.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {
namespace {

using Names = std::vector<std::string_view>;

const Catalogue& BuiltIn() { return *Catalogue::BuiltIn(); }

struct TableRow {
  AssetType type;
  std::size_t seasonal, materials;
  std::string continuous;  // besides density
};

std::string ContinuousOf(const AssetTypeValues& values) {
  std::string names;
  if (values.has_rotation) names += " rotation";
  if (values.has_scale) names += " scale";
  if (values.has_height) names += " height";
  if (values.has_wind) names += " wind";
  if (values.has_slope) names += " slope";
  return names;
}

TEST(BuiltInCatalogueTest, HasTheNumbersOfTheMethodsTable) {
  const std::vector<TableRow> table = {{AssetType::kGrass, 3, 4, ""},
                                       {AssetType::kFlower, 2, 4, " rotation"},
                                       {AssetType::kDeadBranch, 2, 4, " rotation"},
                                       {AssetType::kStone, 3, 4, " rotation"},
                                       {AssetType::kArchitecture, 4, 3, " rotation scale"},
                                       {AssetType::kRoad, 2, 2, ""},
                                       {AssetType::kLake, 2, 2, " height"},
                                       {AssetType::kDesert, 6, 3, " rotation wind"},
                                       {AssetType::kForest, 18, 4, " rotation"},
                                       {AssetType::kCrops, 4, 4, " rotation"},
                                       {AssetType::kSnowMountain, 3, 3, " rotation slope"}};
  ASSERT_EQ(table.size(), static_cast<std::size_t>(kAssetTypeCount));
  std::size_t seasonal = 0, materials = 0;
  for (const TableRow& row : table) {
    const AssetTypeValues& values = BuiltIn().ValuesOf(row.type);
    EXPECT_EQ(values.type, row.type);
    EXPECT_EQ(values.season_variants.size(), row.seasonal) << NameOf(row.type);
    EXPECT_EQ(values.materials.size(), row.materials) << NameOf(row.type);
    EXPECT_EQ(ContinuousOf(values), row.continuous) << NameOf(row.type);
    seasonal += values.season_variants.size();
    materials += values.materials.size();
  }
  EXPECT_EQ(seasonal, 49u);
  EXPECT_EQ(materials, 37u);
}

// Worlds, prompts and bundles name the values: their names and order are an interface.
TEST(BuiltInCatalogueTest, NamesItsValues) {
  const auto seasonal = [](AssetType type) { return BuiltIn().ValuesOf(type).season_variants; };
  const auto materials = [](AssetType type) { return BuiltIn().ValuesOf(type).materials; };
  EXPECT_EQ(seasonal(AssetType::kGrass), Names({"lush", "dry", "snow-covered"}));
  EXPECT_EQ(materials(AssetType::kGrass), Names({"ryegrass", "fescue", "meadow mix", "reed"}));
  EXPECT_EQ(seasonal(AssetType::kFlower), Names({"blooming", "withered"}));
  EXPECT_EQ(materials(AssetType::kFlower), Names({"poppy", "daisy", "lavender", "heather"}));
  EXPECT_EQ(seasonal(AssetType::kDeadBranch), Names({"bare", "snow-covered"}));
  EXPECT_EQ(materials(AssetType::kDeadBranch), Names({"oak", "pine", "birch", "driftwood"}));
  EXPECT_EQ(seasonal(AssetType::kStone), Names({"dry", "mossy", "snow-covered"}));
  EXPECT_EQ(materials(AssetType::kStone), Names({"granite", "limestone", "sandstone", "basalt"}));
  EXPECT_EQ(seasonal(AssetType::kArchitecture), Names({"spring", "summer", "autumn", "winter"}));
  EXPECT_EQ(materials(AssetType::kArchitecture), Names({"brick", "timber", "concrete"}));
  EXPECT_EQ(seasonal(AssetType::kRoad), Names({"clear", "snow-covered"}));
  EXPECT_EQ(materials(AssetType::kRoad), Names({"asphalt", "gravel"}));
  EXPECT_EQ(seasonal(AssetType::kLake), Names({"open", "frozen"}));
  EXPECT_EQ(materials(AssetType::kLake), Names({"clear", "silty"}));
  EXPECT_EQ(seasonal(AssetType::kDesert), Names({"spring bloom", "summer dunes", "autumn dunes",
                                                 "winter dunes", "dry storm", "cold night"}));
  EXPECT_EQ(materials(AssetType::kDesert), Names({"quartz sand", "gypsum sand", "clay"}));
  EXPECT_EQ(seasonal(AssetType::kForest),
            Names({"spring oak", "spring birch", "spring maple", "spring pine", "spring spruce",
                   "summer oak", "summer birch", "summer maple", "summer pine", "summer spruce",
                   "autumn oak", "autumn birch", "autumn maple", "autumn pine", "autumn spruce",
                   "winter bare deciduous", "winter pine", "winter spruce"}));
  EXPECT_EQ(materials(AssetType::kForest),
            Names({"smooth bark", "furrowed bark", "scaly bark", "mossy bark"}));
  EXPECT_EQ(seasonal(AssetType::kCrops), Names({"sown", "green", "ripe", "stubble"}));
  EXPECT_EQ(materials(AssetType::kCrops), Names({"wheat", "maize", "rapeseed", "vineyard"}));
  EXPECT_EQ(seasonal(AssetType::kSnowMountain), Names({"patchy snow", "firn", "deep snow"}));
  EXPECT_EQ(materials(AssetType::kSnowMountain), Names({"powder", "packed snow", "ice"}));
}

void ExpectIn(double value, double low, double high, const std::string& what) {
  EXPECT_TRUE(value >= low && value <= high) << what << ": " << value;
}

void ExpectMeaning(const Reflectivity& reflectivity, const GroundEffect& ground,
                   const std::string& what) {
  ExpectIn(reflectivity.lidar, 0.01, 1.0, what + " lidar");
  ExpectIn(reflectivity.radar_db, -40.0, 10.0, what + " radar");
  ExpectIn(ground.friction, 0.05, 2.0, what + " friction");
  ExpectIn(ground.rolling_resistance, 0.1, 20.0, what + " rolling resistance");
  ExpectIn(ground.cone_index, 0.05, 5.0, what + " cone index");
}

TEST(BuiltInCatalogueTest, EverySeasonalValueHasAllItsMeaning) {
  for (const auto& type : EnumNames(AssetType{})) {
    for (const SeasonVariant& variant : BuiltIn().season_variants(type.value)) {
      const std::string what = std::string(type.name) + "/" + variant.name;
      ExpectMeaning(variant.reflectivity, variant.ground, what);
      ExpectIn(variant.foliage, 0.0, 1.0, what);
      ExpectIn(variant.growth, 0.01, 1.0, what);
      ExpectIn(variant.snow, 0.0, 1.0, what);
      EXPECT_NE(std::count(variant.seasons.begin(), variant.seasons.end(), true), 0) << what;
      for (const ColorRange& color : variant.color) {
        // The default of a field that no file filled.
        EXPECT_FALSE(color.from == (Rgb{128, 128, 128})) << what;
        EXPECT_FALSE(color.from == color.to) << what;
      }
    }
  }
}

TEST(BuiltInCatalogueTest, EveryMaterialHasAllItsMeaning) {
  for (const auto& type : EnumNames(AssetType{})) {
    for (const Material& material : BuiltIn().materials(type.value)) {
      const std::string what = std::string(type.name) + "/" + material.name;
      ExpectMeaning(material.reflectivity, material.ground, what);
      ExpectIn(material.density_kgpm3, 50.0, 4000.0, what);
      ExpectIn(material.elastic_modulus_pa, 1e5, 1e11, what);
      ExpectIn(material.bending_strength_pa, 1e2, 1e9, what);
      EXPECT_LT(material.bending_strength_pa, material.elastic_modulus_pa) << what;
      EXPECT_FALSE(material.color.from == (Rgb{128, 128, 128})) << what;
    }
  }
}

void ExpectSize(const SizeRange& size, double low, double high, const std::string& what) {
  ExpectIn(size.low, low, size.mean, what);
  ExpectIn(size.high, size.mean, high, what);
  ExpectIn(size.deviation, 1e-6, size.high - size.low, what);
}

TEST(BuiltInCatalogueTest, EveryModelHasAllItsMeaning) {
  ASSERT_GE(BuiltIn().models().size(), 30u);
  ASSERT_LE(BuiltIn().models().size(), 255u);
  std::set<std::string> names;
  for (const AssetModel& model : BuiltIn().models()) {
    EXPECT_TRUE(names.insert(model.name).second) << model.name;
    EXPECT_EQ(model.type, TypeOf(model.kind)) << model.name;
    EXPECT_EQ(model.collision != Collision::kNone, IsSolid(model.kind)) << model.name;
    if (model.shape == Shape::kParts) {  // all of one size
      EXPECT_FALSE(model.parts.empty()) << model.name;
      EXPECT_EQ(model.height_m.deviation, 0.0) << model.name;
      continue;
    }
    ExpectSize(model.height_m, 0.05, 100.0, model.name);
    ExpectIn(model.share, 0.01, 10.0, model.name);
    if (model.kind == AssetKind::kTree) {
      // Hemery et al. (2005) measured 18 to 28 for grown broadleaves.
      ExpectIn(model.crown_per_trunk, 17.0, 28.0, model.name);
      ExpectIn(model.wood.density_kgpm3, 500.0, 1200.0, model.name);
      ExpectIn(model.wood.elastic_modulus_pa, 5e9, 1.5e10, model.name);
      ExpectIn(model.wood.bending_strength_pa, 2e7, 1e8, model.name);
    } else if (model.kind == AssetKind::kBuilding) {
      ExpectSize(model.half_length_m, 1.0, 25.0, model.name);
      ExpectSize(model.half_width_m, 1.0, 25.0, model.name);
    } else {
      ExpectSize(model.spread, 0.1, 10.0, model.name);
    }
  }
}

TEST(BuiltInCatalogueTest, EveryKindHasModels) {
  std::size_t sum = 0;
  for (const auto& kind : EnumNames(AssetKind{})) {
    const std::vector<std::uint8_t>& models = BuiltIn().models_of(kind.value);
    EXPECT_GE(models.size(), 3u) << kind.name;
    EXPECT_TRUE(std::is_sorted(models.begin(), models.end())) << kind.name;
    for (const std::uint8_t model : models) {
      EXPECT_EQ(BuiltIn().models()[model].kind, kind.value) << kind.name;
    }
    sum += models.size();
  }
  EXPECT_EQ(sum, BuiltIn().models().size());
}

std::uint8_t ModelNamed(std::string_view name) {
  const std::vector<AssetModel>& models = BuiltIn().models();
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i].name == name) return static_cast<std::uint8_t>(i);
  }
  ADD_FAILURE() << "no model " << name;
  return 0;
}

std::size_t IndexIn(const std::vector<std::string_view>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  EXPECT_NE(found, names.end()) << name;
  return static_cast<std::size_t>(found - names.begin());
}

TEST(BuiltInCatalogueTest, EverythingCanBeShownInEverySeason) {
  for (std::size_t m = 0; m < BuiltIn().models().size(); ++m) {
    const AssetModel& model = BuiltIn().models()[m];
    const auto& variants = BuiltIn().season_variants(model.type);
    for (const auto& season : EnumNames(Season{})) {
      bool is_found = false;
      for (std::size_t v = 0; v < variants.size(); ++v) {
        is_found = is_found || (BuiltIn().CanWear(static_cast<std::uint8_t>(m), v) &&
                                variants[v].seasons[static_cast<std::size_t>(season.value)]);
      }
      EXPECT_TRUE(is_found) << model.name << " in " << season.name;
    }
  }
}

// "spring oak", "winter pine": seen in that season, on that species.
TEST(BuiltInCatalogueTest, TreesWearTheirOwnLeavesInTheirSeason) {
  const auto& variants = BuiltIn().season_variants(AssetType::kForest);
  for (std::size_t v = 0; v < variants.size(); ++v) {
    for (const auto& season : EnumNames(Season{})) {
      const bool is_named = variants[v].name.find(season.name) != std::string::npos;
      EXPECT_EQ(variants[v].seasons[static_cast<std::size_t>(season.value)], is_named)
          << variants[v].name;
    }
    for (const char* species : {"oak", "birch", "maple", "pine", "spruce"}) {
      const bool is_deciduous = std::string(species) != "pine" && std::string(species) != "spruce";
      const bool is_legal =
          variants[v].name.find(species) != std::string::npos ||
          (is_deciduous && variants[v].name.find("deciduous") != std::string::npos);
      EXPECT_EQ(BuiltIn().CanWear(ModelNamed(species), v), is_legal)
          << species << " " << variants[v].name;
    }
  }
}

TEST(BuiltInCatalogueTest, CropsAndFlowersAreOfTheirOwnMaterialOnly) {
  const auto expect_own = [](AssetType type, std::string_view model, std::string_view material) {
    const Names& materials = BuiltIn().ValuesOf(type).materials;
    for (std::size_t i = 0; i < materials.size(); ++i) {
      EXPECT_EQ(BuiltIn().CanBeOf(ModelNamed(model), i), materials[i] == material)
          << model << " " << materials[i];
    }
  };
  expect_own(AssetType::kCrops, "wheat", "wheat");
  expect_own(AssetType::kCrops, "maize", "maize");
  expect_own(AssetType::kCrops, "rapeseed", "rapeseed");
  expect_own(AssetType::kCrops, "vine", "vineyard");
  for (const char* flower : {"poppy", "daisy", "lavender", "heather"}) {
    expect_own(AssetType::kFlower, flower, flower);
  }
  expect_own(AssetType::kGrass, "reed", "reed");
  expect_own(AssetType::kGrass, "meadow tuft", "meadow mix");
}

TEST(BuiltInCatalogueTest, WinterIsBareAndColdOnes) {
  const auto& forest = BuiltIn().season_variants(AssetType::kForest);
  const Names& names = BuiltIn().ValuesOf(AssetType::kForest).season_variants;
  EXPECT_LT(forest[IndexIn(names, "winter bare deciduous")].foliage, 0.1);
  EXPECT_GT(forest[IndexIn(names, "winter spruce")].foliage, 0.8);
  for (const auto& type : EnumNames(AssetType{})) {
    for (const SeasonVariant& variant : BuiltIn().season_variants(type.value)) {
      if (variant.name == "snow-covered") {
        EXPECT_GT(variant.snow, 0.5) << type.name;
      }
      if (variant.snow > 0.5) {
        EXPECT_TRUE(variant.seasons[static_cast<std::size_t>(Season::kWinter)]) << variant.name;
      }
    }
  }
}

TEST(BuiltInCatalogueTest, GroundActsAsItsNameSays) {
  const auto material = [](AssetType type, std::string_view name) {
    return BuiltIn().materials(type)[IndexIn(BuiltIn().ValuesOf(type).materials, name)].ground;
  };
  EXPECT_LT(material(AssetType::kRoad, "gravel").friction,
            material(AssetType::kRoad, "asphalt").friction);
  EXPECT_GT(material(AssetType::kRoad, "gravel").rolling_resistance,
            material(AssetType::kRoad, "asphalt").rolling_resistance);
  EXPECT_GT(material(AssetType::kDesert, "clay").cone_index,
            material(AssetType::kDesert, "quartz sand").cone_index);
  EXPECT_LT(material(AssetType::kSnowMountain, "ice").friction,
            material(AssetType::kSnowMountain, "packed snow").friction);
  EXPECT_LT(material(AssetType::kSnowMountain, "powder").cone_index,
            material(AssetType::kSnowMountain, "packed snow").cone_index);
}

TEST(BuiltInCatalogueTest, DensitiesAreThoseOfTheTable) {
  const auto of = [](AssetKind kind, std::string_view vocabulary, std::string_view letters) {
    std::vector<double> row;
    for (const char letter : letters) row.push_back(BuiltIn().PerHectare(kind, vocabulary, letter));
    return row;
  };
  using Row = std::vector<double>;
  const std::string_view suburb = "ABDFGRW", wild = "BFRSW";
  EXPECT_EQ(of(AssetKind::kTree, "suburb", suburb), Row({2, 15, 2, 800, 6, 0, 0}));
  EXPECT_EQ(of(AssetKind::kBush, "suburb", suburb), Row({5, 20, 10, 150, 30, 0, 0}));
  EXPECT_EQ(of(AssetKind::kStone, "suburb", suburb), Row({1, 1, 30, 15, 8, 0, 0}));
  EXPECT_EQ(of(AssetKind::kBuilding, "suburb", suburb), Row({0, 40, 0, 0, 0, 0, 0}));
  EXPECT_EQ(of(AssetKind::kDeadBranch, "suburb", suburb), Row({0, 0, 2, 80, 1, 0, 0}));
  EXPECT_EQ(of(AssetKind::kGrassTuft, "suburb", suburb), Row({60, 150, 40, 250, 1100, 0, 0}));
  EXPECT_EQ(of(AssetKind::kFlower, "suburb", suburb), Row({20, 60, 5, 60, 350, 0, 0}));
  EXPECT_EQ(of(AssetKind::kCrop, "suburb", suburb), Row({1600, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(of(AssetKind::kTree, "wild", wild), Row({12, 800, 8, 25, 0}));
  EXPECT_EQ(of(AssetKind::kBush, "wild", wild), Row({200, 150, 30, 10, 0}));
  EXPECT_EQ(of(AssetKind::kStone, "wild", wild), Row({15, 15, 120, 40, 0}));
  EXPECT_EQ(of(AssetKind::kBuilding, "wild", wild), Row({0, 0, 0, 0, 0}));
  EXPECT_EQ(of(AssetKind::kDeadBranch, "wild", wild), Row({3, 80, 2, 2, 0}));
  EXPECT_EQ(of(AssetKind::kGrassTuft, "wild", wild), Row({900, 250, 60, 0, 0}));
  EXPECT_EQ(of(AssetKind::kFlower, "wild", wild), Row({300, 60, 15, 0, 0}));
  EXPECT_EQ(of(AssetKind::kCrop, "wild", wild), Row({0, 0, 0, 0, 0}));
  EXPECT_EQ(BuiltIn().PerHectare(AssetKind::kTree, "lunar", 'F'), 0.0);
}

TEST(BuiltInCatalogueTest, IsOneAndTheSameAndNothingAdded) {
  EXPECT_EQ(Catalogue::BuiltIn(), Catalogue::BuiltIn());
  EXPECT_TRUE(BuiltIn().added_files().empty());
  EXPECT_EQ(&ValuesOf(AssetType::kRoad), &BuiltIn().ValuesOf(AssetType::kRoad));
}

}  // namespace
}  // namespace latticeworld
