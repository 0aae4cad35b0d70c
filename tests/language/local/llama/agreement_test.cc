// The decoder and the tokenizer beside real llama.cpp on the same files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "language/local/tiny_model.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/local/gguf_file.h"
#include "latticeworld/language/local/llama_decoder.h"
#include "latticeworld/language/local/llama_model.h"
#include "latticeworld/language/local/tokenizer.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

// What llama.cpp answers to each question about the model.
std::vector<Json> Ask(const ModelFile& model, const std::vector<Json>& questions) {
  const std::string asked = model.path() + ".questions", said = model.path() + ".answers";
  std::ofstream out(asked);
  for (const Json& question : questions) out << question.dump() << "\n";
  out.close();
  const std::string command = "cd '" LLAMA_DIRECTORY "' && ./node '" LLAMA_ANSWERS "' '" +
                              model.path() + "' < '" + asked + "' > '" + said + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::vector<Json> answers;
  std::ifstream in(said);
  for (std::string line; std::getline(in, line);) answers.push_back(Json::parse(line));
  EXPECT_EQ(answers.size(), questions.size());
  answers.resize(questions.size());
  return answers;
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
  const auto opened = GgufFile::Open(file.path());
  const auto model = std::make_shared<const LlamaModel>(*ReadLlamaModel(*opened));

  constexpr int kPrompts = 4, kTokens = 48;
  RandomStream random(3, "prompts");
  std::vector<Json> questions;
  std::vector<std::vector<TokenId>> prompts(kPrompts);
  for (auto& prompt : prompts) {
    prompt = {1};
    const int size = random.UniformInt(1, 200);
    for (int i = 0; i < size; ++i) prompt.push_back(random.UniformInt(5, 370));
    questions.push_back({{"tokens", prompt}, {"count", kTokens}});
  }
  const std::vector<Json> answers = Ask(file, questions);
  const Progress progress;
  int same = 0, all = 0;
  for (int i = 0; i < kPrompts; ++i) {
    LlamaDecoder decoder(model);
    ASSERT_TRUE(decoder.Append(prompts[i], progress).ok());
    for (const TokenId theirs : answers[i].get<std::vector<TokenId>>()) {
      const auto& logits = decoder.logits();
      const auto ours = std::max_element(logits.begin(), logits.end());
      EXPECT_LT(*ours - logits[theirs], GetParam() == 8 ? 0.06f : 0.005f);
      same += ours - logits.begin() == static_cast<std::ptrdiff_t>(theirs) ? 1 : 0;
      ++all;
      if (theirs == 2) break;
      ASSERT_TRUE(decoder.Append({theirs}, progress).ok());
    }
  }
  EXPECT_GT(all, kPrompts * 20);
  // Activations that lie between two int8 go either way, so that there what is nearly as likely may
  // change places.
  EXPECT_GE(same, GetParam() == 8 ? all * 97 / 100 : all);
}

INSTANTIATE_TEST_SUITE_P(Types, AgreementTest, testing::Values(0u, 1u, 8u));

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
  const std::vector<Json> answers = Ask(file, questions);
  for (std::size_t i = 0; i < texts.size(); ++i)
    EXPECT_EQ(tokenizer->Encode(texts[i]), answers[i].get<std::vector<TokenId>>()) << texts[i];
}

}  // namespace
}  // namespace latticeworld
