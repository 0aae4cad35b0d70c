#include "latticeworld/language/local/decoding/llama_decoder.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/common/work_crew.h"
#include "latticeworld/language/local/decoding/llama_math.h"

namespace latticeworld {
namespace {

// Places that go through the layers together: enough to share each reading of
// the weights, few enough for their activations to stay in the cache.
constexpr std::size_t kPiece = 64;
// Below so many products of queries and keys a thread alone is as fast as a crew.
constexpr std::size_t kLeastProducts = 32768;

void AddTo(std::vector<float>* sums, const std::vector<float>& terms, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) (*sums)[i] += terms[i];
}

}  // namespace

LlamaDecoder::LlamaDecoder(std::shared_ptr<const LlamaModel> model, std::shared_ptr<WorkCrew> crew)
    : model_(std::move(model)),
      crew_(std::move(crew)),
      caches_(model_->sizes.layers,
              AttentionCache(model_->sizes.kv_heads, model_->sizes.head_width)) {
  const LlamaSizes& sizes = model_->sizes;
  for (std::size_t i = 0; i < sizes.head_width / 2; ++i)
    turns_per_place_.push_back(static_cast<float>(
        std::pow(double{sizes.rope_base}, -2.0 * static_cast<double>(i) / sizes.head_width) /
        model_->rope_factors[i]));
}

void LlamaDecoder::Reserve(std::size_t places) {
  for (AttentionCache& cache : caches_) cache.Reserve(std::min(places, model_->sizes.context));
}

void LlamaDecoder::Truncate(std::size_t length) {
  length_ = std::min(length, length_);
  for (AttentionCache& cache : caches_) cache.Truncate(length_);
  logits_.clear();
}

Status LlamaDecoder::CheckRoom(std::size_t count) const {
  if (count <= model_->sizes.context && length_ <= model_->sizes.context - count) return Status();
  return ResourceExhausted(std::to_string(length_ + count) +
                           " tokens do not fit into the model's context of " +
                           std::to_string(model_->sizes.context));
}

Status LlamaDecoder::Append(const std::vector<TokenId>& tokens, const Progress& progress) {
  LW_RETURN_IF_ERROR(CheckRoom(tokens.size()));
  for (const TokenId token : tokens)
    if (token >= model_->sizes.tokens)
      return InvalidArgument("token " + std::to_string(token) + "; the model has " +
                             std::to_string(model_->sizes.tokens));
  const std::size_t width = model_->sizes.width;
  for (std::size_t begin = 0; begin < tokens.size(); begin += kPiece) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    const std::size_t count = std::min(kPiece, tokens.size() - begin);
    std::vector<float> places(count * width);
    for (std::size_t i = 0; i < count; ++i)
      model_->embeddings.Row(tokens[begin + i], places.data() + i * width);
    Pass(std::move(places), count, begin + count == tokens.size());
  }
  return Status();
}

Status LlamaDecoder::AppendEmbeddings(const float* embeddings, std::size_t count,
                                      const Progress& progress) {
  LW_RETURN_IF_ERROR(CheckRoom(count));
  const std::size_t width = model_->sizes.width;
  for (std::size_t begin = 0; begin < count; begin += kPiece) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    const std::size_t some = std::min(kPiece, count - begin);
    const float* first = embeddings + begin * width;
    Pass(std::vector<float>(first, first + some * width), some, begin + some == count);
  }
  return Status();
}

void LlamaDecoder::Pass(std::vector<float> places, std::size_t count, bool last) {
  const LlamaSizes& sizes = model_->sizes;
  normed_.resize(count * sizes.width);
  added_.resize(count * sizes.width);
  cosines_.clear();
  sines_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    for (const float turn : turns_per_place_) {
      const float angle_rad = static_cast<float>(length_ + i) * turn;
      cosines_.push_back(std::cos(angle_rad));
      sines_.push_back(std::sin(angle_rad));
    }
  }
  for (std::size_t i = 0; i < sizes.layers; ++i) {
    Attend(model_->layers[i], count, &places, &caches_[i]);
    FeedForward(model_->layers[i], count, &places);
  }
  length_ += count;
  logits_.clear();
  if (!last) return;
  logits_.resize(sizes.tokens);
  RootMeanSquareNorm(places.data() + (count - 1) * sizes.width, model_->output_norm.data(), 1,
                     sizes.width, sizes.norm_epsilon, normed_.data());
  model_->OutputWeights().Multiply(normed_.data(), 1, logits_.data(), crew_.get());
}

