#include "latticeworld/language/chat/openai_client.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/chat/api_key.h"
#include "latticeworld/language/chat/call_clock.h"
#include "latticeworld/language/chat/cut_prompt.h"
#include "latticeworld/language/chat/failure.h"
#include "latticeworld/language/chat/kept_form.h"
#include "latticeworld/language/chat/model_list.h"
#include "latticeworld/language/chat/request_body.h"
#include "latticeworld/language/chat/retry_policy.h"
#include "latticeworld/language/chat/server_try.h"
#include "latticeworld/language/chat/server_url.h"

namespace latticeworld {
namespace {

// The tries of one call, those for the list of models included.
class Tries {
 public:
  Tries(const OpenAiOptions& options, const CallClock& clock, std::uint64_t seed)
      : options_(options), clock_(clock), policy_(options.backoff_s, seed) {}

  int retries() const { return retries_; }

  // Repeats `attempt` until it succeeds, fails for good, or no time or number of tries is left.
  Status Run(const std::function<Failure()>& attempt) {
    while (true) {
      const Failure failure = attempt();
      if (failure.ok()) return Status();
      if (clock_.cancelled()) return Cancelled("cancelled by the caller");
      if (!failure.again) return failure.status;
      if (retries_ == options_.max_retries) {
        return GiveUp(failure.status, "gave up after " + std::to_string(retries_ + 1) +
                                          (retries_ == 0 ? " try" : " tries"));
      }
      const double wait_s = policy_.WaitSeconds(retries_, failure.retry_after_s);
      if (wait_s >= clock_.left_s()) {
        return GiveUp(failure.status, "the next try is due in " +
                                          FormatDouble(std::round(wait_s * 1e3) / 1e3) +
                                          " s, which is beyond the total timeout of " +
                                          FormatDouble(options_.total_timeout_s) + " s");
      }
      clock_.Wait(wait_s);
      if (clock_.cancelled()) return Cancelled("cancelled by the caller");
      ++retries_;
    }
  }

 private:
  static Status GiveUp(const Status& last, const std::string& why) {
    return Status(last.code(), last.message() + "; " + why);
  }

  const OpenAiOptions& options_;
  const CallClock& clock_;
  RetryPolicy policy_;
  int retries_ = 0;
};

// If a form holds from the first letter on, a thinking model cannot write the end of its thinking,
// so that some servers take the whole answer for that. What is thinking in earnest is not in the
// form as a whole.
void TakeAnswerFromThinking(const AnswerForm& form, const AnswerListener& listener,
                            ChatReply* reply) {
  if (reply->text.find_first_not_of(" \t\r\n") != std::string::npos) return;
  if (KeepsForm(reply->thinking, /*whole=*/true, form, reply->form) != KeptForm::kYes) return;
  reply->text = reply->thinking;
  if (listener) listener(reply->text);
}

class CurlOpenAiClient : public OpenAiClient {
 public:
  CurlOpenAiClient(OpenAiOptions options, ServerUrl url)
      : options_(std::move(options)), url_(std::move(url)) {}

  bool sees() const override { return options_.sees; }

  Result<ChatReply> Complete(const ChatRequest& request, const AnswerListener& listener,
                             const Progress& progress) override {
    const CallClock clock(options_.total_timeout_s, progress);
    Tries tries(options_, clock, request.seed);
    Result<ChatReply> reply = Answer(request, listener, clock, &tries);
    const double total_s = clock.elapsed_s();
    if (reply.ok()) {
      reply->retries = tries.retries();
      reply->total_s = total_s;
    } else {
      reply = reply.status().WithContext("chat server " + url_.base);
    }
    Count(reply, tries.retries(), total_s);
    return reply;
  }

  ServerStatistics statistics() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return statistics_;
  }

