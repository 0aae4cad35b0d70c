// What becomes of a request when the server, or what is between, goes wrong: each row is one fault,
// and ends in its status within its time limit, which is measured. A row without one has nothing to
// wait for, and ends at once.

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "language/chat/misbehaving_server.h"
#include "latticeworld/language/chat/openai_client.h"

namespace latticeworld {
namespace {

constexpr char kVariable[] = "LATTICEWORLD_TEST_FAULT_KEY";
constexpr char kKey[] = "sk-test-0123456789";
constexpr char kAnswer[] = "Hello, w\xC3\xB6rld";

constexpr int kAny = -1;

constexpr int kRetries = 2;
constexpr double kBackoff_s = 0.01;
// What a busy machine may take beyond a time limit; far below the timeouts that a row does not set.
constexpr double kSlack_s = 5.0;

using Setter = std::function<void(OpenAiOptions*)>;

// What a row asks of the options, and when it has ended then.
struct Limits {
  double end_s = 0.0;  // of the whole request, with every try and wait
  Setter set = [](OpenAiOptions*) {};
};

Limits Within(double end_s, Setter set) { return {end_s, std::move(set)}; }
Limits AtOnce(Setter set) { return Within(0.0, std::move(set)); }
Limits FirstToken(double seconds) {
  return Within(seconds, [=](OpenAiOptions* options) { options->first_token_timeout_s = seconds; });
}
Limits Total(double seconds) {
  return Within(seconds, [=](OpenAiOptions* options) { options->total_timeout_s = seconds; });
}
// Tried again each time, after waits that double.
Limits Connect(double seconds) {
  return Within((1 + kRetries) * seconds + ((1 << kRetries) - 1) * kBackoff_s,
                [=](OpenAiOptions* options) { options->connect_timeout_s = seconds; });
}

struct Fault {
  std::string scenario;  // of misbehaving_server.py
  StatusCode code;       // kOk: it is answered after all
  std::string says;      // the message holds this
  int requests;          // that the server got; kAny: it cannot count them
  Limits limits = {};
};

class FaultTableTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    ASSERT_EQ(setenv(kVariable, kKey, 1), 0);
    server_ = std::make_unique<MisbehavingServer>();
  }
  static void TearDownTestSuite() { server_.reset(); }

  static OpenAiOptions Options(const std::string& url) {
    OpenAiOptions options;
    options.url = url;
    options.model = "tiny";
    options.api_key_variable = kVariable;
    options.first_token_timeout_s = 60;
    options.total_timeout_s = 60;
    options.max_retries = kRetries;
    options.backoff_s = kBackoff_s;
    options.max_answer_bytes = 1 << 18;
    return options;
  }

  static void Check(const Fault& fault, const std::string& url,
                    const std::string& text = "Say hello.") {
    SCOPED_TRACE(fault.scenario);
    OpenAiOptions options = Options(url);
    fault.limits.set(&options);
    const auto client = MakeOpenAiClient(options);
    ASSERT_TRUE(client.ok()) << client.status().ToString();
    ChatRequest request;
    request.messages = {{ChatRole::kUser, text, ""}};
    const Progress progress;
    const auto begin = std::chrono::steady_clock::now();
    const Result<ChatReply> reply = (*client)->Complete(request, nullptr, progress);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(taken.count(), fault.limits.end_s + kSlack_s)
        << "its limit is " << fault.limits.end_s;
    EXPECT_EQ(reply.status().code(), fault.code) << reply.status().ToString();
    EXPECT_NE(reply.status().message().find(fault.says), std::string::npos)
        << reply.status().message();
    if (reply.ok()) {
      EXPECT_EQ(reply->text, kAnswer);
    }
    if (fault.requests != kAny) {
      EXPECT_EQ(server_->Requests(fault.scenario).size(), static_cast<std::size_t>(fault.requests));
    }
    const ServerStatistics statistics = (*client)->statistics();
    EXPECT_EQ(statistics.failures, reply.ok() ? 0u : 1u);
    EXPECT_EQ(statistics.last_error, reply.ok() ? "" : reply.status().ToString());
    EXPECT_EQ(reply.status().ToString().find(kKey), std::string::npos)
        << "the key is in: " << reply.status().ToString();
  }

  static void CheckAll(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) Check(fault, server_->Url(fault.scenario));
  }

  static std::unique_ptr<MisbehavingServer> server_;
};

std::unique_ptr<MisbehavingServer> FaultTableTest::server_;

