#ifndef LATTICEWORLD_LANGUAGE_REMOTE_PROMPTS_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_PROMPTS_H_

#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// The functions here make what is said to a model. The words stand in prompts/*.txt.

// Returns the messages that ask for a layout: a system prompt with the vocabulary, then the
// instruction and the relief in words, and as a picture for a model that sees. Errors: INTERNAL
// (the picture cannot be made).
Result<std::vector<ChatMessage>> LayoutMessages(const LayoutRequest& request, bool sees);

// Returns the messages that ask for an environment: a system prompt with the schema, then the
// layout, the relief and the instruction. Errors: the same.
Result<std::vector<ChatMessage>> EnvironmentMessages(const EnvironmentRequest& request, bool sees);

// Returns what goes back to the model after an answer that cannot be used: all that is wrong with
// it, one violation a line, at most a hundred of them, and the form that is wanted.
std::string LayoutRepairText(const std::vector<Violation>& violations, Vocabulary vocabulary);
std::string EnvironmentRepairText(const std::vector<Violation>& violations);

// Returns a line for each class: "A = farmland: fields, orchards, crops" and so on.
std::string ClassLines(Vocabulary vocabulary);
// Returns a line for each violation, a hundred at most.
std::string ViolationLines(const std::vector<Violation>& violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_PROMPTS_H_
