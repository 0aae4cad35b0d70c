#ifndef LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_MODEL_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_MODEL_H_

#include <cstddef>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/local/weights/weight_matrix.h"

namespace latticeworld {

class GgufFile;

// The sizes of a model of LLaMA's architecture (Touvron et al. 2023).
struct LlamaSizes {
  std::size_t tokens = 0;  // in the vocabulary
  std::size_t width = 0;   // of a token's embedding
  std::size_t layers = 0;
  std::size_t heads = 0;       // of queries; divides width
  std::size_t kv_heads = 0;    // of keys and values; divides heads
  std::size_t head_width = 0;  // width / heads; even
  std::size_t hidden = 0;      // of the feed-forward network
  std::size_t context = 0;     // tokens that it was made for
  float norm_epsilon = 1e-5f;
  float rope_base = 10000.0f;
};

struct LlamaLayer {
  std::vector<float> attention_norm, feed_forward_norm;  // width
  WeightMatrix query, key, value, attention_output;
  WeightMatrix gate, up, down;
};

struct LlamaModel {
  LlamaSizes sizes;
  WeightMatrix embeddings;  // (tokens x width)
  std::vector<LlamaLayer> layers;
  std::vector<float> output_norm;   // width
  WeightMatrix output;              // (tokens x width); empty: embeddings serve
  std::vector<float> rope_factors;  // head_width / 2: what angles are divided by

  const WeightMatrix& OutputWeights() const { return output.rows() == 0 ? embeddings : output; }
};

// Reads the weights; float16 is widened, int8 stays. Errors: DATA_LOSS naming
// what is missing, of another shape, or not read here (another architecture,
// positions scaled in another way, biases).
Result<LlamaModel> ReadLlamaModel(const GgufFile& file);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_MODEL_H_
