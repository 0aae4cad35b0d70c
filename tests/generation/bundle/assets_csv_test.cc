#include "latticeworld/generation/bundle/assets_csv.h"

#include <gtest/gtest.h>

#include "generation/test_world.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

const GridGeometry& TestGeometry() {
  static const GridGeometry geometry = *GridGeometry::Create(32.0, 0.5);
  return geometry;
}

const Catalogue& BuiltIn() { return *Catalogue::BuiltIn(); }

std::uint8_t FirstModel(AssetKind kind) { return BuiltIn().models_of(kind).front(); }

constexpr char kHeader[] =
    "kind,model,season_variant,material,x_m,y_m,z_m,yaw_rad,scale,height_m,half_length_m,"
    "half_width_m,trunk_radius_m\n";

std::string StoneLine(const std::string& numbers) {
  const AssetTypeValues& values = ValuesOf(TypeOf(AssetKind::kStone));
  return "stone," + BuiltIn().models()[FirstModel(AssetKind::kStone)].name + "," +
         std::string(values.season_variants[0]) + "," + std::string(values.materials[0]) + "," +
         numbers + "\n";
}

TEST(AssetsCsvTest, BeginsWithTheNamesOfItsColumns) {
  EXPECT_EQ(*EncodeAssets({}, BuiltIn()), kHeader);
  const auto decoded = DecodeAssets(kHeader, TestGeometry(), BuiltIn());
  ASSERT_TRUE(decoded.ok());
  EXPECT_TRUE(decoded->empty());
}

TEST(AssetsCsvTest, WritesNamesAndShortestNumbers) {
  Asset stone;
  stone.kind = AssetKind::kStone;
  stone.model = FirstModel(AssetKind::kStone);
  stone.x_m = 0.1f;
  stone.y_m = -2.5f;
  EXPECT_EQ(*EncodeAssets({stone}, BuiltIn()), kHeader + StoneLine("0.1,-2.5,0,0,1,0,0,0,0"));
}

TEST(AssetsCsvTest, GivesBackEveryVariantOfEveryKind) {
  std::vector<Asset> assets;
  for (const auto& entry : EnumNames(AssetKind{})) {
    const AssetTypeValues& values = ValuesOf(TypeOf(entry.value));
    for (const std::uint8_t model : BuiltIn().models_of(entry.value)) {
      Asset asset;
      asset.kind = entry.value;
      asset.model = model;
      assets.push_back(asset);
    }
    for (std::size_t variant = 0; variant < values.season_variants.size(); ++variant) {
      for (std::size_t material = 0; material < values.materials.size(); ++material) {
        Asset asset;
        asset.kind = entry.value;
        asset.model = FirstModel(entry.value);
        asset.season_variant = static_cast<std::uint8_t>(variant);
        asset.material = static_cast<std::uint8_t>(material);
        assets.push_back(asset);
      }
    }
  }
  const auto decoded = DecodeAssets(*EncodeAssets(assets, BuiltIn()), TestGeometry(), BuiltIn());
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  ASSERT_EQ(decoded->size(), assets.size());
  for (std::size_t i = 0; i < assets.size(); ++i) {
    EXPECT_EQ((*decoded)[i].kind, assets[i].kind);
    EXPECT_EQ((*decoded)[i].model, assets[i].model);
    EXPECT_EQ((*decoded)[i].season_variant, assets[i].season_variant);
    EXPECT_EQ((*decoded)[i].material, assets[i].material);
  }
}

TEST(AssetsCsvTest, GivesBackTheSameFloats) {
  RandomStream random(3, "assets");
  std::vector<Asset> assets(500);
  for (Asset& asset : assets) {
    asset.model = FirstModel(asset.kind);
    asset.x_m = static_cast<float>(random.Uniform(-16.0, 16.0));
    asset.y_m = static_cast<float>(random.Normal(0.0, 1e-7));
    asset.z_m = static_cast<float>(random.Uniform(-9000.0, 9000.0));
    asset.yaw_rad = static_cast<float>(random.Uniform(-4.0, 4.0));
    asset.scale = static_cast<float>(random.Uniform());
  }
  const auto decoded = DecodeAssets(*EncodeAssets(assets, BuiltIn()), TestGeometry(), BuiltIn());
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  for (std::size_t i = 0; i < assets.size(); ++i) {
    EXPECT_EQ((*decoded)[i].x_m, assets[i].x_m);
    EXPECT_EQ((*decoded)[i].y_m, assets[i].y_m);
    EXPECT_EQ((*decoded)[i].z_m, assets[i].z_m);
    EXPECT_EQ((*decoded)[i].yaw_rad, assets[i].yaw_rad);
    EXPECT_EQ((*decoded)[i].scale, assets[i].scale);
  }
}

