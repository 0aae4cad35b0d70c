#include "latticeworld/language/reading/sentences_of_claims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/layout_of_sentences.h"

namespace latticeworld {
namespace {

Claim ClaimOf(ClaimKind kind, char subject, char object = '\0', char second = '\0') {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.object = object;
  claim.second_object = second;
  return claim;
}

Zone Named(const char* name) { return *FindZone(name); }

// Everything but bounds and words.
bool IsSame(const Claim& a, const Claim& b) {
  return a.kind == b.kind && a.subject == b.subject && a.object == b.object &&
         a.second_object == b.second_object && a.zone == b.zone && a.object_zone == b.object_zone &&
         a.from == b.from && a.to == b.to && a.sequence == b.sequence && a.heading == b.heading &&
         a.shape == b.shape;
}

// One of each kind, some with places.
std::vector<Claim> OneOfEachKind() {
  std::vector<Claim> claims = {
      ClaimOf(ClaimKind::kPresent, 'F'),
      ClaimOf(ClaimKind::kAbsent, 'F'),
      ClaimOf(ClaimKind::kAmount, 'W'),
      ClaimOf(ClaimKind::kDominant, 'F'),
      ClaimOf(ClaimKind::kMoreThan, 'F', 'A'),
      ClaimOf(ClaimKind::kLocated, 'B'),
      ClaimOf(ClaimKind::kCount, 'W'),
      ClaimOf(ClaimKind::kClustered, 'B'),
      ClaimOf(ClaimKind::kScattered, 'B'),
      ClaimOf(ClaimKind::kAdjacent, 'B', 'W'),
      ClaimOf(ClaimKind::kApart, 'R', 'W'),
      ClaimOf(ClaimKind::kSurrounds, 'F', 'W'),
      ClaimOf(ClaimKind::kWithin, 'W', 'F'),
      ClaimOf(ClaimKind::kBothSides, 'F', 'W'),
      ClaimOf(ClaimKind::kBetween, 'B', 'W', 'F'),
      ClaimOf(ClaimKind::kDirection, 'B', 'W'),
      ClaimOf(ClaimKind::kOrder, 'D'),
      ClaimOf(ClaimKind::kCourse, 'W'),
      ClaimOf(ClaimKind::kThrough, 'R', 'F'),
      ClaimOf(ClaimKind::kAlong, 'B', 'R'),
      ClaimOf(ClaimKind::kCrosses, 'R', 'W'),
      ClaimOf(ClaimKind::kParallel, 'R', 'W'),
      ClaimOf(ClaimKind::kConnects, 'R', 'B', 'W'),
      ClaimOf(ClaimKind::kShape, 'W'),
      ClaimOf(ClaimKind::kRest, 'G'),
  };
  for (Claim& claim : claims) {
    if (claim.kind == ClaimKind::kAmount) claim.least = 0.3;
    if (claim.kind == ClaimKind::kCount) claim.least = claim.most = 3.0;
    if (claim.kind == ClaimKind::kLocated || claim.kind == ClaimKind::kDominant) {
      claim.zone = Named("northern half");
    }
    if (claim.kind == ClaimKind::kPresent) claim.zone = Named("upper left");
    if (claim.kind == ClaimKind::kDirection) claim.heading = {1, -1};
    if (claim.kind == ClaimKind::kOrder) {
      claim.sequence = "DFG";
      claim.heading = {0, 1};
    }
    if (claim.kind == ClaimKind::kCourse) {
      claim.from = Named("northern edge");
      claim.to = Named("south-east corner");
    }
  }
  return claims;
}

TEST(SentencesOfClaimsTest, EveryKindOfLayoutClaimIsSaidAndReadBack) {
  const std::vector<Claim> claims = OneOfEachKind();
  ASSERT_EQ(claims.size(), EnumNames(ClaimKind{}).size());
  for (const Claim& claim : claims) {
    const std::vector<std::string> sentences = SentencesOf(claim, Vocabulary::kSuburb);
    const LayoutPlan plan = LayoutOfSentences(sentences, Vocabulary::kSuburb);
    const bool found = std::any_of(plan.claims.begin(), plan.claims.end(),
                                   [&claim](const Claim& other) { return IsSame(claim, other); });
    EXPECT_TRUE(found) << NameOf(claim.kind) << ": " << Join(sentences, ". ");
  }
}

TEST(SentencesOfClaimsTest, BoundsAreSaid) {
  Claim share = ClaimOf(ClaimKind::kAmount, 'F');
  share.least = 0.2;
  share.most = 0.4;
  EXPECT_EQ(SentencesOf(share, Vocabulary::kWild),
            std::vector<std::string>{"Forest covers 20 to 40 % of the map"});
  Claim near = ClaimOf(ClaimKind::kAdjacent, 'B', 'W');
  near.most = 7.0;
  EXPECT_EQ(SentencesOf(near, Vocabulary::kSuburb),
            std::vector<std::string>{"The houses are at most 7 cells from water"});
}

TEST(SentencesOfClaimsTest, AThingThatIsToldByItsPlaceHasALabel) {
  Claim around = ClaimOf(ClaimKind::kSurrounds, 'F', 'W');
  around.object_zone = Named("upper left");
  const std::vector<std::string> sentences = SentencesOf(around, Vocabulary::kWild);
  EXPECT_EQ(sentences,
            (std::vector<std::string>{"Water B in the north-west", "Forest surrounds water B"}));
}

TEST(SentencesOfClaimsTest, ALineThatEndsInANinthEndsOnItsSide) {
  Claim course = ClaimOf(ClaimKind::kCourse, 'W');
  course.from = Named("north-east corner");
  course.to = Named("lower left");
  EXPECT_EQ(SentencesOf(course, Vocabulary::kWild),
            std::vector<std::string>{"A river from the north-east to the south-west"});
}

TEST(SentencesOfClaimsTest, EveryZoneWithANameIsSaid) {
  for (const std::string_view name : ZoneNames()) {
    Claim claim = ClaimOf(ClaimKind::kPresent, 'F');
    claim.zone = *FindZone(name);
    const LayoutPlan plan =
        LayoutOfSentences(SentencesOf(claim, Vocabulary::kWild), Vocabulary::kWild);
    ASSERT_FALSE(plan.claims.empty()) << name;
    EXPECT_EQ(plan.claims.front().zone, claim.zone) << name;
  }
}

// Claims of sentences of the environment, and those of what they are said as.
TEST(SentencesOfClaimsTest, EveryKindOfEnvironmentClaimIsSaidAndReadBack) {
  const std::vector<std::string> samples = {
      "Season: winter or autumn",
      "Weather: fog",
      "Time: dusk",
      "Style: cartoon",
      "Terrain: hills",
      "Grass: dry",
      "Forest density: 20 to 40 %",
      "Snow density: none",
      "Wind: at least 10 m/s",
      "Lake level: -0.3 m",
      "Building scale: 1.5",
      "Building heading: 90 degrees",
      "Snow slope: 30 degrees",
      "12 sheep grazing in the south-west",
      "3 sheep in the south",
      "At least 2 robotic dogs",
      "No goblins",
      "15 agents in all",
  };
  for (const std::string& sample : samples) {
    const auto claims_of = [](const std::vector<std::string>& sentences) {
      return ClaimsOf(EnvironmentOfSentences(sentences, *Catalogue::BuiltIn()), nullptr);
    };
    const std::vector<EnvironmentClaim> claims = claims_of({sample});
    ASSERT_EQ(claims.size(), 1u) << sample;
    const std::vector<std::string> sentences = SentencesOf(claims);
    ASSERT_EQ(sentences.size(), 1u) << sample;
    const std::vector<EnvironmentClaim> again = claims_of(sentences);
    ASSERT_EQ(again.size(), 1u) << sentences.front();
    const EnvironmentClaim& a = claims.front();
    const EnvironmentClaim& b = again.front();
    EXPECT_EQ(a.kind, b.kind) << sentences.front();
    EXPECT_EQ(a.asset, b.asset) << sentences.front();
    EXPECT_EQ(a.values, b.values) << sentences.front();
    EXPECT_NEAR(a.least, b.least, 1e-3) << sentences.front();
    EXPECT_NEAR(a.most, b.most, 1e-3) << sentences.front();
    EXPECT_EQ(a.categories, b.categories) << sentences.front();
    EXPECT_EQ(a.least_quantity, b.least_quantity) << sentences.front();
    EXPECT_EQ(a.most_quantity, b.most_quantity) << sentences.front();
    EXPECT_EQ(a.states, b.states) << sentences.front();
    EXPECT_EQ(a.positions, b.positions) << sentences.front();
  }
}

}  // namespace
}  // namespace latticeworld
