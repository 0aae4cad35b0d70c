#ifndef LATTICEWORLD_LANGUAGE_REMOTE_PROMPTS_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_PROMPTS_H_

#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// What is said to a model. The words stand in prompts/*.txt.

// System prompt with the vocabulary; instruction, relief in words, and as a picture for a model
// that sees. Errors: INTERNAL (the picture cannot be made).
Result<std::vector<ChatMessage>> LayoutMessages(const LayoutRequest& request, bool sees);

// System prompt with the schema; layout, relief and instruction. Errors: the same.
Result<std::vector<ChatMessage>> EnvironmentMessages(const EnvironmentRequest& request, bool sees);

// What goes back to the model after an answer that cannot be used: all that is wrong with it, one
// violation a line, at most a hundred of them, and the form that is wanted.
std::string LayoutRepairText(const std::vector<Violation>& violations, Vocabulary vocabulary);
std::string EnvironmentRepairText(const std::vector<Violation>& violations);

// "A = farmland: fields, orchards, crops" and so on, a line each.
std::string ClassLines(Vocabulary vocabulary);
// At most a hundred violations, a line each.
std::string ViolationLines(const std::vector<Violation>& violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_PROMPTS_H_
