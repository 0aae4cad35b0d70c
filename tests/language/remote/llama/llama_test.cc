// The remote back end against real llama.cpp: client, prompts, grammar, schema and validation
// together. The model's weights are noise, so that all that is right in an answer comes from the
// constraint and the validation, and nothing from luck with a model.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "language/remote/llama/llama_process.h"
#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

class LlamaTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { process_ = new LlamaProcess; }
  static void TearDownTestSuite() {
    delete process_;
    process_ = nullptr;
  }
  void SetUp() override {
    ASSERT_FALSE(process_->url().empty()) << "llama.cpp did not start";
    OpenAiOptions options;
    options.url = process_->url();
    options.dialect = ChatDialect::kLlamaCpp;
    // On a busy machine; a test that hangs is ended by CTest.
    options.first_token_timeout_s = options.total_timeout_s = 600.0;
    auto client = MakeOpenAiClient(options);
    ASSERT_TRUE(client.ok()) << client.status().ToString();
    server_ = *std::move(client);
  }

  static LlamaProcess* process_;
  std::shared_ptr<OpenAiClient> server_;
};
LlamaProcess* LlamaTest::process_ = nullptr;

TEST_F(LlamaTest, NoiseUnderTheGrammarIsALegalLayoutInOneTurn) {
  for (const auto vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    std::vector<double> rows;
    const Progress progress([&](std::string_view, double fraction) { rows.push_back(fraction); });
    const LayoutRequest request{"A lake lies in the north.", vocabulary, nullptr, 11};
    std::vector<ModelReply> replies;
    const auto answer =
        MakeRemoteLayoutGenerator(server_, {})->Generate(request, progress, &replies);
    ASSERT_TRUE(answer.ok()) << answer.status().ToString();
    ASSERT_EQ(replies.size(), 1u);
    const ModelReply& reply = replies[0];
    EXPECT_EQ(reply.text + "\n", ToText(answer->layout));
    EXPECT_EQ(reply.finish_reason, "stop");
    EXPECT_EQ(reply.completion_tokens, 1055) << "one token a letter";
    EXPECT_GT(reply.prompt_tokens, 1000);
    // Rows are reported as they arrive; of some that arrive together the last alone.
    EXPECT_GT(rows.size(), 1u);
    EXPECT_LE(rows.size(), 32u);
    EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
    EXPECT_EQ(rows.back(), 1.0);
  }
  EXPECT_EQ(server_->statistics().completion_tokens, 2110u);
}

TEST_F(LlamaTest, TheSeedDecidesTheLayout) {
  const auto generator = MakeRemoteLayoutGenerator(server_, {});
  const auto layout = [&](std::uint64_t seed) {
    const LayoutRequest request{"hills", Vocabulary::kWild, nullptr, seed};
    const auto answer = generator->Generate(request, Progress());
    EXPECT_TRUE(answer.ok()) << answer.status().ToString();
    return answer.ok() ? ToText(answer->layout) : "";
  };
  const std::string first = layout(1);
  EXPECT_EQ(layout(1), first);
  EXPECT_NE(layout(2), first);
}

TEST_F(LlamaTest, WithoutAConstraintNoiseIsRefusedAndItsViolationsSaid) {
  // The same server asked by a client that keeps the form to itself.
  OpenAiOptions options;
  options.url = process_->url();
  options.dialect = ChatDialect::kNone;
  auto client = MakeOpenAiClient(options);
  ASSERT_TRUE(client.ok());
  RemoteOptions remote;
  remote.repair_turns = 1;
  remote.layout_max_tokens = 200;
  const LayoutRequest request{"A lake.", Vocabulary::kSuburb, nullptr, 3};
  const auto answer =
      MakeRemoteLayoutGenerator(*std::move(client), remote)->Generate(request, Progress());
  EXPECT_EQ(answer.status().code(), StatusCode::kDataLoss) << answer.status().ToString();
  EXPECT_FALSE(answer.status().violations().empty());
}

// Keeps what a server answered, also where the generator gives up.
class Recorder final : public ChatServer {
 public:
  explicit Recorder(std::shared_ptr<ChatServer> server) : server_(std::move(server)) {}
  bool sees() const override { return server_->sees(); }
  Result<ChatReply> Complete(const ChatRequest& request, const AnswerListener& listener,
                             const Progress& progress) override {
    Result<ChatReply> reply = server_->Complete(request, listener, progress);
    if (reply.ok()) texts.push_back(reply->text);
    return reply;
  }
  std::vector<std::string> texts;

 private:
  std::shared_ptr<ChatServer> server_;
};

TEST_F(LlamaTest, WhatTheSchemaLetsThroughWronglyIsCaughtByValidation) {
  LayoutRequest layout_request{"fields", Vocabulary::kSuburb, nullptr, 4};
  const auto layout = MakeRemoteLayoutGenerator(server_, {})->Generate(layout_request, Progress());
  ASSERT_TRUE(layout.ok()) << layout.status().ToString();
  EnvironmentRequest request;
  request.instruction = "An autumn evening; nine sheep graze in the lower left.";
  request.layout = &layout->layout;
  RemoteOptions options;
  options.repair_turns = 1;
  request.seed = 1;
  const auto recorder = std::make_shared<Recorder>(server_);
  const auto answer =
      MakeRemoteEnvironmentGenerator(recorder, options)->Generate(request, Progress());
  // All keys are there, and in their order: noise alone would never do that.
  ASSERT_FALSE(recorder->texts.empty()) << answer.status().ToString();
  std::size_t at = 0;
  for (const auto& type : EnumNames(AssetType{})) {
    at = recorder->texts[0].find('"' + std::string(type.name) + '"', at);
    ASSERT_NE(at, std::string::npos) << type.name << " in " << recorder->texts[0];
  }
  // No schema can say which of its values go together.
  EXPECT_FALSE(ParseEnvironment(recorder->texts[0]).ok());
  ASSERT_EQ(recorder->texts.size(), 2u) << "what was wrong goes back to the model";
  if (answer.ok()) {
    EXPECT_TRUE(Validate(answer->environment).empty());
  } else {
    EXPECT_EQ(answer.status().code(), StatusCode::kDataLoss) << answer.status().ToString();
    EXPECT_FALSE(answer.status().violations().empty());
  }
}

TEST_F(LlamaTest, AGrammarThatTheServerRefusesIsAnErrorWithItsWords) {
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "x", ""}};
  request.form.gbnf = "root ::= [a]{3000}";
  const auto reply = server_->Complete(
      request, [](std::string_view) { return true; }, Progress());
  EXPECT_EQ(reply.status().code(), StatusCode::kInvalidArgument) << reply.status().ToString();
}

TEST_F(LlamaTest, CancelEndsAnAnswerInItsMiddle) {
  Progress* to_cancel = nullptr;
  Progress progress([&](std::string_view, double fraction) {
    if (fraction > 0.2) to_cancel->Cancel();
  });
  to_cancel = &progress;
  const LayoutRequest request{"hills", Vocabulary::kWild, nullptr, 5};
  const auto answer = MakeRemoteLayoutGenerator(server_, {})->Generate(request, progress);
  EXPECT_EQ(answer.status().code(), StatusCode::kCancelled) << answer.status().ToString();
}

}  // namespace
}  // namespace latticeworld
