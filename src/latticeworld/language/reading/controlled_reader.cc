#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/reading/layout_of_sentences.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

class ControlledReader final : public InstructionReader {
 public:
  std::string_view name() const override { return "controlled"; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& /*progress*/,
                                   std::vector<ModelReply>* /*replies*/) override {
    LayoutReading reading;
    reading.sentences = SplitSentences(request.instruction);
    reading.plan = LayoutOfSentences(reading.sentences, request.vocabulary);
    return reading;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& /*progress*/,
                                             std::vector<ModelReply>* /*replies*/) override {
    EnvironmentReading reading;
    reading.sentences = SplitSentences(request.instruction);
    reading.heard = EnvironmentOfSentences(reading.sentences, *request.catalogue);
    return reading;
  }
};

}  // namespace

std::unique_ptr<InstructionReader> MakeControlledReader() {
  return std::make_unique<ControlledReader>();
}

}  // namespace latticeworld
