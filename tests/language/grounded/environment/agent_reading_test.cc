// Who is in the world, in which state and where: instructions in many voices.

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "language/grounded/environment/environment_country.h"

namespace latticeworld {
namespace {

struct Sample {
  std::string instruction;
  std::string expected;
};
void PrintTo(const Sample& sample, std::ostream* os) { *os << sample.instruction; }

class AgentVoices : public testing::TestWithParam<Sample> {};

TEST_P(AgentVoices, AreReadAsMeant) {
  const EnvironmentAnswer answer = GenerateInCountry(GetParam().instruction);
  std::string text;
  for (const AgentGroup& group : answer.environment.agents) {
    text += std::to_string(group.quantity) + " " + std::string(NameOf(group.category)) + " " +
            std::string(NameOf(group.state)) + " " + std::string(NameOf(group.position)) + "; ";
  }
  EXPECT_EQ(text, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Counts, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"half a dozen sheep", "6 sheep grazing anywhere; "},
        {"a score of horses", "20 horse grazing anywhere; "},
        {"between five and nine goblins", "7 goblin patrolling anywhere; "},
        {"no more than four eagles", "4 eagle flying anywhere; "},
        {"two flocks of ten sheep", "20 sheep grazing anywhere; "},
        {"a herd of thirty horses", "30 horse grazing anywhere; "},
        {"six hundred sheep", "500 sheep grazing anywhere; 100 sheep grazing anywhere; "},
        {"a goblin warband of 25", "25 goblin patrolling anywhere; "},
        {"a trio of drones", "3 aerial robot flying anywhere; "},
        {"3-5 goblins", "4 goblin patrolling anywhere; "},
        {"Ten, I mean twelve, sheep graze.", "12 sheep grazing anywhere; "},
        {"Three, no, four drones hover.", "4 aerial robot flying anywhere; "},
        {"Four rovers: two stand still, two patrol.",
         "2 wheeled robot idle anywhere; 2 wheeled robot patrolling anywhere; "},
        {"Six animals: two sheep, four horses.",
         "2 sheep grazing anywhere; 4 horse grazing anywhere; "},
        {"There used to be goblins here but they are gone. Two sheep.",
         "2 sheep grazing anywhere; "},
        {"Three horses; the wolves have left.", "3 horse grazing anywhere; "},
        {"A robot dog is charging its battery.", "1 robotic dog idle anywhere; "},
        {"The only living thing is an eagle.", "1 eagle flying anywhere; "},
        {"One eagle. That is all there is in the way of agents.", "1 eagle flying anywhere; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    References, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Three goblins in the north. No, make it five.", "5 goblin patrolling upper; "},
        {"Two knights guard the east. Sorry, four knights.",
         "4 ancient warrior patrolling middle right; "},
        {"Eight horses graze. Three of them are in the west, the rest sleep in the east.",
         "5 horse idle middle right; 3 horse grazing middle left; "},
        {"Six drones: two in the west, three in the north and one in the south.",
         "2 aerial robot flying middle left; 3 aerial robot flying upper; "
         "1 aerial robot flying lower; "},
        {"two goblins in the north and three in the south",
         "2 goblin patrolling upper; 3 goblin patrolling lower; "},
        {"Ten sheep. Half of them rest.", "5 sheep grazing anywhere; 5 sheep idle anywhere; "},
        {"Five sheep. They sleep in the south.", "5 sheep idle lower; "},
        {"Two goblins chase the sheep in the west. The goblins are green.",
         "2 goblin pursuing middle left; 3 sheep grazing middle left; "},
        {"Sheep are guarded by two knights.",
         "3 sheep grazing anywhere; 2 ancient warrior patrolling anywhere; "},
        {"Three goblins here, no goblins after all.", ""},
        {"Sheep, horses and goblins rest in the east.",
         "3 sheep idle middle right; 3 horse idle middle right; 3 goblin idle middle right; "},
        {"one knight in each corner",
         "1 ancient warrior patrolling upper left; 1 ancient warrior patrolling upper right; "
         "1 ancient warrior patrolling lower left; 1 ancient warrior patrolling lower right; "},
        {"Three knights and two goblins. The former sleep in the east, the latter walk in the "
         "west.",
         "3 ancient warrior idle middle right; 2 goblin patrolling middle left; "},
        {"Four knights in the north, six goblins in the south, all asleep.",
         "4 ancient warrior idle upper; 6 goblin idle lower; "},
        {"25 agents: 20 sheep in the west and the rest are goblins.",
         "20 sheep grazing middle left; 5 goblin patrolling anywhere; "},
        {"Let goblins attack the village. Nine goblins.", "9 goblin attacking center; "},
        {"This is for my robot. One rover waits in the east.",
         "1 wheeled robot idle middle right; "},
        {"Three of the eight sheep are in the west, the others rest in the east.",
         "5 sheep idle middle right; 3 sheep grazing middle left; "},
        {"Half of the ten knights sleep in the north, the other half march in the south.",
         "5 ancient warrior patrolling lower; 5 ancient warrior idle upper; "},
        {"Two goblins march to the village, where five knights wait.",
         "2 goblin patrolling center; 5 ancient warrior idle center; "},
        {"Nobody except a shepherd, in the west.", "1 humanoid robot idle middle left; "},
        {"Four rovers on the road, none of them parked.",
         "4 wheeled robot patrolling lower left; "},
        {"The robots stand in the village, three of them, charging.",
         "3 wheeled robot idle center; "},
        {"Mist lies over the road, and three mares doze in the fields.",
         "3 horse idle upper right; "},
        {"A rover - a robot - waits in the east.", "1 wheeled robot idle middle right; "},
        {"A goblin gathering near the village, nine of them sleeping.", "9 goblin idle center; "},
        {"Eight sheep. Three of the sheep sleep in the east, the others graze.",
         "5 sheep grazing anywhere; 3 sheep idle middle right; "},
        {"Twelve drones. A third of the drones patrol, two thirds of the drones hover in the east.",
         "4 aerial robot patrolling anywhere; 8 aerial robot flying middle right; "},
        {"Ten goblins. Most of the goblins attack the village.",
         "3 goblin patrolling anywhere; 7 goblin attacking center; "},
        {"Ten horses. All but one of the horses graze in the east.",
         "1 horse idle anywhere; 9 horse grazing middle right; "},
        {"A quarter of the 20 sheep sleep, the rest graze.",
         "15 sheep grazing anywhere; 5 sheep idle anywhere; "},
        {"Forty sheep: 25% sleep, 75% graze.",
         "10 sheep idle anywhere; 30 sheep grazing anywhere; "},
        {"Ninety goblins attack. Half of them chase a horse, the other half sleep in the east.",
         "45 goblin idle middle right; 45 goblin pursuing anywhere; 1 horse grazing anywhere; "},
        {"Twenty mares graze in the east. The stallion sleeps in the west.",
         "20 horse grazing middle right; 1 horse idle middle left; "},
        {"Forty knights. Goblins, three times that number, attack in the east.",
         "40 ancient warrior patrolling anywhere; 120 goblin attacking middle right; "},
        {"Twelve goblins, half that number of knights.",
         "12 goblin patrolling anywhere; 6 ancient warrior patrolling anywhere; "},
        {"Sheep in the east, drones in the west: two of the former, a single one of the latter.",
         "2 sheep grazing middle right; 1 aerial robot flying middle left; "},
        {"Six goblins sleep in the east, and a seventh, who is braver, chases a horse.",
         "6 goblin idle middle right; 1 goblin pursuing anywhere; 1 horse grazing anywhere; "},
        {"Two robodogs in the east and three sheep. Ah no, forget the dogs.",
         "3 sheep grazing anywhere; "},
        {"A hnudred gbolins in the froest.", "100 goblin patrolling lower right; "},
        {"I'd like a whale in the lake.", "1 whale swimming upper left; "},
        {"Sheep: 17. Of these grazing: 12, in the east. Remaining 5: resting, bottom left.",
         "5 sheep idle lower left; 12 sheep grazing middle right; "},
        {"Twelve knights in three equal bands: one in the north, one in the south, one in the "
         "east. All they do is wait.",
         "4 ancient warrior idle upper; 4 ancient warrior idle lower; "
         "4 ancient warrior idle middle right; "},
        {"Eight of the ten sheep graze; the remaining two just stare at the lake.",
         "2 sheep idle upper left; 8 sheep grazing anywhere; "},
        {"Whales: a pair. Sheep: twice as many as whales, asleep.",
         "2 whale swimming anywhere; 4 sheep idle anywhere; "},
        {"Twelve drones. Two thirds over the lake, one third over the village.",
         "8 aerial robot flying upper left; 4 aerial robot flying center; "},
        {"There are 12 robots: 4 drones, 4 rovers and 4 dogs. The drones fly over the lake, the "
         "rest are parked in the village.",
         "4 aerial robot flying upper left; 4 wheeled robot idle center; "
         "4 robotic dog idle center; "},
        {"Seven knights have made camp by the lake, six are asleep; the seventh patrols.",
         "1 ancient warrior patrolling upper left; 6 ancient warrior idle upper left; "},
        {"Goblins vs knights, 8 on both sides.",
         "8 goblin patrolling anywhere; 8 ancient warrior patrolling anywhere; "},
        {"The drones, both of them, hover in the east.", "2 aerial robot flying middle right; "},
        {"Nothing in the village but three goats.", "3 sheep grazing center; "},
        {"A dozen o\xE2\x80\x99 me goblin lads storm the village.", "12 goblin attacking center; "},
        {"9 goblins forest; 9 warriors village; all idle",
         "9 goblin idle lower right; 9 ancient warrior idle center; "},
        {"In the north stands a knight, in the south another.",
         "1 ancient warrior idle upper; 1 ancient warrior idle lower; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    PlacesAndNegations, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"a whale swims in the lake", "1 whale swimming upper left; "},
        {"three knights guard the village", "3 ancient warrior patrolling center; "},
        {"a rover drives along the road", "1 wheeled robot patrolling lower left; "},
        {"an android rests at the forest edge", "1 humanoid robot idle lower right; "},
        {"four goblins lurk in the fields", "4 goblin patrolling upper right; "},
        {"no animals, no robots, just one knight", "1 ancient warrior patrolling anywhere; "},
        {"Not a soul, neither man nor beast.", ""},
        {"two rovers parked by the lake", "2 wheeled robot idle upper left; "},
        {"No goblins in the north, but four goblins in the south.", "4 goblin patrolling lower; "},
        {"agents: 3 horses (idle, NE)", "3 horse idle upper right; "},
        {"goblins everywhere! like 40 of them, attacking", "40 goblin attacking anywhere; "},
        {"instead of goblins, two knights", "2 ancient warrior patrolling anywhere; "},
        {"robots fly over the village", "3 aerial robot flying center; "},
        {"the statue of a knight and the eagle's nest", ""},
        {"The goblins do not attack, they sleep.", "3 goblin idle anywhere; "},
        {"No sheep in the village, but two knights stand there.",
         "2 ancient warrior idle center; "},
        {"3 goblins attacking @ village", "3 goblin attacking center; "},
        {"Two robots on wheels wait by the lake.", "2 wheeled robot idle upper left; "},
        {"a sheepdog robot in the fields", "1 robotic dog patrolling upper right; "},
        {"What I do not want: sheep or horses.", ""},
        {"a shepherd and his flock of sixty",
         "1 humanoid robot idle anywhere; 60 sheep grazing anywhere; "},
        {"Instead of sheep I want nine horses.", "9 horse grazing anywhere; "},
        {"a dozen swans drift over the lake", "12 eagle flying upper left; "},
        {"In the village five goblins, in the fields seven.",
         "5 goblin patrolling center; 7 goblin patrolling upper right; "},
        {"Two knights guard the fields. Nobody is in the village.",
         "2 ancient warrior patrolling upper right; "},
        {"Leave the animals out. One knight in the east.",
         "1 ancient warrior patrolling middle right; "},
        {"the village is full of goblins", "3 goblin patrolling center; "},
        {"two knights on the southern shore", "2 ancient warrior patrolling upper left; "},
        {"a goblin sits on a stone in the south", "1 goblin idle lower; "},
        {"a knight in the middle of the forest", "1 ancient warrior patrolling lower right; "},
        {"drones x4 over the fields", "4 aerial robot flying upper right; "},
        {"a pack mule by the road", "1 horse grazing lower left; "},
        {"drone footage of three horses", "3 horse grazing anywhere; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    AsidesAndFragments, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Nine sheep graze. Make it a foggy night, with one eagle over the village.",
         "9 sheep grazing anywhere; 1 eagle flying center; "},
        {"one rover (patrolling) in the village, two knights by the lake",
         "1 wheeled robot patrolling center; 2 ancient warrior patrolling upper left; "},
        {"Six horses trotting... okay, only resting, in the east.", "6 horse idle middle right; "},
        {"four robots with wheels, parked in the south", "4 wheeled robot idle lower; "},
        {"Snow on the fields, and one eagle soars over the village.", "1 eagle flying center; "},
        {"two dozen goats south of the village", "24 sheep grazing lower; "},
        {"three delivery robots (six wheels each) wait in the village",
         "3 wheeled robot idle center; "},
        {"One drone and two rovers, all three parked in the village.",
         "1 aerial robot idle center; 2 wheeled robot idle center; "},
        {"Two horses rest in the east, the third grazes in the south.",
         "2 horse idle middle right; 1 horse grazing lower; "},
        {"Six horses graze in the east and another eight in the south.",
         "6 horse grazing middle right; 8 horse grazing lower; "},
        {"Four knights guard the village, with one eagle above them.",
         "4 ancient warrior patrolling center; 1 eagle flying center; "},
        {"two more groups of four goblins in the south", "8 goblin patrolling lower; "},
        {"five rovers in the corner down left", "5 wheeled robot idle lower left; "},
        {"two horses in the part down left", "2 horse grazing lower left; "},
        {"five humanoid courier robots in the east", "5 humanoid robot idle middle right; "},
        {"We want to test how robots cope with rain, so put two rovers in the south.",
         "2 wheeled robot idle lower; "},
        {"a dozen o' goblins", "12 goblin patrolling anywhere; "},
        {"four drons patroll", "4 aerial robot patrolling anywhere; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    Parts, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Of the twenty horses in the fields all but two are asleep. The other two graze.",
         "2 horse grazing upper right; 18 horse idle upper right; "},
        {"Twelve drones. Half are parked in the village, half hover over the lake.",
         "6 aerial robot idle center; 6 aerial robot flying upper left; "},
        {"Nine goblins: a third of them sleep in the north, the rest march in the south.",
         "6 goblin patrolling lower; 3 goblin idle upper; "},
        {"Eight dogs in four pairs: one pair in the north, one in the south, another in the west, "
         "the last by the lake.",
         "2 robotic dog patrolling upper left; 2 robotic dog patrolling upper; "
         "2 robotic dog patrolling lower; 2 robotic dog patrolling middle left; "},
        {"Six rovers in teams of three: one team in the village, another in the fields.",
         "3 wheeled robot idle center; 3 wheeled robot idle upper right; "},
        {"Ten knights have camped in the forest. Nine are asleep; the tenth keeps watch.",
         "1 ancient warrior patrolling lower right; 9 ancient warrior idle lower right; "},
        {"Two eagles soar over the lake, a third is perched in the village.",
         "2 eagle flying upper left; 1 eagle idle center; "},
        {"Goblins are on a raid: four in the north, six in the east.",
         "4 goblin attacking upper; 6 goblin attacking middle right; "},
        {"One flock of forty sheep in the south. One of thirty goats in the west.",
         "40 sheep grazing lower; 30 sheep grazing middle left; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    Comparisons, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Five knights, and goblins three times as many, all asleep.",
         "5 ancient warrior idle anywhere; 15 goblin idle anywhere; "},
        {"There are seven rovers in the village and just as many drones over the lake.",
         "7 wheeled robot idle center; 7 aerial robot flying upper left; "},
        {"Four horses and twice as many sheep as horses.",
         "4 horse grazing anywhere; 8 sheep grazing anywhere; "},
        {"Goblins against knights, 30 against 20, both attacking.",
         "30 goblin attacking anywhere; 20 ancient warrior attacking anywhere; "},
        {"robots versus goblins in the east, six on each side",
         "6 wheeled robot idle middle right; 6 goblin patrolling middle right; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    Company, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Ten knights camp in the village. Above them circle three eagles.",
         "10 ancient warrior idle center; 3 eagle flying center; "},
        {"The fields are ripe. Two drones hover over them.", "2 aerial robot flying upper right; "},
        {"A dog lies next to the sheep, which graze in the south.",
         "1 robotic dog idle lower; 3 sheep grazing lower; "},
        {"An android waits in the village, and with it two robot dogs.",
         "1 humanoid robot idle center; 2 robotic dog patrolling center; "},
        {"The lake is calm. Three drones hover above it.", "3 aerial robot flying upper left; "},
        {"Headquarters is the village, where two androids wait.", "2 humanoid robot idle center; "},
        {"On the sand, in the corner down right, stand nine knights.",
         "9 ancient warrior idle lower right; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    AllOfThem, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Rovers: 4. Drones: 2. All of them are parked, in the village.",
         "4 wheeled robot idle center; 2 aerial robot idle center; "},
        {"Three goblins in the north. Ten sheep in the south. Everybody is asleep.",
         "3 goblin idle upper; 10 sheep idle lower; "},
        {"I would like some ponies. Twenty-five, please, in the fields, grazing.",
         "25 horse grazing upper right; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    Denials, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Goblins have no place here. Two knights.", "2 ancient warrior patrolling anywhere; "},
        {"Eagles: none. Rovers: 3. Whales: 0.", "3 wheeled robot idle anywhere; "},
        {"Ten robots, but no rovers and no drones.", "10 humanoid robot idle anywhere; "},
        {"Three knights and four horses. All are idle except for the horses, which graze.",
         "3 ancient warrior idle anywhere; 4 horse grazing anywhere; "},
        {"Everybody sleeps except two dogs, which patrol the village.",
         "2 robotic dog patrolling center; "},
        {"Seven wolves in the fields; if you have no wolves, use robot dogs.",
         "7 robotic dog patrolling upper right; "},
        {"Eight goblins by the lake. Not by the lake, in the village.",
         "8 goblin patrolling center; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    EachOfThem, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Three knights guard the village, each with a horse at his side.",
         "3 ancient warrior patrolling center; 3 horse grazing center; "},
        {"Two shepherds wait in the fields. Each of them has two dogs.",
         "2 humanoid robot idle upper right; 4 robotic dog patrolling upper right; "},
        {"Five androids in the village with a drone each.",
         "5 humanoid robot idle center; 5 aerial robot flying center; "},
        {"A knight and a goblin meet in the village. The two fight.",
         "1 ancient warrior attacking center; 1 goblin attacking center; "},
        {"Three knights and three goblins. Apart from these six nobody is there.",
         "3 ancient warrior patrolling anywhere; 3 goblin patrolling anywhere; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    LandAndOrder, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Halfway between the lake and the forest stand two knights.",
         "2 ancient warrior idle center; "},
        {"Five rovers drive from the lake to the village.",
         "5 wheeled robot patrolling upper left; "},
        {"Six horses on the far side of the village, seen from the lake.",
         "6 horse grazing center; "},
        {"The village is quiet: one dog dozes, another patrols.",
         "1 robotic dog idle center; 1 robotic dog patrolling center; "},
        {"Along the top, from left to right: two knights, three goblins, four sheep.",
         "2 ancient warrior patrolling upper left; 3 goblin patrolling upper; "
         "4 sheep grazing upper right; "},
        {"From north to south there are a drone, a rover and an android.",
         "1 aerial robot flying upper; 1 wheeled robot idle center; 1 humanoid robot idle lower; "},
        {"By the lake, with the fields to its east, four knights have made camp.",
         "4 ancient warrior idle upper left; "},
        {"Nine drones: six soar over the fields, the rest are on the ground in the village.",
         "3 aerial robot idle center; 6 aerial robot flying upper right; "},
        {"Leaning on her staff, a shepherdess waits in the fields.",
         "1 humanoid robot idle upper right; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    Discourse, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"A shepherd waits in the fields together with his thirty sheep and two dogs.",
         "1 humanoid robot idle upper right; 30 sheep grazing upper right; "
         "2 robotic dog patrolling upper right; "},
        {"There are twelve robots, five of which are drones; the other seven are rovers parked in "
         "the village.",
         "7 wheeled robot idle center; 5 aerial robot flying anywhere; "},
        {"Of the ten knights three guard the village, three patrol the forest and the rest sleep.",
         "4 ancient warrior idle anywhere; 3 ancient warrior patrolling center; "
         "3 ancient warrior patrolling lower right; "},
        {"Twenty goblins, split evenly between the forest and the fields.",
         "10 goblin patrolling lower right; 10 goblin patrolling upper right; "},
        {"Ten sheep graze in the south; so do two horses.",
         "10 sheep grazing lower; 2 horse grazing lower; "},
        {"One robot in the north, south and east each.",
         "1 wheeled robot idle upper; 1 wheeled robot idle lower; "
         "1 wheeled robot idle middle right; "},
        {"Five rovers patrol the village and a drone watches them from above.",
         "5 wheeled robot patrolling center; 1 aerial robot flying center; "},
        {"Eleven sheep, three of them lambs, doze near the lake.",
         "8 sheep idle upper left; 3 sheep idle upper left; "},
        {"All six drones hover above the village except one, which has landed in the fields.",
         "5 aerial robot flying center; 1 aerial robot idle upper right; "},
        {"First group: ten sheep in the fields. Second group: five horses by the lake. The first "
         "group grazes, the second sleeps.",
         "10 sheep grazing upper right; 5 horse idle upper left; "},
        {"There are two teams of four androids each; one team combs the forest, the other one "
         "searches the fields.",
         "4 humanoid robot patrolling upper right; 4 humanoid robot patrolling lower right; "},
        {"All the robots (six drones, four rovers) are switched off in the village.",
         "6 aerial robot idle center; 4 wheeled robot idle center; "},
        {"There used to be twenty horses; now there are only three, standing by the lake.",
         "3 horse idle upper left; "},
        {"Every animal is asleep: ten sheep in the fields, four horses in the forest.",
         "10 sheep idle upper right; 4 horse idle lower right; "},
        {"Two drones over the village, one drone over the lake. Three drones altogether.",
         "2 aerial robot flying center; 1 aerial robot flying upper left; "},
        {"Four androids march in the east, led by a robot dog.",
         "4 humanoid robot patrolling middle right; 1 robotic dog patrolling middle right; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    ListsAndLands, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Agents:\n- 4 wheeled robots, road, parked\n- 2 drones, lake, flying",
         "4 wheeled robot idle lower left; 2 aerial robot flying upper left; "},
        {"Goblins, 12 of them. Location: forest. Behaviour: sleeping.",
         "12 goblin idle lower right; "},
        {"Sixty sheep in total, twenty each in the fields, by the lake and in the forest.",
         "20 sheep grazing upper right; 20 sheep grazing upper left; "
         "20 sheep grazing lower right; "},
        {"Two packs of wolves, seven in each, roam the forest.",
         "14 goblin patrolling lower right; "},
        {"Eight goblins, of which half hide in the forest and half in the fields.",
         "4 goblin idle lower right; 4 goblin idle upper right; "},
        {"Three horses by the lake, two of them asleep, one grazing.",
         "2 horse idle upper left; 1 horse grazing upper left; "},
        {"Four rovers were in the village, but one has driven off to the lake.",
         "3 wheeled robot idle center; 1 wheeled robot idle upper left; "},
        {"Neither of the two androids moves.", "2 humanoid robot idle anywhere; "},
        {"The south belongs to the goblins (fifty), the north to the knights (thirty).",
         "50 goblin patrolling lower; 30 ancient warrior patrolling upper; "},
        {"A hundred goblins storm the village while thirty knights defend it.",
         "100 goblin attacking center; 30 ancient warrior patrolling center; "},
        {"One sheep has strayed: it stands in the forest while the other nineteen graze in the "
         "fields.",
         "1 sheep idle lower right; 19 sheep grazing upper right; "},
        {"Two androids face each other in the village; behind each of them stands a robot dog.",
         "2 humanoid robot idle center; 2 robotic dog idle center; "},
        {"A robot dog runs around the village, chased by two goblins.",
         "1 robotic dog patrolling center; 2 goblin pursuing center; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    OfWhomAndWhose, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Six eagles above the lake, of which two are perched.",
         "4 eagle flying upper left; 2 eagle idle upper left; "},
        {"Horses run free in the fields. I counted nine.", "9 horse patrolling upper right; "},
        {"Both rovers are parked: one in the village, the other by the lake.",
         "1 wheeled robot idle upper left; 1 wheeled robot idle center; "},
        {"The village is guarded by four knights.", "4 ancient warrior patrolling center; "},
        {"In the fields: camels, at least ten, resting. In the village: nobody.",
         "10 horse idle upper right; "},
        {"Two horses stand in the village, nobody moves.", "2 horse idle center; "},
        {"robots: none | animals: 5 sheep, fields | people: 1 shepherd, patrolling",
         "5 sheep grazing upper right; 1 humanoid robot patrolling anywhere; "},
        {"I'd rather have goats than sheep: eighteen, in the south.", "18 sheep grazing lower; "},
        {"10 goblins, west. Also 10 warriors, east. They fight each other.",
         "10 goblin attacking middle left; 10 ancient warrior attacking middle right; "},
        {"The farmers (five) are in the fields, the sheep (twenty) too.",
         "5 humanoid robot idle upper right; 20 sheep grazing upper right; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    PartsAndHabits, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"All but two of the nine knights sleep in the south.",
         "2 ancient warrior patrolling anywhere; 7 ancient warrior idle lower; "},
        {"Six rovers, parked in the village bar one, which roams the fields.",
         "5 wheeled robot idle center; 1 wheeled robot patrolling upper right; "},
        {"Five goblins raid the village. Another seven, lying low in the forest.",
         "5 goblin attacking center; 7 goblin idle lower right; "},
        {"8 horses W grazing. 3 NE idle.",
         "8 horse grazing middle left; 3 horse idle upper right; "},
        {"Four sheep in the north grazing, two in the south asleep.",
         "4 sheep grazing upper; 2 sheep idle lower; "},
        {"Three rovers that usually patrol the road stand in the village.",
         "3 wheeled robot idle center; "},
        {"Two eagles, which normally circle, sit in the forest.", "2 eagle idle lower right; "},
        {"Drones: two, over the lake. Goblins: none today.", "2 aerial robot flying upper left; "},
        {"Five sheep in the west, heads down.", "5 sheep grazing middle left; "},
        {"Four robot dogs patroling the village", "4 robotic dog patrolling center; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    PartsAndPlaces, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Four wheeled robots in the village: one is parked, the others drive their rounds.",
         "3 wheeled robot patrolling center; 1 wheeled robot idle center; "},
        {"Two four-wheeled robots in the village.", "2 wheeled robot idle center; "},
        {"Ten sheep in the fields, all of them grazing except four, which just stand around.",
         "6 sheep grazing upper right; 4 sheep idle upper right; "},
        {"Eight drones, all but two in the air.",
         "2 aerial robot idle anywhere; 6 aerial robot flying anywhere; "},
        {"Most of the twelve sheep sleep; the rest graze.",
         "4 sheep grazing anywhere; 8 sheep idle anywhere; "},
        {"Ten sheep and ten robot dogs. The sheep sleep, the dogs patrol.",
         "10 sheep idle anywhere; 10 robotic dog patrolling anywhere; "},
        {"Ten knights: nine of them guard the village, the tenth sleeps.",
         "1 ancient warrior idle anywhere; 9 ancient warrior patrolling center; "},
        {"Three humanoids wait in the village, two robot dogs are with them, and a drone flies "
         "above all five.",
         "3 humanoid robot idle center; 2 robotic dog patrolling center; "
         "1 aerial robot flying center; "},
        {"Our rovers are spread along the road, two in the north, two in the south.",
         "2 wheeled robot idle upper; 2 wheeled robot idle lower; "},
        {"Six goblins: two small ones, four big ones, all in the village.",
         "2 goblin patrolling center; 4 goblin patrolling center; "},
        {"Five goblins each in the north and in the south.",
         "5 goblin patrolling upper; 5 goblin patrolling lower; "},
        {"Goblins in the north and in the south, ten in each.",
         "10 goblin patrolling upper; 10 goblin patrolling lower; "},
        {"Thirty sheep graze on the grass by the forest.", "30 sheep grazing lower right; "},
        {"A robot dog lies in the grass east of the lake.", "1 robotic dog idle upper; "},
        {"Seven dogs. Four live in the village. The other three roam the forest.",
         "3 robotic dog patrolling lower right; 4 robotic dog patrolling center; "},
        {"Five drones. One lies by the road, the others fly.",
         "4 aerial robot flying anywhere; 1 aerial robot idle lower left; "},
        {"Neither of the two eagles is flying.", "2 eagle idle anywhere; "},
        {"Three robots are charging in the village.", "3 wheeled robot idle center; "},
        {"In the middle of the night two dogs patrol the forest.",
         "2 robotic dog patrolling lower right; "},
        {"A flock of 30 sheep in the south and another of 15 in the west.",
         "30 sheep grazing lower; 15 sheep grazing middle left; "},
        {"Six robots, of which one flies and five drive along the road.",
         "1 aerial robot flying anywhere; 5 wheeled robot patrolling lower left; "},
        {"Five drones and nine rovers, all parked except two rovers that patrol the road.",
         "5 aerial robot idle anywhere; 7 wheeled robot idle anywhere; "
         "2 wheeled robot patrolling lower left; "},
        {"Only one of the four eagles is in the air.",
         "3 eagle idle anywhere; 1 eagle flying anywhere; "},
        {"Two out of five drones are charging.",
         "3 aerial robot flying anywhere; 2 aerial robot idle anywhere; "},
        {"Two knights stand in the forest; in the village there are four.",
         "2 ancient warrior idle lower right; 4 ancient warrior idle center; "},
        {"Two rovers inspect the road, another two the village.",
         "2 wheeled robot patrolling lower left; 2 wheeled robot patrolling center; "},
        {"Ten goblins in the lower part of the map on the left.",
         "10 goblin patrolling lower left; "},
        {"sheep: lower left, 7, asleep", "7 sheep idle lower left; "},
        {"As for animals, only 3 eagles over the village.", "3 eagle flying center; "},
        {"Ten goblins. Ten are too many. Two.", "2 goblin patrolling anywhere; "},
        {"100 agents, half sheep, half goblins.",
         "50 sheep grazing anywhere; 50 goblin patrolling anywhere; "},
    }));

}  // namespace
}  // namespace latticeworld
