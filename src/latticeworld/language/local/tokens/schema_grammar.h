#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_SCHEMA_GRAMMAR_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_SCHEMA_GRAMMAR_H_

#include <string>
#include <string_view>

#include "latticeworld/common/result.h"

namespace latticeworld {

// A grammar, in the notation that Grammar::FromGbnf reads, of JSON values that
// a schema allows, written without spaces and with the members of objects in
// the schema's order. Read here: object (properties, all of them required, no
// others), array (items, minItems, maxItems up to 1000), string (free, or with
// an enum), integer (minimum and maximum), number (free), boolean, null, enum,
// const; titles and descriptions are passed over. Every text of the grammar is
// valid by the schema. Errors: INVALID_ARGUMENT naming the place (a JSON
// pointer) and what is not read here.
Result<std::string> SchemaGrammar(std::string_view json_schema);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_SCHEMA_GRAMMAR_H_
