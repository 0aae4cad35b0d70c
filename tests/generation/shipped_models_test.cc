#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {
namespace {

LanguageStack Shipped() {
  LocalModelOptions options;
  options.layout_model = LATTICEWORLD_MODELS "/layouts.gguf";
  options.environment_model = LATTICEWORLD_MODELS "/environments.gguf";
  auto language = LoadLanguage({}, options);
  EXPECT_TRUE(language.ok()) << language.status().ToString();
  return std::move(language->stack);
}

struct Wish {
  Vocabulary vocabulary;
  const char* words;
};

const std::vector<Wish>& Wishes() {
  static const std::vector<Wish> wishes = {
      {Vocabulary::kSuburb, "A lake in the north and a forest in the south."},
      {Vocabulary::kSuburb, "Fields cover most of the land. There is a lake in the centre."},
      {Vocabulary::kSuburb, "There are houses in the western half. The east is all forest."},
      {Vocabulary::kSuburb, "A river runs from the northern edge to the southern edge."},
      {Vocabulary::kSuburb, "Mostly forest, with a village in the south-east."},
      {Vocabulary::kSuburb, "A road goes from the west to the east. No water."},
      {Vocabulary::kWild, "Snow covers the north. Forest dominates the south."},
      {Vocabulary::kWild, "There is bare rock in the upper left corner. The rest is grass."},
      {Vocabulary::kWild, "A lake surrounded by forest."},
      {Vocabulary::kWild, "About half of the land is snow."},
  };
  return wishes;
}

// For a meadow with a lake in the west, a forest in the north-east and a village in the south.
SymbolicLayout Land() {
  SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  const auto fill = [&](int top, int left, char letter) {
    for (int row = top; row < top + 10; ++row) {
      for (int column = left; column < left + 10; ++column) layout.cells(row, column) = letter;
    }
  };
  fill(11, 1, 'W');
  fill(1, 21, 'F');
  fill(22, 11, 'B');
  return layout;
}

const std::vector<const char*>& Descriptions() {
  static const std::vector<const char*> descriptions = {
      "A rainy autumn morning. Five sheep graze in the upper left.",
      "Winter, night, snow. Three goblins attack in the center.",
      "A sunny summer day. Two horses graze on the right.",
      "Fog at dawn in spring. No animals and no people.",
      "Dusk. Four eagles fly in the upper right. In a cartoon style.",
      "It is cloudy. One wheeled robot patrols in the lower left. Ten sheep graze in the upper "
      "right.",
      "A winter evening with fog. Two humanoid robots are idle in the center.",
      "Spring rain at noon. Six ancient warriors patrol at the bottom.",
  };
  return descriptions;
}

// How many of the claims of a wish a layout has.
std::size_t Held(const std::vector<Claim>& claims, const SymbolicLayout& layout) {
  std::size_t held = 0;
  for (const Claim& claim : claims) held += Measure(claim, layout).holds ? 1 : 0;
  return held;
}

// Draws are the same on every processor, so that what is counted here is the file's.
TEST(ShippedModelsTest, TheLayoutModelListens) {
  const LanguageStack stack = Shipped();
  LayoutGenerator& shipped = *stack.generators.at("local").layout;
  constexpr int kSeeds = 4;
  std::size_t asked = 0, held = 0, held_by_others = 0, others = 0;
  for (std::size_t i = 0; i < Wishes().size(); ++i) {
    const Wish& wish = Wishes()[i];
    const std::vector<Claim> claims =
        ReadLayoutInstruction(wish.words, wish.vocabulary).plan.claims;
    ASSERT_FALSE(claims.empty()) << wish.words;
    for (int seed = 0; seed < kSeeds; ++seed) {
      LayoutRequest request;
      request.instruction = wish.words;
      request.vocabulary = wish.vocabulary;
      request.seed = static_cast<std::uint64_t>(seed);
      std::vector<ModelReply> replies;
      const auto answer = shipped.Generate(request, Progress(), &replies);
      ASSERT_TRUE(answer.ok()) << wish.words << ": " << answer.status().ToString();
      EXPECT_EQ(replies.size(), 1u) << wish.words << ": an answer was illegal";
      asked += claims.size();
      held += Held(claims, answer->layout);
      // What was not asked for is there less often.
      for (std::size_t j = 0; j < Wishes().size(); ++j) {
        const Wish& other = Wishes()[j];
        if (j == i || other.vocabulary != wish.vocabulary) continue;
        const auto unasked = ReadLayoutInstruction(other.words, other.vocabulary).plan.claims;
        others += unasked.size();
        held_by_others += Held(unasked, answer->layout);
      }
    }
  }
  RecordProperty("held", std::to_string(held) + " of " + std::to_string(asked));
  EXPECT_GE(held * 10, asked * 4) << held << " of " << asked;
  EXPECT_GE(held * others * 10, 13 * held_by_others * asked)
      << held << " of " << asked << "; unasked: " << held_by_others << " of " << others;
}

TEST(ShippedModelsTest, TheEnvironmentModelListens) {
  const LanguageStack stack = Shipped();
  EnvironmentGenerator& shipped = *stack.generators.at("local").environment;
  const SymbolicLayout land = Land();
  constexpr int kSeeds = 3;
  std::size_t asked = 0, held = 0, held_by_others = 0, others = 0;
  const auto claims_of = [&](std::size_t i) {
    return ReadEnvironmentInstruction(Descriptions()[i], &land).claims;
  };
  const auto held_of = [](const std::vector<EnvironmentClaim>& claims,
                          const EnvironmentConfig& environment) {
    return static_cast<std::size_t>(std::count_if(
        claims.begin(), claims.end(),
        [&](const EnvironmentClaim& claim) { return Measure(claim, environment).holds; }));
  };
  for (std::size_t i = 0; i < Descriptions().size(); ++i) {
    const std::vector<EnvironmentClaim> claims = claims_of(i);
    ASSERT_FALSE(claims.empty()) << Descriptions()[i];
    for (int seed = 0; seed < kSeeds; ++seed) {
      EnvironmentRequest request;
      request.instruction = Descriptions()[i];
      request.layout = &land;
      request.seed = static_cast<std::uint64_t>(seed);
      const auto answer = shipped.Generate(request, Progress());
      ASSERT_TRUE(answer.ok()) << Descriptions()[i] << ": " << answer.status().ToString();
      asked += claims.size();
      held += held_of(claims, answer->environment);
      for (std::size_t j = 0; j < Descriptions().size(); ++j) {
        if (j == i) continue;
        const std::vector<EnvironmentClaim> unasked = claims_of(j);
        others += unasked.size();
        held_by_others += held_of(unasked, answer->environment);
      }
    }
  }
  RecordProperty("held", std::to_string(held) + " of " + std::to_string(asked));
  EXPECT_GE(held * 10, asked * 7) << held << " of " << asked;
  EXPECT_GE(held * others, 3 * held_by_others * asked)
      << held << " of " << asked << "; unasked: " << held_by_others << " of " << others;
}

}  // namespace
}  // namespace latticeworld
