#include "latticeworld/language/interpreted/interpreting_reader.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpretation.h"
#include "latticeworld/language/interpreted/prompts.h"
#include "latticeworld/language/interpreted/reading_text.h"
#include "latticeworld/language/interpreted/sentences.h"
#include "latticeworld/language/remote/conversation.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

// How the instruction was read comes first, then what is to be said of the server.
void Warn(std::string_view words, std::vector<std::string> of_server,
          std::vector<std::string>* warnings) {
  of_server.insert(of_server.begin(), ReadAsWarning(words));
  warnings->insert(warnings->begin(), of_server.begin(), of_server.end());
}

class InterpretingReader final : public InstructionReader {
 public:
  InterpretingReader(std::shared_ptr<ChatServer> server, const RemoteOptions& options)
      : server_(std::move(server)), options_(options), rules_(MakeRuleReader()) {}

  std::string_view name() const override { return "remote"; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                   std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    if (Trimmed(request.instruction).empty()) return rules_->ReadLayout(request, progress, replies);
    progress.Report("layout", 0.0);
    Interpretation interpretation = Asked(request.seed);
    interpretation.purpose = kLayoutWords;
    interpretation.messages = LayoutWordsMessages(request);
    interpretation.read_back = [vocabulary = request.vocabulary](const std::string& words) {
      return TextOf(ReadLayoutInstruction(words, vocabulary));
    };
    interpretation.max_tokens = options_.layout_max_tokens;
    const std::size_t before = replies->size();
    LW_ASSIGN_OR_RETURN(const std::string words,
                        Interpret(server_.get(), interpretation, progress, replies));
    LayoutRequest plain = request;
    // Where nothing is asked of the map, the person's own words are nearest to it.
    if (!words.empty()) plain.instruction = words;
    LW_RETURN_IF_ERROR(latticeworld::Validate(plain));
    LW_ASSIGN_OR_RETURN(LayoutReading reading, rules_->ReadLayout(plain, progress, replies));
    reading.sentences = SplitSentences(words);
    LW_ASSIGN_OR_RETURN(LayoutReading own, rules_->ReadLayout(request, progress, replies));
    reading.second = std::move(own.plan.claims);
    reading.coverage = CoverageOf(request.instruction, reading.sentences, SentenceKind::kLayout,
                                  request.vocabulary);
    Warn(plain.instruction, ServerWarnings(*replies, before), &reading.plan.warnings);
    return reading;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    if (Trimmed(request.instruction).empty()) {
      return rules_->ReadEnvironment(request, progress, replies);
    }
    progress.Report("environment", 0.0);
    Interpretation interpretation = Asked(request.seed);
    interpretation.purpose = kEnvironmentWords;
    interpretation.messages = EnvironmentWordsMessages(request);
    interpretation.read_back = [&request](const std::string& words) {
      return TextOf(ReadEnvironmentInstruction(words, request.layout, *request.catalogue));
    };
    interpretation.max_tokens = options_.environment_max_tokens;
    const std::size_t before = replies->size();
    LW_ASSIGN_OR_RETURN(const std::string words,
                        Interpret(server_.get(), interpretation, progress, replies));
    EnvironmentRequest plain = request;
    if (!words.empty()) plain.instruction = words;
    LW_RETURN_IF_ERROR(latticeworld::Validate(plain));
    LW_ASSIGN_OR_RETURN(EnvironmentReading reading,
                        rules_->ReadEnvironment(plain, progress, replies));
    reading.sentences = SplitSentences(words);
    LW_ASSIGN_OR_RETURN(EnvironmentReading own,
                        rules_->ReadEnvironment(request, progress, replies));
    reading.second = std::move(own.heard);
    reading.coverage = CoverageOf(request.instruction, reading.sentences,
                                  SentenceKind::kEnvironment, request.layout->vocabulary);
    Warn(plain.instruction, ServerWarnings(*replies, before), &reading.heard.warnings);
    return reading;
  }

 private:
  Interpretation Asked(std::uint64_t seed) const {
    Interpretation interpretation;
    interpretation.read_back_turns = options_.repair_turns;
    interpretation.temperature = options_.temperature;
    interpretation.seed = seed;
    return interpretation;
  }

  const std::shared_ptr<ChatServer> server_;
  const RemoteOptions options_;
  const std::unique_ptr<InstructionReader> rules_;
};

}  // namespace

std::shared_ptr<InstructionReader> MakeInterpretingReader(std::shared_ptr<ChatServer> server,
                                                          const RemoteOptions& options) {
  LW_CHECK(server != nullptr, "a model that interprets needs a server");
  LW_CHECK(Validate(options).empty(), "options are validated where they come in");
  return std::make_shared<InterpretingReader>(std::move(server), options);
}

}  // namespace latticeworld
