#ifndef LATTICEWORLD_LANGUAGE_CHAT_KEPT_FORM_H_
#define LATTICEWORLD_LANGUAGE_CHAT_KEPT_FORM_H_

#include <cstdint>
#include <string_view>

#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

enum class KeptForm : std::uint8_t { kYes, kNo, kUnknown };

// Whether a server held an answer to the form that it was told in this language. Of a schema it is
// looked at whether the answer is one JSON value and, where that is to be an object, whether its
// members are those that the schema wants; a regular expression stands for the grammar beside it.
// Blanks around the answer are passed over. text: without thinking; whole: not cut, be it by the
// server's limit or by the listener. kUnknown: no form was told, nothing was said, or what there is
// could still become an answer in the form.
KeptForm KeepsForm(std::string_view text, bool whole, const AnswerForm& form,
                   FormLanguage language);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_KEPT_FORM_H_
