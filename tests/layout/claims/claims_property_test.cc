#include <gtest/gtest.h>

#include "latticeworld/common/random.h"
#include "layout/claim_checks.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

char AnyLetter(Vocabulary vocabulary, RandomStream* random) {
  const auto& classes = ClassesOf(vocabulary);
  return classes[static_cast<std::size_t>(
                     random->UniformInt(0, static_cast<int>(classes.size()) - 1))]
      .letter;
}

Zone AnyZone(RandomStream* random) {
  const std::vector<std::string_view> names = ZoneNames();
  if (random->UniformInt(0, 1) == 0) return {};
  return FindZone(names[static_cast<std::size_t>(
                      random->UniformInt(0, static_cast<int>(names.size()) - 1))])
      .value();
}

Claim AnyClaim(ClaimKind kind, Vocabulary vocabulary, RandomStream* random) {
  Claim claim;
  claim.kind = kind;
  claim.subject = AnyLetter(vocabulary, random);
  claim.object = AnyLetter(vocabulary, random);
  claim.second_object = AnyLetter(vocabulary, random);
  if (kind == ClaimKind::kAlong && random->UniformInt(0, 1) == 0) claim.object = '\0';
  claim.zone = AnyZone(random);
  claim.object_zone = AnyZone(random);
  claim.from = AnyZone(random);
  claim.to = AnyZone(random);
  for (int i = random->UniformInt(1, 4); i > 0; --i) {
    claim.sequence += AnyLetter(vocabulary, random);
  }
  claim.heading = {random->UniformInt(-1, 1), random->UniformInt(-1, 1)};
  claim.shape = EnumNames(ClaimShape{})[static_cast<std::size_t>(random->UniformInt(0, 6))].value;
  return claim;
}

// Random and patchy layouts of both vocabularies, and one of a single class.
SymbolicLayout AnyLayout(std::uint64_t seed) {
  const Vocabulary vocabulary = seed % 2 == 0 ? Vocabulary::kSuburb : Vocabulary::kWild;
  if (seed % 7 == 0) return Uniform(vocabulary, 'W');
  return seed % 3 == 0 ? Random(vocabulary, seed) : Patchy(vocabulary, seed);
}

TEST(ClaimsPropertyTest, WordsAndSearchesSeeTheSameDistance) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SymbolicLayout layout = AnyLayout(seed);
    RandomStream random(seed, "claims");
    for (const auto& kind : EnumNames(ClaimKind{})) {
      for (int i = 0; i < 3; ++i) {
        Measured(AnyClaim(kind.value, layout.vocabulary, &random), layout);
      }
    }
    if (HasFailure()) return;
  }
}

TEST(ClaimsPropertyTest, EveryKindHoldsSomewhereAndFailsSomewhere) {
  for (const auto& kind : EnumNames(ClaimKind{})) {
    int held = 0, failed = 0;
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
      const SymbolicLayout layout = AnyLayout(seed);
      RandomStream random(seed, kind.name);
      const double distance =
          DistanceOf(AnyClaim(kind.value, layout.vocabulary, &random), LayoutMasks(layout));
      held += distance == 0.0;
      failed += distance > 0.0;
    }
    // An amount without bounds holds of everything.
    EXPECT_GT(held, 0) << kind.name;
    EXPECT_TRUE(failed > 0 || kind.value == ClaimKind::kAmount) << kind.name;
  }
}

TEST(ClaimsPropertyTest, MasksFollowTheirCells) {
  SymbolicLayout layout = Patchy(Vocabulary::kSuburb, 5);
  LayoutMasks masks(layout);
  RandomStream random(1, "changes");
  for (int i = 0; i < 500; ++i) {
    const int row = random.UniformInt(0, kLayoutSize - 1),
              col = random.UniformInt(0, kLayoutSize - 1);
    const char to = AnyLetter(layout.vocabulary, &random);
    masks.Set({row, col}, layout.cells(row, col), to);
    layout.cells(row, col) = to;
  }
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
    EXPECT_EQ(masks.of(entry.letter), MaskOf(layout, entry.letter)) << entry.letter;
  }
  EXPECT_EQ(masks.vocabulary(), Vocabulary::kSuburb);
}

}  // namespace
}  // namespace latticeworld
