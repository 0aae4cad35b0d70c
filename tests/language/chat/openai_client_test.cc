#include "latticeworld/language/chat/openai_client.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "language/chat/misbehaving_server.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

constexpr char kAnswer[] = "Hello, w\xC3\xB6rld";

class OpenAiClientTest : public testing::Test {
 protected:
  OpenAiOptions Options(const std::string& scenario) const {
    OpenAiOptions options;
    options.url = server_.Url(scenario);
    options.model = "tiny";
    options.backoff_s = 0.01;
    return options;
  }

  static std::unique_ptr<OpenAiClient> Make(const OpenAiOptions& options) {
    auto client = MakeOpenAiClient(options);
    EXPECT_TRUE(client.ok()) << client.status().ToString();
    return client.ok() ? std::move(client).value() : nullptr;
  }

  static ChatRequest Hello() {
    ChatRequest request;
    request.messages = {{ChatRole::kUser, "Say hello.", ""}};
    request.seed = 7;
    return request;
  }

  Json LastBody(const std::string& scenario) const {
    const std::vector<Json> requests = server_.Requests(scenario);
    return requests.empty() ? Json() : Json::parse(requests.back().at("body").get<std::string>());
  }

  MisbehavingServer server_;
  Progress progress_;
};

TEST_F(OpenAiClientTest, HandsOnTheWholeReply) {
  const auto client = Make(Options("good"));
  std::vector<std::string> heard;
  const auto reply = client->Complete(
      Hello(),
      [&](std::string_view text) {
        heard.emplace_back(text);
        return true;
      },
      progress_);
  ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  EXPECT_EQ(reply->text, kAnswer);
  EXPECT_EQ(reply->finish_reason, "stop");
  EXPECT_EQ(reply->model, "tiny");
  EXPECT_EQ(reply->prompt_tokens, 11);
  EXPECT_EQ(reply->completion_tokens, 4);
  EXPECT_EQ(reply->retries, 0);
  EXPECT_GT(reply->first_token_s, 0.0);
  EXPECT_GE(reply->total_s, reply->first_token_s);
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.back(), kAnswer);
}

TEST_F(OpenAiClientTest, TheListenerHearsTheTextGrow) {
  const auto client = Make(Options("byte_by_byte"));
  std::vector<std::string> heard;
  const auto reply = client->Complete(
      Hello(),
      [&](std::string_view text) {
        heard.emplace_back(text);
        return true;
      },
      progress_);
  ASSERT_TRUE(reply.ok());
  for (std::size_t i = 1; i < heard.size(); ++i) {
    EXPECT_GT(heard[i].size(), heard[i - 1].size());
    EXPECT_EQ(heard[i].substr(0, heard[i - 1].size()), heard[i - 1]);
  }
  EXPECT_EQ(heard.back(), kAnswer);
}

TEST_F(OpenAiClientTest, TheListenerCutsAnAnswerThatWouldNeverEnd) {
  const auto client = Make(Options("slow_drip"));
  const auto reply = client->Complete(
      Hello(), [](std::string_view text) { return text.size() < 9; }, progress_);
  ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  EXPECT_EQ(reply->finish_reason, "cut");
  EXPECT_EQ(reply->text, "HelHelHel");
}

TEST_F(OpenAiClientTest, AnAnswerThatBrokeIsHeardFromItsStartAgain) {
  const auto client = Make(Options("disconnect_once"));
  std::vector<std::string> heard;
  const auto reply = client->Complete(
      Hello(),
      [&](std::string_view text) {
        heard.emplace_back(text);
        return true;
      },
      progress_);
  ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  EXPECT_EQ(reply->text, kAnswer);
  EXPECT_EQ(reply->retries, 1);
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.front().substr(0, 3), "Hel");
  EXPECT_EQ(heard.back(), kAnswer);
  const ServerStatistics statistics = client->statistics();
  EXPECT_EQ(statistics.requests, 1u);
  EXPECT_EQ(statistics.retries, 1u);
  EXPECT_EQ(statistics.prompt_tokens, 11u);
  EXPECT_EQ(statistics.completion_tokens, 4u);
  EXPECT_GT(statistics.last_total_s, 0.0);
}

TEST_F(OpenAiClientTest, TheLengthLimitIsHandedOn) {
  const auto reply = Make(Options("length"))->Complete(Hello(), nullptr, progress_);
  ASSERT_TRUE(reply.ok());
  EXPECT_EQ(reply->finish_reason, "length");
  EXPECT_EQ(reply->text, "Hel");
}

