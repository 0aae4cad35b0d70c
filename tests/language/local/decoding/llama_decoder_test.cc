#include "latticeworld/language/local/decoding/llama_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "language/local/chosen_instructions.h"
#include "language/local/tiny_model.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/work_crew.h"
#include "latticeworld/language/local/decoding/llama_math.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

std::shared_ptr<const LlamaModel> Model(const TinyModel& tiny) {
  const ModelFile file(TinyGguf(tiny));
  const auto opened = GgufFile::Open(file.path());
  auto model = ReadLlamaModel(*opened);
  EXPECT_TRUE(model.ok()) << model.status().ToString();
  return std::make_shared<const LlamaModel>(*std::move(model));
}

std::vector<TokenId> Tokens(int count) {
  RandomStream random(2, "tokens");
  std::vector<TokenId> tokens;
  for (int i = 0; i < count; ++i) tokens.push_back(random.UniformInt(3, 360));
  return tokens;
}

class LlamaDecoderTest : public testing::TestWithParam<std::uint32_t> {
 protected:
  LlamaDecoderTest() {
    TinyModel tiny;
    tiny.weight_type = GetParam();
    model_ = Model(tiny);
  }
  std::shared_ptr<const LlamaModel> model_;
  const Progress progress_;
};

TEST_P(LlamaDecoderTest, GivesTheSameBitsHoweverATextIsSplit) {
  const std::vector<TokenId> tokens = Tokens(150);
  LlamaDecoder together(model_), one_by_one(model_);
  ASSERT_TRUE(together.Append(tokens, progress_).ok());
  for (const TokenId token : tokens) ASSERT_TRUE(one_by_one.Append({token}, progress_).ok());
  EXPECT_EQ(together.length(), 150u);
  EXPECT_EQ(together.logits(), one_by_one.logits());
}

TEST_P(LlamaDecoderTest, GivesTheSameBitsWhoeverComputes) {
  // Wide enough that a crew shares matrices and heads.
  TinyModel wide;
  wide.weight_type = GetParam();
  wide.width = 256;
  wide.hidden = 512;
  wide.heads = wide.kv_heads = 8;
  const auto model = Model(wide);
  const auto crew = std::make_shared<WorkCrew>(3);
  LlamaDecoder alone(model), shared(model, crew);
  const std::vector<TokenId> tokens = Tokens(100);
  ASSERT_TRUE(alone.Append(tokens, progress_).ok());
  ASSERT_TRUE(shared.Append(tokens, progress_).ok());
  EXPECT_EQ(shared.logits(), alone.logits());
  for (const TokenId token : Tokens(30)) {
    ASSERT_TRUE(alone.Append({token}, progress_).ok());
    ASSERT_TRUE(shared.Append({token}, progress_).ok());
    ASSERT_EQ(shared.logits(), alone.logits());
  }
}

TEST_P(LlamaDecoderTest, GivesTheSameBitsWithAllInstructionsOfThisProcessor) {
  // Heads, matrices and gates of no whole number of lanes have ends of their own.
  TinyModel odd;
  odd.weight_type = GetParam();
  odd.width = 96;
  odd.heads = odd.kv_heads = 4;
  const auto model = Model(odd);
  const auto logits_with = [&](Instructions instructions) {
    const ChosenInstructions chosen(instructions);
    LlamaDecoder decoder(model);
    EXPECT_TRUE(decoder.Append(Tokens(77), progress_).ok());
    std::vector<float> logits = decoder.logits();
    EXPECT_TRUE(decoder.Append({20}, progress_).ok());
    logits.insert(logits.end(), decoder.logits().begin(), decoder.logits().end());
    return logits;
  };
  const std::vector<float> plain = logits_with(Instructions::kPlain);
  for (const Instructions instructions : kAllInstructions) {
    if (HasInstructions(instructions)) {
      EXPECT_EQ(logits_with(instructions), plain) << static_cast<int>(instructions);
    }
  }
}

TEST_P(LlamaDecoderTest, ForgetsWhatIsCutOff) {
  const std::vector<TokenId> tokens = Tokens(60);
  LlamaDecoder fresh(model_), used(model_);
  ASSERT_TRUE(fresh.Append(tokens, progress_).ok());
  ASSERT_TRUE(used.Append({tokens.begin(), tokens.begin() + 40}, progress_).ok());
  ASSERT_TRUE(used.Append(Tokens(30), progress_).ok());
  used.Truncate(40);
  ASSERT_TRUE(used.Append({tokens.begin() + 40, tokens.end()}, progress_).ok());
  EXPECT_EQ(used.logits(), fresh.logits());
}

TEST_P(LlamaDecoderTest, TakesEmbeddingsWhereTokensCouldStand) {
  const std::vector<TokenId> tokens = Tokens(20);
  LlamaDecoder by_token(model_), by_embedding(model_);
  std::vector<float> embeddings(tokens.size() * model_->sizes.width);
  for (std::size_t i = 0; i < tokens.size(); ++i)
    model_->embeddings.Row(tokens[i], embeddings.data() + i * model_->sizes.width);
  ASSERT_TRUE(by_token.Append(tokens, progress_).ok());
  ASSERT_TRUE(by_embedding.AppendEmbeddings(embeddings.data(), tokens.size(), progress_).ok());
  EXPECT_EQ(by_embedding.logits(), by_token.logits());
}

TEST_P(LlamaDecoderTest, HearsTheOrderOfTokens) {
  LlamaDecoder forth(model_), back(model_);
  ASSERT_TRUE(forth.Append({10, 20, 30}, progress_).ok());
  ASSERT_TRUE(back.Append({20, 10, 30}, progress_).ok());
  EXPECT_NE(forth.logits(), back.logits());
}

INSTANTIATE_TEST_SUITE_P(Types, LlamaDecoderTest, testing::Values(0u, 1u, 8u));

TEST(LlamaDecoderLimitsTest, RefusesWhatDoesNotFitAndStaysAsItWas) {
  TinyModel tiny;
  tiny.context = 10;
  LlamaDecoder decoder(Model(tiny));
  const Progress progress;
  ASSERT_TRUE(decoder.Append(Tokens(8), progress).ok());
  EXPECT_EQ(decoder.Append(Tokens(3), progress).code(), StatusCode::kResourceExhausted);
  EXPECT_EQ(decoder.Append({100000}, progress).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(decoder.length(), 8u);
  EXPECT_TRUE(decoder.Append(Tokens(2), progress).ok());
}

TEST(LlamaDecoderLimitsTest, StopsWhenCancelled) {
  LlamaDecoder decoder(Model(TinyModel()));
  Progress progress;
  progress.Cancel();
  EXPECT_EQ(decoder.Append(Tokens(5), progress).code(), StatusCode::kCancelled);
  EXPECT_EQ(decoder.length(), 0u);
}

TEST(LlamaMathTest, ExponentialsAreThoseOfTheLibrary) {
  std::vector<float> values;
  for (float x = -86.0f; x < 20.0f; x += 0.0137f) values.push_back(x);
  for (const Instructions instructions : kAllInstructions) {
    if (!HasInstructions(instructions)) continue;
    const ChosenInstructions chosen(instructions);
    std::vector<float> powers = values;
    Exponentials(powers.data(), powers.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(powers[i] / std::exp(double{values[i]}), 1.0, 3e-7) << values[i];
    float far = -1000.0f;
    Exponentials(&far, 1);
    EXPECT_EQ(far, 0.0f);
  }
}

}  // namespace
}  // namespace latticeworld
