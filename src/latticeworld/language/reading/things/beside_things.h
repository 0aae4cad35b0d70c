#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_

#include <functional>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// The one way in which readers of free text come to single things: they are taken out of the text
// (things_of_text.h), `read` reads what is left, and the reading gets the things of the text first
// and behind them those that `read` has found. Errors: those of `read`.
Result<LayoutReading> ReadBesideThings(
    const LayoutRequest& request,
    const std::function<Result<LayoutReading>(const LayoutRequest& rest)>& read);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_
