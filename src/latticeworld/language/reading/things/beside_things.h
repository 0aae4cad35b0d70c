#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_

#include <functional>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// The single things that are taken out of a text before it is read.
enum class ThingsTaken {
  kAll,   // for rules, which know none themselves
  kWhole  // for models: none unless all that the text says of all of them is understood
};

// Reads a text with its single things set apart; all readers of free text use this function. It
// takes the things out of the text (things_of_text.h), lets `read` read what is left, and gives the
// reading the things of the text first and those that `read` has found behind them. Errors: those
// of `read`.
Result<LayoutReading> ReadBesideThings(
    const LayoutRequest& request, ThingsTaken which,
    const std::function<Result<LayoutReading>(const LayoutRequest& rest)>& read);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_BESIDE_THINGS_H_
