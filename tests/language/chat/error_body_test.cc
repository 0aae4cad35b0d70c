#include "latticeworld/language/chat/error_body.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace latticeworld {
namespace {

TEST(ErrorBodyTest, ReadsEveryKnownShape) {
  struct Row {
    const char* who;
    const char* body;
    const char* message;
    const char* type;
    const char* code;
    const char* param;
    int http_status;
  };
  const Row rows[] = {
      {"OpenAI",
       R"({"error":{"message":"Incorrect API key","type":"invalid_request_error","param":"model",
           "code":"invalid_api_key"}})",
       "Incorrect API key", "invalid_request_error", "invalid_api_key", "model", 0},
      {"llama.cpp",
       R"({"error":{"code":503,"message":"Loading model","type":"unavailable_error"}})",
       "Loading model", "unavailable_error", "503", "", 503},
      {"a code in digits", R"({"error":{"message":"m","code":"429"}})", "m", "", "429", "", 429},
      {"null members", R"({"error":{"message":"m","type":null,"param":null,"code":null}})", "m", "",
       "", "", 0},
      {"an empty message", R"({"error":{"message":"","type":"server_error"}})", "", "server_error",
       "", "", 0},
      {"Ollama's own", R"({"error":"model 'x' not found"})", "model 'x' not found", "", "", "", 0},
      {"TGI", R"({"error":"Input validation error","error_type":"validation"})",
       "Input validation error", "validation", "", "", 0},
      {"vLLM", R"({"object":"error","message":"too long","type":"BadRequestError","param":null,
                   "code":400})",
       "too long", "BadRequestError", "400", "", 400},
      {"a message alone", R"({"message":"no Route matched"})", "no Route matched", "", "", "", 0},
      {"a detail", R"({"detail":"Not Found"})", "Not Found", "", "", "", 0},
      {"FastAPI",
       R"({"detail":[{"loc":["body","messages",0],"msg":"field required","type":"missing"},
                     {"loc":["body","seed"],"msg":"not permitted","type":"extra_forbidden"}]})",
       "body.messages.0: field required; body.seed: not permitted", "missing", "", "0", 0},
      {"a detail in a detail", R"({"detail":{"error":{"message":"deep","code":404}}})", "deep", "",
       "404", "", 404},
      {"details that are texts", R"({"detail":["one","two"]})", "one; two", "", "", "", 0},
      {"Gemini", R"([{"error":{"code":400,"message":"bad key","status":"INVALID_ARGUMENT"}}])",
       "bad key", "", "400", "", 400},
      {"what the wrapping says", R"({"error":"busy","code":503,"type":"overloaded"})", "busy",
       "overloaded", "503", "", 503},
      {"nothing said in a known shape", R"({"error":{"message":"","code":null}})", "", "", "", "",
       0},
      {"a JSON text", R"("nope")", "nope", "", "", "", 0},
      {"some other JSON", R"({"reason":"because"})", R"({"reason":"because"})", "", "", "", 0},
      {"plain text", " upstream timed out\n", "upstream timed out", "", "", "", 0},
      {"HTML", "<!doctype html><HTML><head><Title lang=en> 502 Bad Gateway </title>",
       "a page in HTML titled 502 Bad Gateway", "", "", "", 0},
      {"HTML without a title", "<html><body>oops", "a page in HTML", "", "", "", 0},
      {"nothing", "", "", "", "", "", 0},
      {"blanks", " \r\n", "", "", "", "", 0},
  };
  for (const Row& row : rows) {
    const ErrorBody body = ParseErrorBody(row.body);
    EXPECT_EQ(body.message, row.message) << row.who;
    EXPECT_EQ(body.type, row.type) << row.who;
    EXPECT_EQ(body.code, row.code) << row.who;
    EXPECT_EQ(body.param, row.param) << row.who;
    EXPECT_EQ(body.http_status, row.http_status) << row.who;
  }
}

TEST(ErrorBodyTest, SurvivesWhatNobodySends) {
  std::string deep;
  for (int i = 0; i < 20000; ++i) deep += "{\"error\":";
  for (const std::string& body :
       {deep, deep + "1" + std::string(20000, '}'), std::string(50000, '['),
        std::string("{\"error\":[]}"), std::string("{\"error\":[[[[[[[[1]]]]]]]]}"),
        std::string("{\"error\":7}"), std::string("{\"detail\":[7,null,{}]}"),
        std::string("\0\xFF", 2), std::string("{\"error\":{\"message\":{\"a\":1},\"code\":[]}}")}) {
    const Failure failure = FailureOf(400, ParseErrorBody(body), ApiKey());
    EXPECT_EQ(failure.status.code(), StatusCode::kInvalidArgument);
    EXPECT_LT(failure.status.message().size(), 3000u);
  }
}

