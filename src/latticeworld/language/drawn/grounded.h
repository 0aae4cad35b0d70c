#ifndef LATTICEWORLD_LANGUAGE_DRAWN_GROUNDED_H_
#define LATTICEWORLD_LANGUAGE_DRAWN_GROUNDED_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

// The embedded default: no model, no network. Instruction -> claims -> a layout that satisfies
// them -> self-check.
std::unique_ptr<LayoutGenerator> MakeGroundedLayoutGenerator();
std::unique_ptr<EnvironmentGenerator> MakeGroundedEnvironmentGenerator();

// What the rules read in a layout instruction.
LayoutReading ReadLayoutInstruction(std::string_view instruction, Vocabulary vocabulary);

// Lets another generator, one that draws its answers, try `tries` times (1 or more) with seeds of
// their own, the first with the request's. The layout with most of the claims that were read in the
// instruction is the answer; one that has them all ends it. A try that fails is passed over.
// Errors: the last try's where all failed; CANCELLED.
std::unique_ptr<LayoutGenerator> MakeBestOfLayoutGenerator(
    std::unique_ptr<LayoutGenerator> generator, int tries);

// What the rules read in an environment instruction, as claims. Places that features of the land
// name ("by the lake") are claimed only where the layout is given. Values that the catalogue adds
// are known by their names.
struct EnvironmentClaims {
  std::vector<EnvironmentClaim> claims;
  std::vector<std::string> not_understood;  // words, as they stand in the instruction
};
EnvironmentClaims ReadEnvironmentInstruction(std::string_view instruction,
                                             const SymbolicLayout* layout = nullptr,
                                             const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_DRAWN_GROUNDED_H_
