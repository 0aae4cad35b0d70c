#ifndef LATTICEWORLD_LANGUAGE_REMOTE_CONVERSATION_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_CONVERSATION_H_

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/status.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// Question is a question to a model, and how its answers are judged.
struct Question {
  std::string_view purpose;  // "layout", "environment"
  ChatRequest first;         // the first turn; its seed is the request's
  int repair_turns = 0;
  std::function<AnswerListener()> make_listener;  // one for each turn
  // Returns OK where an answer can be used; whoever asks keeps what it reads. Else returns
  // INVALID_ARGUMENT with violations.
  std::function<Status(std::string_view answer)> read;
  // Returns what is said to the model about an answer with these violations.
  std::function<std::string(const std::vector<Violation>&)> repair_text;
};

// Asks the model, and asks again with all that was wrong with its last answer, until an answer can
// be used or the turns are used up. The model sees the question, its last answer and what was wrong
// with that; older answers are left out, so that what is sent stays bounded. Each repair has a seed
// of its own, drawn from the first. Every answer is appended to *replies as it was read, in order,
// with the warnings of its server; an answer out of the form that the server was told adds a
// warning. Errors: those of the server; CANCELLED; DATA_LOSS with the violations of the last answer
// and the warnings of all.
Status Ask(ChatServer* server, Question question, const Progress& progress,
           std::vector<ModelReply>* replies);

// Returns the warnings of the replies from index `from` on, each kind once. The kind is what stands
// before a warning's colon.
std::vector<std::string> ServerWarnings(const std::vector<ModelReply>& replies, std::size_t from);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_CONVERSATION_H_
