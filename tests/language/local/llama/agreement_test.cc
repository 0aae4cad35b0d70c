// The decoder and the tokenizer beside real llama.cpp on the same files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "language/local/tiny_model.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"
#include "latticeworld/language/local/decoding/llama_model.h"
#include "latticeworld/language/local/tokens/chat_text.h"
#include "latticeworld/language/local/tokens/tokenizer.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

// What llama.cpp answers to each question about the model in a file.
std::vector<Json> Ask(const std::string& model, const std::vector<Json>& questions) {
  const std::string scratch =
      std::filesystem::temp_directory_path() / ("agreement-" + std::to_string(getpid()));
  const std::string asked = scratch + ".questions", said = scratch + ".answers";
  std::ofstream out(asked);
  for (const Json& question : questions) out << question.dump() << "\n";
  out.close();
  const std::string command = "cd '" LLAMA_DIRECTORY "' && ./node '" LLAMA_ANSWERS "' '" + model +
                              "' < '" + asked + "' > '" + said + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::vector<Json> answers;
  std::ifstream in(said);
  for (std::string line; std::getline(in, line);) answers.push_back(Json::parse(line));
  EXPECT_EQ(answers.size(), questions.size());
  answers.resize(questions.size());
  std::filesystem::remove(asked);
  std::filesystem::remove(said);
  return answers;
}

// Expects that what llama.cpp writes after the prompts is the likeliest here too. Activations that
// lie between two int8 go either way, so that there what is nearly as likely may change places.
void ExpectAgreement(const std::string& file, const std::vector<std::vector<TokenId>>& prompts,
                     int tokens, bool int8) {
  const auto opened = GgufFile::Open(file);
  ASSERT_TRUE(opened.ok()) << opened.status().ToString();
  const auto model = std::make_shared<const LlamaModel>(*ReadLlamaModel(*opened));
  const TokenId end = Tokenizer::Read(*opened)->end();
  std::vector<Json> questions;
  for (const auto& prompt : prompts) questions.push_back({{"tokens", prompt}, {"count", tokens}});
  const std::vector<Json> answers = Ask(file, questions);
  const Progress progress;
  int same = 0, all = 0;
  for (std::size_t i = 0; i < prompts.size(); ++i) {
    LlamaDecoder decoder(model);
    ASSERT_TRUE(decoder.Append(prompts[i], progress).ok());
    for (const TokenId theirs : answers[i].get<std::vector<TokenId>>()) {
      const auto& logits = decoder.logits();
      const auto ours = std::max_element(logits.begin(), logits.end());
      EXPECT_LT(*ours - logits[theirs], int8 ? 0.06f : 0.005f);
      same += ours - logits.begin() == static_cast<std::ptrdiff_t>(theirs) ? 1 : 0;
      ++all;
      if (theirs == end) break;
      ASSERT_TRUE(decoder.Append({theirs}, progress).ok());
    }
  }
  EXPECT_GT(all, static_cast<int>(prompts.size()) * 20);
  EXPECT_GE(same, int8 ? all * 97 / 100 : all);
}

class AgreementTest : public testing::TestWithParam<std::uint32_t> {};

TEST_P(AgreementTest, TheLikeliestTokensAreTheSame) {
  TinyModel tiny;
  tiny.weight_type = GetParam();
  tiny.layers = 3;
  tiny.width = 128;
  tiny.hidden = 256;
  tiny.seed = 11;
  const ModelFile file(TinyGguf(tiny));
  RandomStream random(3, "prompts");
  std::vector<std::vector<TokenId>> prompts(4);
  for (auto& prompt : prompts) {
    prompt = {1};
    const int size = random.UniformInt(1, 200);
    for (int k = 0; k < size; ++k) prompt.push_back(random.UniformInt(5, 370));
  }
  ExpectAgreement(file.path(), prompts, 48, GetParam() == 8);
}

INSTANTIATE_TEST_SUITE_P(Types, AgreementTest, testing::Values(0u, 1u, 8u));

void ExpectAgreementOfShipped(const std::string& name, const std::vector<std::string>& texts) {
  const std::string file = SHIPPED_MODELS "/" + name;
  const auto opened = GgufFile::Open(file);
  ASSERT_TRUE(opened.ok()) << opened.status().ToString();
  const Tokenizer tokenizer = *Tokenizer::Read(*opened);
  std::vector<std::vector<TokenId>> prompts;
  for (const std::string& words : texts) {
    std::vector<ChatMessage> messages = {{ChatRole::kUser, words, ""}};
    prompts.push_back(ChatTokens(tokenizer, ChatStyle::kChatMl, messages));
  }
  ExpectAgreement(file, prompts, 300, /*int8=*/true);
}

TEST(ShippedModelTest, WritesTheLayoutsThatLlamaCppWrites) {
  ExpectAgreementOfShipped("layouts.gguf",
                           {"A lake in the north.", "Mostly forest, with a village in the east."});
}

TEST(ShippedModelTest, WritesTheEnvironmentsThatLlamaCppWrites) {
  std::string begin =
      "The map, 32 by 32 squares of 16 m, line 1 in the north, first letter in the west:\n";
  for (int row = 0; row < 32; ++row) begin += std::string(32, row < 12 ? 'F' : 'G') + "\n";
  begin += "\nDescription of the environment:\n";
  ExpectAgreementOfShipped("environments.gguf",
                           {begin + "A foggy autumn morning. Five sheep graze in the upper left.",
                            begin + "Winter, night, snow. Three goblins attack in the center."});
}

TEST(TokenizerAgreementTest, TextsBecomeTheSameTokens) {
  const ModelFile file(TinyGguf(TinyModel()));
  const auto opened = GgufFile::Open(file.path());
  const auto tokenizer = Tokenizer::Read(*opened);
  const std::vector<std::string> words = {
      "the", "forest", " ",        "there", "WWW", "st",           "\n",   "or",    "fo",
      "er",  "\":",    "\xC3\xBC", "t",     "  ",  "\xE6\xB0\xB4", "</s>", "<0x41>"};
  RandomStream random(4, "texts");
  std::vector<Json> questions;
  std::vector<std::string> texts;
  for (int i = 0; i < 60; ++i) {
    std::string text;
    const int size = random.UniformInt(1, 12);
    for (int k = 0; k < size; ++k)
      text += words[random.UniformInt(0, static_cast<int>(words.size()) - 1)];
    texts.push_back(text);
    questions.push_back({{"text", text}});
  }
  const std::vector<Json> answers = Ask(file.path(), questions);
  for (std::size_t i = 0; i < texts.size(); ++i)
    EXPECT_EQ(tokenizer->Encode(texts[i]), answers[i].get<std::vector<TokenId>>()) << texts[i];
}

}  // namespace
}  // namespace latticeworld
