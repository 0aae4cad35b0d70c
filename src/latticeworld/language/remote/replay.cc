#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

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
    // For its progress; the reply stays as long as it was recorded, whatever the listener wants.
    listener(reply.text);
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

}  // namespace

std::shared_ptr<ChatServer> MakeReplayServer(std::vector<ModelReply> replies) {
  return std::make_shared<ReplayServer>(std::move(replies));
}

}  // namespace latticeworld
