#include "latticeworld/language/reading/text_warnings.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {
namespace {

std::vector<std::string> WarningsOf(const std::string& text, SentenceKind kind) {
  std::vector<std::string> warnings;
  WarnOfText(text, kind, &warnings);
  return warnings;
}

TEST(TextWarningsTest, MoreThanTheWholeIsSaidAsItWasWritten) {
  for (const std::string share : {"300 %", "101%", "120.5 percent"}) {
    const auto warnings = WarningsOf("Forest covers " + share + " of it.", SentenceKind::kLayout);
    ASSERT_EQ(warnings.size(), 1u) << share;
    EXPECT_EQ(warnings[0].find("\"" + share + "\" is more than the whole"), 0u) << warnings[0];
  }
  EXPECT_TRUE(WarningsOf("Forest covers 100 % of it.", SentenceKind::kLayout).empty());
  EXPECT_TRUE(WarningsOf("300 trees on 5 % of it.", SentenceKind::kLayout).empty());
  // Houses may well be of 150 % of their size.
  EXPECT_TRUE(WarningsOf("Scale the houses to 150 %.", SentenceKind::kEnvironment).empty());
}

TEST(TextWarningsTest, EveryReaderSaysThem) {
  for (auto make : {&MakeRuleReader, &MakeControlledReader}) {
    const std::unique_ptr<InstructionReader> reader = make();
    std::vector<ModelReply> replies;
    LayoutRequest request;
    request.instruction = "Forest covers 300 % of the map.";
    const auto reading = reader->ReadLayout(request, Progress(), &replies);
    ASSERT_TRUE(reading.ok());
    ASSERT_FALSE(reading->plan.warnings.empty()) << reader->name();
    EXPECT_NE(reading->plan.warnings[0].find("300 %"), std::string::npos) << reader->name();
  }
  std::vector<ModelReply> replies;
  LayoutRequest request;
  request.instruction = "Ein See im Norden, rundherum Wald.";
  const auto reading = MakeRuleReader()->ReadLayout(request, Progress(), &replies);
  ASSERT_TRUE(reading.ok());
  EXPECT_NE(reading->plan.warnings[0].find("English"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
