#include "language/local/tiny_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr std::size_t kAlignment = 32;
enum Kind : std::uint32_t {
  kUint32 = 4,
  kInt32 = 5,
  kFloat32 = 6,
  kBool = 7,
  kString = 8,
  kArray = 9
};

template <typename T>
std::string Raw(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

std::string Text(const std::string& text) { return Raw<std::uint64_t>(text.size()) + text; }

std::uint16_t Half(float value) {
  // Of numbers that are normal as float16, cut.
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  const auto exponent = static_cast<int>((bits >> 23) & 0xFF) - 112;
  if (exponent <= 0) return 0;
  return static_cast<std::uint16_t>(((bits >> 16) & 0x8000u) |
                                    (static_cast<std::uint32_t>(exponent) << 10) |
                                    ((bits >> 13) & 0x3FFu));
}

std::string Stored(const std::vector<float>& values, std::uint32_t type) {
  std::string bytes;
  if (type == 0)
    for (const float value : values) bytes += Raw(value);
  if (type == 1)
    for (const float value : values) bytes += Raw(Half(value));
  if (type == 8) {
    for (std::size_t at = 0; at < values.size(); at += 32) {
      float most = 0.0f;
      for (std::size_t i = 0; i < 32; ++i) most = std::max(most, std::abs(values[at + i]));
      bytes += Raw(Half(most / 127.0f));
      for (std::size_t i = 0; i < 32; ++i)
        bytes += Raw(static_cast<std::int8_t>(std::lround(values[at + i] * 127.0f / most)));
    }
  }
  return bytes;
}

class Writer {
 public:
  explicit Writer(const TinyModel& model) : model_(model), random_(model.seed, "tiny model") {}

  void Entry(const std::string& key, std::uint32_t kind, const std::string& value) {
    if (LeftOut(key)) return;
    entries_ += Text(key) + Raw(kind) + value;
    ++entry_count_;
  }
  void Number(const std::string& key, std::size_t value) {
    Entry(key, kUint32, Raw(static_cast<std::uint32_t>(value)));
  }
  void Weights(const std::string& name, std::size_t rows, std::size_t columns, bool is_norm) {
    if (LeftOut(name)) return;
    std::vector<float> values(rows * columns);
    for (float& value : values)
      value = static_cast<float>(is_norm ? random_.Uniform(0.5, 1.5)
                                         : random_.Normal(0.0, 1.0 / std::sqrt(columns)));
    const std::uint32_t type = is_norm ? 0 : model_.weight_type;
    data_.resize((data_.size() + kAlignment - 1) / kAlignment * kAlignment);
    infos_ += Text(name) + Raw<std::uint32_t>(is_norm ? 1 : 2) + Raw<std::uint64_t>(columns);
    if (!is_norm) infos_ += Raw<std::uint64_t>(rows);
    infos_ += Raw(type) + Raw<std::uint64_t>(data_.size());
    data_ += Stored(values, type);
    ++tensor_count_;
  }
  std::string File() const {
    std::string file = "GGUF" + Raw<std::uint32_t>(3) + Raw<std::uint64_t>(tensor_count_) +
                       Raw<std::uint64_t>(entry_count_) + entries_ + infos_;
    file.resize((file.size() + kAlignment - 1) / kAlignment * kAlignment);
    return file + data_;
  }

 private:
  bool LeftOut(const std::string& name) const {
    return std::find(model_.without.begin(), model_.without.end(), name) != model_.without.end();
  }

  const TinyModel& model_;
  RandomStream random_;
  std::string entries_, infos_, data_;
  std::uint64_t entry_count_ = 0, tensor_count_ = 0;
};

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

void WriteMetadata(const TinyModel& model, Writer* writer) {
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
  writer->Number("tokenizer.ggml.eos_token_id", 2);
  writer->Entry("tokenizer.ggml.add_space_prefix", kBool, Raw(model.adds_space));
  if (!model.chat_template.empty())
    writer->Entry("tokenizer.chat_template", kString, Text(model.chat_template));
}

void WriteTensors(const TinyModel& model, Writer* writer) {
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
  Writer writer(model);
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