TEST_F(OpenAiClientTest, CancelEndsEveryKindOfWaiting) {
  using Clock = std::chrono::steady_clock;
  // Far above what it takes on a busy machine, and far below every time limit of the request.
  constexpr std::chrono::seconds kAtOnce(5);
  struct Row {
    std::string scenario;
    std::string url;
    bool lists_models = false;
  };
  const Row rows[] = {{"hang", server_.Url("hang")},
                      {"hang_in_answer", server_.Url("hang_in_answer")},
                      {"slow_drip", server_.Url("slow_drip")},
                      {"hang", server_.Url("hang"), true},
                      {"hang_in_head", server_.Url("hang_in_head")},
                      {"429_too_long", server_.Url("429_too_long")},
                      {"tls_hello", server_.HangingTlsUrl("any")}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.scenario);
    // Nothing but the cancellation could end it before the test's own time limit.
    OpenAiOptions options = Options(row.scenario);
    options.url = row.url;
    options.connect_timeout_s = 600;
    options.first_token_timeout_s = 3600;
    options.total_timeout_s = 7200;
    options.backoff_s = 60;
    if (row.lists_models) options.model.clear();
    const auto client = Make(options);
    Progress progress;
    Status status;
    const auto before = server_.Requests(row.scenario).size();
    const auto closed_before = server_.Closed(row.scenario);
    std::thread caller([&] { status = client->Complete(Hello(), nullptr, progress).status(); });
    while (server_.Requests(row.scenario).size() == before) std::this_thread::yield();
    const auto cancelled = Clock::now();
    progress.Cancel();
    caller.join();
    EXPECT_LT(Clock::now() - cancelled, kAtOnce);
    EXPECT_EQ(status.code(), StatusCode::kCancelled) << status.ToString();
    // The server sees the connection closed while the client lives on.
    while (server_.Closed(row.scenario) == closed_before && Clock::now() < cancelled + kAtOnce) {
      std::this_thread::yield();
    }
    EXPECT_EQ(server_.Closed(row.scenario), closed_before + 1);
    const ServerStatistics statistics = client->statistics();
    EXPECT_EQ(statistics.requests, 1u);
    EXPECT_EQ(statistics.failures, 0u);
    EXPECT_EQ(statistics.last_error, "");
  }
}

TEST_F(OpenAiClientTest, TheNextTryWaitsForAsLongAsTheServerWishes) {
  const auto reply = Make(Options("429_for_a_second"))->Complete(Hello(), nullptr, progress_);
  ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  EXPECT_EQ(reply->retries, 1);
  const std::vector<Json> requests = server_.Requests("429_for_a_second");
  ASSERT_EQ(requests.size(), 2u);
  const double between_s =
      requests[1].at("time_s").get<double>() - requests[0].at("time_s").get<double>();
  EXPECT_GE(between_s, 1.0);
  EXPECT_LT(between_s, 6.0);
}

TEST_F(OpenAiClientTest, ACallThatIsCancelledAlreadyAsksNobody) {
  progress_.Cancel();
  const auto reply = Make(Options("good"))->Complete(Hello(), nullptr, progress_);
  EXPECT_EQ(reply.status().code(), StatusCode::kCancelled);
  EXPECT_TRUE(server_.Requests("good").empty());
}

TEST_F(OpenAiClientTest, WithoutANameTheFirstListedModelIsAskedForOnce) {
  OpenAiOptions options = Options("good");
  options.model.clear();
  const auto client = Make(options);
  for (int i = 0; i < 2; ++i) {
    const auto reply = client->Complete(Hello(), nullptr, progress_);
    ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  }
  const auto requests = server_.Requests("good");
  ASSERT_EQ(requests.size(), 3u);
  EXPECT_EQ(requests[0].at("method"), "GET");
  EXPECT_EQ(requests[0].at("path"), "/good/v1/models");
  EXPECT_EQ(requests[1].at("method"), "POST");
  EXPECT_EQ(requests[2].at("method"), "POST");
  EXPECT_EQ(LastBody("good").at("model"), "tiny");
}

TEST_F(OpenAiClientTest, AModelThatIsGoneIsLookedUpAnew) {
  OpenAiOptions options = Options("404");
  options.model.clear();
  const auto client = Make(options);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(client->Complete(Hello(), nullptr, progress_).status().code(), StatusCode::kNotFound);
  }
  EXPECT_EQ(server_.Requests("404").size(), 4u);
}

TEST_F(OpenAiClientTest, AServerWithoutModelsIsToldOf) {
  OpenAiOptions options = Options("no_models");
  options.model.clear();
  // Its list of models is no success here: the scenario answers both with an empty list.
  const auto reply = Make(options)->Complete(Hello(), nullptr, progress_);
  EXPECT_EQ(reply.status().code(), StatusCode::kNotFound);
  EXPECT_NE(reply.status().message().find("lists no model"), std::string::npos);
}