// Rotates each pair of neighbouring values by the angle of its place (RoPE: Su et al. 2021).
void LlamaDecoder::Turn(float* heads, std::size_t count, std::size_t i) const {
  const std::size_t pairs = turns_per_place_.size();
  const float* cosines = cosines_.data() + i * pairs;
  const float* sines = sines_.data() + i * pairs;
  for (std::size_t head = 0; head < count; ++head) {
    float* pair = heads + head * 2 * pairs;
    for (std::size_t k = 0; k < pairs; ++k, pair += 2) {
      const float x = pair[0], y = pair[1];
      pair[0] = x * cosines[k] - y * sines[k];
      pair[1] = x * sines[k] + y * cosines[k];
    }
  }
}

void LlamaDecoder::Attend(const LlamaLayer& layer, std::size_t count, std::vector<float>* places,
                          AttentionCache* cache) {
  const LlamaSizes& sizes = model_->sizes;
  const std::size_t kv_width = sizes.kv_heads * sizes.head_width;
  RootMeanSquareNorm(places->data(), layer.attention_norm.data(), count, sizes.width,
                     sizes.norm_epsilon, normed_.data());
  queries_.resize(count * sizes.width);
  attended_.resize(count * sizes.width);
  keys_.resize(count * kv_width);
  values_.resize(count * kv_width);
  layer.query.Multiply(normed_.data(), count, queries_.data(), crew_.get());
  layer.key.Multiply(normed_.data(), count, keys_.data(), crew_.get());
  layer.value.Multiply(normed_.data(), count, values_.data(), crew_.get());
  for (std::size_t i = 0; i < count; ++i) {
    Turn(queries_.data() + i * sizes.width, sizes.heads, i);
    Turn(keys_.data() + i * kv_width, sizes.kv_heads, i);
  }
  cache->Append(keys_.data(), values_.data(), kv_width, count);
  const std::size_t share = sizes.heads / sizes.kv_heads;
  const auto look_back = [&](int head_of_all) {
    const auto head = static_cast<std::size_t>(head_of_all);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = i * sizes.width + head * sizes.head_width;
      cache->Attend(head / share, queries_.data() + at, length_ + i + 1, attended_.data() + at);
    }
  };
  const auto heads = static_cast<int>(sizes.heads);
  if (crew_ != nullptr && (length_ + count) * count * sizes.width >= kLeastProducts) {
    crew_->Run(heads, look_back);
  } else {
    for (int head = 0; head < heads; ++head) look_back(head);
  }
  layer.attention_output.Multiply(attended_.data(), count, added_.data(), crew_.get());
  AddTo(places, added_, count * sizes.width);
}

void LlamaDecoder::FeedForward(const LlamaLayer& layer, std::size_t count,
                               std::vector<float>* places) {
  const LlamaSizes& sizes = model_->sizes;
  RootMeanSquareNorm(places->data(), layer.feed_forward_norm.data(), count, sizes.width,
                     sizes.norm_epsilon, normed_.data());
  gates_.resize(count * sizes.hidden);
  ups_.resize(count * sizes.hidden);
  layer.gate.Multiply(normed_.data(), count, gates_.data(), crew_.get());
  layer.up.Multiply(normed_.data(), count, ups_.data(), crew_.get());
  GateWithSwish(gates_.data(), ups_.data(), count * sizes.hidden);
  layer.down.Multiply(gates_.data(), count, added_.data(), crew_.get());
  AddTo(places, added_, count * sizes.width);
}

}  // namespace latticeworld
