#include "latticeworld/generation/fidelity.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/grounded/grounded.h"
#include "latticeworld/layout/claims.h"

namespace latticeworld {
namespace {

template <typename ClaimType, typename Measured>
ClaimOutcome OutcomeOf(InstructionPart part, const ClaimType& claim, Measured measure) {
  return {part,
          std::string(NameOf(claim.kind)),
          claim.words,
          measure.holds,
          measure.distance,
          std::move(measure.explanation)};
}

}  // namespace

int FidelityReport::satisfied() const {
  return static_cast<int>(std::count_if(claims.begin(), claims.end(),
                                        [](const ClaimOutcome& claim) { return claim.satisfied; }));
}

FidelityReport AssessLayoutFidelity(std::string_view instruction, const SymbolicLayout& layout) {
  FidelityReport report;
  LayoutReading reading = ReadLayoutInstruction(instruction, layout.vocabulary);
  for (const Claim& claim : reading.claims) {
    report.claims.push_back(OutcomeOf(InstructionPart::kLayout, claim, Measure(claim, layout)));
  }
  report.not_understood = std::move(reading.not_understood);
  return report;
}

FidelityReport AssessFidelity(std::string_view layout_instruction,
                              std::string_view environment_instruction,
                              const SymbolicLayout& layout, const EnvironmentConfig& environment) {
  FidelityReport report = AssessLayoutFidelity(layout_instruction, layout);
  EnvironmentReading reading = ReadEnvironmentInstruction(environment_instruction);
  for (const EnvironmentClaim& claim : reading.claims) {
    report.claims.push_back(
        OutcomeOf(InstructionPart::kEnvironment, claim, Measure(claim, environment)));
  }
  for (std::string& words : reading.not_understood) {
    report.not_understood.push_back(std::move(words));
  }
  return report;
}

std::vector<std::string> WarningsOf(const FidelityReport& report) {
  std::vector<std::string> warnings;
  for (const ClaimOutcome& claim : report.claims) {
    if (claim.satisfied) continue;
    warnings.push_back("not satisfied: " + Quote(claim.words) + ": " + claim.explanation);
  }
  if (!report.not_understood.empty()) {
    std::vector<std::string> quoted;
    for (const std::string& words : report.not_understood) quoted.push_back(Quote(words));
    warnings.push_back("not understood: " + Join(quoted, ", "));
  }
  return warnings;
}

}  // namespace latticeworld