TEST(ErrorBodyTest, HttpStatusBecomesTheStatusThatTheHeaderPromises) {
  struct Row {
    int http_status;
    StatusCode code;
    bool again;
  };
  const Row rows[] = {
      {400, StatusCode::kInvalidArgument, false},  {401, StatusCode::kUnauthenticated, false},
      {402, StatusCode::kPermissionDenied, false}, {403, StatusCode::kPermissionDenied, false},
      {404, StatusCode::kNotFound, false},         {405, StatusCode::kInvalidArgument, false},
      {407, StatusCode::kUnauthenticated, false},  {408, StatusCode::kDeadlineExceeded, false},
      {410, StatusCode::kNotFound, false},         {413, StatusCode::kInvalidArgument, false},
      {418, StatusCode::kInvalidArgument, false},  {422, StatusCode::kInvalidArgument, false},
      {429, StatusCode::kUnavailable, true},       {500, StatusCode::kInternal, false},
      {501, StatusCode::kInternal, false},         {502, StatusCode::kUnavailable, true},
      {503, StatusCode::kUnavailable, true},       {504, StatusCode::kDeadlineExceeded, false},
      {529, StatusCode::kUnavailable, true},       {999, StatusCode::kInternal, false}};
  for (const Row& row : rows) {
    const Failure failure = FailureOf(row.http_status, {}, ApiKey());
    EXPECT_EQ(failure.status.code(), row.code) << row.http_status;
    EXPECT_EQ(failure.again, row.again) << row.http_status;
    EXPECT_EQ(failure.status.message(),
              "HTTP " + std::to_string(row.http_status) + " without a message");
  }
}

TEST(ErrorBodyTest, AQuotaThatIsUsedUpIsNotTriedAgain) {
  for (const char* body : {R"({"error":{"message":"m","type":"insufficient_quota"}})",
                           R"({"error":{"message":"m","code":"insufficient_quota"}})",
                           R"({"error":{"message":"m","code":"billing_hard_limit_reached"}})"}) {
    EXPECT_FALSE(FailureOf(429, ParseErrorBody(body), ApiKey()).again) << body;
  }
  EXPECT_TRUE(
      FailureOf(429, ParseErrorBody(R"({"error":{"code":"rate_limit_exceeded"}})"), ApiKey())
          .again);
}

TEST(ErrorBodyTest, AnErrorWithinAnAnswerStandsForTheStatusOfItsCodeOrType) {
  EXPECT_EQ(HttpStatusOf(ParseErrorBody(R"({"error":{"code":429}})")), 429);
  EXPECT_EQ(HttpStatusOf(ParseErrorBody(R"({"error":{"type":"overloaded_error"}})")), 503);
  EXPECT_EQ(HttpStatusOf(ParseErrorBody(R"({"error":{"code":"rate_limit_exceeded",
                                            "type":"tokens"}})")),
            429);
  EXPECT_EQ(HttpStatusOf(ParseErrorBody(R"({"error":{"message":"m","code":7}})")), 500);
}

TEST(ErrorBodyTest, MessagesAreQuotedCutAndWithoutTheKey) {
  ASSERT_EQ(setenv("LATTICEWORLD_TEST_ERROR_KEY", "sk-very-secret", 1), 0);
  const auto key = ApiKey::FromEnvironment("LATTICEWORLD_TEST_ERROR_KEY");
  ASSERT_TRUE(key.ok());
  const ErrorBody body{"line\nsk-very-secret" + std::string(5000, 'x'), "", "bad sk-very-secret",
                       "", 0};
  const std::string message = FailureOf(401, body, *key).status.message();
  EXPECT_NE(message.find("HTTP 401 (\"bad [key]\"): \"line\\x0a[key]xxx"), std::string::npos)
      << message;
  EXPECT_LT(message.size(), 700u);
  // The key in front of where the message is cut leaves no half of it.
  for (std::size_t before = 560; before < 620; ++before) {
    const ErrorBody long_body{std::string(before, 'x') + "sk-very-secret", "", "", "", 0};
    EXPECT_EQ(FailureOf(401, long_body, *key).status.message().find("sk-"), std::string::npos);
  }
}

// Once each took more stack than there is.
TEST(ErrorBodyTest, SurvivesListsInListsThatAreWhole) {
  const std::string deep = std::string(1000, '[') + std::string(1000, ']');
  for (const std::string& body : {deep, "{\"detail\":[{\"loc\":[" + deep + "],\"msg\":\"no\"}]}"}) {
    const Failure failure = FailureOf(400, ParseErrorBody(body), ApiKey());
    EXPECT_EQ(failure.status.code(), StatusCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace latticeworld
