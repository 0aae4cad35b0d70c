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

// These make the generators of the embedded default back end, which needs no model and no network.
// They read the claims of the instruction by rules, draw a layout or an environment that satisfies
// them, and check the result themselves.
std::unique_ptr<LayoutGenerator> MakeGroundedLayoutGenerator();
std::unique_ptr<EnvironmentGenerator> MakeGroundedEnvironmentGenerator();

// Returns what the rules read in a layout instruction.
LayoutReading ReadLayoutInstruction(std::string_view instruction, Vocabulary vocabulary);

// Makes a generator that lets another one, which draws its answers at random, try `tries` times (1
// or more). The first try has the request's seed, the others have seeds of their own. The answer is
// the layout that satisfies most of the claims that were read in the instruction; a layout that
// satisfies all of them ends the tries. A try that fails is passed over. Errors: the last try's
// where all failed; CANCELLED.
std::unique_ptr<LayoutGenerator> MakeBestOfLayoutGenerator(
    std::unique_ptr<LayoutGenerator> generator, int tries);

// EnvironmentClaims is what the rules read in an environment instruction, as claims.
struct EnvironmentClaims {
  std::vector<EnvironmentClaim> claims;
  std::vector<std::string> not_understood;  // words, as they stand in the instruction
};

// Reads an environment instruction by the rules. Places that features of the land name ("by the
// lake") are claimed only where `layout` is given. Values that the catalogue adds are known by
// their names.
EnvironmentClaims ReadEnvironmentInstruction(std::string_view instruction,
                                             const SymbolicLayout* layout = nullptr,
                                             const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_DRAWN_GROUNDED_H_
