#ifndef LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_DECODER_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_DECODER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/status.h"
#include "latticeworld/language/local/decoding/attention_cache.h"
#include "latticeworld/language/local/decoding/llama_model.h"

namespace latticeworld {

class WorkCrew;
using TokenId = std::uint32_t;

// What a model makes of a text so far: keys and values of all that was appended
// are kept, so that each further token costs one pass. Computed in float32
// (activations in int8 where weights are), the same however the text was split
// into calls and whoever computes. One thread owns it.
class LlamaDecoder {
 public:
  // model: never null. crew: who computes; null: the calling thread alone. No
  // other thread calls it at the same time.
  explicit LlamaDecoder(std::shared_ptr<const LlamaModel> model,
                        std::shared_ptr<WorkCrew> crew = nullptr);

  const LlamaModel& model() const { return *model_; }
  std::size_t length() const { return length_; }
  // Takes the memory of a text of so many places, at most the model's context, at once.
  void Reserve(std::size_t places);
  // Forgets what comes after the first `length` places, at most length().
  void Truncate(std::size_t length);

  // Errors: RESOURCE_EXHAUSTED (more than the model's context),
  // INVALID_ARGUMENT (no such token); nothing is appended then. CANCELLED: what
  // was appended until then stays.
  Status Append(const std::vector<TokenId>& tokens, const Progress& progress);
  // The same for `count` embeddings in a row (count x width), which stand where
  // tokens could: what an encoder of pictures makes for the model's eyes.
  Status AppendEmbeddings(const float* embeddings, std::size_t count, const Progress& progress);

  // (tokens of the vocabulary) for what comes next; of an empty text: empty.
  const std::vector<float>& logits() const { return logits_; }

 private:
  Status CheckRoom(std::size_t count) const;
  // One piece of at most kPiece places; last: logits are wanted of its end.
  void Pass(std::vector<float> places, std::size_t count, bool last);
  void Attend(const LlamaLayer& layer, std::size_t count, std::vector<float>* places,
              AttentionCache* cache);
  void FeedForward(const LlamaLayer& layer, std::size_t count, std::vector<float>* places);
  // heads: `count` of them at one place, the i-th of the piece.
  void Turn(float* heads, std::size_t count, std::size_t i) const;

  std::shared_ptr<const LlamaModel> model_;
  std::shared_ptr<WorkCrew> crew_;
  std::vector<float> turns_per_place_;  // head_width / 2: angles of RoPE [rad]
  std::vector<AttentionCache> caches_;  // one a layer
  std::size_t length_ = 0;
  std::vector<float> logits_;
  // Kept from pass to pass, so that memory is touched once.
  std::vector<float> cosines_, sines_;  // (places of the piece x head_width / 2)
  std::vector<float> normed_, queries_, attended_, keys_, values_, added_, gates_, ups_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_DECODER_H_