TEST_F(OpenAiClientTest, TheRequestOnTheWireIsWhatTheDialectPromises) {
  const std::pair<ChatDialect, const char*> rows[] = {{ChatDialect::kLlamaCpp, "grammar"},
                                                      {ChatDialect::kVllm, "response_format"},
                                                      {ChatDialect::kOllama, "response_format"},
                                                      {ChatDialect::kOpenAi, "response_format"},
                                                      {ChatDialect::kNone, nullptr}};
  for (const auto& [dialect, member] : rows) {
    SCOPED_TRACE(NameOf(dialect));
    OpenAiOptions options = Options("good");
    options.dialect = dialect;
    ChatRequest request = Hello();
    request.form = {"layout", "root ::= [A-Z]", "[A-Z]", R"({"type":"object"})"};
    ASSERT_TRUE(Make(options)->Complete(request, nullptr, progress_).ok());
    const Json body = LastBody("good");
    for (const char* each : {"grammar", "json_schema", "structured_outputs", "response_format",
                             "format", "guided_json", "guided_regex", "guided_grammar"}) {
      EXPECT_EQ(body.contains(each), member != nullptr && std::string(each) == member) << each;
    }
    const Json headers = server_.Requests("good").back().at("headers");
    EXPECT_EQ(headers.at("content-type"), "application/json");
    EXPECT_FALSE(headers.contains("expect"));
    EXPECT_FALSE(headers.contains("authorization"));
    EXPECT_FALSE(headers.contains("accept-encoding"));
  }
}

// As of a layout, in a language that takes its schema.
ChatRequest AskedForRows() {
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "Draw.", ""}};
  request.form.name = "rows";
  request.form.json_schema = R"({"type":"object","properties":{"rows":{}},"required":["rows"],)"
                             R"("additionalProperties":false})";
  return request;
}

TEST_F(OpenAiClientTest, AnAnswerInItsFormInThePlaceOfThinkingIsTheAnswer) {
  for (const char* scenario : {"answers_in_thinking", "answers_in_thinking_whole"}) {
    SCOPED_TRACE(scenario);
    OpenAiOptions options = Options(scenario);
    options.dialect = ChatDialect::kLlamaCpp;
    std::string heard;
    const auto reply = Make(options)->Complete(
        AskedForRows(), [&heard](std::string_view text) { return !(heard = text).empty(); },
        progress_);
    ASSERT_TRUE(reply.ok()) << reply.status().ToString();
    EXPECT_EQ(reply->text, R"({"rows": ["A"]})");
    EXPECT_EQ(heard, reply->text);
    EXPECT_EQ(reply->form, FormLanguage::kJsonSchema);
  }
}

TEST_F(OpenAiClientTest, AMatrixInThePlaceOfThinkingIsHeldToItsGrammar) {
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "Draw.", ""}};
  OpenAiOptions options = Options("answers_matrix_in_thinking");
  options.dialect = ChatDialect::kLlamaCpp;
  for (const std::string letters : {"FW", "FX"}) {
    const std::string row = "[" + letters + "]{32}";
    request.form = {"layout", "root ::= line{31} row", "(" + row + "\\n){31}" + row, "{}"};
    const auto reply = Make(options)->Complete(request, nullptr, progress_);
    ASSERT_TRUE(reply.ok()) << reply.status().ToString();
    EXPECT_EQ(reply->form, FormLanguage::kGbnf);
    const bool is_in_form = letters == "FW";
    EXPECT_EQ(reply->text.size(), is_in_form ? 32u * 33u - 1u : 1u) << reply->text;
  }
}

TEST_F(OpenAiClientTest, ThinkingIsNeverAnAnswerWhereItIsNotInTheFormOrNoneWasTold) {
  for (const auto& [scenario, dialect] :
       {std::pair<const char*, ChatDialect>{"only_thinks", ChatDialect::kLlamaCpp},
        std::pair<const char*, ChatDialect>{"cut_in_thinking", ChatDialect::kVllm},
        std::pair<const char*, ChatDialect>{"answers_in_thinking", ChatDialect::kNone}}) {
    SCOPED_TRACE(scenario);
    OpenAiOptions options = Options(scenario);
    options.dialect = dialect;
    const auto reply = Make(options)->Complete(AskedForRows(), nullptr, progress_);
    ASSERT_TRUE(reply.ok()) << reply.status().ToString();
    EXPECT_EQ(reply->text.find_first_not_of('\n'), std::string::npos) << reply->text;
    EXPECT_NE(reply->thinking, "");
  }
}

TEST_F(OpenAiClientTest, AReplyThatCountsTooFewTokensWarnsOfACutPrompt) {
  ChatRequest request = Hello();
  const auto client = Make(Options("good"));  // counts 11 tokens whatever it is sent
  const auto small = client->Complete(request, nullptr, progress_);
  ASSERT_TRUE(small.ok()) << small.status().ToString();
  EXPECT_TRUE(small->warnings.empty());
  request.messages[0].text = std::string(400, 'x');
  const auto large = client->Complete(request, nullptr, progress_);
  ASSERT_TRUE(large.ok()) << large.status().ToString();
  ASSERT_EQ(large->warnings.size(), 1u);
  EXPECT_NE(large->warnings[0].find("cut the prompt"), std::string::npos) << large->warnings[0];
}

