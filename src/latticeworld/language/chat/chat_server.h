#ifndef LATTICEWORLD_LANGUAGE_CHAT_CHAT_SERVER_H_
#define LATTICEWORLD_LANGUAGE_CHAT_CHAT_SERVER_H_

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

enum class ChatRole : std::uint8_t { kSystem, kUser, kAssistant };

struct ChatMessage {
  ChatRole role = ChatRole::kUser;
  std::string text;       // UTF-8
  std::string image_png;  // bytes of a PNG that goes with the text; empty: none
};

// AnswerForm is the form that an answer must have, in every language in which a server may ask for
// it. A server uses the language that its dialect knows. Where a member is empty, the form cannot
// be said in that language.
struct AnswerForm {
  std::string name;         // [a-z_]+, for servers that want one
  std::string gbnf;         // llama.cpp grammar of the whole answer
  std::string regex;        // of the whole answer
  std::string json_schema;  // draft 2020-12; an answer in this form is one JSON value
};

// FormLanguage is the language in which a server was told the form. What was told so holds by
// force: the server lets the model write nothing else.
enum class FormLanguage : std::uint8_t { kNone, kGbnf, kRegex, kJsonSchema };

struct ChatRequest {
  std::vector<ChatMessage> messages;
  AnswerForm form;
  int max_tokens = 2048;
  int max_prompt_tokens = 0;  // that the messages may have; 0: any number. A server that cannot
                              // count them before it answers leaves this out
  double temperature = 0.7;
  std::uint64_t seed = 0;
};

struct ChatReply {
  std::string text;           // the answer without what the server marks as thinking
  std::string thinking;       // what it marks so
  std::string finish_reason;  // "stop", "length", ...; "cut": the listener wanted no more
  std::string model;          // as the server names it
  int prompt_tokens = 0;      // 0: not said
  int completion_tokens = 0;
  int retries = 0;
  // The natural logarithm of the answer's probability, where a form and temperature 0 left the
  // model choices; 0: not said.
  double log_probability = 0.0;
  double first_token_s = 0.0;               // from the last try's start
  double total_s = 0.0;                     // with all tries and waits between them
  FormLanguage form = FormLanguage::kNone;  // in which the server was told the form
  std::vector<std::string> warnings;        // of how the server treats what it is asked:
                                            // "what it does: how that shows"
};

// AnswerListener hears the answer so far each time more of it has come. It returns false to cut the
// answer short. When a connection breaks in the middle, the answer may be asked for once more: the
// text then starts anew, and so is shorter than what was heard last.
using AnswerListener = std::function<bool(std::string_view text_so_far)>;

// ChatServer is something that one can talk to: an HTTP server, a recording, a fake.
class ChatServer {
 public:
  virtual ~ChatServer() = default;
  // Returns whether the model looks at images.
  virtual bool sees() const = 0;
  // Asks for one answer. The listener is called in the calling thread; an empty one means that
  // nobody listens. No error message carries the key. Errors: CANCELLED at once when progress is
  // cancelled; DEADLINE_EXCEEDED (a timeout, each with words of its own, or the server's own HTTP
  // 408, 504); UNAVAILABLE (nobody there, not to be trusted, busy, out of quota, or gave up after
  // retries); UNAUTHENTICATED and PERMISSION_DENIED (the key); NOT_FOUND (model or path, or the
  // server has moved); INVALID_ARGUMENT (the server refused the request, or its model to answer);
  // RESOURCE_EXHAUSTED (answer too long); INTERNAL (the server failed, or speaks no HTTP) and
  // DATA_LOSS (the answer makes no sense).
  virtual Result<ChatReply> Complete(const ChatRequest& request, const AnswerListener& listener,
                                     const Progress& progress) = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_CHAT_SERVER_H_
