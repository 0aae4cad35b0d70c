#ifndef LATTICEWORLD_LANGUAGE_DRAWN_DRAWN_H_
#define LATTICEWORLD_LANGUAGE_DRAWN_DRAWN_H_

#include <memory>
#include <string>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// These make generators that draw what a reader reads. The reader reads the instruction, the
// generator draws a layout or an environment that satisfies the claims, and checks the result
// itself. The request's own reading is used where it has one. `name` is that of the back end.
std::unique_ptr<LayoutGenerator> MakeDrawnLayoutGenerator(
    std::string name, std::shared_ptr<InstructionReader> reader);
std::unique_ptr<EnvironmentGenerator> MakeDrawnEnvironmentGenerator(
    std::string name, std::shared_ptr<InstructionReader> reader);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_DRAWN_DRAWN_H_
