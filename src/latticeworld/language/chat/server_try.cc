#include "latticeworld/language/chat/server_try.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/chat/http_exchange.h"
#include "latticeworld/language/chat/retry_policy.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxErrorBytes = 64 << 10;  // that are read of an error's body

bool IsSuccess(int http_status) { return http_status >= 200 && http_status < 300; }

std::string Seconds(double seconds) { return FormatDouble(seconds) + " s"; }

// Watches the time limits of one try and keeps the body of an answer that is no success.
class TryHandler : public HttpHandler {
 public:
  explicit TryHandler(const TryContext& context)
      : context_(context), begin_s_(context.clock.elapsed_s()) {}

  bool OnBody(const HttpHead& head, std::string_view bytes) final {
    if (IsSuccess(head.status)) return OnAnswer(bytes);
    error_body_ += bytes.substr(0, kMaxErrorBytes - error_body_.size());
    return error_body_.size() < kMaxErrorBytes;
  }

  bool Interrupted() final {
    const CallClock& clock = context_.clock;
    if (clock.cancelled()) {
      interruption_ = Cancelled("cancelled by the caller");
    } else if (clock.left_s() <= 0) {
      interruption_ =
          Status(StatusCode::kDeadlineExceeded, "the answer was not complete after " +
                                                    Seconds(clock.total_s()) + " (total timeout)");
    } else if (!spoken() && try_s() > context_.options.first_token_timeout_s) {
      interruption_ =
          Status(StatusCode::kDeadlineExceeded,
                 "no token of an answer within " + Seconds(context_.options.first_token_timeout_s) +
                     " (first-token timeout)");
    } else {
      return EnoughWaited();
    }
    return true;
  }

  // Returns the time since the try began [s].
  double try_s() const { return context_.clock.elapsed_s() - begin_s_; }
  // Why the handler interrupted the exchange; OK: it had waited enough for what is not needed.
  const Status& interruption() const { return interruption_; }
  const std::string& error_body() const { return error_body_; }

 protected:
  virtual bool OnAnswer(std::string_view bytes) = 0;
  virtual bool spoken() const = 0;
  virtual bool EnoughWaited() { return false; }

  const TryContext& context_;

 private:
  double begin_s_;
  Status interruption_;
  std::string error_body_;
};

class FetchHandler : public TryHandler {
 public:
  FetchHandler(const TryContext& context, std::string* answer)
      : TryHandler(context), answer_(answer) {}

 protected:
  bool OnAnswer(std::string_view bytes) override {
    *answer_ += bytes;
    return true;
  }
  bool spoken() const override { return !answer_->empty(); }

 private:
  std::string* answer_;
};

class AnswerHandler : public TryHandler {
 public:
  AnswerHandler(const TryContext& context, const AnswerListener& listener)
      : TryHandler(context), reader_(&context.key), listener_(listener) {}

  // The end of the answer, told to the listener. To be called once the exchange is over.
  Failure Finish(std::string_view content_type) {
    if (cut_) return {};
    Failure failure = reader_.Finish(content_type);
    if (failure.ok()) Tell();
    return failure;
  }

  bool cut() const { return cut_; }
  bool finished() const { return reader_.finished(); }
  double first_token_s() const { return first_token_s_.value_or(0.0); }
  const Completion& completion() const { return reader_.completion(); }

 protected:
  bool OnAnswer(std::string_view bytes) override {
    const bool more = reader_.Feed(bytes);
    if (!first_token_s_ && reader_.spoken()) first_token_s_ = try_s();
    return Tell() && more;
  }
  bool spoken() const override { return reader_.spoken(); }

  // After the reason of its end only the count of tokens and the end mark may come, and some
  // servers send neither and leave the connection open.
  bool EnoughWaited() override {
    constexpr double kLongestEndS = 1.0;
    if (!reader_.finished()) return false;
    if (!finished_s_) finished_s_ = try_s();
    return try_s() > *finished_s_ + kLongestEndS;
  }

 private:
  bool Tell() {
    const std::string& text = reader_.completion().text;
    if (text.size() > told_bytes_ && listener_ && !cut_) {
      told_bytes_ = text.size();
      cut_ = !listener_(text);
    }
    return !cut_;
  }

  CompletionReader reader_;
  const AnswerListener& listener_;
  std::size_t told_bytes_ = 0;
  bool cut_ = false;
  std::optional<double> first_token_s_;
  std::optional<double> finished_s_;
};

HttpRequest MakeRequest(const TryContext& context, const std::string& url) {
  HttpRequest request;
  request.url = url;
  request.key = context.key.value();
  request.ca_file = context.options.ca_file;
  request.is_loopback = context.is_loopback;
  request.connect_timeout_s =
      std::min(context.options.connect_timeout_s, std::max(0.0, context.clock.left_s()));
  request.max_body_bytes = context.options.max_answer_bytes;
  return request;
}

