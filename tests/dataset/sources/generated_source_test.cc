#include "latticeworld/dataset/sources/generated_source.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/dataset/sources/random_plan.h"

namespace latticeworld {
namespace {

TEST(GeneratedSourceTest, PlacesAreLegalAndWhatIsKnownOfThemIsTrue) {
  GeneratedSourceOptions options;
  options.seed = 3;
  std::size_t known = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    const GeneratedPlace place = GeneratePlace(options, i);
    const SymbolicLayout& layout = place.instance.layout;
    EXPECT_TRUE(ParseLayout(ToText(layout), layout.vocabulary).ok());
    for (const Claim& claim : place.claims) {
      EXPECT_TRUE(Measure(claim, layout).holds) << Measure(claim, layout).explanation;
    }
    known += place.claims.size();
  }
  EXPECT_GT(known, 300u * 4) << "a handful of each place";
}

TEST(GeneratedSourceTest, EveryClassOfBothVocabulariesComesUpOften) {
  GeneratedSourceOptions options;
  std::map<Vocabulary, int> places;
  std::map<std::pair<Vocabulary, char>, int> places_with;
  std::set<std::string> layouts;
  int reliefs = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    const Instance instance = GeneratePlace(options, i).instance;
    const Vocabulary vocabulary = instance.layout.vocabulary;
    ++places[vocabulary];
    if (instance.relief != nullptr) ++reliefs;
    layouts.insert(ToText(instance.layout));
    const std::set<char> letters(instance.layout.cells.begin(), instance.layout.cells.end());
    for (const char letter : letters) ++places_with[{vocabulary, letter}];
  }
  EXPECT_EQ(layouts.size(), 400u) << "no two are the same";
  EXPECT_NEAR(reliefs, 200, 50);
  for (const auto& [vocabulary, count] : places) {
    EXPECT_NEAR(count, 200, 50);
    for (const LayoutClass& entry : ClassesOf(vocabulary)) {
      EXPECT_GT(places_with[std::make_pair(vocabulary, entry.letter)], count / 6) << entry.name;
    }
  }
}

TEST(GeneratedSourceTest, APlaceDependsOnSeedAndIndexAlone) {
  GeneratedSourceOptions options;
  options.groups = 20;
  options.seed = 5;
  const auto source = MakeGeneratedSource(options);
  ASSERT_TRUE(source.ok());
  const Instance late = (*source)->ReadGroup(17).value().front();
  for (std::size_t i = 0; i < 20; ++i) (void)(*source)->ReadGroup(i).value();
  const Instance again = (*source)->ReadGroup(17).value().front();
  EXPECT_TRUE(late.layout.cells == again.layout.cells);
  EXPECT_EQ(late.id, (*source)->GroupName(17));
  ASSERT_EQ(late.relief == nullptr, again.relief == nullptr);
  if (late.relief != nullptr) {
    EXPECT_TRUE(late.relief->height_m == again.relief->height_m);
  }
  options.seed = 6;
  EXPECT_FALSE(GeneratePlace(options, 17).instance.layout.cells == late.layout.cells);
}

TEST(RandomPlanTest, FormsAndRelationsComeUp) {
  std::set<FeatureForm> forms;
  std::set<RelationKind> relations;
  std::set<ClaimKind> kinds;
  for (int i = 0; i < 4000; ++i) {
    RandomStream random(9, std::to_string(i));
    const LayoutPlan plan = RandomPlan(i % 2 ? Vocabulary::kSuburb : Vocabulary::kWild, &random);
    EXPECT_FALSE(plan.features.empty());
    EXPECT_NE(FindClass(plan.vocabulary, plan.background), nullptr);
    for (const PlannedFeature& feature : plan.features) forms.insert(feature.form);
    for (const PlannedRelation& relation : plan.relations) relations.insert(relation.kind);
    for (const Claim& claim : plan.claims) kinds.insert(claim.kind);
  }
  EXPECT_EQ(forms.size(), 3u);
  EXPECT_GE(relations.size(), 12u);
  EXPECT_GE(kinds.size(), 19u);
}

TEST(GeneratedSourceTest, UnusableOptionsAreRefused) {
  GeneratedSourceOptions options;
  options.groups = 0;
  options.relief_share = 2.0;
  EXPECT_EQ(MakeGeneratedSource(options).status().violations().size(), 2u);
}

}  // namespace
}  // namespace latticeworld
