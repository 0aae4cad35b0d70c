#ifndef LATTICEWORLD_LANGUAGE_CHAT_CUT_PROMPT_H_
#define LATTICEWORLD_LANGUAGE_CHAT_CUT_PROMPT_H_

#include <string>

#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

// Returns the warning that a server cut what it was sent before its model read it, as Ollama does
// beyond its context without a word. The signs of it are that the server counted too few tokens for
// the characters of the messages, or exactly as many as a usual context has room for, where the
// characters would be more. Returns "" where there is no sign of it. prompt_tokens 0 means that the
// server counted none.
std::string CutPromptWarning(const ChatRequest& request, int prompt_tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_CUT_PROMPT_H_
