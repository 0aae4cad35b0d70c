#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_

#include <functional>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Reads a text with its single things set apart; all readers of free text use this function. It
// takes the things out of the text (things_of_text.h), lets `read` read what is left, and gives the
// reading the things of the text first and those that `read` has found behind them. Errors: those
// of `read`.
Result<LayoutReading> ReadBesideThings(
    const LayoutRequest& request,
    const std::function<Result<LayoutReading>(const LayoutRequest& rest)>& read);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_
