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
                              const SymbolicLayout& layout, const EnvironmentConfig& environment,
                              const Catalogue& catalogue) {
  FidelityReport report = AssessLayoutFidelity(layout_instruction, layout);
  EnvironmentReading reading =
      ReadEnvironmentInstruction(environment_instruction, &layout, catalogue);
  for (const EnvironmentClaim& claim : reading.claims) {
    report.claims.push_back(
        OutcomeOf(InstructionPart::kEnvironment, claim, Measure(claim, environment)));
  }
  for (std::string& words : reading.not_understood) {
    report.not_understood.push_back(std::move(words));
  }
  return report;
}

std::vector<std::string> WarningsOf(const FidelityReport& report,
                                    const std::vector<std::string>& so_far) {
  const auto is_quoted = [&so_far](const std::string& quote) {
    return std::any_of(so_far.begin(), so_far.end(), [&quote](const std::string& warning) {
      return warning.find(quote) != std::string::npos;
    });
  };
  std::vector<std::string> warnings;
  for (const ClaimOutcome& claim : report.claims) {
    const std::string quote = Quote(claim.words);
    if (claim.satisfied || is_quoted(quote)) continue;
    warnings.push_back("not satisfied: " + quote + ": " + claim.explanation);
  }
  std::vector<std::string> quotes;
  for (const std::string& words : report.not_understood) {
    if (!is_quoted(Quote(words))) quotes.push_back(Quote(words));
  }
  if (!quotes.empty()) warnings.push_back("not understood: " + Join(quotes, ", "));
  return warnings;
}

}  // namespace latticeworld
