#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETATION_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETATION_H_

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// A question for the plain sentences of an instruction.
struct Interpretation {
  std::string_view purpose;  // "layout_words", "environment_words"
  std::vector<ChatMessage> messages;
  // What the embedded reader makes of an instruction in plain words, for the model to look over.
  std::function<std::string(const std::string& words)> read_back;
  int read_back_turns = 2;  // times that it is shown
  int max_tokens = 2048;
  double temperature = 0.7;
  std::uint64_t seed = 0;
};

// The instruction in plain words, its sentences in one line; empty where it asks for nothing. The
// model is done when it says the same twice, or when the turns are used up, or when its server
// fails after it has said something. replies: every answer, appended in order.
// Errors: those of Ask while nothing has been said; CANCELLED.
Result<std::string> Interpret(ChatServer* server, const Interpretation& interpretation,
                              const Progress& progress, std::vector<ModelReply>* replies);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETATION_H_
