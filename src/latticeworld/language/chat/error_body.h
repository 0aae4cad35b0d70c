#ifndef LATTICEWORLD_LANGUAGE_CHAT_ERROR_BODY_H_
#define LATTICEWORLD_LANGUAGE_CHAT_ERROR_BODY_H_

#include <string>
#include <string_view>

#include "latticeworld/language/chat/api_key.h"
#include "latticeworld/language/chat/failure.h"

namespace latticeworld {

// ErrorBody is what a server says about its failure; members that the server leaves out are empty.
struct ErrorBody {
  std::string message;
  std::string type;     // "invalid_request_error", ...
  std::string code;     // "invalid_api_key", "503", ...
  std::string param;    // the request's member that it is about
  int http_status = 0;  // when type or code say one, 400 .. 599
};

// Reads every shape of an error that servers are known to use. It never fails: at worst the message
// is the body itself, or the title of a page in HTML.
//   {"error": {"message", "type", "code", "param"}}   OpenAI, llama.cpp (code: a number), Ollama
//   [{"error": {...}}]                                 Gemini
//   {"error": "text", "error_type": ...}               TGI, Ollama's own interface
//   {"object": "error", "message", "type", "code"}     vLLM
//   {"message": ...}, {"detail": "text"},
//   {"detail": [{"loc": [...], "msg", "type"}]}        FastAPI
ErrorBody ParseErrorBody(std::string_view body);

// Returns the failure that an answer with this HTTP status is, without retry_after_s:
//   401, 407            UNAUTHENTICATED
//   402, 403            PERMISSION_DENIED
//   404, 410            NOT_FOUND
//   408, 504            DEADLINE_EXCEEDED
//   429                 UNAVAILABLE, to try again unless the quota is used up
//   502, 503, 529       UNAVAILABLE, to try again (llama.cpp says 503 while it loads its model)
//   other 4xx           INVALID_ARGUMENT
//   other               INTERNAL
Failure FailureOf(int http_status, const ErrorBody& body, const ApiKey& key);

// Returns the HTTP status that an error within a 200 answer stands for: the one that it says, or
// the one of its type, else 500.
int HttpStatusOf(const ErrorBody& body);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_ERROR_BODY_H_
