#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

class ReplayServer final : public ChatServer {
 public:
  explicit ReplayServer(std::vector<ModelReply> replies)
      : replies_(std::move(replies)), given_(replies_.size(), false) {}

  bool sees() const override { return false; }

  Result<ChatReply> Complete(const ChatRequest& request, const AnswerListener& listener,
                             const Progress& progress) override {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    const ModelReply* record = Next(request.form.name);
    if (record == nullptr) {
      return Status(StatusCode::kOutOfRange,
                    "the recording holds no further reply for the " + request.form.name);
    }
    ChatReply reply;
    reply.text = record->text;
    reply.finish_reason = record->finish_reason;
    reply.model = record->model;
    reply.prompt_tokens = record->prompt_tokens;
    reply.completion_tokens = record->completion_tokens;
    reply.retries = record->retries;
    reply.total_s = record->seconds;
    reply.warnings = record->warnings;
    reply.log_probability = record->log_probability;
    // The listener hears it for its progress; the reply stays as long as it was recorded, whatever
    // the listener wants.
    if (listener) listener(reply.text);
    return reply;
  }

 private:
  // The first of the purpose that was not given yet; nullptr: none.
  const ModelReply* Next(std::string_view purpose) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 0; i < replies_.size(); ++i) {
      if (given_[i] || replies_[i].purpose != purpose) continue;
      given_[i] = true;
      return &replies_[i];
    }
    return nullptr;
  }

  const std::vector<ModelReply> replies_;
  std::mutex mutex_;
  std::vector<bool> given_;  // under mutex_
};

// Layout and environment fail by the same rule.
template <typename Generator, typename Request, typename Answer>
class FailedGenerator final : public Generator {
 public:
  FailedGenerator(std::string name, std::vector<ModelReply> replies)
      : name_(std::move(name)), replies_(std::move(replies)) {
    LW_CHECK(!replies_.empty() && !replies_.back().failure.ok(),
             "what failed has a record of its failure");
    failure_ = replies_.back().failure;
    replies_.pop_back();
  }

  std::string_view name() const override { return name_; }

  Result<Answer> Generate(const Request& request, const Progress& progress,
                          std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    replies->insert(replies->end(), replies_.begin(), replies_.end());
    return failure_;
  }

 private:
  std::string name_;
  std::vector<ModelReply> replies_;
  Status failure_;
};

}  // namespace

std::shared_ptr<ChatServer> MakeReplayServer(std::vector<ModelReply> replies) {
  return std::make_shared<ReplayServer>(std::move(replies));
}

std::unique_ptr<LayoutGenerator> MakeFailedLayoutGenerator(std::string name,
                                                           std::vector<ModelReply> replies) {
  return std::make_unique<FailedGenerator<LayoutGenerator, LayoutRequest, LayoutAnswer>>(
      std::move(name), std::move(replies));
}

std::unique_ptr<EnvironmentGenerator> MakeFailedEnvironmentGenerator(
    std::string name, std::vector<ModelReply> replies) {
  return std::make_unique<
      FailedGenerator<EnvironmentGenerator, EnvironmentRequest, EnvironmentAnswer>>(
      std::move(name), std::move(replies));
}

}  // namespace latticeworld
