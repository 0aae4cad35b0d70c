#include "latticeworld/language/remote/prompts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/fine_attributes.h"
#include "latticeworld/language/remote/forms.h"

namespace latticeworld {
namespace {

bool Has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

// Land that rises from west to east.
Relief Ramp(int rows, int cols) {
  Grid<float> height_m(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) height_m(row, col) = static_cast<float>(col);
  }
  return MakeRelief(std::move(height_m));
}

std::vector<ChatMessage> LayoutPrompt(const LayoutRequest& request, bool sees) {
  auto messages = LayoutMessages(request, sees);
  EXPECT_TRUE(messages.ok()) << messages.status().ToString();
  return *messages;
}

std::vector<ChatMessage> EnvironmentPrompt(const EnvironmentRequest& request, bool sees) {
  auto messages = EnvironmentMessages(request, sees);
  EXPECT_TRUE(messages.ok()) << messages.status().ToString();
  return *messages;
}

TEST(PromptsTest, LayoutPromptIsSystemThenUserAndLeavesNoPlaceholder) {
  const Relief relief = Ramp(40, 50);
  for (const auto vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    for (const Relief* v_l : {static_cast<const Relief*>(nullptr), &relief}) {
      for (const bool sees : {false, true}) {
        const auto messages = LayoutPrompt({"a lake in the north", vocabulary, v_l, 1}, sees);
        ASSERT_EQ(messages.size(), 2u);
        EXPECT_EQ(messages[0].role, ChatRole::kSystem);
        EXPECT_EQ(messages[1].role, ChatRole::kUser);
        for (const auto& message : messages) {
          EXPECT_FALSE(Has(message.text, "{{") || Has(message.text, "}}")) << message.text;
        }
      }
    }
  }
}

TEST(PromptsTest, LayoutPromptGivesEveryLetterOfItsVocabularyWithItsMeaningAndNoOther) {
  for (const auto vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    const auto messages = LayoutPrompt({"hills", vocabulary, nullptr, 1}, false);
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      const LayoutClass* entry = FindClass(vocabulary, letter);
      const std::string line = std::string("\n") + letter + " = ";
      EXPECT_EQ(Has(messages[0].text, line), entry != nullptr) << letter;
      if (entry == nullptr) continue;
      EXPECT_TRUE(Has(messages[0].text, line + std::string(entry->meaning)));
    }
    EXPECT_TRUE(Has(messages[1].text, LegalLetters(vocabulary)));
  }
}

TEST(PromptsTest, InstructionIsGivenAsItStands) {
  const std::string instruction = "A {{relief}} river — \"winding\"\n through \xE6\xA3\xAE";
  EXPECT_TRUE(
      Has(LayoutPrompt({instruction, Vocabulary::kWild, nullptr, 1}, false)[1].text, instruction));
}

TEST(PromptsTest, ReliefGoesAsCaptionToAllAndAsPictureToThoseThatSee) {
  const Relief relief = Ramp(40, 50);
  const auto blind = LayoutPrompt({"hills", Vocabulary::kWild, &relief, 1}, false);
  EXPECT_TRUE(Has(blind[1].text, relief.caption));
  EXPECT_FALSE(Has(blind[1].text, "picture"));
  EXPECT_TRUE(blind[1].image_png.empty());
  const auto seeing = LayoutPrompt({"hills", Vocabulary::kWild, &relief, 1}, true);
  EXPECT_TRUE(Has(seeing[1].text, relief.caption));
  EXPECT_TRUE(Has(seeing[1].text, "picture"));
  EXPECT_EQ(seeing[1].image_png.compare(0, 4, "\x89PNG"), 0);
  EXPECT_TRUE(seeing[0].image_png.empty());
  const auto flat = LayoutPrompt({"hills", Vocabulary::kWild, nullptr, 1}, true);
  EXPECT_FALSE(Has(flat[1].text, "eights of the land") || Has(flat[1].text, "picture"));
  EXPECT_TRUE(flat[1].image_png.empty());
}

TEST(PromptsTest, NothingSaidIsSaid) {
  const Relief relief = Ramp(40, 40);
  EXPECT_TRUE(
      Has(LayoutPrompt({"", Vocabulary::kWild, &relief, 1}, false)[1].text, "nothing is said"));
}

