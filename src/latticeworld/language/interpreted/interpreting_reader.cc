#include "latticeworld/language/interpreted/interpreting_reader.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpretation.h"
#include "latticeworld/language/interpreted/prompts.h"
#include "latticeworld/language/interpreted/sentences.h"
#include "latticeworld/language/reading/reading_of_sentences.h"
#include "latticeworld/language/reading/things/beside_things.h"
#include "latticeworld/language/remote/conversation.h"

namespace latticeworld {
namespace {

void PutFirst(std::vector<std::string> of_server, std::vector<std::string>* warnings) {
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
    return ReadBesideThings(request, ThingsTaken::kWhole, [&](const LayoutRequest& rest) {
      return ReadLand(rest, progress, replies);
    });
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    LW_ASSIGN_OR_RETURN(EnvironmentReading own,
                        rules_->ReadEnvironment(request, progress, replies));
    if (Trimmed(request.instruction).empty()) return own;
    progress.Report("environment", 0.0);
    Interpretation interpretation = AskedOf(request.instruction, request.seed);
    interpretation.purpose = kEnvironmentWords;
    interpretation.kind = SentenceKind::kEnvironment;
    interpretation.vocabulary = request.layout->vocabulary;
    interpretation.messages = EnvironmentWordsMessages(request);
    interpretation.max_tokens = options_.environment_max_tokens;
    const std::size_t before = replies->size();
    LW_ASSIGN_OR_RETURN(std::vector<std::string> sentences,
                        Interpret(server_.get(), interpretation, progress, replies));
    EnvironmentReading reading =
        sentences.empty() ? own : ReadingOfSentences(request, std::move(sentences));
    reading.second = std::move(own.heard);
    PutFirst(ServerWarnings(*replies, before), &reading.heard.warnings);
    return reading;
  }

 private:
  Result<LayoutReading> ReadLand(const LayoutRequest& request, const Progress& progress,
                                 std::vector<ModelReply>* replies) {
    // If nothing is asked of the map, the person's own words are nearest to it.
    LW_ASSIGN_OR_RETURN(LayoutReading own, rules_->ReadLayout(request, progress, replies));
    if (Trimmed(request.instruction).empty()) return own;
    progress.Report("layout", 0.0);
    Interpretation interpretation = AskedOf(request.instruction, request.seed);
    interpretation.purpose = kLayoutWords;
    interpretation.kind = SentenceKind::kLayout;
    interpretation.vocabulary = request.vocabulary;
    interpretation.messages = LayoutWordsMessages(request);
    interpretation.max_tokens = options_.layout_max_tokens;
    const std::size_t before = replies->size();
    LW_ASSIGN_OR_RETURN(std::vector<std::string> sentences,
                        Interpret(server_.get(), interpretation, progress, replies));
    LayoutReading reading =
        sentences.empty() ? own : ReadingOfSentences(request, std::move(sentences));
    reading.second = std::move(own.plan.claims);
    PutFirst(ServerWarnings(*replies, before), &reading.plan.warnings);
    return reading;
  }

  Interpretation AskedOf(const std::string& text, std::uint64_t seed) const {
    Interpretation interpretation;
    interpretation.text = text;
    interpretation.repair_turns = options_.repair_turns;
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
