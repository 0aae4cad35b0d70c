#ifndef LATTICEWORLD_LANGUAGE_REMOTE_PROMPT_TEMPLATE_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_PROMPT_TEMPLATE_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// PromptValue is what a template has a {{name}} for.
struct PromptValue {
  std::string_view name;  // [a-z_]+
  std::string text;       // may hold anything, "{{name}}" too: it is not looked into again
};

// Puts each value in the place of its {{name}}, wherever that stands in the text. Errors: INTERNAL
// with every violation at once, where names and values do not fit each other (unknown_name: no
// value is given; unused_value: its name is not in the text; open_brace: "{{" without "}}").
Result<std::string> FillTemplate(std::string_view text, const std::vector<PromptValue>& values);
// Does the same with a file that is part of the program, without the newlines at its end. A name
// that does not fit is a bug, which a test finds.
std::string FillPromptFile(std::string_view text, const std::vector<PromptValue>& values);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_PROMPT_TEMPLATE_H_
