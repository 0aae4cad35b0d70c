#ifndef LATTICEWORLD_LANGUAGE_CHAT_OPENAI_CLIENT_H_
#define LATTICEWORLD_LANGUAGE_CHAT_OPENAI_CLIENT_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/status.h"
#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

// ChatDialect says how a server wants to be told the form of an answer; request_body.h says what
// each is sent.
enum class ChatDialect : std::uint8_t { kLlamaCpp, kVllm, kOllama, kOpenAi, kNone };

constexpr std::array<EnumName<ChatDialect>, 5> EnumNames(ChatDialect) {
  return {{{ChatDialect::kLlamaCpp, "llama.cpp"},
           {ChatDialect::kVllm, "vllm"},
           {ChatDialect::kOllama, "ollama"},
           {ChatDialect::kOpenAi, "openai"},
           {ChatDialect::kNone, "none"}}};
}

// OpenAiOptions says where a server is and how long it may take. A request that a timeout ends
// gives DEADLINE_EXCEEDED with words of its own: the first-token and the total timeout end it at
// once, the connect timeout when no retry is left.
struct OpenAiOptions {
  std::string url;    // base, "http://127.0.0.1:8080/v1"; http or https, no password, no query
  std::string model;  // "": the first that the server lists and that answers by its name
  ChatDialect dialect = ChatDialect::kOpenAi;
  bool sees = false;                        // the model looks at images
  std::string api_key_variable;             // variable with the key, A-Z 0-9 _; "": no key
  std::string ca_file;                      // PEM of certificate authorities; "": the system's
  double connect_timeout_s = 5.0;           // of one try, with TLS; 0.01 .. 600
  double first_token_timeout_s = 60.0;      // of one try, from its start; 0.01 .. 3600
  double total_timeout_s = 180.0;           // with all retries and waits; 0.01 .. 7200
  int max_retries = 3;                      // 0 .. 20
  double backoff_s = 0.5;                   // before the first retry, doubled each time; 0 .. 60
  std::size_t max_answer_bytes = 1u << 20;  // of the body; 1024 .. 64 MiB
};
// Returns every violation of the options. None repeats the url or the variable's name: a password
// or the key may stand there by mistake.
std::vector<Violation> Validate(const OpenAiOptions& options);

// ServerStatistics counts what went over the wire so far, of requests that have ended.
struct ServerStatistics {
  std::uint64_t requests = 0;
  std::uint64_t failures = 0;  // those that the caller cancelled are none
  std::uint64_t retries = 0;
  std::uint64_t prompt_tokens = 0;
  std::uint64_t completion_tokens = 0;
  double last_first_token_s = 0.0;  // of the last request that went well
  double last_total_s = 0.0;        // of the last request
  std::string last_error;           // "": the last request went well
};

// OpenAiClient talks to a chat server behind the HTTP interface of OpenAI (llama.cpp, vLLM, Ollama,
// hosted ones). Several threads may use it at once; each request has a connection of its own.
//
// The client tries again, after a growing wait or what Retry-After says, at HTTP 429 (unless the
// quota is used up), 502, 503 and 529, at an error of that kind within a 200 answer, where there is
// no connection in time, and where a connection breaks, be it in the middle of the answer. A wait
// that would reach beyond the total timeout is not begun: the request ends at once. A request that
// is refused (HTTP 400, 422) for a member that servers differ about (max_tokens, temperature, seed,
// stream_options) is said once more without it, and the client remembers.
//
// An answer that stands where thinking should, with nothing in its own place, is taken from there
// when the server was told its form and all of it is in that form. A prompt that the server seems
// to have cut is a warning of the reply.
//
// The key is read from its variable at each request and stands in the request's header alone.
class OpenAiClient : public ChatServer {
 public:
  // Returns what went over the wire so far. May be called in any thread.
  virtual ServerStatistics statistics() const = 0;
};

// Makes a client. Errors: INVALID_ARGUMENT with every violation of the options.
Result<std::unique_ptr<OpenAiClient>> MakeOpenAiClient(const OpenAiOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_OPENAI_CLIENT_H_
