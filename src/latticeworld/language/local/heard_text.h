#ifndef LATTICEWORLD_LANGUAGE_LOCAL_HEARD_TEXT_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_HEARD_TEXT_H_

#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/status.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"
#include "latticeworld/language/local/decoding/llama_model.h"

namespace latticeworld {

// What a model has been shown and told, of which the next text keeps the part that both begin with.
// One thread owns it.
class HeardText {
 public:
  // Takes what LlamaDecoder takes.
  HeardText(std::shared_ptr<const LlamaModel> model, std::shared_ptr<WorkCrew> crew)
      : decoder_(std::move(model), std::move(crew)) {}

  // Makes it stand behind what is seen (places x width of the model; empty: nothing) and then said.
  // Errors: those of LlamaDecoder::Append; what was heard is then of no meaning to anybody but the
  // next Begin.
  Status Begin(const std::vector<float>& seen, const std::vector<TokenId>& said,
               const Progress& progress);
  // Adds to it. Errors: the same; what was heard until a CANCELLED stays.
  Status Add(const std::vector<TokenId>& tokens, const Progress& progress);

  // Takes the memory of so many places at once.
  void Reserve(std::size_t places) { decoder_.Reserve(places); }

  // (tokens of the vocabulary) for what comes next; of nothing: empty.
  const std::vector<float>& logits() const { return decoder_.logits(); }

 private:
  LlamaDecoder decoder_;
  std::vector<float> seen_;
  std::vector<TokenId> said_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_HEARD_TEXT_H_
