#ifndef LATTICEWORLD_LANGUAGE_REMOTE_FORMS_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_FORMS_H_

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// 32 rows of exactly 32 legal letters: a GBNF grammar and a regular expression of the plain matrix
// (rows joined by '\n', 1055 characters), and a JSON Schema of {"rows": [32 strings]}. Named
// "layout".
AnswerForm LayoutForm(Vocabulary vocabulary);

// The schema of the environment as servers can enforce it: what it accepts is of the right shape
// and of known values, and only what no schema can say (a variant that does not go with the season,
// a grazing goblin, too many agents in all) is left to the validation. It accepts less than
// EnvironmentSchema(): continuous values are enums in steps, because grammars made from ranges of
// numbers let wrong ones through, and there are at most 64 groups. Every enum has its type, every
// object all its keys and no others. Named "environment".
AnswerForm EnvironmentForm(const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_FORMS_H_
