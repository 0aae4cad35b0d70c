#ifndef LATTICEWORLD_LANGUAGE_CHAT_SERVER_TRY_H_
#define LATTICEWORLD_LANGUAGE_CHAT_SERVER_TRY_H_

#include <functional>
#include <string>
#include <string_view>

#include "latticeworld/language/chat/api_key.h"
#include "latticeworld/language/chat/call_clock.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/chat/completion_reader.h"
#include "latticeworld/language/chat/error_body.h"
#include "latticeworld/language/chat/failure.h"
#include "latticeworld/language/chat/openai_client.h"

namespace latticeworld {

// TryContext is what one request to a server is made of, apart from its body. All of it outlives
// the try.
struct TryContext {
  const OpenAiOptions& options;
  const ApiKey& key;
  const CallClock& clock;
  bool is_loopback;
};

// Sends one GET and puts the body of its answer into *answer. Errors: those of AskOnce.
Failure FetchOnce(const TryContext& context, const std::string& url, std::string* answer);

// Sends one POST of a chat completion and puts its answer into *reply (text, thinking,
// finish_reason, model, tokens, first_token_s). A refusal of the request (HTTP 400, 422) is
// described in *refusal as well. Errors: those of FailureOf and of CompletionReader; CANCELLED;
// DEADLINE_EXCEEDED, with a message of its own for each of the three timeouts: connecting (to try
// again), first token and total (final); UNAVAILABLE for no connection or a broken one (to try
// again) and for a certificate that does not hold (final); NOT_FOUND for a redirect;
// RESOURCE_EXHAUSTED for a body or header that is too large; INTERNAL for what is no HTTP.
Failure AskOnce(const TryContext& context, const std::string& url, const std::string& body,
                const AnswerListener& listener, ChatReply* reply, ErrorBody* refusal);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_SERVER_TRY_H_
