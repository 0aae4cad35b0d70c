#include "latticeworld/language/chat/request_body.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kSchema[] =
    R"({"type":"object","properties":{"z":{"type":"string"},"a":{"type":"integer"}}})";

ChatRequest SomeRequest() {
  ChatRequest request;
  request.messages = {{ChatRole::kSystem, "Be brief.", ""},
                      {ChatRole::kUser, "D\xC3\xB6rf\n", ""},
                      {ChatRole::kAssistant, "ok", ""}};
  request.form = {"layout", "root ::= [A-Z]{32}", "[A-Z]{32}", kSchema};
  request.max_tokens = 99;
  request.temperature = 0.25;
  request.seed = 5;
  return request;
}

OpenAiOptions With(ChatDialect dialect) {
  OpenAiOptions options;
  options.dialect = dialect;
  return options;
}

Json Body(const ChatRequest& request, const OpenAiOptions& options,
          const AcceptedMembers& accepted = {}) {
  const auto body = CompletionBody(request, "tiny", options, accepted);
  EXPECT_TRUE(body.ok()) << body.status().ToString();
  return body.ok() ? Json::parse(*body) : Json();
}

TEST(RequestBodyTest, SaysTheSameToEveryDialect) {
  for (const auto& [dialect, name] : EnumNames(ChatDialect{})) {
    const Json body = Body(SomeRequest(), With(dialect));
    EXPECT_EQ(body.at("model"), "tiny") << name;
    EXPECT_EQ(body.at("messages"), Json::parse(R"([{"role":"system","content":"Be brief."},
                              {"role":"user","content":"D\u00f6rf\n"},
                              {"role":"assistant","content":"ok"}])"))
        << name;
    EXPECT_EQ(body.at("max_tokens"), 99) << name;
    EXPECT_EQ(body.at("temperature"), 0.25) << name;
    EXPECT_EQ(body.at("seed"), 5) << name;
    EXPECT_EQ(body.at("stream"), true) << name;
    EXPECT_EQ(body.at("stream_options"), Json::parse(R"({"include_usage":true})")) << name;
  }
}

// What a dialect is told about the form, beside what every one is told.
Json FormMembers(ChatDialect dialect, const AnswerForm& form) {
  ChatRequest request = SomeRequest();
  request.form = form;
  Json body = Body(request, With(dialect));
  for (const char* common :
       {"model", "messages", "max_tokens", "temperature", "seed", "stream", "stream_options"}) {
    body.erase(common);
  }
  return body;
}

TEST(RequestBodyTest, AsksForTheFormInTheServersOwnLanguage) {
  const AnswerForm all = {"layout", "GRAMMAR", "REGEX", kSchema};
  const AnswerForm schema = {"layout", "", "", kSchema};
  const AnswerForm grammar = {"layout", "GRAMMAR", "", ""};
  const AnswerForm regex = {"layout", "", "REGEX", ""};
  const std::string s = kSchema;
  const std::string named = R"({"response_format":{"type":"json_schema","json_schema":
                                {"name":"layout","schema":)" +
                            s;
  struct Row {
    ChatDialect dialect;
    AnswerForm form;
    std::string members;
  };
  const Row rows[] = {
      {ChatDialect::kLlamaCpp, all, R"({"grammar":"GRAMMAR"})"},
      {ChatDialect::kLlamaCpp, schema, R"({"json_schema":)" + s + "}"},
      {ChatDialect::kLlamaCpp, regex, "{}"},
      {ChatDialect::kVllm, all, named + "}}}"},
      {ChatDialect::kVllm, schema, named + "}}}"},
      {ChatDialect::kVllm, regex, R"({"structured_outputs":{"regex":"REGEX"}})"},
      {ChatDialect::kVllm, grammar, R"({"structured_outputs":{"grammar":"GRAMMAR"}})"},
      {ChatDialect::kOllama, all, named + "}}}"},
      {ChatDialect::kOllama, grammar, "{}"},
      {ChatDialect::kOpenAi, all, named + R"(,"strict":true}}})"},
      {ChatDialect::kOpenAi, regex, "{}"},
      {ChatDialect::kNone, all, "{}"},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(FormMembers(row.dialect, row.form), Json::parse(row.members)) << NameOf(row.dialect);
  }
  for (const auto& [dialect, name] : EnumNames(ChatDialect{})) {
    EXPECT_EQ(FormMembers(dialect, {}), Json::object()) << name;
  }
}

