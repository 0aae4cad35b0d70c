#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_SENTENCES_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_SENTENCES_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

// Returns the text without the blanks and line breaks at both ends.
std::string_view Trimmed(std::string_view text);

// A JSON object {"sentences": ["...", ...]} of at most 64 strings, as a JSON Schema.
AnswerForm SentencesForm(std::string name);

// The sentences of a whole answer, with thinking, prose and Markdown fences around the object:
// trimmed, empty ones left out, without their stops. Errors: INVALID_ARGUMENT with violations: no
// such object, too many of them, or longer together than an instruction may be.
Result<std::vector<std::string>> ReadSentences(std::string_view answer);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_SENTENCES_H_
