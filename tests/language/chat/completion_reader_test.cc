#include "latticeworld/language/chat/completion_reader.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

namespace latticeworld {
namespace {

constexpr std::string_view kStream =
    "data: {\"model\":\"tiny\",\"choices\":[{\"index\":0,\"delta\":{\"role\":\"assistant\","
    "\"content\":null},\"finish_reason\":null}]}\n\n"
    ": a comment\n\n"
    "data: {\"choices\":[{\"index\":0,\"delta\":{\"content\":\"w\xC3\xB6\"}}]}\n\n"
    "data: {\"choices\":[{\"index\":0,\"delta\":{\"content\":\"rld\"}}]}\r\n\r\n"
    "data: {\"choices\":[{\"index\":0,\"delta\":{},\"finish_reason\":\"stop\"}]}\n\n"
    "data: {\"choices\":[],\"usage\":{\"prompt_tokens\":7,\"completion_tokens\":3}}\n\n"
    "data: [DONE]\n\n";
constexpr std::string_view kJson =
    "{\"object\":\"chat.completion\",\"model\":\"tiny\",\"choices\":[{\"index\":0,\"message\":"
    "{\"role\":\"assistant\",\"content\":\"w\xC3\xB6rld\"},\"finish_reason\":\"stop\"}],"
    "\"usage\":{\"prompt_tokens\":7,\"completion_tokens\":3}}";

struct Reading {
  Failure end;
  Completion completion;
};

Reading Read(std::string_view body, std::size_t cut = 0) {
  const ApiKey no_key;
  CompletionReader reader(&no_key);
  reader.Feed(body.substr(0, cut));
  reader.Feed(body.substr(cut));
  const Failure end = reader.Finish("text/plain");
  return {end, reader.completion()};
}

std::string Chunk(const std::string& choice) { return "data: {\"choices\":[" + choice + "]}\n\n"; }

TEST(CompletionReaderTest, ReadsStreamAndObjectAlikeWhereverTheyAreCut) {
  for (const std::string_view body : {kStream, kJson}) {
    for (std::size_t cut = 0; cut <= body.size(); ++cut) {
      const Reading reading = Read(body, cut);
      ASSERT_TRUE(reading.end.ok()) << reading.end.status.ToString() << ", cut after " << cut;
      ASSERT_EQ(reading.completion.text, "w\xC3\xB6rld") << "cut after " << cut;
      ASSERT_EQ(reading.completion.finish_reason, "stop");
      ASSERT_EQ(reading.completion.model, "tiny");
      ASSERT_EQ(reading.completion.prompt_tokens, 7);
      ASSERT_EQ(reading.completion.completion_tokens, 3);
    }
  }
}

TEST(CompletionReaderTest, AnAnswerThatEndsTooEarlyIsToBeAskedForAgain) {
  const std::size_t finish = kStream.find("\"finish_reason\":\"stop\"");
  for (std::size_t length = 1; length < finish; ++length) {
    const Reading reading = Read(kStream.substr(0, length));
    const bool is_sniffable = length >= 5;  // "data:"
    if (!is_sniffable) continue;
    ASSERT_EQ(reading.end.status.code(), StatusCode::kUnavailable) << length << " bytes";
    ASSERT_TRUE(reading.end.again) << length << " bytes";
  }
  for (std::size_t length = 1; length < kJson.size(); ++length) {
    const Reading reading = Read(kJson.substr(0, length));
    ASSERT_EQ(reading.end.status.code(), StatusCode::kUnavailable) << length << " bytes";
    ASSERT_TRUE(reading.end.again) << length << " bytes";
  }
}

TEST(CompletionReaderTest, AnAnswerIsWholeOnceItsEndHasAReason) {
  const std::string_view reason = "\"finish_reason\":\"stop\"}]}\n\n";
  const std::size_t end = kStream.find(reason) + reason.size();
  for (std::size_t length = end; length <= kStream.size(); ++length) {
    const Reading reading = Read(kStream.substr(0, length));
    ASSERT_TRUE(reading.end.ok()) << reading.end.status.ToString() << " at " << length;
    ASSERT_EQ(reading.completion.text, "w\xC3\xB6rld");
  }
}

TEST(CompletionReaderTest, ReadsTheShapesThatServersUse) {
  struct Row {
    const char* what;
    std::string body;
    const char* text;
    const char* finish_reason;
  };
  const std::string stop = Chunk("{\"delta\":{},\"finish_reason\":\"stop\"}");
  const Row rows[] = {
      {"thinking apart (llama.cpp, vLLM)",
       Chunk("{\"delta\":{\"reasoning_content\":\"hm\"}}") +
           Chunk("{\"delta\":{\"content\":\"a\"}}") + stop,
       "a", "stop"},
      {"thinking apart (Ollama)",
       Chunk("{\"delta\":{\"content\":\"\",\"reasoning\":\"hm\"}}") +
           Chunk("{\"delta\":{\"content\":\"a\"}}") + stop,
       "a", "stop"},
      {"parts (Mistral)",
       Chunk("{\"delta\":{\"content\":[{\"type\":\"thinking\",\"text\":\"hm\"},"
             "{\"type\":\"text\",\"text\":\"a\"}]}}") +
           stop,
       "a", "stop"},
      {"the length limit",
       Chunk("{\"delta\":{\"content\":\"a\"},\"finish_reason\":\"length\"}") + "data: [DONE]\n\n",
       "a", "length"},
      {"no end mark", Chunk("{\"delta\":{\"content\":\"a\"}}") + stop, "a", "stop"},
      {"an end mark and no reason", Chunk("{\"delta\":{\"content\":\"a\"}}") + "data: [DONE]\n\n",
       "a", ""},
      {"no blank after the colon",
       "data:{\"choices\":[{\"delta\":{\"content\":\"a\"}}]}\n\n" + stop, "a", "stop"},
      {"another choice beside the first",
       Chunk("{\"index\":1,\"delta\":{\"content\":\"b\"}},{\"index\":0,\"delta\":{\"content\":"
             "\"a\"}}") +
           stop,
       "a", "stop"},
      {"chunks that say nothing", "data: {}\n\n" + Chunk("") + Chunk("{\"delta\":null}") + stop, "",
       "stop"},
      {"blank lines before JSON (a proxy's sign of life)", "\n \n" + std::string(kJson),
       "w\xC3\xB6rld", "stop"},
      {"a byte order mark before JSON", "\xEF\xBB\xBF" + std::string(kJson), "w\xC3\xB6rld",
       "stop"},
      {"JSON without text",
       "{\"choices\":[{\"message\":{\"content\":null},\"finish_reason\":\"stop\"}]}", "", "stop"},
      {"more after the end mark",
       Chunk("{\"delta\":{\"content\":\"a\"}}") + stop + "data: [DONE]\n\ndata: what is this\n\n",
       "a", "stop"},
  };
  for (const Row& row : rows) {
    const Reading reading = Read(row.body);
    EXPECT_TRUE(reading.end.ok()) << row.what << ": " << reading.end.status.ToString();
    EXPECT_EQ(reading.completion.text, row.text) << row.what;
    EXPECT_EQ(reading.completion.finish_reason, row.finish_reason) << row.what;
  }
}

TEST(CompletionReaderTest, KeepsThinkingApartOnceWhateverItsNameAndStreamedOrNot) {
  const char* deltas[] = {R"({"reasoning_content":"h"})", R"({"reasoning":"h"})",
                          R"({"thinking":"h"})", R"({"reasoning":"h","reasoning_content":"h"})"};
  for (const std::string delta : deltas) {
    const Reading stream =
        Read(Chunk("{\"delta\":" + delta + "}") +
             Chunk("{\"delta\":{\"reasoning\":\"m\"},\"finish_reason\":\"stop\"}"));
    EXPECT_EQ(stream.completion.thinking, "hm") << delta;
    EXPECT_EQ(stream.completion.text, "") << delta;
    const Reading whole =
        Read("{\"choices\":[{\"message\":" + delta + ",\"finish_reason\":\"stop\"}]}");
    EXPECT_EQ(whole.completion.thinking, "h") << delta;
    EXPECT_EQ(whole.completion.text, "") << delta;
  }
}

TEST(CompletionReaderTest, RefusesWhatIsNoAnswer) {
  struct Row {
    std::string body;
    StatusCode code;
    bool again;
    const char* says;
  };
  const std::string text = Chunk("{\"delta\":{\"content\":\"a\"}}");
  const Row rows[] = {
      {"", StatusCode::kDataLoss, false, "an empty body"},
      {"<html>", StatusCode::kDataLoss, false, "\"text/plain\""},
      {"<html>", StatusCode::kDataLoss, false, "begins with \"<html>\""},
      {"\"text\"", StatusCode::kDataLoss, false, "no chat completion"},
      {"[]", StatusCode::kDataLoss, false, "JSON objects"},
      {"{}", StatusCode::kDataLoss, false, "choices[0].message"},
      {"{\"choices\":[]}", StatusCode::kDataLoss, false, "choices[0].message"},
      {"{\"choices\":{}}", StatusCode::kDataLoss, false, "choices[0].message"},
      {"{\"a\":1e999}", StatusCode::kDataLoss, false, "JSON objects"},
      {"{} {}", StatusCode::kDataLoss, false, "JSON objects"},
      {text + "data: rubbish\n\n", StatusCode::kDataLoss, false, "\"rubbish\""},
      {text + "data: [1]\n\n", StatusCode::kDataLoss, false, "\"[1]\""},
      {"data: {\"choices\":[{\"delta\":{\"content\":\"\xFF\"}}]}\n\n", StatusCode::kDataLoss, false,
       "\\xff"},
      {text + "data: {\"error\":{\"message\":\"it broke\",\"code\":null}}\n\n",
       StatusCode::kInternal, false, "HTTP 500: \"it broke\""},
      {text + "data: {\"error\":{\"message\":\"busy\",\"code\":503}}\n\n", StatusCode::kUnavailable,
       true, "busy"},
      {"data: {\"object\":\"error\",\"message\":\"too long\",\"type\":\"BadRequestError\"}\n\n",
       StatusCode::kInvalidArgument, false, "too long"},
      {"event: error\ndata: {\"message\":\"limit\",\"type\":\"rate_limit_error\"}\n\n",
       StatusCode::kUnavailable, true, "limit"},
      {"event: error\ndata: plain words\n\n", StatusCode::kInternal, false, "plain words"},
      {"{\"error\":\"no such model\"}", StatusCode::kInternal, false, "no such model"},
      {"[{\"error\":{\"code\":400,\"message\":\"bad\",\"status\":\"INVALID_ARGUMENT\"}}]",
       StatusCode::kInvalidArgument, false, "bad"},
      {Chunk("{\"delta\":{\"refusal\":\"I will not\"},\"finish_reason\":\"stop\"}"),
       StatusCode::kInvalidArgument, false, "I will not"},
  };
  for (const Row& row : rows) {
    const Reading reading = Read(row.body);
    EXPECT_EQ(reading.end.status.code(), row.code)
        << row.body << ": " << reading.end.status.ToString();
    EXPECT_EQ(reading.end.again, row.again) << row.body;
    EXPECT_NE(reading.end.status.message().find(row.says), std::string::npos)
        << row.body << ": " << reading.end.status.message();
  }
}

TEST(CompletionReaderTest, ThinkingIsASignOfLifeAndAnEmptyRoleIsNone) {
  const ApiKey no_key;
  CompletionReader reader(&no_key);
  reader.Feed(": ping\n\n" + Chunk("{\"delta\":{\"role\":\"assistant\",\"content\":\"\"}}"));
  EXPECT_FALSE(reader.spoken());
  reader.Feed(Chunk("{\"delta\":{\"reasoning_content\":\"hm\"}}"));
  EXPECT_TRUE(reader.spoken());
  EXPECT_EQ(reader.completion().text, "");
}

TEST(CompletionReaderTest, WantsNoMoreOnceTheAnswerIsWholeOrLost) {
  const ApiKey no_key;
  CompletionReader whole(&no_key);
  EXPECT_TRUE(whole.Feed(kStream.substr(0, kStream.size() - 1)));
  EXPECT_FALSE(whole.Feed(kStream.substr(kStream.size() - 1)));
  CompletionReader lost(&no_key);
  EXPECT_FALSE(lost.Feed("data: rubbish\n\n"));
  CompletionReader page(&no_key);
  EXPECT_FALSE(page.Feed("<html>" + std::string(1000, ' ')));
}

TEST(CompletionReaderTest, CountsOfTokensThatMakeNoSenseAreNotSaid) {
  for (const char* count : {"-1", "1e3", "\"7\"", "null", "99999999999999999999", "[]"}) {
    const Reading reading = Read(
        "data: {\"choices\":[{\"delta\":{},\"finish_reason\":\"stop\"}],\"usage\":"
        "{\"prompt_tokens\":" +
        std::string(count) + "}}\n\n");
    EXPECT_TRUE(reading.end.ok()) << count;
    EXPECT_EQ(reading.completion.prompt_tokens, 0) << count;
  }
}

TEST(CompletionReaderTest, NeverQuotesTheKey) {
  ASSERT_EQ(setenv("LATTICEWORLD_TEST_READER_KEY", "sk-very-secret", 1), 0);
  const auto key = ApiKey::FromEnvironment("LATTICEWORLD_TEST_READER_KEY");
  ASSERT_TRUE(key.ok());
  const std::string bodies[] = {
      "<html>sk-very-secret",
      std::string(74, 'x') + "sk-very-secret",
      "[\"sk-very-secret\"]",
      "{\"key\":\"sk-very-secret\"}",
      "data: sk-very-secret\n\n",
      "data: {\"error\":\"sk-very-secret\"}\n\n",
      "{\"error\":{\"code\":\"sk-very-secret\"}}",
      Chunk("{\"delta\":{\"refusal\":\"sk-very-secret\"},\"finish_reason\":\"stop\"}")};
  for (const std::string& body : bodies) {
    CompletionReader reader(&*key);
    reader.Feed(body);
    const Failure end = reader.Finish("text/sk-very-secret");
    EXPECT_FALSE(end.ok()) << body;
    // Not its beginning either, where a quotation was cut.
    EXPECT_EQ(end.status.message().find("sk-ve"), std::string::npos) << end.status.message();
  }
}

// Once it took more stack than there is.
TEST(CompletionReaderTest, RefusesListsInLists) {
  const Reading reading = Read(std::string(1000, '[') + std::string(1000, ']'));
  EXPECT_EQ(reading.end.status.code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
