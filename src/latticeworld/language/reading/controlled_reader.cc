#include <algorithm>

#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/reading/layout_of_sentences.h"
#include "latticeworld/language/reading/text_warnings.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

std::vector<std::string> Readable(std::vector<std::string> sentences, SentenceKind kind) {
  const auto unreadable = [kind](const std::string& sentence) {
    return !ReadSentence(sentence, kind).has_value();
  };
  sentences.erase(std::remove_if(sentences.begin(), sentences.end(), unreadable), sentences.end());
  return sentences;
}

class ControlledReader final : public InstructionReader {
 public:
  std::string_view name() const override { return "controlled"; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& /*progress*/,
                                   std::vector<ModelReply>* /*replies*/) override {
    LayoutReading reading;
    reading.sentences = SplitSentences(request.instruction);
    reading.of_sentences = true;
    reading.plan = LayoutOfSentences(reading.sentences, request.vocabulary);
    WarnOfText(request.instruction, SentenceKind::kLayout, &reading.plan.warnings);
    reading.coverage =
        CoverageOf(request.instruction, Readable(reading.sentences, SentenceKind::kLayout),
                   SentenceKind::kLayout, request.vocabulary);
    return reading;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& /*progress*/,
                                             std::vector<ModelReply>* /*replies*/) override {
    EnvironmentReading reading;
    reading.sentences = SplitSentences(request.instruction);
    reading.heard = EnvironmentOfSentences(reading.sentences, *request.catalogue);
    WarnOfText(request.instruction, SentenceKind::kEnvironment, &reading.heard.warnings);
    reading.coverage =
        CoverageOf(request.instruction, Readable(reading.sentences, SentenceKind::kEnvironment),
                   SentenceKind::kEnvironment, request.layout->vocabulary);
    return reading;
  }
};

}  // namespace

std::unique_ptr<InstructionReader> MakeControlledReader() {
  return std::make_unique<ControlledReader>();
}

}  // namespace latticeworld