TEST_F(FaultTableTest, Connection) {
  Check({"any", StatusCode::kUnavailable, "no connection: ", 0}, server_->RefusingUrl());
  Check({"any", StatusCode::kUnavailable, "gave up after 3 tries", 0}, server_->RefusingUrl());
  Check({"any", StatusCode::kUnavailable, "no connection: ", 0},
        "http://" + std::string(70, 'x') + ".invalid/v1");  // no name, not even to ask for
  CheckAll({
      {"disconnect_before", StatusCode::kUnavailable, "the connection broke", 3},
      {"disconnect_in_stream", StatusCode::kUnavailable, "the connection broke", 3},
      {"disconnect_after_end", StatusCode::kOk, "", 1},
      {"disconnect_once", StatusCode::kOk, "", 2},
      {"half_json", StatusCode::kUnavailable, "the connection broke", 3},
      {"half_json_no_length", StatusCode::kUnavailable, "in the middle of the answer", 3},
      {"bad_chunks", StatusCode::kUnavailable, "the connection broke", 3},
  });
}

TEST_F(FaultTableTest, ConnectionThatClosesBeforeTheWholeRequestCame) {
  const std::string long_text(3 << 20, 'x');
  const Fault fault = {"closes_early", StatusCode::kUnavailable, "the connection broke", kAny};
  Check(fault, server_->Url("closes_early"), long_text);
  const Fault over_tls = {
      "closes_early", StatusCode::kUnavailable, "the connection broke", kAny,
      AtOnce([](OpenAiOptions* options) { options->ca_file = server_->certificate(); })};
  Check(over_tls, server_->TlsUrl("closes_early"), long_text);
}

TEST_F(FaultTableTest, Time) {
  const Limits all_but_total = Within(0.2, [](OpenAiOptions* options) {
    options->connect_timeout_s = 60;
    options->total_timeout_s = 0.2;
  });
  const StatusCode late = StatusCode::kDeadlineExceeded;
  CheckAll({
      {"hang", late, "no token of an answer within 0.2 s (first-token timeout)", 1,
       FirstToken(0.2)},
      {"hang_in_head", late, "(first-token timeout)", 1, FirstToken(0.2)},
      {"slow_comments", late, "(first-token timeout)", 1, FirstToken(0.2)},
      {"hang_in_answer", late, "not complete after 0.2 s (total timeout)", 1, Total(0.2)},
      {"hang_after_token", late, "(total timeout)", 1,
       Within(1.0,
              [](OpenAiOptions* options) {
                options->first_token_timeout_s = 0.7;
                options->total_timeout_s = 1.0;
              })},
      {"slow_drip", late, "(total timeout)", 1, Total(0.2)},
      {"503_for_long", StatusCode::kUnavailable, "beyond the total timeout of 0.2 s", kAny,
       Within(0.2,
              [](OpenAiOptions* options) {
                options->total_timeout_s = 0.2;
                options->max_retries = 20;
              })},
      {"504", late, "upstream timed out", 1},
  });
  Check({"hang_tls", late, "no connection within 0.1 s (connect timeout); gave up after 3 tries", 0,
         Connect(0.1)},
        server_->HangingTlsUrl("hang_tls"));
  Check({"hang_tls", late, "(total timeout)", 0, all_but_total},
        server_->HangingTlsUrl("hang_tls"));
  // The server has said all and leaves the connection open: that is an answer, after a second in
  // which more might have come.
  CheckAll({{"no_end_mark", StatusCode::kOk, "", 1,
             Within(1.0, [](OpenAiOptions* options) { options->total_timeout_s = 7200; })}});
}

