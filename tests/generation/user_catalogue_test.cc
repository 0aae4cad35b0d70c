// Worlds furnished from a catalogue that a user added to.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "catalogue/larch.h"
#include "generation/test_world.h"
#include "latticeworld/common/files.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/catalogue_json.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/generation/bundle/rebuild.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

std::shared_ptr<const Catalogue> WithLarches() {
  return Catalogue::Extended({{"larch.json", LarchFile()}}).value();
}

std::shared_ptr<const World> LarchWood(std::shared_ptr<const Catalogue> catalogue) {
  WorldGenerator generator(std::move(LoadLanguage({}).value().stack), SketchTranslator(),
                           std::move(catalogue));
  GenerationRequest request;
  request.layout_instruction = "Dense forest everywhere.";
  request.environment_instruction = "An autumn day, golden larch forest.";
  request.seed = 5;
  request.size_m = 64.0;
  return generator.Generate(request, Progress()).value();
}

long CountOf(const World& world, const std::string& model) {
  return std::count_if(world.scene->assets.begin(), world.scene->assets.end(),
                       [&](const Asset& asset) {
                         return world.scene->catalogue->models()[asset.model].name == model;
                       });
}

TEST(UserCatalogueTest, ItsSpeciesIsAskedForByNameAndGrows) {
  const auto world = LarchWood(WithLarches());
  EXPECT_EQ(world->environment.fine_of(AssetType::kForest).season_variant, "golden larch");
  EXPECT_GT(CountOf(*world, "larch"), 10);
  EXPECT_EQ(world->fidelity.satisfied(), static_cast<int>(world->fidelity.claims.size()));
  EXPECT_TRUE(world->fidelity.not_understood.empty());
  EXPECT_NE(world->id, LarchWood(Catalogue::BuiltIn())->id);
}

TEST(UserCatalogueTest, ABundleCarriesIt) {
  const TemporaryDirectory directory;
  const auto world = LarchWood(WithLarches());
  ASSERT_TRUE(SaveBundle(*world, directory.path() / "wood").ok());
  const auto loaded = LoadBundle(directory.path() / "wood");
  ASSERT_TRUE(loaded.ok()) << loaded.status().ToString();
  ExpectSameWorld(*world, **loaded);
  EXPECT_EQ(CountOf(**loaded, "larch"), CountOf(*world, "larch"));
  // Where nobody added anything there is no such file.
  ASSERT_TRUE(SaveBundle(*LarchWood(Catalogue::BuiltIn()), directory.path() / "plain").ok());
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "wood" / "catalogue.json"));
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "plain" / "catalogue.json"));
}

TEST(UserCatalogueTest, AWorldIsMadeAgainFromItsOwn) {
  const auto world = LarchWood(WithLarches());
  const auto rebuilt = RebuildWorld(*world, Progress());
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
  EXPECT_EQ((*rebuilt)->id, world->id);
}

TEST(CatalogueJsonTest, RefusesWhatIsTooLongUnparsed) {
  const auto catalogue = DecodeCatalogue(std::string((65 << 20) + 1, ' '));
  ASSERT_FALSE(catalogue.ok());
  EXPECT_EQ(catalogue.status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(catalogue.status().message(), "it has 68157441 bytes; legal are at most 68157440");
}

TEST(CatalogueJsonTest, RefusesWhatIsNoCatalogue) {
  for (const char* content : {"", "{}", "[{\"name\": \"x\"}]", "[{\"name\": 1, \"text\": \"{}\"}]",
                              "[{\"name\": \"x.json\", \"text\": \"no JSON\"}]"}) {
    const auto catalogue = DecodeCatalogue(content);
    ASSERT_FALSE(catalogue.ok()) << content;
    EXPECT_EQ(catalogue.status().code(), StatusCode::kDataLoss) << content;
  }
}

}  // namespace
}  // namespace latticeworld
