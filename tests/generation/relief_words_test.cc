#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/generation/fidelity/fidelity.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/reading/relief/relief_reading.h"

namespace latticeworld {
namespace {

// What the words make: their layout, the land, and the claims of its form.
struct Made {
  std::vector<std::string> kinds;  // of the claims of relief, in order
  std::string misses;              // explanations of those that do not hold
  std::string not_understood;
};

Made MadeOf(const std::string& text, Vocabulary vocabulary, InstructionReader* reader) {
  LayoutRequest request;
  request.instruction = text;
  request.vocabulary = vocabulary;
  request.seed = 3;
  std::vector<ModelReply> replies;
  LayoutReading reading = reader->ReadLayout(request, Progress(), &replies).value();
  ReadRelief(text, &reading);
  request.reading = &reading;
  const SymbolicLayout layout =
      MakeGroundedLayoutGenerator()->Generate(request, Progress(), &replies)->layout;
  TerrainRequest land;
  land.geometry = GridGeometry::FromCells(256, 256.0);
  land.layout = &layout;
  land.reliefs = reading.plan.reliefs;
  land.covers = reading.plan.covers;
  land.seed = 3;
  FidelityReport report;
  AssessReliefFidelity(reading, layout, BuildTerrain(land, Progress()).value(), &report);
  Made made;
  for (const ClaimOutcome& claim : report.claims) {
    made.kinds.push_back(claim.kind);
    if (!claim.satisfied) made.misses += claim.words + ": " + claim.explanation + "\n";
  }
  for (const std::string& words : reading.plan.not_understood) made.not_understood += words + "; ";
  return made;
}

// A word of relief, in the small language and as people say it, and what is measured of it.
struct Word {
  const char* sentences;
  const char* text;
  std::vector<std::string> kinds;
  Vocabulary vocabulary = Vocabulary::kSuburb;
};

const std::vector<Word>& Words() {
  static const std::vector<Word> words = {
      // Forms
      {"A mountain in the north. A lake in the south.",
       "Mountains in the north, a lake in the south.",
       {"relief_form"},
       Vocabulary::kWild},
      {"A peak in the center. The peak is 35 m high.",
       "A peak 35 m high in the center.",
       {"relief_form", "relief_height"}},
      {"A hill in the north. The hill is 20 m high.",
       "There is a hill in the north that is 20 m high.",
       {"relief_form", "relief_height"}},
      {"A ridge from the west to the east. The ridge is 20 m high.",
       "A ridge 20 m high runs from the west to the east.",
       {"relief_form", "relief_height"}},
      {"A saddle in the center.", "There is a saddle in the center.", {"relief_form"}},
      {"A valley from the west to the east. The valley is 15 m deep.",
       "A valley 15 m deep runs from the west to the east.",
       {"relief_form", "relief_depth"}},
      {"A gorge from the north to the south. The gorge is 15 m deep.",
       "A gorge with a depth of 15 m runs from the north to the south.",
       {"relief_form", "relief_depth"}},
      {"A canyon in the east.", "A canyon in the east.", {"relief_form"}},
      {"A cliff in the north. The cliff is 12 m high.",
       "Cliffs 12 m high in the north.",
       {"relief_form", "relief_height"}},
      {"A plateau in the west. The plateau is 15 m high.",
       "A plateau in the west rises 15 m.",
       {"relief_form", "relief_height"}},
      {"A mesa in the west. The mesa is 15 m high.",
       "A mesa 15 m high in the west.",
       {"relief_form", "relief_height"}},
      {"A basin in the center. The basin is 8 m deep.",
       "A basin 8 m deep in the center.",
       {"relief_form", "relief_depth"}},
      {"A crater in the center. The crater is 8 m deep.",
       "An 8 m deep crater in the center.",
       {"relief_form", "relief_depth"}},
      {"Terraces in the north.", "Terraces in the north.", {"relief_form"}},
      {"A moraine in the north.", "A moraine in the north.", {"relief_form"}},
      {"Dunes in the north.", "Sand dunes in the north.", {"relief_form"}},
      {"A slope. The slope of the slope is 5 degrees.", "A slope of 5 degrees.", {"relief_slope"}},
      // Land as a whole
      {"The land is flat.", "The land is flat.", {"relief_form"}},
      {"The land is gentle.", "Gentle land.", {"relief_form"}},
      {"The land is rolling.", "Rolling country.", {"relief_form"}},
      {"The land is hilly.", "Hilly terrain.", {"relief_form"}},
      {"The land is mountainous.", "The terrain is predominantly mountainous.", {"relief_form"}},
      {"The land is rugged in the west.", "Rugged land in the west.", {"relief_form"}},
      {"The land is steep.", "The land is steep.", {"relief_form"}},
      {"The land rises by 30 m to north.", "The land rises by 30 m to the north.", {"relief_rise"}},
      // Slopes, widths, lengths, numbers, sizes
      {"A hill. The hill is 20 m high. The slope of the hill is 15 degrees.",
       "A hill 20 m high with a slope of 15 degrees.",
       {"relief_form", "relief_height", "relief_slope"}},
      {"A ridge in the center. The ridge is 120 m long.",
       "A ridge 120 m long in the center.",
       {"relief_form", "relief_length"}},
      {"A canyon in the east. The canyon is 40 m wide.",
       "A canyon 40 m wide in the east.",
       {"relief_form", "relief_width"}},
      {"A valley. The valley is 60 m wide.",
       "A valley with a width of 60 m.",
       {"relief_form", "relief_width"}},
      {"3 small hills in the west.", "Three small hills in the west.", {"relief_form"}},
      // Relations
      {"A lake in the center. A hill is north of the lake.",
       "A lake in the center. A hill north of the lake.",
       {"relief_form", "relief_direction"}},
      {"A village in the west. A hill is near the village.",
       "A village in the west and a hill near the village.",
       {"relief_form", "relief_near"}},
      {"A hill A in the south. A crater is north of hill A.",
       "A hill A in the south. A crater north of hill A.",
       {"relief_form", "relief_form", "relief_direction"}},
      {"A village in the center. A valley. The village is inside the valley.",
       "The village lies in the valley.",
       {"relief_form", "relief_place"}},
      {"A road runs along the southern edge. A hill in the center. The road climbs the hill.",
       "A road along the southern edge. A hill in the center. The road climbs to the hill.",
       {"relief_form", "relief_road"}},
      {"A road runs along the southern edge. A saddle in the center. The road climbs the saddle.",
       "A road along the southern edge. A pass in the center. The road climbs to the pass.",
       {"relief_form", "relief_road"}},
      {"A road runs along the southern edge. A hill in the center. A path of 15 degrees climbs the "
       "hill.",
       "A road along the southern edge. A hill in the center with a path of 15 degrees to its top.",
       {"relief_form", "relief_road", "relief_road_slope"}},
      {"A road runs along the southern edge. A saddle in the center. A road of 8 degrees climbs "
       "the "
       "saddle.",
       "A road along the southern edge. A pass in the center. A road of 8 degrees climbs to the "
       "pass.",
       {"relief_form", "relief_road", "relief_road_slope"}},
      {"A gorge from the north to the south. A bridge is over the gorge.",
       "A gorge from the north to the south. A bridge over the gorge.",
       {"relief_form", "relief_bridge"}},
      {"A gorge. A bridge is over the gorge.",
       "A bridge over the gorge.",
       {"relief_form", "relief_bridge"},
       Vocabulary::kWild},
      {"A road runs along the southern edge. A hill in the north. The hill is steep. A gorge from "
       "the west to the east. A path of 15 degrees climbs the hill. A bridge is over the gorge.",
       "A steep hill with a path of 15 degrees to its top and a bridge over the gorge.",
       {"relief_form", "relief_road", "relief_road_slope", "relief_form", "relief_bridge"}},
      {"2 hills. A saddle is between the hills.",
       "A pass between two hills.",
       {"relief_form", "relief_form"}},
      {"A mountain. Snow above 30 m.",
       "A mountain with snow above 30 m.",
       {"relief_form", "relief_cover"},
       Vocabulary::kWild},
  };
  return words;
}

TEST(ReliefWordsTest, EveryWordOfTheSmallLanguageHoldsWhatItClaims) {
  for (const Word& word : Words()) {
    const Made made = MadeOf(word.sentences, word.vocabulary, MakeControlledReader().get());
    EXPECT_EQ(made.misses, "") << word.sentences;
    EXPECT_EQ(made.kinds, word.kinds) << word.sentences;
    EXPECT_EQ(made.not_understood, "") << word.sentences;
  }
}

TEST(ReliefWordsTest, EveryWordInPlainEnglishHoldsWhatItClaims) {
  for (const Word& word : Words()) {
    const Made made = MadeOf(word.text, word.vocabulary, MakeRuleReader().get());
    EXPECT_EQ(made.misses, "") << word.text;
    EXPECT_EQ(made.kinds, word.kinds) << word.text;
  }
}

}  // namespace
}  // namespace latticeworld
