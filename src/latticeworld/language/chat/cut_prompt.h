#ifndef LATTICEWORLD_LANGUAGE_CHAT_CUT_PROMPT_H_
#define LATTICEWORLD_LANGUAGE_CHAT_CUT_PROMPT_H_

#include <string>

#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

// The warning that a server cut what it was sent before its model read it, as Ollama does beyond
// its context without a word. Either it counted too few tokens for the characters of the messages,
// or exactly as many as a usual context has room for, where the characters would be more. "": no
// sign of it; prompt_tokens 0: not said.
std::string CutPromptWarning(const ChatRequest& request, int prompt_tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_CUT_PROMPT_H_
