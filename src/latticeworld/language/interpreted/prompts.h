#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_PROMPTS_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_PROMPTS_H_

#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// What is said to a model that interprets. The words stand in prompts/*.txt.
std::vector<ChatMessage> LayoutWordsMessages(const LayoutRequest& request);
std::vector<ChatMessage> EnvironmentWordsMessages(const EnvironmentRequest& request);

// Shows the model what was read in its sentences, and asks for them once more.
std::string ReadBackText(const std::string& reading);
// What goes back after an answer that is no list of sentences.
std::string SentencesRepairText(const std::vector<Violation>& violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_PROMPTS_H_