class EnvironmentPromptTest : public testing::Test {
 protected:
  SymbolicLayout layout_ = ParseLayout(LegalMatrix(), Vocabulary::kSuburb).value();
  EnvironmentRequest Request(std::string instruction, const Relief* relief = nullptr) {
    EnvironmentRequest request;
    request.instruction = std::move(instruction);
    request.relief = relief;
    request.layout = &layout_;
    request.size_m = 1024.0;
    return request;
  }
};

TEST_F(EnvironmentPromptTest, HasSchemaLayoutLettersReliefAndInstruction) {
  const Relief relief = Ramp(40, 40);
  const auto messages = EnvironmentPrompt(Request("Dusk, four horses.", &relief), true);
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_TRUE(Has(messages[0].text, EnvironmentForm().json_schema));
  EXPECT_TRUE(Has(messages[1].text, ToText(layout_)));
  for (const LayoutClass& entry : ClassesOf(Vocabulary::kSuburb)) {
    EXPECT_TRUE(Has(messages[1].text, std::string(1, entry.letter) + " = "));
  }
  EXPECT_TRUE(Has(messages[1].text, "squares of 32 m"));
  EXPECT_TRUE(Has(messages[1].text, relief.caption));
  EXPECT_TRUE(Has(messages[1].text, "Dusk, four horses."));
  EXPECT_EQ(messages[1].image_png.compare(0, 4, "\x89PNG"), 0);
  for (const auto& message : messages) EXPECT_FALSE(Has(message.text, "{{"));
}

TEST_F(EnvironmentPromptTest, TellsTheRulesThatNoSchemaCanSay) {
  const std::string text = EnvironmentPrompt(Request(""), false)[0].text;
  EXPECT_TRUE(Has(text, "  lake: open (any season), frozen (winter)\n"));
  EXPECT_TRUE(Has(text, "snow-covered (winter or weather snow)"));
  EXPECT_TRUE(Has(text, "  winter: grass density 0.9 at most, flower density 0.7 at most"));
  EXPECT_TRUE(Has(text, "  summer: no snow_mountain of powder"));
  EXPECT_TRUE(Has(text, "  sandstorm: desert wind 8 at least\n"));
  EXPECT_TRUE(Has(text, "  rain: no desert of dry storm\n"));
  EXPECT_TRUE(Has(text, "  sheep: idle, grazing\n"));
  for (const auto& type : EnumNames(AssetType{})) {
    for (const auto& variant : ValuesOf(type.value).season_variants) {
      EXPECT_TRUE(Has(text, std::string(variant) + " (")) << variant;
    }
  }
}

TEST(PromptsTest, RepairSaysEveryViolationUpToAHundred) {
  std::vector<Violation> violations;
  for (int i = 0; i < 130; ++i) {
    violations.push_back({"x", "row " + std::to_string(i), "is wrong", ""});
  }
  const std::string text = LayoutRepairText(violations, Vocabulary::kWild);
  EXPECT_TRUE(Has(text, "- row 0: is wrong\n"));
  EXPECT_TRUE(Has(text, "- row 99: is wrong\n"));
  EXPECT_FALSE(Has(text, "- row 100:"));
  EXPECT_TRUE(Has(text, "- and 30 further"));
  EXPECT_TRUE(Has(text, "B, F, R, S, W"));
  EXPECT_TRUE(Has(EnvironmentRepairText({{"x", "", "is cut", ""}}), "- is cut\n"));
}

TEST(PromptsTest, EveryPromptStaysSmallEnoughForASmallModel) {
  const SymbolicLayout layout = ParseLayout(LegalMatrix(), Vocabulary::kSuburb).value();
  EnvironmentRequest request;
  request.layout = &layout;
  std::size_t bytes = 0;
  for (const auto& message : EnvironmentPrompt(request, false)) bytes += message.text.size();
  // About 4 bytes a token: with its answer it fits into a context of 8192.
  EXPECT_LT(bytes, 16000u);
}

}  // namespace
}  // namespace latticeworld
