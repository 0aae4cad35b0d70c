#include "latticeworld/language/drawn/grounded.h"

#include <utility>

#include "latticeworld/language/drawn/drawn.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/environment/environment_parser.h"
#include "latticeworld/language/grounded/reading/layout_parser.h"

namespace latticeworld {

std::unique_ptr<LayoutGenerator> MakeGroundedLayoutGenerator() {
  return MakeDrawnLayoutGenerator("grounded", MakeRuleReader());
}

std::unique_ptr<EnvironmentGenerator> MakeGroundedEnvironmentGenerator() {
  return MakeDrawnEnvironmentGenerator("grounded", MakeRuleReader());
}

LayoutReading ReadLayoutInstruction(std::string_view instruction, Vocabulary vocabulary) {
  LayoutReading reading;
  reading.plan = ParseLayoutInstruction(instruction, vocabulary);
  return reading;
}

EnvironmentClaims ReadEnvironmentInstruction(std::string_view instruction,
                                             const SymbolicLayout* layout,
                                             const Catalogue& catalogue) {
  HeardEnvironment heard = ParseEnvironmentInstruction(instruction, catalogue);
  return {ClaimsOf(heard, layout), std::move(heard.not_understood)};
}

}  // namespace latticeworld
