#include <string>
#include <vector>

#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/environment/environment_parser.h"
#include "latticeworld/language/grounded/reading/layout_parser.h"
#include "latticeworld/language/reading/claim_coverage.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/reading/relief/way_slopes.h"
#include "latticeworld/language/reading/sentences_of_claims.h"
#include "latticeworld/language/reading/text_warnings.h"
#include "latticeworld/language/reading/things/beside_things.h"
#include "latticeworld/language/reading/words/subjects.h"

namespace latticeworld {
namespace {

class RuleReader final : public InstructionReader {
 public:
  std::string_view name() const override { return "rules"; }
  bool reads_by_kind() const override { return true; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& /*progress*/,
                                   std::vector<ModelReply>* /*replies*/) override {
    return ReadBesideThings(request, ThingsTaken::kAll, ReadLand);
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& whole,
                                             const Progress& /*progress*/,
                                             std::vector<ModelReply>* /*replies*/) override {
    const EnvironmentRequest request = OfItsKind(whole);
    EnvironmentReading reading;
    reading.heard = ParseEnvironmentInstruction(request.instruction, *request.catalogue);
    WarnOfText(request.instruction, SentenceKind::kEnvironment, &reading.heard.warnings);
    const std::vector<EnvironmentClaim> claims = ClaimsOf(reading.heard, request.layout);
    reading.sentences = SentencesOf(claims);
    reading.coverage =
        CoverageOf(request.instruction, reading.sentences, claims, request.layout->vocabulary);
    AddLost(reading.coverage, reading.heard.warnings, &reading.heard.not_understood);
    return reading;
  }

 private:
  static Result<LayoutReading> ReadLand(const LayoutRequest& whole) {
    const LayoutRequest request = OfItsKind(whole);
    LayoutReading reading;
    reading.plan = ParseLayoutInstruction(WithoutWaySlopes(request.instruction, request.vocabulary),
                                          request.vocabulary);
    WarnOfText(request.instruction, SentenceKind::kLayout, &reading.plan.warnings);
    reading.sentences = SentencesOf(reading.plan.claims, request.vocabulary);
    reading.coverage =
        CoverageOf(request.instruction, reading.sentences, reading.plan.claims, request.vocabulary);
    AddLost(reading.coverage, reading.plan.warnings, &reading.plan.not_understood);
    return reading;
  }
};

}  // namespace

std::unique_ptr<InstructionReader> MakeRuleReader() { return std::make_unique<RuleReader>(); }

}  // namespace latticeworld
