#ifndef LATTICEWORLD_LANGUAGE_CHAT_REQUEST_BODY_H_
#define LATTICEWORLD_LANGUAGE_CHAT_REQUEST_BODY_H_

#include <string>
#include <string_view>

#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/chat/error_body.h"
#include "latticeworld/language/chat/openai_client.h"

namespace latticeworld {

// AcceptedMembers says which members of the request that servers differ about a server accepts, as
// far as it has told us by refusing them.
struct AcceptedMembers {
  bool max_tokens = true;  // false: it wants max_completion_tokens (OpenAI's thinking models)
  bool temperature = true;
  bool seed = true;
  bool stream_options = true;
};

// Returns the language in which a server of this dialect is told a form; kNone: it is not told.
FormLanguage FormLanguageOf(const AnswerForm& form, ChatDialect dialect);

// Returns the JSON of POST /chat/completions. Messages, max_tokens, temperature, seed, stream and
// stream_options are said to all servers. The form of the answer is said in the first of the
// dialect's ways that the form has:
//   llama.cpp  grammar, json_schema                      (it refuses both at once)
//   vllm       response_format json_schema, which old and new versions enforce; a form without a
//              schema structured_outputs: {regex}, {grammar}, which versions before 0.10.2 ignore,
//              as those from 0.12 on do guided_*
//   ollama     response_format json_schema, which its /v1 hands on as its own `format`; a `format`
//              in the request itself is ignored there
//   openai     response_format json_schema, strict
//   none       nothing
// The seed is folded to 31 bits, for some servers read it into 32, others into 64 signed ones. An
// image becomes a data: URL when the model sees, and is left out when not.
// Errors: INVALID_ARGUMENT with every violation: no message, a text that is not UTF-8, max_tokens
// below 1, a temperature outside 0 .. 2, a form's name of more than 64 letters, digits, _ and -, a
// schema that is no JSON object.
Result<std::string> CompletionBody(const ChatRequest& request, std::string_view model,
                                   const OpenAiOptions& options, const AcceptedMembers& accepted);

// Returns whether a server's refusal (HTTP 400 or 422) is about one of those members. The member is
// then noted, and the request may be said again without it.
bool NoteRefusal(const ErrorBody& refusal, AcceptedMembers* accepted);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_REQUEST_BODY_H_
