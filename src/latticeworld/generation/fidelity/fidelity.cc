#include "latticeworld/generation/fidelity/fidelity.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/generation/bundle/things_json.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/reading/relief/relief_reading.h"
#include "latticeworld/language/reading/words/subjects.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/terrain/forms/relief_claims.h"
#include "latticeworld/terrain/forms/relief_covers.h"

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

FidelityReport AssessLayoutFidelity(const LayoutReading& reading, const SymbolicLayout& layout) {
  FidelityReport report;
  for (const Claim& claim : reading.plan.claims) {
    report.claims.push_back(OutcomeOf(InstructionPart::kLayout, claim, Measure(claim, layout)));
  }
  report.not_understood = reading.plan.not_understood;
  report.layout_sentences = reading.sentences;
  report.words = reading.coverage.words;
  report.words_read = reading.coverage.carried;
  for (const Claim& claim : reading.second) {
    report.second.push_back(OutcomeOf(InstructionPart::kLayout, claim, Measure(claim, layout)));
  }
  return report;
}

void AssessReliefFidelity(const LayoutReading& reading, const SymbolicLayout& layout,
                          const Terrain& terrain, FidelityReport* report) {
  std::vector<ClaimOutcome> outcomes;
  std::vector<ReliefMeasure> measures = MeasureReliefs(reading.plan.reliefs, layout, terrain);
  for (ReliefMeasure& measure : MeasureCovers(reading.plan.covers, terrain)) {
    measures.push_back(std::move(measure));
  }
  for (ReliefMeasure& measure : measures) {
    outcomes.push_back({InstructionPart::kLayout, std::move(measure.kind), std::move(measure.words),
                        measure.holds, measure.distance, std::move(measure.explanation)});
  }
  const auto behind_layout = std::find_if(
      report->claims.begin(), report->claims.end(),
      [](const ClaimOutcome& claim) { return claim.part == InstructionPart::kEnvironment; });
  report->claims.insert(behind_layout, outcomes.begin(), outcomes.end());
}

ClaimOutcome OutcomeOf(const EnvironmentClaim& claim, const EnvironmentConfig& environment) {
  return OutcomeOf(InstructionPart::kEnvironment, claim, Measure(claim, environment));
}

FidelityReport AssessFidelity(const LayoutReading& layout_reading,
                              const EnvironmentReading& environment_reading,
                              const SymbolicLayout& layout, const EnvironmentConfig& environment) {
  FidelityReport report = AssessLayoutFidelity(layout_reading, layout);
  for (const EnvironmentClaim& claim : ClaimsOf(environment_reading.heard, &layout)) {
    report.claims.push_back(OutcomeOf(claim, environment));
  }
  for (const std::string& words : environment_reading.heard.not_understood) {
    report.not_understood.push_back(words);
  }
  report.environment_sentences = environment_reading.sentences;
  report.words += environment_reading.coverage.words;
  report.words_read += environment_reading.coverage.carried;
  if (environment_reading.second) {
    for (const EnvironmentClaim& claim : ClaimsOf(*environment_reading.second, &layout)) {
      report.second.push_back(OutcomeOf(claim, environment));
    }
  }
  return report;
}

namespace {

struct Readings {
  LayoutReading layout;
  EnvironmentReading environment;
};

Result<Readings> ReadBoth(InstructionReader* reader, std::string_view layout_instruction,
                          std::string_view environment_instruction, const SymbolicLayout& layout,
                          std::shared_ptr<const Catalogue> catalogue) {
  std::vector<ModelReply> replies;
  LayoutRequest layout_request;
  layout_request.instruction = layout_instruction;
  layout_request.vocabulary = layout.vocabulary;
  Readings readings;
  LW_ASSIGN_OR_RETURN(readings.layout, reader->ReadLayout(layout_request, Progress(), &replies));
  ReadRelief(layout_instruction, &readings.layout);
  EnvironmentRequest environment_request;
  environment_request.instruction = EnvironmentText(layout_instruction, environment_instruction);
  environment_request.layout = &layout;
  environment_request.catalogue = std::move(catalogue);
  LW_ASSIGN_OR_RETURN(readings.environment,
                      reader->ReadEnvironment(environment_request, Progress(), &replies));
  return readings;
}

}  // namespace

Result<FidelityReport> ReadAndAssess(InstructionReader* reader, std::string_view layout_instruction,
                                     std::string_view environment_instruction,
                                     std::string_view things, const SymbolicLayout& layout,
                                     const Scene& scene) {
  LW_ASSIGN_OR_RETURN(
      Readings readings,
      ReadBoth(reader, layout_instruction, environment_instruction, layout, scene.catalogue));
  FidelityReport report =
      AssessFidelity(readings.layout, readings.environment, layout, scene.environment);
  AddTerrainType(readings.environment, &readings.layout);
  AssessReliefFidelity(readings.layout, layout, *scene.terrain, &report);
  LW_ASSIGN_OR_RETURN(
      const std::vector<ThingWish> wishes,
      WishedThings(things, readings.layout.plan, *scene.catalogue, layout.vocabulary));
  AddThings(MeasureThings(scene, wishes), &report);
  return report;
}

void AddThings(const std::vector<ThingOutcome>& things, FidelityReport* report) {
  const auto of_layout = [](const ClaimOutcome& claim) {
    return claim.part == InstructionPart::kLayout;
  };
  auto at = std::find_if_not(report->claims.begin(), report->claims.end(), of_layout);
  for (const ThingOutcome& thing : things) {
    at = report->claims.insert(at, {InstructionPart::kLayout, thing.kind, thing.words, thing.holds,
                                    thing.distance, thing.explanation});
    ++at;
  }
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
