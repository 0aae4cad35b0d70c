#include <utility>

#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/environment/environment_parser.h"
#include "latticeworld/language/grounded/reading/layout_parser.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/reading/text_units.h"
#include "latticeworld/language/reading/things_of_text.h"

namespace latticeworld {
namespace {

class RuleReader final : public InstructionReader {
 public:
  std::string_view name() const override { return "rules"; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& /*progress*/,
                                   std::vector<ModelReply>* /*replies*/) override {
    LayoutReading reading;
    // The rules are of land.
    TextThings things = TakeThings(request.instruction, request.vocabulary);
    reading.plan = ParseLayoutInstruction(things.rest, request.vocabulary);
    reading.plan.things = std::move(things.things);
    std::vector<std::string> quotes;
    for (const Claim& claim : reading.plan.claims) quotes.push_back(claim.words);
    reading.coverage =
        CoverageByQuotes(things.rest, quotes, SentenceKind::kLayout, request.vocabulary);
    const auto of_things =
        static_cast<int>(UnitsOf(things.taken, SentenceKind::kLayout, request.vocabulary).size());
    reading.coverage.words += of_things;
    reading.coverage.carried += of_things;
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
