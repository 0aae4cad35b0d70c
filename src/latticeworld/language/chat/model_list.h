#ifndef LATTICEWORLD_LANGUAGE_CHAT_MODEL_LIST_H_
#define LATTICEWORLD_LANGUAGE_CHAT_MODEL_LIST_H_

#include <string>
#include <string_view>

namespace latticeworld {

// Returns the first name in the answer to GET /models that is not one of a model for something else
// than answers (embeddings, ranking, speech, pictures, moderation); where all are, the first of
// them. The list is {"data": [{"id": ...}]}, or {"models": [{"name": ...}]} of servers that speak
// Ollama's own tongue there. Returns "" where the list has no name.
std::string FirstModel(std::string_view list);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_MODEL_LIST_H_