TEST(RequestBodyTest, KeepsTheOrderOfTheSchema) {
  for (const ChatDialect dialect :
       {ChatDialect::kLlamaCpp, ChatDialect::kVllm, ChatDialect::kOllama, ChatDialect::kOpenAi}) {
    ChatRequest request = SomeRequest();
    request.form = {"", "", "", kSchema};
    const auto body = CompletionBody(request, "tiny", With(dialect), {});
    ASSERT_TRUE(body.ok());
    EXPECT_NE(body->find(kSchema), std::string::npos) << *body;
  }
}

TEST(RequestBodyTest, ShowsImagesToModelsThatSee) {
  ChatRequest request = SomeRequest();
  OpenAiOptions options;
  options.sees = true;
  // The lengths modulo three are all that base64 (RFC 4648, section 10) knows.
  const std::pair<const char*, const char*> images[] = {{"f", "Zg=="},
                                                        {"fo", "Zm8="},
                                                        {"foo", "Zm9v"},
                                                        {"foob", "Zm9vYg=="},
                                                        {"\xFF\xFE\x01", "//4B"}};
  for (const auto& [image, base64] : images) {
    request.messages[1].image_png = image;
    EXPECT_EQ(Body(request, options).at("messages")[1].at("content"),
              Json::parse(R"([{"type":"text","text":"D\u00f6rf\n"},
                              {"type":"image_url","image_url":
                               {"url":"data:image/png;base64,)" +
                          std::string(base64) + R"("}}])"));
  }
  options.sees = false;
  EXPECT_EQ(Body(request, options).at("messages")[1].at("content"), "D\xC3\xB6rf\n");
}

TEST(RequestBodyTest, SeedsStayDifferentAndWithin31Bits) {
  std::set<std::int64_t> sent;
  ChatRequest request = SomeRequest();
  const std::uint64_t seeds[] = {0,          1,          2,          0x7FFFFFFF,
                                 1ull << 32, 3ull << 32, 1ull << 62, ~0ull - 7};
  for (const std::uint64_t seed : seeds) {
    request.seed = seed;
    const auto value = Body(request, With(ChatDialect::kNone)).at("seed").get<std::int64_t>();
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 0x7FFFFFFF);
    sent.insert(value);
  }
  EXPECT_GE(sent.size(), 7u);  // 1 and 1 << 32 fold to the same
}

TEST(RequestBodyTest, LeavesOutWhatAServerHasRefused) {
  AcceptedMembers accepted;
  accepted.max_tokens = accepted.temperature = accepted.seed = accepted.stream_options = false;
  const Json body = Body(SomeRequest(), With(ChatDialect::kNone), accepted);
  EXPECT_EQ(body.at("max_completion_tokens"), 99);
  for (const char* name : {"max_tokens", "temperature", "seed", "stream_options"}) {
    EXPECT_FALSE(body.contains(name)) << name;
  }
}

TEST(RequestBodyTest, NotesEachRefusedMemberOnce) {
  AcceptedMembers accepted;
  const ErrorBody tokens{"Use 'max_completion_tokens' instead.", "", "unsupported_parameter",
                         "max_tokens", 0};
  EXPECT_TRUE(NoteRefusal(tokens, &accepted));
  EXPECT_FALSE(accepted.max_tokens);
  EXPECT_FALSE(NoteRefusal(tokens, &accepted));
  EXPECT_TRUE(NoteRefusal({"", "", "unsupported_value", "temperature", 0}, &accepted));
  EXPECT_FALSE(accepted.temperature);
  EXPECT_TRUE(NoteRefusal({"", "extra_forbidden", "", "seed", 0}, &accepted));
  EXPECT_FALSE(accepted.seed);
  EXPECT_FALSE(NoteRefusal({"", "extra_forbidden", "", "seed", 0}, &accepted));
  // Any other refusal is one.
  EXPECT_FALSE(NoteRefusal({"stream_options is odd", "", "", "stream_options", 0}, &accepted));
  EXPECT_FALSE(NoteRefusal({"", "extra_forbidden", "", "messages", 0}, &accepted));
  EXPECT_FALSE(NoteRefusal({}, &accepted));
  EXPECT_TRUE(accepted.stream_options);
}

TEST(RequestBodyTest, RefusesWhatCannotBeSaidAndNamesAllOfIt) {
  ChatRequest request = SomeRequest();
  request.messages[1].text = "\xFF";
  request.max_tokens = 0;
  request.temperature = 2.5;
  request.form.json_schema = "{\"type\":";
  request.form.name = "a form";
  const auto body = CompletionBody(request, "tiny", With(ChatDialect::kNone), {});
  ASSERT_FALSE(body.ok());
  EXPECT_EQ(body.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(body.status().violations().size(), 5u) << body.status().ToString();
  EXPECT_FALSE(CompletionBody({}, "tiny", With(ChatDialect::kNone), {}).ok());
}

}  // namespace
}  // namespace latticeworld
