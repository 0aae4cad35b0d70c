#ifndef LATTICEWORLD_LANGUAGE_DRAWN_DRAWN_H_
#define LATTICEWORLD_LANGUAGE_DRAWN_DRAWN_H_

#include <memory>
#include <string>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Generators that draw what a reader reads: instruction -> reading -> a layout or an environment
// that satisfies its claims -> self-check. The request's own reading is used where it has one.
// name: of the back end.
std::unique_ptr<LayoutGenerator> MakeDrawnLayoutGenerator(
    std::string name, std::shared_ptr<InstructionReader> reader);
std::unique_ptr<EnvironmentGenerator> MakeDrawnEnvironmentGenerator(
    std::string name, std::shared_ptr<InstructionReader> reader);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_DRAWN_DRAWN_H_
