#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/environment/environment_parser.h"
#include "latticeworld/language/grounded/reading/layout_parser.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/reading/sentences_of_claims.h"

namespace latticeworld {
namespace {

class RuleReader final : public InstructionReader {
 public:
  std::string_view name() const override { return "rules"; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& /*progress*/,
                                   std::vector<ModelReply>* /*replies*/) override {
    LayoutReading reading;
    reading.plan = ParseLayoutInstruction(request.instruction, request.vocabulary);
    reading.sentences = SentencesOf(reading.plan.claims, request.vocabulary);
    reading.coverage = CoverageOf(request.instruction, reading.sentences, SentenceKind::kLayout,
                                  request.vocabulary);
    AddLost(reading.coverage, &reading.plan.not_understood);
    return reading;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& /*progress*/,
                                             std::vector<ModelReply>* /*replies*/) override {
    EnvironmentReading reading;
    reading.heard = ParseEnvironmentInstruction(request.instruction, *request.catalogue);
    reading.sentences = SentencesOf(ClaimsOf(reading.heard, request.layout));
    reading.coverage = CoverageOf(request.instruction, reading.sentences,
                                  SentenceKind::kEnvironment, request.layout->vocabulary);
    AddLost(reading.coverage, &reading.heard.not_understood);
    return reading;
  }
};

}  // namespace

std::unique_ptr<InstructionReader> MakeRuleReader() { return std::make_unique<RuleReader>(); }

}  // namespace latticeworld