TEST_F(OpenAiClientTest, ALongRequestIsSentWithoutWaitingForLeave) {
  ChatRequest request = Hello();
  request.messages[0].text = std::string(3 << 20, 'x');
  ASSERT_TRUE(Make(Options("good"))->Complete(request, nullptr, progress_).ok());
  EXPECT_FALSE(server_.Requests("good").back().at("headers").contains("expect"));
  EXPECT_EQ(LastBody("good").at("messages")[0].at("content"), request.messages[0].text);
}

TEST_F(OpenAiClientTest, MembersThatAServerRefusesAreLeftOutFromThenOn) {
  for (const auto& [scenario, first_requests] :
       {std::pair<const char*, std::size_t>{"wants_max_completion_tokens", 2},
        std::pair<const char*, std::size_t>{"knows_few_members", 4}}) {
    SCOPED_TRACE(scenario);
    const auto client = Make(Options(scenario));
    const auto reply = client->Complete(Hello(), nullptr, progress_);
    ASSERT_TRUE(reply.ok()) << reply.status().ToString();
    EXPECT_EQ(reply->retries, 0);  // the server was not at fault
    EXPECT_EQ(server_.Requests(scenario).size(), first_requests);
    ASSERT_TRUE(client->Complete(Hello(), nullptr, progress_).ok());
    EXPECT_EQ(server_.Requests(scenario).size(), first_requests + 1);
  }
}

TEST_F(OpenAiClientTest, TheKeyIsReadAtEachRequestAndStandsInItsHeaderAlone) {
  constexpr char kVariable[] = "LATTICEWORLD_TEST_CLIENT_KEY";
  OpenAiOptions options = Options("good");
  options.api_key_variable = kVariable;
  const auto client = Make(options);
  unsetenv(kVariable);
  EXPECT_EQ(client->Complete(Hello(), nullptr, progress_).status().code(),
            StatusCode::kUnauthenticated);
  EXPECT_TRUE(server_.Requests("good").empty());
  for (const char* key : {"sk-first-secret", "sk-second-secret"}) {
    ASSERT_EQ(setenv(kVariable, (std::string(key) + "\n").c_str(), 1), 0);
    ASSERT_TRUE(client->Complete(Hello(), nullptr, progress_).ok());
    const Json request = server_.Requests("good").back();
    EXPECT_EQ(request.at("headers").at("authorization"), "Bearer " + std::string(key));
    EXPECT_EQ(request.at("body").get<std::string>().find("secret"), std::string::npos);
    EXPECT_EQ(request.at("path").get<std::string>().find("secret"), std::string::npos);
  }
}

TEST_F(OpenAiClientTest, NoProxyStandsBeforeLoopback) {
  ASSERT_EQ(setenv("http_proxy", server_.RefusingUrl().c_str(), 1), 0);
  const auto reply = Make(Options("good"))->Complete(Hello(), nullptr, progress_);
  unsetenv("http_proxy");
  EXPECT_TRUE(reply.ok()) << reply.status().ToString();
}

TEST_F(OpenAiClientTest, ServesSeveralThreadsAtOnce) {
  OpenAiOptions options = Options("good");
  options.model.clear();
  const auto client = Make(options);
  constexpr int kThreads = 8;
  std::vector<std::string> texts(kThreads);
  std::vector<std::thread> threads;
  for (std::string& text : texts) {
    threads.emplace_back([&client, &text] {
      const Progress progress;
      const auto reply = client->Complete(Hello(), nullptr, progress);
      text = reply.ok() ? reply->text : reply.status().ToString();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : texts) EXPECT_EQ(text, kAnswer);
  EXPECT_EQ(client->statistics().requests, static_cast<std::uint64_t>(kThreads));
  EXPECT_EQ(client->statistics().completion_tokens, 4u * kThreads);
}

TEST_F(OpenAiClientTest, ARequestThatCannotBeSaidAsksNobody) {
  const auto reply = Make(Options("good"))->Complete({}, nullptr, progress_);
  EXPECT_EQ(reply.status().code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(server_.Requests("good").empty());
}

TEST_F(OpenAiClientTest, MessagesNameTheServer) {
  const auto reply = Make(Options("404"))->Complete(Hello(), nullptr, progress_);
  EXPECT_EQ(reply.status().message().find("chat server " + server_.Url("404") + ": HTTP 404"), 0u)
      << reply.status().message();
}

}  // namespace
}  // namespace latticeworld