TEST(AssetsCsvTest, RefusesToWriteAVariantThatTheTypeHasNot) {
  Asset stone;
  stone.kind = AssetKind::kStone;
  stone.model = FirstModel(AssetKind::kStone);
  stone.material = 200;
  EXPECT_EQ(EncodeAssets({stone}, BuiltIn()).status().code(), StatusCode::kInternal);
}

TEST(AssetsCsvTest, NamesTheLineAndWhatIsWrongWithIt) {
  const std::string good = StoneLine("0,0,0,0,1,0,0,0,0");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {StoneLine("0,0,0,0,1,0,0,0"), "12 fields, not 13"},
      {StoneLine("0,0,0,0,1,0,0,0,0,0"), "14 fields, not 13"},
      {StoneLine("x,0,0,0,1,0,0,0,0"), "x_m is \"x\""},
      {StoneLine("nan,0,0,0,1,0,0,0,0"), "x_m is \"nan\""},
      {StoneLine("0,inf,0,0,1,0,0,0,0"), "y_m is \"inf\""},
      {StoneLine("0,0,1e40,0,1,0,0,0,0"), "z_m is \"1e40\""},
      {StoneLine("0,0,0,0,1,-1,0,0,0"), "height_m is \"-1\""},
      {StoneLine("0,0,0,0,1,,0,0,0"), "height_m is \"\""},
      {StoneLine("16.5,0,0,0,1,0,0,0,0"), "outside the world"},
      {"rock" + good.substr(5), "kind is \"rock\""},
      {"stone,hot," + good.substr(6), "14 fields"},
      {"\n", "1 fields"},
  };
  for (const auto& [line, message] : cases) {
    const auto decoded = DecodeAssets(kHeader + good + line, TestGeometry(), BuiltIn());
    ASSERT_FALSE(decoded.ok()) << line;
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
    EXPECT_NE(decoded.status().message().find("line 3"), std::string::npos);
    EXPECT_NE(decoded.status().message().find(message), std::string::npos)
        << decoded.status().message();
  }
  EXPECT_FALSE(DecodeAssets("", TestGeometry(), BuiltIn()).ok());
  EXPECT_FALSE(DecodeAssets("kind,x\n", TestGeometry(), BuiltIn()).ok());
}

TEST(AssetsCsvTest, RefusesAModelOfAnotherKind) {
  Asset stone;
  stone.kind = AssetKind::kStone;
  stone.model = FirstModel(AssetKind::kTree);
  EXPECT_EQ(EncodeAssets({stone}, BuiltIn()).status().code(), StatusCode::kInternal);
  const std::string tree = BuiltIn().models()[stone.model].name;
  const std::string line = "stone," + tree + ",dry,granite,0,0,0,0,1,0,0,0,0\n";
  const auto decoded = DecodeAssets(kHeader + line, TestGeometry(), BuiltIn());
  ASSERT_FALSE(decoded.ok());
  EXPECT_NE(decoded.status().message().find("model is \"" + tree + "\""), std::string::npos)
      << decoded.status().message();
}

TEST(AssetsCsvTest, RefusesAVariantOfAnotherType) {
  const std::string line =
      "stone," + BuiltIn().models()[FirstModel(AssetKind::kStone)].name + ",no such variant," +
      std::string(ValuesOf(TypeOf(AssetKind::kStone)).materials[0]) + ",0,0,0,0,1,0,0,0,0\n";
  const auto decoded = DecodeAssets(kHeader + line, TestGeometry(), BuiltIn());
  ASSERT_FALSE(decoded.ok());
  EXPECT_NE(decoded.status().message().find("season_variant is \"no such variant\""),
            std::string::npos);
}

}  // namespace
}  // namespace latticeworld
