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
    return LayoutReading{{}, ParseLayoutInstruction(request.instruction, request.vocabulary)};
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& /*progress*/,
                                             std::vector<ModelReply>* /*replies*/) override {
    return EnvironmentReading{{},
                              ParseEnvironmentInstruction(request.instruction, *request.catalogue)};
  }
};

}  // namespace

std::unique_ptr<InstructionReader> MakeRuleReader() { return std::make_unique<RuleReader>(); }

}  // namespace latticeworld
