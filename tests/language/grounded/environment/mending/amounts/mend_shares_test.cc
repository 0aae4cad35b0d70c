#include "latticeworld/language/grounded/environment/mending/amounts/mend_shares.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_multiples.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_ranges.h"
#include "latticeworld/language/grounded/environment/mending/mend_sides.h"

namespace latticeworld {
namespace {

template <typename Mend>
std::string MendedBy(Mend mend, std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  mend(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

std::string Ranged(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendRanges(GetEnvironmentWords(), text, &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

// Claims of agents as "3 sheep grazing; 2-6 goblin; total 20", several categories as "any".
std::string AgentsOf(std::string_view text) {
  std::ostringstream out;
  for (const EnvironmentClaim& claim : ReadEnvironmentInstruction(text).claims) {
    const bool total = claim.kind == EnvironmentClaimKind::kTotalAgents;
    if (claim.kind != EnvironmentClaimKind::kAgents && !total) continue;
    if (out.tellp() > 0) out << "; ";
    if (total) out << "total ";
    out << claim.least_quantity;
    if (claim.most_quantity != claim.least_quantity) out << "-" << claim.most_quantity;
    if (total) continue;
    out << " "
        << (claim.categories.size() > 1 ? std::string_view("any")
                                        : NameOf(claim.categories.front()));
    if (!claim.states.empty()) out << " " << NameOf(claim.states.front());
  }
  return out.str();
}

// Claims of densities and parameters as "grass 0.2-0.4; desert 0-10", rounded.
std::string NumbersOf(std::string_view text) {
  std::ostringstream out;
  out.precision(3);
  for (const EnvironmentClaim& claim : ReadEnvironmentInstruction(text).claims) {
    if (claim.kind != EnvironmentClaimKind::kDensity &&
        claim.kind != EnvironmentClaimKind::kParameter) {
      continue;
    }
    if (out.tellp() > 0) out << "; ";
    out << NameOf(claim.asset) << " " << claim.least << "-" << claim.most;
  }
  return out.str();
}

TEST(MendSharesTest, PercentsOfAgentsAreCounted) {
  const auto mended = [](std::string_view text) { return MendedBy(MendShares, text); };
  EXPECT_EQ(mended("40 sheep, 15% of them asleep"), "40 sheep , 6 of them asleep");
  EXPECT_EQ(mended("35 percent of the 60 knights march"), "21 of the 60 knights march");
  EXPECT_EQ(mended("40 sheep: 35% grazing, 65% asleep"),
            "40 sheep : 14 of them grazing , 26 of them asleep");
  EXPECT_EQ(mended("80 agents. 5% are whales"), "80 agents . 4 of them are whales");
  EXPECT_EQ(mended("45% goblins and 55% knights, 40 in all"),
            "18 goblins and 22 knights , 40 in all");
  for (const char* kept :
       {"40 sheep on 30 percent grass", "40 sheep , grass density 30 percent",
        "30 percent of the sheep graze", "40 sheep . rain : 20 percent near the lake",
        "40 sheep . rocks : 20 percent in the forest , 5 percent on the road",
        "20 robots . 30 percent of the sheep graze"})
    EXPECT_EQ(mended(kept), kept);
}

TEST(MendSharesTest, FractionsAreOfThem) {
  const auto mended = [](std::string_view text) { return MendedBy(MendShares, text); };
  EXPECT_EQ(mended("12 knights, half marching and half asleep"),
            "12 knights , half of them marching and half of them asleep");
  EXPECT_EQ(mended("12 drones, a quarter hovering, the rest parked"),
            "12 drones , a quarter of them hovering , the rest parked");
  for (const char* kept : {"12 knights , half asleep", "two eagles fly , a third perched on a tree",
                           "12 knights , half of them marching"})
    EXPECT_EQ(mended(kept), kept);
}

TEST(MendSharesTest, PartsComeFirst) {
  const auto mended = [](std::string_view text) { return MendedBy(MendShares, text); };
  EXPECT_EQ(mended("of the 12 horses most graze"), "most of the 12 horses graze");
  EXPECT_EQ(mended("of our horses, a few are asleep"), "a few of our horses are asleep");
  EXPECT_EQ(mended("all 12 horses except three are asleep"),
            "all but three of the 12 horses are asleep");
  EXPECT_EQ(mended("12 horses. Every horse but three is asleep"),
            "12 horses . all but three of the horses is asleep");
  for (const char* kept : {"most of the 12 horses graze", "all horses but two goblins are asleep",
                           "of the 12 horses five graze", "of the 12 robots , half are rovers",
                           "every robot but one sleeps"})
    EXPECT_EQ(mended(kept), kept);
}

TEST(MendSharesTest, SharesAreReadAsMeant) {
  EXPECT_EQ(AgentsOf("80 agents, 15% of them goblins."), "12 goblin; total 80");
  EXPECT_EQ(AgentsOf("40 robots: 10% drones, the rest wheeled."),
            "4 aerial robot; 36 wheeled robot");
  EXPECT_EQ(AgentsOf("60% of the 20 horses graze."), "8 horse; 12 horse grazing");
  EXPECT_EQ(AgentsOf("12 knights, half on patrol, half asleep."),
            "6 ancient warrior patrolling; 6 ancient warrior idle");
  EXPECT_EQ(AgentsOf("All 12 horses but three are grazing."), "3 horse idle; 9 horse grazing");
}

TEST(MendSharesTest, VaguePartsAreRanges) {
  EXPECT_EQ(AgentsOf("10 horses, most of them asleep."), "1-4 horse; 6-9 horse idle");
  EXPECT_EQ(AgentsOf("A few of the 10 horses are asleep."), "5-8 horse; 2-5 horse idle");
  EXPECT_EQ(AgentsOf("Half of the 10 horses are asleep."), "5 horse; 5 horse idle");
}

TEST(MendSharesTest, GroupsBesideEachOtherStay) {
  EXPECT_EQ(AgentsOf("12 robots and 4 robot dogs."), "12 any; 4 robotic dog");
  EXPECT_EQ(AgentsOf("6 animals by the lake, 2 horses in the fields."), "6 any; 2 horse");
  EXPECT_EQ(AgentsOf("12 robots, 4 of them rovers."), "8 any; 4 wheeled robot");
  EXPECT_EQ(AgentsOf("12 robots including 4 rovers."), "8 any; 4 wheeled robot");
  EXPECT_EQ(AgentsOf("Thirty creatures, ten of them whales."), "10 whale; total 30");
  EXPECT_EQ(AgentsOf("Six robots: two drones and four rovers."), "2 aerial robot; 4 wheeled robot");
  EXPECT_EQ(AgentsOf("Six robots, two drones and four rovers."), "2 aerial robot; 4 wheeled robot");
}

TEST(MendSharesTest, SoManyOfThemAreAtLeastSoMany) {
  EXPECT_EQ(AgentsOf("Knights wait by the lake. Eight of them sleep."),
            "1-8 ancient warrior idle; 8 ancient warrior idle");
  EXPECT_EQ(AgentsOf("The horses are in the fields. All seven of them are asleep."),
            "7 horse idle");
}

TEST(MendRangesTest, SignsAreSaid) {
  EXPECT_EQ(Ranged("8+ drones"), "at least 8 drones");
  EXPECT_EQ(Ranged(">3 whales, <=9 sheep"), "more than 3 whales , at most 9 sheep");
  EXPECT_EQ(Ranged("sky -> 5 drones"), "sky to 5 drones");
  EXPECT_EQ(Ranged("8 + 3 drones"), "8 and 3 drones");
}

TEST(MendRangesTest, TwoBoundsAreARange) {
  EXPECT_EQ(Ranged("no fewer than 4 but no more than 7 whales"), "between 4 and 7 whales");
  EXPECT_EQ(Ranged("more than four whales, but fewer than nine"), "between 5 and 8 whales");
  EXPECT_EQ(Ranged("at most 7 and at least 4 whales"), "between 4 and 7 whales");
  EXPECT_EQ(Ranged("at least 4 whales and at most 7 eagles"),
            "at least 4 whales and at most 7 eagles");
  EXPECT_EQ(Ranged("at least 4 but at most 7 m/s"), "at least 4 but at most 7 m s");
  EXPECT_EQ(Ranged("at least 4 whales, at most 7 in all"), "between 4 and 7 whales in all");
  for (const char* kept :
       {"at least 4 whales , at most 7 m s wind", "at least 4 whales , at most 7 percent trees",
        "at least 4 whales and at most seven houses",
        "at least 4 whales , no more than 20 degrees slope",
        "at most 7 whales and more than 4 big old brown shaggy horses"})
    EXPECT_EQ(Ranged(kept), kept);
}

TEST(MendRangesTest, TolerancesAreARange) {
  EXPECT_EQ(Ranged("50 knights, give or take five"), "between 45 and 55 knights");
  EXPECT_EQ(Ranged("about 50 plus or minus 10 percent knights"), "between 45 and 55 knights");
  EXPECT_EQ(Ranged("50 knights plus 5 goblins"), "50 knights plus 5 goblins");
  EXPECT_EQ(Ranged("50 knights give or take two or three"), "between 47 and 53 knights");
  EXPECT_EQ(Ranged("50 knights plus minus 5 goblins"), "50 knights plus minus 5 goblins");
  EXPECT_EQ(Ranged("minus 10 degrees, 20 sheep"), "minus 10 degrees , 20 sheep");
}

TEST(MendRangesTest, TheNumberOfThemIsBounded) {
  EXPECT_EQ(Ranged("the total number of agents should not exceed 25"),
            "at most 25 agents in total");
  EXPECT_EQ(Ranged("the number of whales must be at least three"), "at least three whales");
  EXPECT_EQ(Ranged("the number of whales is three"), "the number of whales is three");
  EXPECT_EQ(AgentsOf("The number of agents must not exceed 25. Six sheep."), "6 sheep; total 1-25");
}

TEST(MendMultiplesTest, ComparedCountsAreCounted) {
  const auto mended = [](std::string_view text) { return MendedBy(MendMultiples, text); };
  EXPECT_EQ(mended("twice as many sheep as horses; there are four horses"),
            "8 sheep ; there are four horses");
  EXPECT_EQ(mended("twice as many sheep as horses, and nine of the latter"),
            "18 sheep beside horses , and nine of the latter");
  EXPECT_EQ(mended("as many whales as drones: six"), "6 whales and 6 drones");
  EXPECT_EQ(mended("three times as many knights as drones"), "knights and drones");
  for (const char* kept : {"four horses and twice as many sheep as horses",
                           "as many as twelve sheep", "many sheep and horses"})
    EXPECT_EQ(mended(kept), kept);
  EXPECT_EQ(AgentsOf("About 40 sheep, twice as many goblins."), "30-50 sheep; 60-100 goblin");
  EXPECT_EQ(AgentsOf("As many sheep as possible."), "6-100 sheep");
  EXPECT_EQ(AgentsOf("As many horses as fit on the road."), "6-100 horse");
}

TEST(MendSidesTest, LandIsAtASide) {
  const auto mended = [](std::string_view text) { return MendedBy(MendSides, text); };
  EXPECT_EQ(mended("two sheep to the south of the forest"), "two sheep south of the forest");
  EXPECT_EQ(mended("right of our old village wait two sheep"),
            "east of our village wait two sheep");
  for (const char* kept :
       {"two sheep in the south of the forest", "two sheep to the left of the map",
        "two sheep to the left of the goblins", "the upper left of the forest",
        "the houses to the left of the lake", "what is left of the village is guarded"})
    EXPECT_EQ(mended(kept), kept);
}

TEST(FineBoundsTest, BoundsOfMeasuresAreRead) {
  EXPECT_EQ(NumbersOf("Wind under 7 m/s."), "desert 0-7");
  EXPECT_EQ(NumbersOf("A wind of 15 m/s or more."), "desert 15-40");
  EXPECT_EQ(NumbersOf("The wind should never be stronger than 9 m/s."), "desert 0-9");
  EXPECT_EQ(NumbersOf("Wind 3-6 m/s."), "desert 3-6");
  EXPECT_EQ(NumbersOf("Wind of 5 m/s with gusts up to 11 m/s."), "desert 4.5-5.5");
  EXPECT_EQ(NumbersOf("Stone density between 0.1 and 0.3, flower density at least 60%."),
            "stone 0.1-0.3; flower 0.6-1");
  EXPECT_EQ(NumbersOf("The mountain slopes must not exceed 30 degrees."), "snow_mountain 0-30");
  EXPECT_EQ(NumbersOf("Wind 5 m/s, at most ten sheep."), "desert 4.5-5.5");
  EXPECT_EQ(NumbersOf("Wind of 10 m/s and above the lake two drones."), "desert 9-11");
  EXPECT_EQ(NumbersOf("Raise the wind from 5 to 8 m/s."), "desert 7.2-8.8");
  EXPECT_EQ(NumbersOf("Wind from 5 to 8 m/s."), "desert 5-8");
  EXPECT_EQ(NumbersOf("Three drones hover over 30 degree slopes."), "snow_mountain 25-35");
  EXPECT_EQ(NumbersOf("Minimal style: slope 20 degrees."), "snow_mountain 15-25");
  EXPECT_EQ(NumbersOf("Max fun: wind 8 m/s."), "desert 7.2-8.8");
  EXPECT_EQ(NumbersOf("Max wind speed: 8 m/s."), "desert 0-8");
  EXPECT_EQ(NumbersOf("Wind 10 m/s\nMax: 5 sheep"), "desert 9-11");
}

TEST(FineListsTest, OneAdjectiveIsSaidOfAList) {
  EXPECT_EQ(NumbersOf("The stones and the flowers are sparse."), "flower 0.05-0.4; stone 0.05-0.4");
  EXPECT_EQ(NumbersOf("Sparse grass, stones and flowers."),
            "grass 0.05-0.4; stone 0.05-0.4; flower 0.05-0.4");
  EXPECT_EQ(NumbersOf("The forest is dense and the grass is sparse."),
            "forest 0.65-1; grass 0.05-0.4");
  EXPECT_EQ(NumbersOf("Dense forest and a village."), "forest 0.65-1");
  EXPECT_EQ(NumbersOf("Few stones and grass."), "stone 0.05-0.4");
  EXPECT_EQ(NumbersOf("There is grass and the flowers are dense."), "flower 0.65-1");
}

}  // namespace
}  // namespace latticeworld
