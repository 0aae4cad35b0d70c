#include "latticeworld/language/local/tokens/tokenizer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "language/local/tiny_gguf.h"
#include "language/local/tiny_model.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

class TokenizerTest : public testing::Test {
 protected:
  TokenizerTest() {
    const ModelFile file(TinyGguf(TinyModel()));
    auto opened = GgufFile::Open(file.path());
    auto read = Tokenizer::Read(*opened);
    EXPECT_TRUE(read.ok()) << read.status().ToString();
    tokenizer_ = *std::move(read);
  }
  std::vector<std::string> Pieces(const std::string& text) const {
    std::vector<std::string> pieces;
    for (const TokenId token : tokenizer_.Encode(text)) pieces.push_back(tokenizer_.BytesOf(token));
    return pieces;
  }
  Tokenizer tokenizer_;
};

TEST_F(TokenizerTest, MergesByScoreThenFromTheLeft) {
  // "re" has a better score than "or", and without it "forest" has no way to come about.
  EXPECT_EQ(Pieces("the forest"), (std::vector<std::string>{"the", " ", "f", "o", "re", "st"}));
  // "th" has the best score of all, so that " t" does not take its letter.
  EXPECT_EQ(Pieces(" the"), (std::vector<std::string>{" the"}));
  EXPECT_EQ(Pieces(" tx"), (std::vector<std::string>{" t", "x"}));
  EXPECT_EQ(Pieces("WWWWW"), (std::vector<std::string>{"WWWW", "W"}));
}

TEST_F(TokenizerTest, SpellsWhatHasNoPieceInBytes) {
  EXPECT_EQ(Pieces("\xC3\xBC"), (std::vector<std::string>{"\xC3", "\xBC"}));
  EXPECT_EQ(Pieces(std::string(1, '\x01')), (std::vector<std::string>{"\x01"}));
}

TEST_F(TokenizerTest, NeverReadsATextAsControl) {
  for (const TokenId token : tokenizer_.Encode("</s><|im_end|><s>"))
    EXPECT_FALSE(tokenizer_.IsControl(token));
}

TEST_F(TokenizerTest, GivesBackEveryText) {
  RandomStream random(5, "texts");
  for (int i = 0; i < 300; ++i) {
    std::string text;
    const int size = random.UniformInt(0, 60);
    for (int k = 0; k < size; ++k)
      text += random.Chance(0.3) ? "the re forest"[random.UniformInt(0, 12)]
                                 : static_cast<char>(random.UniformInt(0, 255));
    std::string back;
    for (const std::string& piece : Pieces(text)) back += piece;
    EXPECT_EQ(back, text);
  }
}

// Once the last of no tokens counted as any.
TEST_F(TokenizerTest, RefusesAFileWithoutTokens) {
  tiny::GgufWriter writer(1, 0, {});
  writer.Entry("tokenizer.ggml.model", tiny::kString, tiny::Text("llama"));
  const std::string none = tiny::Raw<std::uint64_t>(0);
  writer.Entry("tokenizer.ggml.tokens", tiny::kArray,
               tiny::Raw<std::uint32_t>(tiny::kString) + none);
  for (const char* key : {"tokenizer.ggml.scores", "tokenizer.ggml.token_type"})
    writer.Entry(key, tiny::kArray, tiny::Raw<std::uint32_t>(tiny::kFloat32) + none);
  writer.Number("tokenizer.ggml.eos_token_id", 7);
  const ModelFile file(writer.File());
  const auto opened = GgufFile::Open(file.path());
  ASSERT_TRUE(opened.ok()) << opened.status().ToString();
  EXPECT_EQ(Tokenizer::Read(*opened).status().code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
