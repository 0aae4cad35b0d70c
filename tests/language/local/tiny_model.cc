#include "language/local/tiny_model.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "language/local/tiny_gguf.h"

namespace latticeworld {
namespace {

using namespace tiny;  // NOLINT: what files are made of

struct Token {
  std::string text;
  int type;
  float score;
};

std::vector<Token> Tokens() {
  constexpr int kNormal = 1, kUnknown = 2, kControl = 3, kByte = 6;
  std::vector<Token> tokens = {{"<unk>", kUnknown, 0},
                               {"<s>", kControl, 0},
                               {"</s>", kControl, 0},
                               {"<|im_start|>", kControl, 0},
                               {"<|im_end|>", kControl, 0}};
  for (int byte = 0; byte < 256; ++byte) {
    char name[8];
    std::snprintf(name, sizeof(name), "<0x%02X>", byte);
    tokens.push_back({name, kByte, 0});
  }
  tokens.push_back({"\xE2\x96\x81", kNormal, -1000});
  tokens.push_back({"\n", kNormal, -1000});
  for (char c = '!'; c <= '~'; ++c) tokens.push_back({std::string(1, c), kNormal, -1000});
  float score = 0;
  for (const char* piece : {"th", "the", "\xE2\x96\x81t", "\xE2\x96\x81the", "re", "er", "ere",
                            "WW", "WWWW", "\":", "\",\"", "st", "fore", "or", "est", "forest"})
    tokens.push_back({piece, kNormal, score -= 1});
  return tokens;
}

void WriteMetadata(const TinyModel& model, GgufWriter* writer) {
  writer->Entry("general.architecture", kString, Text("llama"));
  writer->Entry("general.name", kString, Text("tiny"));
  writer->Number("llama.context_length", model.context);
  writer->Number("llama.embedding_length", model.width);
  writer->Number("llama.block_count", model.layers);
  writer->Number("llama.feed_forward_length", model.hidden);
  writer->Number("llama.attention.head_count", model.heads);
  writer->Number("llama.attention.head_count_kv", model.kv_heads);
  writer->Entry("llama.attention.layer_norm_rms_epsilon", kFloat32, Raw(1e-5f));
  writer->Number("llama.rope.dimension_count", model.width / model.heads);
  if (model.guidance) writer->Entry("latticeworld.guidance", kFloat32, Raw(*model.guidance));
  if (model.sees) writer->Entry("latticeworld.sees", kBool, Raw(true));
  writer->Entry("tokenizer.ggml.model", kString, Text("llama"));
  std::string texts, scores, types;
  const std::vector<Token> tokens = Tokens();
  for (const Token& token : tokens) {
    texts += Text(token.text);
    scores += Raw(token.score);
    types += Raw(static_cast<std::int32_t>(token.type));
  }
  const auto count = Raw<std::uint64_t>(tokens.size());
  writer->Entry("tokenizer.ggml.tokens", kArray, Raw<std::uint32_t>(kString) + count + texts);
  writer->Entry("tokenizer.ggml.scores", kArray, Raw<std::uint32_t>(kFloat32) + count + scores);
  writer->Entry("tokenizer.ggml.token_type", kArray, Raw<std::uint32_t>(kInt32) + count + types);
  writer->Number("tokenizer.ggml.unknown_token_id", 0);
  writer->Number("tokenizer.ggml.bos_token_id", 1);
  writer->Number("tokenizer.ggml.eos_token_id", model.end_token);
  writer->Entry("tokenizer.ggml.add_space_prefix", kBool, Raw(model.adds_space));
  if (!model.chat_template.empty())
    writer->Entry("tokenizer.chat_template", kString, Text(model.chat_template));
}

void WriteTensors(const TinyModel& model, GgufWriter* writer) {
  const std::size_t tokens = Tokens().size(), width = model.width;
  const std::size_t kv_width = width / model.heads * model.kv_heads;
  writer->Weights("token_embd.weight", tokens, width, false);
  for (std::size_t i = 0; i < model.layers; ++i) {
    const std::string block = "blk." + std::to_string(i) + ".";
    writer->Weights(block + "attn_norm.weight", 1, width, true);
    writer->Weights(block + "attn_q.weight", width, width, false);
    writer->Weights(block + "attn_k.weight", kv_width, width, false);
    writer->Weights(block + "attn_v.weight", kv_width, width, false);
    writer->Weights(block + "attn_output.weight", width, width, false);
    writer->Weights(block + "ffn_norm.weight", 1, width, true);
    writer->Weights(block + "ffn_gate.weight", model.hidden, width, false);
    writer->Weights(block + "ffn_up.weight", model.hidden, width, false);
    writer->Weights(block + "ffn_down.weight", width, model.hidden, false);
  }
  writer->Weights("output_norm.weight", 1, width, true);
  if (!model.ties_output) writer->Weights("output.weight", tokens, width, false);
}

}  // namespace

std::string TinyGguf(const TinyModel& model) {
  GgufWriter writer(model.seed, model.weight_type, model.without, model.spoilt, model.spoilt_with);
  WriteMetadata(model, &writer);
  WriteTensors(model, &writer);
  return writer.File();
}

ModelFile::ModelFile(const std::string& content) {
  std::string name =
      (std::filesystem::temp_directory_path() / "latticeworld_model_XXXXXX").string();
  EXPECT_NE(mkdtemp(name.data()), nullptr);
  path_ = name + "/model.gguf";
  std::ofstream(path_, std::ios::binary) << content;
}

ModelFile::~ModelFile() {
  std::error_code ignored;
  std::filesystem::remove_all(std::filesystem::path(path_).parent_path(), ignored);
}

}  // namespace latticeworld
