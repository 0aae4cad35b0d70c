#include "latticeworld/dataset/writing/data_card.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace latticeworld {
namespace {

DatasetFacts SomeFacts() {
  DatasetFacts facts;
  facts.version = "1.2.3";
  facts.annotator = "written";
  facts.command = "latticeworld dataset --scenes DIR --out DIR";
  facts.source = {"scenes", "Scenes of the fells", "CC-BY-4.0", "A survey, 2024"};
  facts.groups = 12;
  facts.tallies = {{"groups/train", 10},
                   {"groups/test", 1},
                   {"instances/train", 40},
                   {"instances/test", 4},
                   {"relief", 44},
                   {"records/layout/train", 40},
                   {"records/layout/test", 4},
                   {"bytes/layout", 44 * 130},
                   {"length/layout/0100", 44},
                   {"vocabulary/wild", 44},
                   {"cells/wild/F", 44 * 1024 / 4},
                   {"cells/wild/W", 44 * 1024 * 3 / 4},
                   {"season/winter", 11},
                   {"season/summer", 33}};
  for (const DatasetSplit split : {DatasetSplit::kTrain, DatasetSplit::kTest}) {
    const std::string name(NameOf(split));
    facts.files.push_back({DatasetTask::kLayout, split, "layout/" + name + ".jsonl",
                           facts.tallies["records/layout/" + name], 1000, std::string(64, 'a')});
  }
  facts.failed = {{"fell", "", "DATA_LOSS: fell/segmentation.png is cut off"}};
  return facts;
}

void ExpectHas(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in:\n" << text;
}

TEST(DataCardTest, SaysWhatThereIsOfWhatAndHowItIsUsed) {
  ExpectHas(
      DataCard(SomeFacts()),
      {"license: \"cc-by-4.0\"", "- config_name: layout\n  data_files:\n  - split: train\n",
       "    path: layout/test.jsonl\n", "- n<1K", "44 places", "11 of 12 groups",
       "| layout | 44 | 130 | less than 200 |", "| F | forest | 25 % |", "| W | water | 75 % |",
       "| winter | 11 | 25 % |", "CC-BY-4.0. Cite: A survey, 2024", "1 group or instance could",
       "- fell: \"DATA_LOSS", "    latticeworld dataset --scenes DIR --out DIR\n"});
}

TEST(DataCardTest, NamesOfFilesAndLegendsStayWords) {
  DatasetFacts facts = SomeFacts();
  facts.annotator = "model`\n# Heading";
  facts.source.title = "Scenes\n---\n<script>alert(1)</script>";
  facts.source.licence = "CC-BY\nlicense: mit\n\"#";
  facts.source.citation = "[click](http://example.com) | **bold** &amp;";
  facts.failed = {{"<img src=x>", "", "DATA_LOSS: a\nb|c\xff"}};
  const std::string card = DataCard(facts);
  for (const char* never : {"\n# Heading", "<script", "\nlicense: mit", "[click]", "<img",
                            " **bold", " &amp;", "b|c"}) {
    std::size_t at = card.find(never);
    EXPECT_TRUE(at == std::string::npos || card[at - 1] == '\\') << never << "\n" << card;
  }
  EXPECT_EQ(card.find("\n---\n"), card.rfind("\n---\n")) << "the front matter ends once";
  EXPECT_FALSE(nlohmann::json::parse(ManifestJson(facts), nullptr, false).is_discarded());
}

}  // namespace
}  // namespace latticeworld
