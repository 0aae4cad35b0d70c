#ifndef LATTICEWORLD_LANGUAGE_REMOTE_FORMS_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_FORMS_H_

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// Returns the form of a layout, named "layout": 32 rows of exactly 32 legal letters. It has a GBNF
// grammar and a regular expression of the plain matrix (rows joined by '\n', 1055 characters), and
// a JSON Schema of {"rows": [32 strings]}.
AnswerForm LayoutForm(Vocabulary vocabulary);

// Returns the form of an environment, named "environment": its schema as servers can enforce it.
// What the schema accepts is of the right shape and of known values; the validation is left with
// only what no schema can say (a variant that does not go with the season, a grazing goblin, too
// many agents in all). It accepts less than EnvironmentSchema(): continuous values are enums in
// steps, because grammars made from ranges of numbers let wrong ones through, and there are at most
// 64 groups. Every enum has its type, every object all its keys and no others.
AnswerForm EnvironmentForm(const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_FORMS_H_
