#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_READING_TEXT_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_READING_TEXT_H_

#include <string>
#include <string_view>

#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {

// What was read, for a model to look over: a claim a line as JSON, then the words that said
// nothing.
std::string TextOf(const LayoutReading& reading);
std::string TextOf(const EnvironmentClaims& reading);

// The warning that tells a person how an instruction was read: "read as: ...".
std::string ReadAsWarning(std::string_view words);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_READING_TEXT_H_
