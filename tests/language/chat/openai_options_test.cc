#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld/language/chat/server_url.h"

namespace latticeworld {
namespace {

OpenAiOptions Good() {
  OpenAiOptions options;
  options.url = "http://127.0.0.1:8080/v1";
  return options;
}

TEST(OpenAiOptionsTest, EachIllegalValueIsOneViolationAtItsName) {
  struct Row {
    const char* pointer;
    void (*spoil)(OpenAiOptions*);
  };
  const Row rows[] = {
      {"url", [](OpenAiOptions* o) { o->url = ""; }},
      {"model", [](OpenAiOptions* o) { o->model = "\xFF"; }},
      {"model", [](OpenAiOptions* o) { o->model = std::string(300, 'a'); }},
      {"dialect", [](OpenAiOptions* o) { o->dialect = static_cast<ChatDialect>(9); }},
      {"api_key_variable", [](OpenAiOptions* o) { o->api_key_variable = "sk-0123"; }},
      {"api_key_variable", [](OpenAiOptions* o) { o->api_key_variable = "hf_0123"; }},
      {"api_key_variable", [](OpenAiOptions* o) { o->api_key_variable = "1KEY"; }},
      {"ca_file", [](OpenAiOptions* o) { o->ca_file = "no/such/file.pem"; }},
      {"connect_timeout_s", [](OpenAiOptions* o) { o->connect_timeout_s = 0; }},
      {"first_token_timeout_s", [](OpenAiOptions* o) { o->first_token_timeout_s = 3601; }},
      {"total_timeout_s",
       [](OpenAiOptions* o) { o->total_timeout_s = std::numeric_limits<double>::quiet_NaN(); }},
      {"max_retries", [](OpenAiOptions* o) { o->max_retries = -1; }},
      {"max_retries", [](OpenAiOptions* o) { o->max_retries = 21; }},
      {"backoff_s", [](OpenAiOptions* o) { o->backoff_s = -0.1; }},
      {"max_answer_bytes", [](OpenAiOptions* o) { o->max_answer_bytes = 1023; }},
      {"max_answer_bytes", [](OpenAiOptions* o) { o->max_answer_bytes = (64u << 20) + 1; }},
  };
  EXPECT_TRUE(Validate(Good()).empty());
  for (const Row& row : rows) {
    OpenAiOptions options = Good();
    row.spoil(&options);
    const auto violations = Validate(options);
    ASSERT_EQ(violations.size(), 1u) << row.pointer;
    EXPECT_EQ(violations[0].pointer, row.pointer);
    EXPECT_FALSE(violations[0].message.empty());
  }
}

TEST(OpenAiOptionsTest, MakingAClientNamesEveryViolationAndRepeatsNoSecret) {
  OpenAiOptions options;
  options.url = "http://me:pa55word@host/v1";
  options.api_key_variable = "sk-0123456789";
  options.max_retries = 99;
  const auto client = MakeOpenAiClient(options);
  ASSERT_FALSE(client.ok());
  EXPECT_EQ(client.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(client.status().violations().size(), 3u);
  EXPECT_EQ(client.status().ToString().find("pa55word"), std::string::npos);
  EXPECT_EQ(client.status().ToString().find("sk-0123"), std::string::npos);
}

TEST(ServerUrlTest, ReadsBaseAddresses) {
  struct Row {
    const char* url;
    const char* base;
    bool is_loopback;
  };
  const Row rows[] = {
      {"http://127.0.0.1:8080/v1", "http://127.0.0.1:8080/v1", true},
      {"http://127.8.9.1/v1//", "http://127.8.9.1/v1", true},
      {"http://LocalHost:1/v1", "http://LocalHost:1/v1", true},
      {"http://[::1]:8080", "http://[::1]:8080", true},
      {"http://model.localhost/v1", "http://model.localhost/v1", true},
      {"https://api.example.com/v1/", "https://api.example.com/v1", false},
      {"https://127.example.com/v1", "https://127.example.com/v1", false},
      {"https://notlocalhost/v1", "https://notlocalhost/v1", false},
  };
  for (const Row& row : rows) {
    const auto url = ParseServerUrl(row.url);
    ASSERT_TRUE(url.ok()) << row.url << ": " << url.status().ToString();
    EXPECT_EQ(url->base, row.base);
    EXPECT_EQ(url->is_loopback, row.is_loopback) << row.url;
  }
}

TEST(ServerUrlTest, RefusesWhatIsNone) {
  struct Row {
    const char* url;
    const char* says;
  };
  const Row rows[] = {
      {"", "no address"},
      {"127.0.0.1:8080/v1", "no address"},
      {"/v1", "no address"},
      {"http://", "no address"},
      {"http://host:99999/v1", "no address"},
      {"ftp://host/v1", "\"ftp\" is neither http nor https"},
      {"file:///etc/passwd", "\"file\" is neither"},
      {"http://me@host/v1", "user or password"},
      {"http://me:secret@host/v1", "user or password"},
      {"http://host/v1?key=secret", "query or fragment"},
      {"http://host/v1#there", "query or fragment"},
      {"http://host/v1/chat/completions", "is an endpoint"},
      {"http://host/v1/models/", "is an endpoint"},
  };
  for (const Row& row : rows) {
    const auto url = ParseServerUrl(row.url);
    ASSERT_FALSE(url.ok()) << row.url;
    EXPECT_EQ(url.status().code(), StatusCode::kInvalidArgument);
    EXPECT_NE(url.status().message().find(row.says), std::string::npos)
        << row.url << ": " << url.status().message();
    EXPECT_EQ(url.status().message().find("secret"), std::string::npos);
  }
}

}  // namespace
}  // namespace latticeworld