TEST_F(FaultTableTest, Content) {
  CheckAll({
      {"garbage", StatusCode::kInternal, "does not speak HTTP", 1},
      {"no_status", StatusCode::kInternal, "does not speak HTTP: \"its first line has no status\"",
       1},
      {"garbage_body", StatusCode::kDataLoss, "no chat completion", 1},
      {"garbage_event", StatusCode::kDataLoss, "\"not JSON\"", 1},
      {"bad_utf8", StatusCode::kDataLoss, "\\xff\\xfe", 1},
      {"html", StatusCode::kDataLoss, "Content-Type \"text/html\"", 1},
      {"wrong_content_type", StatusCode::kOk, "", 1},
      {"no_content_type", StatusCode::kOk, "", 1},
      {"other_json", StatusCode::kDataLoss, "no choices[0].message", 1},
      {"empty_body", StatusCode::kDataLoss, "an empty body", 1},
      {"huge_json", StatusCode::kResourceExhausted, "at most 262144 bytes", 1},
      {"huge_stream", StatusCode::kResourceExhausted, "at most 262144 bytes", 1},
      {"endless_line", StatusCode::kResourceExhausted, "at most 262144 bytes", 1},
      {"header_flood", StatusCode::kResourceExhausted, "65536 of header", 1},
      {"endless_header", StatusCode::kResourceExhausted, "65536 of header", 1},
      {"error_in_stream", StatusCode::kInternal, "(\"server_error\"): \"out of memory\"", 1},
      {"overload_in_stream", StatusCode::kOk, "", 2},
      {"error_in_200", StatusCode::kInternal, "no such model", 1},
      {"refusal", StatusCode::kInvalidArgument, "I will not draw that", 1},
      {"echoes_key_as_answer", StatusCode::kDataLoss, "repeats the key", 1},
      {"not_a_stream", StatusCode::kOk, "", 1},
      {"byte_by_byte", StatusCode::kOk, "", 1},
      {"thinks_aloud", StatusCode::kOk, "", 1},
      {"interim", StatusCode::kOk, "", 1},
      {"interim_misleads", StatusCode::kOk, "", 2},
  });
}

TEST_F(FaultTableTest, HttpStatus) {
  CheckAll({
      {"400", StatusCode::kInvalidArgument, "HTTP 400 (\"invalid_request_error\"): \"Failed to", 1},
      {"401", StatusCode::kUnauthenticated, "Incorrect API key provided: Bearer [key]", 1},
      {"401_hang", StatusCode::kUnauthenticated, "wrong key", 1, FirstToken(0.2)},
      {"403", StatusCode::kPermissionDenied, "HTTP 403: \"Not your model\"", 1},
      {"404", StatusCode::kNotFound, "The model `tiny` does not exist.", 1},
      {"422", StatusCode::kInvalidArgument, "body.messages.0: field required", 1},
      {"429_then_good", StatusCode::kOk, "", 2},
      {"429_date_then_good", StatusCode::kOk, "", 2},
      {"429_too_long", StatusCode::kUnavailable,
       "the next try is due in 3600 s, which is beyond the total timeout of 60 s", 1},
      {"429_date_too_long", StatusCode::kUnavailable, "the next try is due in 3600 s", 1},
      {"429_quota", StatusCode::kUnavailable, "(\"insufficient_quota\")", 1},
      {"500_empty", StatusCode::kInternal, "HTTP 500 without a message", 1},
      {"500_no_body", StatusCode::kInternal, "HTTP 500 without a message", 1},
      {"500_huge", StatusCode::kInternal, "HTTP 500: \"no no", 1},
      {"500_beyond_limit", StatusCode::kInternal, "HTTP 500: \"no no", 1,
       AtOnce([](OpenAiOptions* options) { options->max_answer_bytes = 1024; })},
      {"502_html", StatusCode::kUnavailable, "titled 502 Bad Gateway", 3},
      {"503_then_good", StatusCode::kOk, "", 3},
      {"503", StatusCode::kUnavailable, "\"Loading model\"; gave up after 3 tries", 3},
      {"503_in_time", StatusCode::kUnavailable, "beyond the total timeout of 20 s", 1,
       AtOnce([](OpenAiOptions* options) {
         options->backoff_s = 60;
         options->total_timeout_s = 20;
       })},
      {"redirect", StatusCode::kNotFound, "HTTP 307 sends on to \"http://127.0.0.1:", 1},
  });
  EXPECT_TRUE(server_->Requests("collector").empty()) << "a redirect was followed";
}

TEST_F(FaultTableTest, Certificate) {
  const auto trusting = [](std::string ca_file) {
    return AtOnce([=](OpenAiOptions* options) { options->ca_file = ca_file; });
  };
  const std::string refused = "certificate is not trusted";
  Check({"good", StatusCode::kUnavailable, refused, 0}, server_->TlsUrl("good"));
  Check({"good", StatusCode::kUnavailable, refused, 0, trusting(server_->foreign_certificate())},
        server_->TlsUrl("good"));
  Check({"good", StatusCode::kUnavailable, refused, 0, trusting(server_->foreign_certificate())},
        server_->ForeignTlsUrl("good"));  // trusted, and made out to another host
  Check({"good", StatusCode::kUnavailable, "certificate has expired", 0,
         trusting(server_->expired_certificate())},
        server_->ExpiredTlsUrl("good"));
  Check({"good", StatusCode::kOk, "", 1, trusting(server_->certificate())},
        server_->TlsUrl("good"));
}

}  // namespace
}  // namespace latticeworld
