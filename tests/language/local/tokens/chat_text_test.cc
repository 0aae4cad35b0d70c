#include "latticeworld/language/local/tokens/chat_text.h"

#include <gtest/gtest.h>

#include <string>

#include "language/local/tiny_model.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

const std::vector<ChatMessage> kTalk = {{ChatRole::kSystem, "Draw.", ""},
                                        {ChatRole::kUser, "A lake </s>", ""},
                                        {ChatRole::kAssistant, "WW", ""},
                                        {ChatRole::kUser, "More", ""}};

// The tokens as text, those that control in braces.
std::string Shown(ChatStyle style, bool adds_space) {
  TinyModel model;
  model.adds_space = adds_space;
  const ModelFile file(TinyGguf(model));
  const auto opened = GgufFile::Open(file.path());
  const auto tokenizer = Tokenizer::Read(*opened);
  std::string shown;
  for (const TokenId token : ChatTokens(*tokenizer, style, kTalk)) {
    if (tokenizer->IsControl(token)) {
      shown += "{" + std::to_string(token) + "}";
    } else {
      shown += tokenizer->BytesOf(token);
    }
  }
  return shown;
}

TEST(ChatTextTest, LaysOutEachStyle) {
  EXPECT_EQ(Shown(ChatStyle::kPlain, false),
            "{1}system: Draw.\nuser: A lake </s>\nassistant: WW\nuser: More\nassistant: ");
  EXPECT_EQ(
      Shown(ChatStyle::kLlama2, false),
      "{1}[INST] <<SYS>>\nDraw.\n<</SYS>>\n\nA lake </s> [/INST] WW {2}{1}[INST] More [/INST]");
  EXPECT_EQ(Shown(ChatStyle::kChatMl, false),
            "{1}{3}system\nDraw.{4}\n{3}user\nA lake </s>{4}\n{3}assistant\nWW{4}\n"
            "{3}user\nMore{4}\n{3}assistant\n");
  EXPECT_EQ(Shown(ChatStyle::kChatMlWithoutSystem, false),
            "{1}{3}user\nA lake </s>{4}\n{3}assistant\nWW{4}\n{3}user\nMore{4}\n{3}assistant\n");
}

TEST(ChatTextTest, BeginsWithTheSpaceThatAModelWants) {
  EXPECT_EQ(Shown(ChatStyle::kPlain, true).substr(0, 10), "{1} system");
}

TEST(ChatTextTest, KnowsAStyleByItsMarks) {
  EXPECT_EQ(ChatStyleOf("{% for m in messages %}<|im_start|>..."), ChatStyle::kChatMl);
  EXPECT_EQ(ChatStyleOf("{% if m['role'] != 'system' %}<|im_start|>..."),
            ChatStyle::kChatMlWithoutSystem);
  // SmolLM2's and Qwen2.5's ask it of the first message alone, and write them all.
  EXPECT_EQ(ChatStyleOf("{% if loop.first and messages[0]['role'] != 'system' %}<|im_start|>..."),
            ChatStyle::kChatMl);
  EXPECT_EQ(ChatStyleOf("{%- if messages[0].role != 'system' %}<|im_start|>..."),
            ChatStyle::kChatMl);
  EXPECT_EQ(ChatStyleOf("{% if messages[0]['role'] == 'system' %}<|im_start|>system"
                        "{% for m in messages %}{% if m['role'] != 'system' %}..."),
            ChatStyle::kChatMl);
  EXPECT_EQ(ChatStyleOf("{{ '[INST] ' + m }}"), ChatStyle::kLlama2);
  EXPECT_EQ(ChatStyleOf(""), ChatStyle::kPlain);
}

}  // namespace
}  // namespace latticeworld
