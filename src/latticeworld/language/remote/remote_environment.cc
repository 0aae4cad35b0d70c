#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/remote/conversation.h"
#include "latticeworld/language/remote/environment_reader.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/prompts.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

// Bytes of a usual answer, to say how much of it has come: its end cannot be known before.
constexpr std::size_t kUsualBytes = 3000;
constexpr int kSteps = 20;  // in which progress is reported

// Reports how much of an environment has come.
AnswerListener MakeListener(const Progress* progress) {
  return [progress, reported = 0](std::string_view text) mutable {
    const std::size_t bytes = std::min(text.size(), kUsualBytes);
    const int step = std::min(static_cast<int>(bytes * kSteps / kUsualBytes), kSteps - 1);
    if (step != reported) {
      reported = step;
      progress->Report("environment", static_cast<double>(step) / kSteps);
    }
    return true;
  };
}

class RemoteEnvironmentGenerator final : public EnvironmentGenerator {
 public:
  RemoteEnvironmentGenerator(std::shared_ptr<ChatServer> server, const RemoteOptions& options)
      : server_(std::move(server)), options_(options) {}

  std::string_view name() const override { return options_.name; }

  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request, const Progress& progress,
                                     std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    EnvironmentAnswer answer;
    Question question;
    question.purpose = "environment";
    LW_ASSIGN_OR_RETURN(question.first.messages, EnvironmentMessages(request, server_->sees()));
    question.first.form = EnvironmentForm(*request.catalogue);
    question.first.max_tokens = options_.environment_max_tokens;
    question.first.temperature = options_.temperature;
    question.first.seed = request.seed;
    question.repair_turns = options_.repair_turns;
    question.make_listener = [&progress] { return MakeListener(&progress); };
    question.read = [&](std::string_view text) {
      LW_ASSIGN_OR_RETURN(
          answer.environment,
          options_.mends ? ReadMendedEnvironmentAnswer(text, *request.catalogue, &answer.warnings)
                         : ReadEnvironmentAnswer(text, *request.catalogue));
      return Status();
    };
    question.repair_text = EnvironmentRepairText;
    const std::size_t before = replies->size();
    LW_RETURN_IF_ERROR(Ask(server_.get(), std::move(question), progress, replies));
    for (std::string& warning : ServerWarnings(*replies, before)) {
      answer.warnings.push_back(std::move(warning));
    }
    return answer;
  }

 private:
  std::shared_ptr<ChatServer> server_;
  RemoteOptions options_;
};

}  // namespace

std::unique_ptr<EnvironmentGenerator> MakeRemoteEnvironmentGenerator(
    std::shared_ptr<ChatServer> server, const RemoteOptions& options) {
  LW_CHECK(server != nullptr, "a remote generator needs a server");
  LW_CHECK(Validate(options).empty(), "options are validated where they come in");
  return std::make_unique<RemoteEnvironmentGenerator>(std::move(server), options);
}

}  // namespace latticeworld
