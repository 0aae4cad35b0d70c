#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_PROMPTS_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_PROMPTS_H_

#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// What is said to a model that interprets. The words stand in prompts/*.txt; the small language in
// them is written from its own tables.
std::vector<ChatMessage> LayoutWordsMessages(const LayoutRequest& request);
std::vector<ChatMessage> EnvironmentWordsMessages(const EnvironmentRequest& request);

// What goes back after an answer that is not all sentences of the language, or that leaves words
// out.
std::string SentencesRepairText(const std::vector<Violation>& violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_PROMPTS_H_
