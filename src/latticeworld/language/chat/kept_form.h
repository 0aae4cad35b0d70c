#ifndef LATTICEWORLD_LANGUAGE_CHAT_KEPT_FORM_H_
#define LATTICEWORLD_LANGUAGE_CHAT_KEPT_FORM_H_

#include <cstdint>
#include <string_view>

#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

enum class KeptForm : std::uint8_t { kYes, kNo, kUnknown };

// Returns whether a server held an answer to the form that it was told in this language. For a
// schema the function looks at whether the answer is one JSON value and, where that is to be an
// object, whether its members are those that the schema wants; a regular expression stands for the
// grammar beside it. Blanks around the answer are passed over. `text` is the answer without
// thinking; `whole` says that it was not cut, be it by the server's limit or by the listener. The
// result is kUnknown where no form was told, nothing was said, or what there is could still become
// an answer in the form.
KeptForm KeepsForm(std::string_view text, bool whole, const AnswerForm& form,
                   FormLanguage language);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_KEPT_FORM_H_
