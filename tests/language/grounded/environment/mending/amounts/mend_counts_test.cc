#include "latticeworld/language/grounded/environment/mending/amounts/mend_counts.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/mending/amounts/mend_each.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_numerals.h"
#include "latticeworld/language/grounded/environment/mending/mend_asides.h"
#include "latticeworld/language/grounded/environment/mending/mend_denials.h"
#include "latticeworld/language/grounded/environment/mending/mend_labels.h"
#include "latticeworld/language/grounded/environment/mending/mend_robots.h"

namespace latticeworld {
namespace {

std::string Mended(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendCounts(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

std::string MendedBy(void (*mend)(const EnvironmentWords&, std::vector<Token>*),
                     std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  mend(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

TEST(MendCountsTest, TheNumberThatIsMeantStandsAlone) {
  EXPECT_EQ(Mended("three no four drones"), "four drones");
  EXPECT_EQ(Mended("ten, I mean twelve, sheep"), "twelve sheep");
  EXPECT_EQ(Mended("five, no wait, six goblins"), "six goblins");
  EXPECT_EQ(Mended("no four drones"), "no four drones");
  EXPECT_EQ(Mended("two goblins, no wolves"), "two goblins , no wolves");
}

TEST(MendCountsTest, PartsBehindAColonAreOfTheWhole) {
  EXPECT_EQ(Mended("four rovers: two stand still, two patrol"),
            "four rovers : two of them stand still , two of them patrol");
  EXPECT_EQ(Mended("six animals: two sheep, four horses"), "six animals : two sheep , four horses");
  EXPECT_EQ(Mended("four rovers: two patrol, one sleeps"), "four rovers : two patrol , one sleeps")
      << "one is missing";
}

TEST(MendCountsTest, WhatUsedToBeIsNot) {
  EXPECT_EQ(Mended("there used to be goblins"), "there no goblins");
  EXPECT_EQ(Mended("there used to be ten horses; now there are only three"),
            "there used to be ten horses ; now there are only three");
}

TEST(MendCountsTest, WhatIsTakenBackBehindTheNounCounts) {
  EXPECT_EQ(Mended("four white horses, no, five of them"), "five white horses");
  EXPECT_EQ(Mended("four horses, five of them white"), "four horses , five of them white");
}

TEST(MendCountsTest, RoundNumbersAreAbout) {
  EXPECT_EQ(Mended("twenty or so sheep"), "about twenty sheep");
  EXPECT_EQ(Mended("twenty-odd sheep"), "about twenty sheep");
  EXPECT_EQ(Mended("a couple of dozen sheep"), "two dozen sheep");
  EXPECT_EQ(Mended("a couple of sheep"), "a couple of sheep");
  EXPECT_EQ(Mended("two or three sheep"), "two or three sheep");
}

TEST(MendRobotsTest, KindsOfRobotsAreRobots) {
  EXPECT_EQ(MendedBy(MendRobots, "robots: 3 wheeled, 2 aerial"),
            "robots : 3 wheeled robots , 2 aerial robots");
  EXPECT_EQ(MendedBy(MendRobots, "robots: 3 wheeled carts"), "robots : 3 wheeled carts");
  EXPECT_EQ(MendedBy(MendRobots, "3 wheeled, 2 aerial"), "3 wheeled , 2 aerial");
}

TEST(MendCountsTest, HeadsAreAnimals) {
  EXPECT_EQ(Mended("64 heads of sheep"), "64 sheep");
  EXPECT_EQ(Mended("four more of them, asleep"), "four more , asleep");
}

TEST(MendCountsTest, WhatIsChangedIsTakenBack) {
  EXPECT_EQ(Mended("ten sheep. Change that to twelve."), "ten sheep . actually , twelve .");
  EXPECT_EQ(Mended("they change into wolves"), "they change into wolves");
}

TEST(MendCountsTest, TheLatterAreCounted) {
  EXPECT_EQ(Mended("of the latter we have nine"), "nine of the latter");
  EXPECT_EQ(Mended("of the latter we have heard"), "of the latter we have heard");
}

TEST(MendCountsTest, BothAreTwoOfThem) {
  EXPECT_EQ(Mended("the drones, both of them, hover"), "the drones , two of them , hover");
  EXPECT_EQ(Mended("a knight and goblins, both of them, sleep"),
            "a knight and goblins , both of them , sleep");
}

TEST(MendCountsTest, EqualBandsShareTheNumber) {
  EXPECT_EQ(Mended("a hundred and twenty knights in three equal bands: one here, one there and one "
                   "in the north"),
            "a hundred and twenty knights : 40 of them here , 40 of them there and 40 of them in "
            "the north");
  EXPECT_EQ(Mended("ten knights in three bands, one here, one there, one in the north"),
            "ten knights in three bands , one here , one there , one in the north");
}

TEST(MendCountsTest, WhoComesOneAfterAnotherIsCountedTogether) {
  EXPECT_EQ(Mended("first two rovers, then four more, then the last three, all parked"),
            "9 rovers , all parked");
  EXPECT_EQ(Mended("first two rovers, then a storm"), "first two rovers , then a storm");
}

TEST(MendCountsTest, WhatTheyAllDoIsSaidOfAll) {
  EXPECT_EQ(Mended("all they do is wait"), "they all wait");
}

TEST(MendCountsTest, TheOthersMakeUpTheWhole) {
  EXPECT_EQ(Mended("twelve sheep: eight graze, the other four sleep"),
            "twelve sheep : eight of them graze , the other four sleep");
}

TEST(MendLabelsTest, DashesBehindALabelAreColons) {
  EXPECT_EQ(MendedBy(MendLabels, "Flowers - none. Sheep - 12"), "flowers : none . sheep : 12");
  EXPECT_EQ(MendedBy(MendLabels, "Ten sheep - all asleep"), "ten sheep - all asleep");
}

TEST(MendLabelsTest, ValuesNeedNoColon) {
  EXPECT_EQ(MendedBy(MendLabels, "branches 0.9; flowers 0"), "branches : 0.9 ; flowers : none");
  EXPECT_EQ(MendedBy(MendLabels, "livestock nil"), "livestock : none");
  EXPECT_EQ(MendedBy(MendLabels, "drones: 0"), "drones : none");
}

TEST(MendLabelsTest, StatesAreLabelsOfCounts) {
  EXPECT_EQ(MendedBy(MendLabels, "17 sheep. Of these grazing: 12. Remaining 5: resting."),
            "17 sheep . 12 of these grazing . the remaining 5 resting .");
  EXPECT_EQ(MendedBy(MendLabels, "nine goblins. Asleep: 4"), "nine goblins . 4 of them asleep");
}

TEST(MendLabelsTest, TelegramsLeaveSmallWordsOut) {
  EXPECT_EQ(MendedBy(MendLabels, "9 goblins forest; 3 drones lake"),
            "9 goblins in the forest ; 3 drones by the lake");
  EXPECT_EQ(MendedBy(MendLabels, "two horses pasture"), "two horses pasture");
  EXPECT_EQ(MendedBy(MendLabels, "eagles: a pair too"), "eagles : a pair");
}

TEST(MendDenialsTest, NothingIsSaidInManyWays) {
  const auto mended = [](std::string_view text) { return MendedBy(MendDenials, text); };
  EXPECT_EQ(mended("zero robots and 0 sheep"), "no robots and no sheep");
  EXPECT_EQ(mended("0 degrees"), "0 degrees");
  EXPECT_EQ(mended("windspeed=0, sunny"), "no wind , sunny");
  EXPECT_EQ(mended("Snow? None. Sheep? Twelve."), "no snow . sheep ? twelve .");
  EXPECT_EQ(mended("not any wind"), "no wind");
  EXPECT_EQ(mended("not any more"), "not any more");
  EXPECT_EQ(mended("cancel the rain"), "no the rain");
  EXPECT_EQ(mended("ah no, forget about the dogs"), "ah no , no the dogs");
  EXPECT_EQ(mended("goblins skip the road"), "goblins skip the road");
  EXPECT_EQ(mended("of the warriors none remain"), "no the warriors");
  EXPECT_EQ(mended("nothing on the bridge but a horse"), "on the bridge nothing but a horse");
  EXPECT_EQ(mended("with no moving"), "without moving");
}

TEST(MendNumeralsTest, NumbersAreWrittenInManyWays) {
  const auto mended = [](std::string_view text) { return MendedBy(MendNumerals, text); };
  EXPECT_EQ(mended("two point five metres"), "2.5 metres");
  EXPECT_EQ(mended("a point in the north"), "a point in the north");
  EXPECT_EQ(mended("on 4 legs in all 4 corners"), "on four legs in all four corners");
  EXPECT_EQ(mended("a dog between the 2."), "a dog between the two .");
  EXPECT_EQ(mended("4 sheep"), "4 sheep");
  EXPECT_EQ(mended("50 % of them sleep, the other 50% graze"),
            "half of them sleep , the others graze");
  EXPECT_EQ(mended("33% are asleep"), "a third of them are asleep");
  EXPECT_EQ(mended("grass at 50 %"), "grass at 50 percent");
  EXPECT_EQ(mended("thirty at the very least, hunting"), "at least thirty , hunting");
  EXPECT_EQ(mended("twenty sheep tops"), "at most twenty sheep");
  EXPECT_EQ(mended("ten goblins or more sleep"), "at least ten goblins sleep");
  EXPECT_EQ(mended("Goblins. How many? Thirty."), "goblins . thirty .");
}

TEST(MendAsidesTest, WhatIsOnlySaidBesideIsLeftOut) {
  const auto mended = [](std::string_view text) { return MendedBy(MendAsides, text); };
  EXPECT_EQ(mended("make it nine, twelve is too much for my laptop"), "make it nine ,");
  EXPECT_EQ(mended("twelve sheep are too many"), "twelve sheep are too many");
  EXPECT_EQ(mended("my kids want ten sheep"), "want ten sheep");
  EXPECT_EQ(mended("the children will not look at it"), "will not look at it");
  EXPECT_EQ(mended("the children will play by the lake"), "the children will play by the lake");
  EXPECT_EQ(mended("I am tired of the rain, give me sun"), ", give me sun");
  EXPECT_EQ(mended("she finds the realistic one boring"), "");
  EXPECT_EQ(mended("she loves horses, so five horses"), ", so five horses");
  EXPECT_EQ(mended("I like horses, a white one"), "i like horses , a white one");
}

TEST(MendAsidesTest, WhatGoesOnIsDone) {
  const auto mended = [](std::string_view text) { return MendedBy(MendAsides, text); };
  EXPECT_EQ(mended("two dogs that go on patrolling"), "two dogs that patrolling");
  EXPECT_EQ(mended("they continue to graze"), "they graze");
  EXPECT_EQ(mended("they keep still"), "they keep still");
  EXPECT_EQ(mended("reed instead of ordinary grass"), "reed");
  EXPECT_EQ(mended("asphalt instead of grass"), "asphalt instead of grass");
}

TEST(MendEachTest, CountsOfEachAreThoseOfAll) {
  const auto mended = [](std::string_view text) { return MendedBy(MendEach, text); };
  EXPECT_EQ(mended("two knights on each side of the bridge"),
            "4 knights on each side of the bridge");
  EXPECT_EQ(mended("sixteen soldiers, eight on each side"), "sixteen soldiers");
  EXPECT_EQ(mended("sixteen soldiers, eight on each bank of the river"),
            "sixteen soldiers by the river");
  EXPECT_EQ(mended("four rovers, one in each corner"), "four rovers in all four corners");
  EXPECT_EQ(mended("a rover, one goblin in each corner"), "a rover , one goblin in each corner");
}

TEST(MendEachTest, LooksAreOfOneGroup) {
  const auto mended = [](std::string_view text) { return MendedBy(MendEach, text); };
  EXPECT_EQ(mended("one big and two small robot dogs"), "3 robot dogs");
  EXPECT_EQ(mended("two black horses, three white ones"), "two black horses , three white horses");
  EXPECT_EQ(mended("two white horses and a black one"), "two white horses and a black horse");
  EXPECT_EQ(mended("four horses, one of them white, pull a cart"), "four horses pull a cart");
  EXPECT_EQ(mended("four horses, one of them asleep"), "four horses , one of them asleep");
  EXPECT_EQ(mended("a family of four by the lake"), "four people by the lake");
  EXPECT_EQ(mended("a family of four goblins"), "four goblins");
}

TEST(MendNumeralsTest, CountsMayBeSaidTwiceOrBySteps) {
  const auto mended = [](std::string_view text) { return MendedBy(MendNumerals, text); };
  EXPECT_EQ(mended("seven (7) robot dogs"), "seven robot dogs");
  EXPECT_EQ(mended("seven (8) robot dogs"), "seven ( 8 ) robot dogs");
  EXPECT_EQ(mended("every second one of the ten sheep"), "half of the ten sheep");
  EXPECT_EQ(mended("every third sheep is asleep"), "a third of the sheep is asleep");
}

TEST(MendCountsTest, DozensAndHundredsAreCounted) {
  EXPECT_EQ(Mended("a few dozen sheep"), "dozens of sheep");
  EXPECT_EQ(Mended("a couple hundred sheep"), "two hundred sheep");
}

TEST(MendRobotsTest, PartsOfAWholeAreCountedByTheirKind) {
  const auto mended = [](std::string_view text) { return MendedBy(MendRobots, text); };
  EXPECT_EQ(mended("robots: three on wheels, two with four legs"),
            "robots : three robots on wheels , two robots with four legs");
  EXPECT_EQ(mended("ten robots, half of them wheeled and half flying"),
            "ten robots , 5 wheeled robots and 5 flying robots");
  EXPECT_EQ(mended("100 agents, 60 % sheep, 40 % goblins"), "100 agents , 60 sheep , 40 goblins");
  EXPECT_EQ(mended("sixty animals: sheep and horses in equal numbers"),
            "sixty animals : 30 sheep and 30 horses");
  EXPECT_EQ(mended("ten sheep, half of them lambs"), "ten sheep , half of them lambs");
}

TEST(MendLabelsTest, ValuesBehindLabelsAreMeant) {
  const auto mended = [](std::string_view text) { return MendedBy(MendLabels, text); };
  EXPECT_EQ(mended("Grass: fescue, 0.9"), "grass : fescue , density 0.9");
  EXPECT_EQ(mended("lots of dead wood, birch as well"),
            "lots of dead wood , birch dead wood as well");
  EXPECT_EQ(mended("wind speed 5"), "wind speed 5 m s");
  EXPECT_EQ(mended("everyone is asleep: ten sheep"), "all agents are asleep : ten sheep");
}

}  // namespace
}  // namespace latticeworld
