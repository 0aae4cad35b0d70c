#ifndef LATTICEWORLD_TESTS_LANGUAGE_REMOTE_FORM_CHECKERS_H_
#define LATTICEWORLD_TESTS_LANGUAGE_REMOTE_FORM_CHECKERS_H_

#include <string>
#include <string_view>

#include "latticeworld/common/random.h"

namespace latticeworld {

// Small readers of the languages in which a form is said, written from their specifications and
// not from the code that makes the forms. They know what the forms use and throw on all else.

// GBNF (llama.cpp's grammars/README.md): rules of literals, character classes, rule names and
// repetitions {n}.
bool MatchesGbnf(const std::string& grammar, std::string_view text);

// JSON Schema: type, enum, properties, required, additionalProperties, items, minItems, maxItems,
// minimum, maximum, and patterns like ^[ABC]{32}$.
bool MatchesSchema(const std::string& schema, const std::string& json);

// A random JSON value that a schema of these keywords accepts; arrays have at most eight elements
// where the schema leaves it open.
std::string RandomInstance(const std::string& schema, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_REMOTE_FORM_CHECKERS_H_
