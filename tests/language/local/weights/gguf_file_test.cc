#include "latticeworld/language/local/weights/gguf_file.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "language/local/tiny_model.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/local/decoding/llama_model.h"
#include "latticeworld/language/local/local.h"

namespace latticeworld {
namespace {

TinyModel Smallest() {
  TinyModel model;
  model.layers = 1;
  model.width = 32;
  model.hidden = 32;
  return model;
}

Status OpenedAs(const std::string& content) {
  const ModelFile file(content);
  return MakeLocalChatServer(file.path()).status();
}

TEST(GgufFileTest, ReadsWhatWasWritten) {
  const ModelFile file(TinyGguf(Smallest()));
  const auto opened = GgufFile::Open(file.path());
  ASSERT_TRUE(opened.ok()) << opened.status().ToString();
  EXPECT_EQ(*opened->Text("general.architecture"), "llama");
  EXPECT_EQ(*opened->Integer("llama.embedding_length", 1, 100), 32u);
  EXPECT_NEAR(*opened->Number("llama.attention.layer_norm_rms_epsilon"), 1e-5, 1e-9);
  EXPECT_EQ(opened->tensors().size(), 12u);
  EXPECT_EQ(opened->Tensor("blk.0.ffn_norm.weight", 1, 32)->rows, 1u);
}

TEST(GgufFileTest, SaysWhatIsMissingOrOfAnotherShape) {
  const ModelFile file(TinyGguf(Smallest()));
  const auto opened = GgufFile::Open(file.path());
  ASSERT_TRUE(opened.ok());
  EXPECT_NE(opened->Tensor("none", 1, 1).status().message().find("'none' is missing"),
            std::string::npos);
  EXPECT_NE(opened->Tensor("output_norm.weight", 2, 32).status().message().find("1 x 32"),
            std::string::npos);
  EXPECT_EQ(opened->Integer("llama.block_count", 2, 9).status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(opened->Text("llama.block_count").status().code(), StatusCode::kDataLoss);
}

TEST(GgufFileTest, RefusesWhatIsNoModelFile) {
  EXPECT_EQ(GgufFile::Open("/nowhere/model.gguf").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(GgufFile::Open("/tmp").status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(GgufFile::Open("/dev/null").status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(OpenedAs("").code(), StatusCode::kDataLoss);
  EXPECT_EQ(OpenedAs("PK\3\4 something else").code(), StatusCode::kDataLoss);
  std::string newer = TinyGguf(Smallest());
  newer[4] = 9;
  EXPECT_NE(OpenedAs(newer).message().find("version 9"), std::string::npos);
}

TEST(GgufFileTest, RefusesAFileThatIsCutAnywhere) {
  const std::string whole = TinyGguf(Smallest());
  ASSERT_TRUE(OpenedAs(whole).ok()) << OpenedAs(whole).ToString();
  for (std::size_t size = 1; size < whole.size(); size += 1 + size / 40) {
    const Status status = OpenedAs(whole.substr(0, size));
    EXPECT_EQ(status.code(), StatusCode::kDataLoss) << size << ": " << status.ToString();
  }
}

TEST(GgufFileTest, ReadsOrRefusesAFileWithAnyBytesChanged) {
  const std::string whole = TinyGguf(Smallest());
  RandomStream random(3, "damage");
  // Where keys, sizes and offsets are: the weights behind them are any numbers.
  const int head = 16000;
  int refused = 0;
  for (int i = 0; i < 600; ++i) {
    std::string damaged = whole;
    const int changes = random.UniformInt(1, 4);
    for (int k = 0; k < changes; ++k)
      damaged[random.UniformInt(0, head)] = static_cast<char>(random.UniformInt(0, 255));
    const Status status = OpenedAs(damaged);
    refused += status.ok() ? 0 : 1;
    if (!status.ok()) EXPECT_EQ(status.code(), StatusCode::kDataLoss) << status.ToString();
  }
  EXPECT_GT(refused, 100);
}

// The pages of files that this process holds [kB].
int FilePages_kB() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("RssFile:", 0) == 0) return std::stoi(line.substr(8));
  }
  return -1;
}

TEST(LlamaModelTest, IsNotHeldTwiceAsItIsRead) {
  TinyModel large = Smallest();
  large.width = 512;
  large.hidden = 4096;
  const ModelFile file(TinyGguf(large));
  const auto opened = GgufFile::Open(file.path());
  ASSERT_TRUE(opened.ok());
  const int before_kB = FilePages_kB();
  ASSERT_GT(before_kB, 0);
  const auto model = ReadLlamaModel(*opened);
  ASSERT_TRUE(model.ok()) << model.status().ToString();
  // Three of its tensors have 8 MB each.
  EXPECT_LT(FilePages_kB() - before_kB, 4096);
  std::vector<float> row(512);
  const GgufTensor tensor = opened->Tensor("blk.0.ffn_gate.weight", 4096, 512).value();
  model->layers[0].gate.Row(7, row.data());
  EXPECT_EQ(std::memcmp(tensor.data + std::size_t{7} * 512 * 4, row.data(), 512 * 4), 0)
      << "the file is read again";
}

TEST(LlamaModelTest, NamesEachKeyAndTensorThatIsMissing) {
  for (const char* name :
       {"llama.embedding_length", "llama.block_count", "llama.attention.head_count",
        "tokenizer.ggml.tokens", "tokenizer.ggml.scores", "tokenizer.ggml.eos_token_id",
        "blk.0.attn_k.weight", "blk.0.ffn_norm.weight", "token_embd.weight"}) {
    TinyModel model = Smallest();
    model.without = {name};
    const Status status = OpenedAs(TinyGguf(model));
    EXPECT_EQ(status.code(), StatusCode::kDataLoss);
    EXPECT_NE(status.message().find(name), std::string::npos) << status.ToString();
  }
}

TEST(LlamaModelTest, RefusesSizesThatDoNotGoTogether) {
  TinyModel model = Smallest();
  model.heads = 4;
  model.kv_heads = 3;
  EXPECT_EQ(OpenedAs(TinyGguf(model)).code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
