#include "latticeworld/language/grounded/environment/mending/amounts/mend_nones.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/grounded/environment/mending/mend_exceptions.h"
#include "latticeworld/language/grounded/environment/mending/mend_lacks.h"

namespace latticeworld {
namespace {

std::string Mended(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendNones(GetEnvironmentWords(), &tokens);
  MendLacks(GetEnvironmentWords(), text, &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

std::string Excepted(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendExceptions(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

void ExpectKept(std::string (*mend)(std::string_view), std::initializer_list<const char*> texts) {
  for (const char* text : texts) EXPECT_EQ(mend(text), text);
}

// How many agents of just this category are asked for; -1: none may be there, 0: nothing is said.
int AskedFor(const char* text, AgentCategory category) {
  int asked = 0;
  for (const EnvironmentClaim& claim : ReadEnvironmentInstruction(text).claims) {
    bool named = claim.kind == EnvironmentClaimKind::kNoAgents && claim.categories.empty();
    for (const AgentCategory one : claim.categories) named = named || one == category;
    if (named && claim.kind == EnvironmentClaimKind::kNoAgents) return -1;
    const bool alone = named && claim.categories.size() == 1;
    if (alone && claim.kind == EnvironmentClaimKind::kAgents) asked += claim.least_quantity;
  }
  return asked;
}

TEST(MendExceptionsTest, WhoIsExceptedIsThere) {
  EXPECT_EQ(Excepted("Each animal is grazing, except for three eagles."),
            "all animals are grazing , except for three eagles .");
  EXPECT_EQ(Excepted("Apart from four sheep, nobody is there"),
            "nobody is there except four sheep");
  EXPECT_EQ(Excepted("Save for a lone knight by the bridge there is no life."),
            "there is no life except a lone knight by the bridge .");
  EXPECT_EQ(Excepted("The fields are empty apart from ten horses"),
            "the fields are empty but for ten horses");
  ExpectKept(Excepted, {"every robot patrols the road", "except for the road all is grass",
                        "the world is empty except for trees", "no robots , only two dogs",
                        "apart from ten sheep there are two horses",
                        "excluding whales , add six animals , all asleep",
                        "aside from two drones , six rovers patrol and none are here"});
  EXPECT_EQ(Excepted("Every robot except the two drones patrols the road."),
            "all robots patrols the road except the two drones .");
  EXPECT_EQ(Excepted("Each animal but the wolf is asleep"), "all animals are asleep but the wolf");
  EXPECT_EQ(Excepted("Apart from two knights, who patrol the road, there are no people"),
            "there are no people except two knights who patrol the road");
  EXPECT_EQ(Excepted("Except for the two knights who guard the village, everybody sleeps"),
            "everybody sleeps . the two knights guard the village");
  EXPECT_EQ(AskedFor("Every machine sleeps except the three drones.", AgentCategory::kAerialRobot),
            3);
}

TEST(MendExceptionsTest, AllButSomeIsNoneOfThem) {
  EXPECT_EQ(Excepted("Everything but goblins."), "no goblins .");
  EXPECT_EQ(Excepted("Anybody except knights, please"), "no knights , please");
  ExpectKept(Excepted, {"everybody but the two drones is idle", "everything but the sheep sleeps",
                        "everyone except goblins , who attack the village , is asleep"});
  EXPECT_EQ(AskedFor("Instead of goblins give me six knights.", AgentCategory::kAncientWarrior), 6);
  EXPECT_EQ(AskedFor("No living beings, just two rovers.", AgentCategory::kWheeledRobot), 2);
  EXPECT_EQ(AskedFor("No one, only a shepherd.", AgentCategory::kHumanoidRobot), 1);
}

TEST(MendNonesTest, WhoDoesNotIsThereAllTheSame) {
  EXPECT_EQ(Mended("No horse is grazing."), "the horses are not grazing .");
  EXPECT_EQ(Mended("Six goblins. No goblin attacks."),
            "six goblins . the goblins do not attacks .");
  EXPECT_EQ(Mended("Not a single goblin attacks the village, but six sleep"),
            "the goblins do not attacks the village , but six sleep");
  ExpectKept(Mended,
             {"no goblins", "no goblins attack the village", "no horse", "no goblin camps",
              "no whale swims in the lake", "no bird sings", "no guards in the village",
              "no knight fights and no goblin attacks", "no drone flies",
              "there are no goblins , so no goblin attacks", "it is so quiet that no sheep grazes",
              "where no goblin hides , six sheep graze"});
  EXPECT_EQ(AskedFor("Twelve goblins. No goblin is attacking.", AgentCategory::kGoblin), 12);
  EXPECT_EQ(Mended("nobody is watching the horses"), "the horses");
  EXPECT_EQ(Mended("no one attacks the village"), "the village");
  EXPECT_EQ(Mended("nobody guards the road except two drones"), "two drones guards the road");
  EXPECT_EQ(Mended("nobody guards the road except"), "nobody guards the road except");
  EXPECT_EQ(Mended("no one is watching the horses but an old dog"),
            "an old dog watching the horses");
  ExpectKept(Mended, {"nobody lives in the village", "nobody watches", "nobody walks"});
}

TEST(MendNonesTest, NoneOfThemDoes) {
  EXPECT_EQ(Mended("six rovers, none patrolling"), "six rovers , none of them patrolling");
  EXPECT_EQ(Mended("ten sheep; and not one of them asleep"), "ten sheep ; and none of them asleep");
  EXPECT_EQ(Mended("three eagles, none of them on the ground"), "three eagles , all in the air");
  ExpectKept(Mended, {"sheep : none", "ten sheep , none of them asleep",
                      "six eagles perched , not one of them in the air",
                      "six eagles in the trees , none on the ground"});
}

TEST(MendNonesTest, AllOfAKindAreOfItsName) {
  EXPECT_EQ(Mended("six robots, all wheeled, patrol"), "six wheeled robots , patrol");
  EXPECT_EQ(Mended("six robots, all on four legs"), "six robots on four legs");
  EXPECT_EQ(Mended("twelve animals, all of them horses"), "twelve horses");
  ExpectKept(Mended, {"eight robots , all flying", "ten sheep , all white",
                      "ten animals , five sheep and five horses"});
}

TEST(MendLacksTest, NotManyAreAFew) {
  EXPECT_EQ(Mended("there aren't many trees"), "there are few trees");
  EXPECT_EQ(Mended("not a lot of robots"), "few robots");
  EXPECT_EQ(Mended("scarcely any people"), "few people");
  EXPECT_EQ(Mended("not much wind"), "little wind");
  ExpectKept(Mended, {"hardly any trees", "hardly any wind", "not much snow", "not much"});
}

TEST(MendLacksTest, NothingIsSaidInManyWays) {
  EXPECT_EQ(Mended("Guards: none"), "no guards");
  EXPECT_EQ(Mended("rocks are nowhere, trees everywhere"), "no rocks , trees everywhere");
  EXPECT_EQ(Mended("a fog-free morning"), "a no fog , morning");
  EXPECT_EQ(Mended("the town is completely abandoned"), "the town is completely deserted");
  EXPECT_EQ(Mended("I don't mind if there are no robots, add sheep"), ", add sheep");
  EXPECT_EQ(Mended("without a moon"), "moonless");
  EXPECT_EQ(Mended("the bridge lies deserted"), "the bridge");
  ExpectKept(Mended, {"the knights free the horses", "an ice free lake", "a deserted village",
                      "it is fine , no sheep", "it is fine if it rains", "the moon is full",
                      "abandoned houses in the forest", "set the dog free", "keep the bridge free",
                      "a horse free and wild", "no moon base",
                      "an abandoned village where knights now live",
                      "it is fine if the six sheep do not graze"});
  EXPECT_EQ(Mended("the village is goblin free"), "the village is no goblin");
  EXPECT_EQ(Mended("at dusk, without a moon"), "at dusk ,");
  EXPECT_EQ(Mended("it is dawn and there is no moon yet"), "it is dawn and there is yet");
  EXPECT_EQ(Mended("wolves creep without a moon along the road"),
            "wolves creep moonless along the road");
  EXPECT_EQ(Mended("it is all right if there are no sheep but add dogs"), "but add dogs");
}

}  // namespace
}  // namespace latticeworld
