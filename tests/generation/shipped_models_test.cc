#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/generation/language_backends.h"
#include "latticeworld/language/grounded/grounded.h"
#include "latticeworld/layout/claims.h"

namespace latticeworld {
namespace {

LanguageBackends Shipped() {
  LocalBackendOptions options;
  options.layout_model = LATTICEWORLD_MODELS "/layouts.gguf";
  options.environment_model = "grounded";
  auto backends = MakeLanguageBackends({}, options);
  EXPECT_TRUE(backends.ok()) << backends.status().ToString();
  return *std::move(backends);
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

// How many of the claims of a wish a layout has.
std::size_t Held(const std::vector<Claim>& claims, const SymbolicLayout& layout) {
  std::size_t held = 0;
  for (const Claim& claim : claims) held += Measure(claim, layout).holds ? 1 : 0;
  return held;
}

// Draws are the same on every processor, so that what is counted here is the file's.
TEST(ShippedModelsTest, TheLayoutModelListens) {
  const LanguageBackends backends = Shipped();
  LayoutGenerator& shipped = *backends.by_name.at("local").layout;
  constexpr int kSeeds = 4;
  std::size_t asked = 0, held = 0, held_by_others = 0, others = 0;
  for (std::size_t i = 0; i < Wishes().size(); ++i) {
    const Wish& wish = Wishes()[i];
    const std::vector<Claim> claims = ReadLayoutInstruction(wish.words, wish.vocabulary).claims;
    ASSERT_FALSE(claims.empty()) << wish.words;
    for (int seed = 0; seed < kSeeds; ++seed) {
      LayoutRequest request;
      request.instruction = wish.words;
      request.vocabulary = wish.vocabulary;
      request.seed = static_cast<std::uint64_t>(seed);
      const auto answer = shipped.Generate(request, Progress());
      ASSERT_TRUE(answer.ok()) << wish.words << ": " << answer.status().ToString();
      EXPECT_EQ(answer->replies.size(), 1u) << wish.words << ": an answer was illegal";
      asked += claims.size();
      held += Held(claims, answer->layout);
      // What was not asked for is there less often.
      for (std::size_t j = 0; j < Wishes().size(); ++j) {
        const Wish& other = Wishes()[j];
        if (j == i || other.vocabulary != wish.vocabulary) continue;
        const auto unasked = ReadLayoutInstruction(other.words, other.vocabulary).claims;
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

}  // namespace
}  // namespace latticeworld
