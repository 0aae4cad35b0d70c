#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpretation.h"
#include "latticeworld/language/interpreted/interpreted.h"
#include "latticeworld/language/interpreted/prompts.h"
#include "latticeworld/language/interpreted/reading_text.h"
#include "latticeworld/language/interpreted/sentences.h"

namespace latticeworld {
namespace {

class InterpretedEnvironmentGenerator final : public EnvironmentGenerator {
 public:
  InterpretedEnvironmentGenerator(std::shared_ptr<ChatServer> server, const RemoteOptions& options)
      : server_(std::move(server)),
        options_(options),
        embedded_(MakeGroundedEnvironmentGenerator()) {}

  std::string_view name() const override { return options_.name; }

  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request, const Progress& progress,
                                     std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    if (Trimmed(request.instruction).empty())
      return embedded_->Generate(request, progress, replies);
    progress.Report("environment", 0.0);
    Interpretation interpretation;
    interpretation.purpose = "environment_words";
    interpretation.messages = EnvironmentWordsMessages(request);
    interpretation.read_back = [&request](const std::string& words) {
      return TextOf(ReadEnvironmentInstruction(words, request.layout, *request.catalogue));
    };
    interpretation.read_back_turns = options_.repair_turns;
    interpretation.max_tokens = options_.environment_max_tokens;
    interpretation.temperature = options_.temperature;
    interpretation.seed = request.seed;
    LW_ASSIGN_OR_RETURN(const std::string words,
                        Interpret(server_.get(), interpretation, progress, replies));
    EnvironmentRequest plain = request;
    plain.reading = nullptr;
    // Where nothing is asked of it, the person's own words are nearest to it.
    if (!words.empty()) plain.instruction = words;
    LW_ASSIGN_OR_RETURN(EnvironmentAnswer answer, embedded_->Generate(plain, progress, replies));
    answer.warnings.insert(answer.warnings.begin(), ReadAsWarning(plain.instruction));
    return answer;
  }

 private:
  const std::shared_ptr<ChatServer> server_;
  const RemoteOptions options_;
  const std::unique_ptr<EnvironmentGenerator> embedded_;
};

}  // namespace

std::unique_ptr<EnvironmentGenerator> MakeInterpretedEnvironmentGenerator(
    std::shared_ptr<ChatServer> server, const RemoteOptions& options) {
  LW_CHECK(server != nullptr, "a model that interprets needs a server");
  LW_CHECK(Validate(options).empty(), "options are validated where they come in");
  return std::make_unique<InterpretedEnvironmentGenerator>(std::move(server), options);
}

}  // namespace latticeworld