// The failure of the transport, or of an answer that is no success; OK: a 2xx answer came whole, or
// as much of it as the handler wanted.
Failure TransportFailure(const TryContext& context, const HttpResult& result,
                         const TryHandler& handler) {
  const std::string detail = Quote(context.key.Scrub(result.detail), 200);
  // Failures of the transport are told first, unless the server's own answer says more.
  switch (result.end) {
    case HttpEnd::kInterrupted:
      // A server that fails and then hangs has said more than that it is late.
      if (handler.interruption().code() == StatusCode::kDeadlineExceeded &&
          result.head.status >= 400) {
        break;
      }
      return Failure::Final(handler.interruption());
    case HttpEnd::kConnectTimeout:
      if (context.clock.left_s() <= 0) {
        return Failure::Final(
            Status(StatusCode::kDeadlineExceeded, "no connection before the " +
                                                      Seconds(context.clock.total_s()) +
                                                      " were over (total timeout)"));
      }
      return Failure::Passing(
          Status(StatusCode::kDeadlineExceeded, "no connection within " +
                                                    Seconds(context.options.connect_timeout_s) +
                                                    " (connect timeout)"));
    case HttpEnd::kNoConnection:
      return Failure::Passing(Unavailable("no connection: " + detail));
    case HttpEnd::kUntrusted:
      return Failure::Final(Unavailable("the server's certificate is not trusted: " + detail));
    case HttpEnd::kBroken:
      if (IsSuccess(result.head.status) || result.head.status == 0) {
        return Failure::Passing(Unavailable("the connection broke: " + detail));
      }
      break;
    case HttpEnd::kNotHttp:
      return Failure::Final(Internal("what answers does not speak HTTP: " + detail));
    case HttpEnd::kTooLarge:
      if (!handler.error_body().empty()) break;
      return Failure::Final(ResourceExhausted("the answer is too large: at most " +
                                              std::to_string(context.options.max_answer_bytes) +
                                              " bytes of body and 65536 of header are read"));
    case HttpEnd::kStopped:
    case HttpEnd::kComplete:
      break;
  }
  // The answer's status decides the rest.
  const int status = result.head.status;
  if (IsSuccess(status)) return {};
  if (status >= 300 && status < 400) {
    return Failure::Final(NotFound("HTTP " + std::to_string(status) + " sends on to " +
                                   Quote(context.key.Scrub(result.head.location), 200) +
                                   ", which is not followed: set the url to where the server is"));
  }
  Failure failure = FailureOf(status, ParseErrorBody(handler.error_body()), context.key);
  failure.retry_after_s = ParseRetryAfter(result.head.retry_after, result.head.date);
  return failure;
}

}  // namespace

Failure FetchOnce(const TryContext& context, const std::string& url, std::string* answer) {
  answer->clear();
  FetchHandler handler(context, answer);
  const HttpResult result = Exchange(MakeRequest(context, url), &handler);
  return TransportFailure(context, result, handler);
}

Failure AskOnce(const TryContext& context, const std::string& url, const std::string& body,
                const AnswerListener& listener, ChatReply* reply, ErrorBody* refusal) {
  HttpRequest request = MakeRequest(context, url);
  request.body = body;
  AnswerHandler handler(context, listener);
  const HttpResult result = Exchange(request, &handler);
  Failure failure = TransportFailure(context, result, handler);
  if (result.head.status == 400 || result.head.status == 422) {
    *refusal = ParseErrorBody(handler.error_body());
  }
  // Once the server has said why it stopped, the answer is whole, however the connection ends.
  const bool whole = handler.finished() && failure.status.code() != StatusCode::kCancelled;
  if (failure.ok() || whole) failure = handler.Finish(result.head.content_type);
  if (!failure.ok()) return failure;
  const Completion& completion = handler.completion();
  for (const std::string& said :
       {completion.text, completion.thinking, completion.model, completion.finish_reason}) {
    if (!context.key.IsGivenAwayBy(said)) continue;
    return Failure::Final(DataLoss("the answer repeats the key that came with the request"));
  }
  reply->text = completion.text;
  reply->thinking = completion.thinking;
  reply->finish_reason = handler.cut() ? "cut" : completion.finish_reason;
  reply->model = completion.model;
  reply->prompt_tokens = completion.prompt_tokens;
  reply->completion_tokens = completion.completion_tokens;
  reply->first_token_s = handler.first_token_s();
  return {};
}

}  // namespace latticeworld
