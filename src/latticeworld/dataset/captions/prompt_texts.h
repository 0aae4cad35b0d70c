#ifndef LATTICEWORLD_DATASET_CAPTIONS_PROMPT_TEXTS_H_
#define LATTICEWORLD_DATASET_CAPTIONS_PROMPT_TEXTS_H_

#include <array>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// The messages of LayoutMessages and EnvironmentMessages in their text variants, as language/remote
// sends them. Those of environments are taken apart once and put together for each request, which
// takes microseconds instead of milliseconds. Const and shared by threads.
class PromptTexts {
 public:
  // size_m: side of the world that environments are for. Errors: INTERNAL.
  static Result<PromptTexts> Make(double size_m);

  // System and user message. Errors: INTERNAL.
  Result<std::vector<ChatMessage>> Layout(const LayoutRequest& request) const;
  // request.size_m and its catalogue: those of Make, the built-in one.
  Result<std::vector<ChatMessage>> Environment(const EnvironmentRequest& request) const;

 private:
  // A user message around what differs: the layout, the relief's caption (where there is one) and
  // the instruction, in this order.
  struct Frame {
    std::string before_layout, before_caption, before_instruction, after_instruction;
  };
  static constexpr std::size_t kVocabularies = 2;

  std::string system_;
  std::array<std::array<Frame, 2>, kVocabularies> frames_;  // [vocabulary][with relief]
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_PROMPT_TEXTS_H_
