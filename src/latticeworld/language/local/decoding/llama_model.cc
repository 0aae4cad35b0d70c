#include "latticeworld/language/local/decoding/llama_model.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "latticeworld/language/local/weights/gguf_file.h"
#include "latticeworld/language/local/weights/weight_reader.h"

namespace latticeworld {
namespace {

constexpr std::uint64_t kMostWidth = 1u << 16, kMostLayers = 512, kMostContext = 1u << 22;

Result<LlamaSizes> ReadSizes(const GgufFile& file) {
  LW_ASSIGN_OR_RETURN(const std::string architecture, file.Text("general.architecture"));
  if (architecture != "llama")
    return DataLoss("a model of the architecture '" + architecture + "'; read here is 'llama'");
  // These are the sizes of the layers, and how heads share them.
  LlamaSizes sizes;
  LW_ASSIGN_OR_RETURN(sizes.width, file.Integer("llama.embedding_length", 2, kMostWidth));
  LW_ASSIGN_OR_RETURN(sizes.layers, file.Integer("llama.block_count", 1, kMostLayers));
  LW_ASSIGN_OR_RETURN(sizes.heads, file.Integer("llama.attention.head_count", 1, sizes.width));
  sizes.kv_heads = sizes.heads;
  if (file.Has("llama.attention.head_count_kv")) {
    LW_ASSIGN_OR_RETURN(sizes.kv_heads,
                        file.Integer("llama.attention.head_count_kv", 1, sizes.heads));
  }
  LW_ASSIGN_OR_RETURN(sizes.hidden, file.Integer("llama.feed_forward_length", 1, 4 * kMostWidth));
  LW_ASSIGN_OR_RETURN(sizes.context, file.Integer("llama.context_length", 1, kMostContext));
  if (sizes.width % sizes.heads != 0 || sizes.heads % sizes.kv_heads != 0 ||
      sizes.width / sizes.heads % 2 != 0)
    return DataLoss(std::to_string(sizes.width) + " values cannot be shared by " +
                    std::to_string(sizes.heads) + " heads over " + std::to_string(sizes.kv_heads) +
                    " of keys");
  sizes.head_width = sizes.width / sizes.heads;
  // Normalization and rotary positions have constants; forms that are not computed here are
  // refused.
  LW_ASSIGN_OR_RETURN(const double epsilon, file.Number("llama.attention.layer_norm_rms_epsilon"));
  if (!(epsilon > 0.0 && epsilon < 1.0))
    return DataLoss("llama.attention.layer_norm_rms_epsilon is " + std::to_string(epsilon) +
                    "; legal is what lies between 0 and 1");
  sizes.norm_epsilon = static_cast<float>(epsilon);
  if (file.Has("llama.rope.freq_base")) {
    LW_ASSIGN_OR_RETURN(const double base, file.Number("llama.rope.freq_base"));
    if (!(base > 1.0 && base < 1e12))
      return DataLoss("llama.rope.freq_base is " + std::to_string(base) + "; legal is above 1");
    sizes.rope_base = static_cast<float>(base);
  }
  if (file.Has("llama.rope.dimension_count")) {
    LW_RETURN_IF_ERROR(
        file.Integer("llama.rope.dimension_count", sizes.head_width, sizes.head_width).status());
  }
  if (file.Has("llama.rope.scaling.type")) {
    LW_ASSIGN_OR_RETURN(const std::string scaling, file.Text("llama.rope.scaling.type"));
    if (scaling != "none")
      return DataLoss("llama.rope.scaling.type is '" + scaling + "'; read here is 'none'");
  }
  // The number of tokens follows from the tokenizer's list.
  const auto found = file.metadata().find("tokenizer.ggml.tokens");
  const auto* tokens = found == file.metadata().end()
                           ? nullptr
                           : std::get_if<std::vector<std::string>>(&found->second);
  if (tokens == nullptr || tokens->empty())
    return DataLoss("the key 'tokenizer.ggml.tokens' has no list of tokens");
  sizes.tokens = tokens->size();
  return sizes;
}

LlamaLayer ReadLayer(std::size_t number, const LlamaSizes& sizes, WeightReader* weights) {
  const std::string block = "blk." + std::to_string(number) + ".";
  const std::size_t width = sizes.width;
  const std::size_t kv_width = sizes.kv_heads * sizes.head_width;
  LlamaLayer layer;
  layer.attention_norm = weights->Vector(block + "attn_norm.weight", width);
  layer.feed_forward_norm = weights->Vector(block + "ffn_norm.weight", width);
  layer.query = weights->Matrix(block + "attn_q.weight", width, width);
  layer.key = weights->Matrix(block + "attn_k.weight", kv_width, width);
  layer.value = weights->Matrix(block + "attn_v.weight", kv_width, width);
  layer.attention_output = weights->Matrix(block + "attn_output.weight", width, width);
  layer.gate = weights->Matrix(block + "ffn_gate.weight", sizes.hidden, width);
  layer.up = weights->Matrix(block + "ffn_up.weight", sizes.hidden, width);
  layer.down = weights->Matrix(block + "ffn_down.weight", width, sizes.hidden);
  return layer;
}

}  // namespace

Result<LlamaModel> ReadLlamaModel(const GgufFile& file) {
  LlamaModel model;
  LW_ASSIGN_OR_RETURN(model.sizes, ReadSizes(file));
  const LlamaSizes& sizes = model.sizes;
  WeightReader weights(&file);
  model.embeddings = weights.Matrix("token_embd.weight", sizes.tokens, sizes.width);
  model.output_norm = weights.Vector("output_norm.weight", sizes.width);
  if (file.tensors().count("output.weight") != 0) {
    model.output = weights.Matrix("output.weight", sizes.tokens, sizes.width);
  }
  model.rope_factors.assign(sizes.head_width / 2, 1.0f);
  if (file.tensors().count("rope_freqs.weight") != 0) {
    model.rope_factors = weights.Vector("rope_freqs.weight", sizes.head_width / 2);
  }
  for (std::size_t i = 0; i < sizes.layers && weights.status().ok(); ++i)
    model.layers.push_back(ReadLayer(i, sizes, &weights));
  LW_RETURN_IF_ERROR(weights.status());
  for (const float factor : model.rope_factors)
    if (!(std::isfinite(factor) && factor > 0.0f))
      return DataLoss("the tensor 'rope_freqs.weight' holds what is no positive number");
  LW_RETURN_IF_ERROR(weights.CheckAllRead());
  return model;
}

}  // namespace latticeworld
