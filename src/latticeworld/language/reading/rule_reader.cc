#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/environment/environment_parser.h"
#include "latticeworld/language/grounded/reading/layout_parser.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {
namespace {

class RuleReader final : public InstructionReader {
 public:
  std::string_view name() const override { return "rules"; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& /*progress*/,
                                   std::vector<ModelReply>* /*replies*/) override {
    LayoutReading reading;
    reading.plan = ParseLayoutInstruction(request.instruction, request.vocabulary);
    std::vector<std::string> quotes;
    for (const Claim& claim : reading.plan.claims) quotes.push_back(claim.words);
    reading.coverage =
        CoverageByQuotes(request.instruction, quotes, SentenceKind::kLayout, request.vocabulary);
    return reading;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& /*progress*/,
                                             std::vector<ModelReply>* /*replies*/) override {
    EnvironmentReading reading;
    reading.heard = ParseEnvironmentInstruction(request.instruction, *request.catalogue);
    std::vector<std::string> quotes;
    for (const EnvironmentClaim& claim : ClaimsOf(reading.heard, request.layout)) {
      quotes.push_back(claim.words);
    }
    reading.coverage = CoverageByQuotes(request.instruction, quotes, SentenceKind::kEnvironment,
                                        request.layout->vocabulary);
    return reading;
  }
};

}  // namespace

std::unique_ptr<InstructionReader> MakeRuleReader() { return std::make_unique<RuleReader>(); }

}  // namespace latticeworld