 private:
  Result<ChatReply> Answer(const ChatRequest& request, const AnswerListener& listener,
                           const CallClock& clock, Tries* tries) {
    if (clock.cancelled()) return Cancelled("cancelled by the caller");
    LW_ASSIGN_OR_RETURN(const ApiKey key, ApiKey::FromEnvironment(options_.api_key_variable));
    const TryContext context{options_, key, clock, url_.is_loopback};
    LW_ASSIGN_OR_RETURN(const std::string model, ModelName(context, tries));
    ChatReply reply;
    const Status status =
        tries->Run([&] { return AskAsAccepted(request, model, context, listener, &reply); });
    if (status.code() == StatusCode::kNotFound) ForgetModel();
    if (!status.ok()) return status;
    reply.form = FormLanguageOf(request.form, options_.dialect);
    TakeAnswerFromThinking(request.form, listener, &reply);
    const std::string cut = CutPromptWarning(request, reply.prompt_tokens);
    if (!cut.empty()) reply.warnings.push_back(cut);
    if (reply.model.empty()) reply.model = model;
    return reply;
  }

  // One try; said once more for each member that the server refuses.
  Failure AskAsAccepted(const ChatRequest& request, const std::string& model,
                        const TryContext& context, const AnswerListener& listener,
                        ChatReply* reply) {
    AcceptedMembers accepted = Accepted();
    while (true) {
      const Result<std::string> body = CompletionBody(request, model, options_, accepted);
      if (!body.ok()) return Failure::Final(body.status());
      ErrorBody refusal;
      Failure failure =
          AskOnce(context, url_.base + "/chat/completions", *body, listener, reply, &refusal);
      if (failure.ok() || !NoteRefusal(refusal, &accepted)) return failure;
      Accept(accepted);
    }
  }

  // The model that was named, or the first that the server lists and that seems to answer.
  Result<std::string> ModelName(const TryContext& context, Tries* tries) {
    if (!options_.model.empty()) return options_.model;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!first_model_.empty()) return first_model_;
    }
    std::string list;
    LW_RETURN_IF_ERROR(tries->Run([&] { return FetchOnce(context, url_.base + "/models", &list); })
                           .WithContext("the list of models, as none is named"));
    std::string first = FirstModel(list);
    if (first.empty() || context.key.IsGivenAwayBy(first)) {
      return NotFound("the server lists no model, and none is named");
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    first_model_ = first;
    return first;
  }

  // The server may have been started anew with another one.
  void ForgetModel() {
    const std::lock_guard<std::mutex> lock(mutex_);
    first_model_.clear();
  }

  AcceptedMembers Accepted() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return accepted_;
  }

  void Accept(const AcceptedMembers& accepted) {
    const std::lock_guard<std::mutex> lock(mutex_);
    accepted_ = accepted;
  }

  void Count(const Result<ChatReply>& reply, int retries, double total_s) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++statistics_.requests;
    statistics_.retries += static_cast<std::uint64_t>(retries);
    statistics_.last_total_s = total_s;
    if (reply.ok()) {
      statistics_.prompt_tokens += static_cast<std::uint64_t>(reply->prompt_tokens);
      statistics_.completion_tokens += static_cast<std::uint64_t>(reply->completion_tokens);
      statistics_.last_first_token_s = reply->first_token_s;
      statistics_.last_error.clear();
    } else if (reply.status().code() != StatusCode::kCancelled) {
      ++statistics_.failures;
      statistics_.last_error = reply.status().ToString();
    }
  }

  const OpenAiOptions options_;
  const ServerUrl url_;
  mutable std::mutex mutex_;  // over what follows
  std::string first_model_;
  AcceptedMembers accepted_;
  ServerStatistics statistics_;
};

}  // namespace

Result<std::unique_ptr<OpenAiClient>> MakeOpenAiClient(const OpenAiOptions& options) {
  LW_RETURN_IF_ERROR(Status::FromViolations("chat server", Validate(options)));
  LW_ASSIGN_OR_RETURN(ServerUrl url, ParseServerUrl(options.url));
  return std::unique_ptr<OpenAiClient>(std::make_unique<CurlOpenAiClient>(options, std::move(url)));
}

}  // namespace latticeworld
