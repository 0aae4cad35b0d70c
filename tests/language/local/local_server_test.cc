#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "language/local/chosen_instructions.h"
#include "language/local/tiny_model.h"
#include "language/remote/form_checkers.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/remote.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {
namespace {

std::shared_ptr<ChatServer> Server(const TinyModel& tiny = {}) {
  const ModelFile file(TinyGguf(tiny));
  auto server = MakeLocalChatServer(file.path());
  EXPECT_TRUE(server.ok()) << server.status().ToString();
  return server.ok() ? *std::move(server) : nullptr;
}

ChatRequest Request(const std::string& text, AnswerForm form, std::uint64_t seed = 1) {
  ChatRequest request;
  request.messages = {{ChatRole::kSystem, "You draw maps.", ""}, {ChatRole::kUser, text, ""}};
  request.form = std::move(form);
  request.seed = seed;
  return request;
}

const Progress kProgress;

class LocalServerTest : public testing::TestWithParam<std::uint32_t> {
 protected:
  LocalServerTest() {
    TinyModel tiny;
    tiny.weight_type = GetParam();
    server_ = Server(tiny);
  }
  std::shared_ptr<ChatServer> server_;
};

TEST_P(LocalServerTest, EveryAnswerHasTheFormThatIsAskedFor) {
  const AnswerForm form = LayoutForm(Vocabulary::kWild);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto reply = server_->Complete(Request("a lake", form, seed), {}, kProgress);
    ASSERT_TRUE(reply.ok()) << reply.status().ToString();
    EXPECT_EQ(reply->finish_reason, "stop");
    EXPECT_TRUE(MatchesGbnf(form.gbnf, reply->text)) << reply->text;
  }
}

TEST_P(LocalServerTest, GeneratorsOverItNeedNoRepair) {
  RemoteOptions options;
  options.repair_turns = 0;
  const auto layout = MakeRemoteLayoutGenerator(server_, options)
                          ->Generate({"a lake", Vocabulary::kSuburb, nullptr, 3}, kProgress);
  ASSERT_TRUE(layout.ok()) << layout.status().ToString();
  EXPECT_TRUE(layout->warnings.empty());
}

TEST_P(LocalServerTest, AGreedyReplyIsTheSameBytesWithAllInstructionsOfThisProcessor) {
  ChatRequest request = Request("a lake", LayoutForm(Vocabulary::kWild));
  request.temperature = 0.0;
  const auto reply_with = [&](Instructions instructions) {
    const ChosenInstructions chosen(instructions);
    TinyModel tiny;
    tiny.weight_type = GetParam();
    const auto reply = Server(tiny)->Complete(request, {}, kProgress);
    EXPECT_TRUE(reply.ok()) << reply.status().ToString();
    return std::make_pair(reply->text, reply->log_probability);
  };
  const auto plain = reply_with(Instructions::kPlain);
  EXPECT_LT(plain.second, 0.0);
  for (const Instructions instructions : kAllInstructions) {
    if (HasInstructions(instructions)) {
      EXPECT_EQ(reply_with(instructions), plain) << static_cast<int>(instructions);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Types, LocalServerTest, testing::Values(0u, 1u, 8u));

TEST(LocalServerAnswersTest, AnEnvironmentIsValidByItsSchema) {
  const AnswerForm form = EnvironmentForm();
  ChatRequest request = Request("winter", form, 2);
  request.max_tokens = 20000;
  TinyModel tiny;
  tiny.context = 32768;
  tiny.layers = 1;
  const auto reply = Server(tiny)->Complete(request, {}, kProgress);
  ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  EXPECT_TRUE(MatchesSchema(form.json_schema, reply->text)) << reply->text;
}

TEST(LocalServerAnswersTest, AreTheSameForTheSameSeedAndOthersForOthers) {
  const AnswerForm form = LayoutForm(Vocabulary::kWild);
  const auto server = Server();
  const auto first = server->Complete(Request("a lake", form, 5), {}, kProgress);
  const auto other = server->Complete(Request("a lake", form, 6), {}, kProgress);
  const auto another = server->Complete(Request("a wood", form, 5), {}, kProgress);
  const auto again = server->Complete(Request("a lake", form, 5), {}, kProgress);
  const auto fresh = Server()->Complete(Request("a lake", form, 5), {}, kProgress);
  EXPECT_EQ(first->text, again->text);
  EXPECT_EQ(first->text, fresh->text);
  EXPECT_NE(first->text, other->text);
  EXPECT_NE(first->text, another->text);
}

TEST(LocalServerAnswersTest, AtTemperatureZeroTheSeedIsNoMatter) {
  const auto server = Server();
  ChatRequest request = Request("a lake", LayoutForm(Vocabulary::kWild), 1);
  request.temperature = 0.0;
  const auto first = server->Complete(request, {}, kProgress);
  request.seed = 2;
  EXPECT_EQ(server->Complete(request, {}, kProgress)->text, first->text);
}

TEST(LocalServerAnswersTest, ListenersHearTheTextGrowAndMayCutIt) {
  std::string heard;
  const auto reply = Server()->Complete(
      Request("a lake", LayoutForm(Vocabulary::kWild)),
      [&](std::string_view text) {
        EXPECT_EQ(text.substr(0, heard.size()), heard);
        heard = std::string(text);
        return text.size() < 50;
      },
      kProgress);
  ASSERT_TRUE(reply.ok());
  EXPECT_EQ(reply->finish_reason, "cut");
  EXPECT_EQ(reply->text, heard);
  EXPECT_GE(heard.size(), 50u);
  EXPECT_LT(heard.size(), 60u);
}

TEST(LocalServerAnswersTest, ACancelledRequestLeavesTheNextAsItWouldBe) {
  const auto server = Server();
  const ChatRequest request = Request("a lake", LayoutForm(Vocabulary::kWild), 9);
  Progress progress;
  const auto cancelled = server->Complete(
      request,
      [&](std::string_view text) {
        if (text.size() > 100) progress.Cancel();
        return true;
      },
      progress);
  EXPECT_EQ(cancelled.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(server->Complete(request, {}, kProgress)->text,
            Server()->Complete(request, {}, kProgress)->text);
}

TEST(LocalServerAnswersTest, EndsAtTheLimitOfTokensAndOfTheContext) {
  ChatRequest request = Request("a lake", LayoutForm(Vocabulary::kWild));
  request.max_tokens = 10;
  const auto few = Server()->Complete(request, {}, kProgress);
  EXPECT_EQ(few->finish_reason, "length");
  EXPECT_EQ(few->completion_tokens, 10);
  TinyModel narrow;
  narrow.context = 100;
  request.max_tokens = 5000;
  const auto cut = Server(narrow)->Complete(request, {}, kProgress);
  ASSERT_TRUE(cut.ok()) << cut.status().ToString();
  EXPECT_EQ(cut->finish_reason, "length");
  EXPECT_EQ(cut->prompt_tokens + cut->completion_tokens, 100);
  request.messages[1].text = std::string(200, '~');
  EXPECT_EQ(Server(narrow)->Complete(request, {}, kProgress).status().code(),
            StatusCode::kResourceExhausted);
}

TEST(LocalServerAnswersTest, MessagesBeyondWhatARequestAllowsAreRefused) {
  const auto server = Server();
  ChatRequest request = Request("a lake", {});
  request.max_tokens = 1;
  const auto reply = server->Complete(request, {}, kProgress);
  ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  request.max_prompt_tokens = reply->prompt_tokens;
  EXPECT_TRUE(server->Complete(request, {}, kProgress).ok());
  --request.max_prompt_tokens;
  const Status refused = server->Complete(request, {}, kProgress).status();
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
  EXPECT_NE(refused.message().find(std::to_string(request.max_prompt_tokens) + " at most"),
            std::string::npos)
      << refused.ToString();
}

TEST(LocalServerAnswersTest, RefusesWhatItCannotDo) {
  const auto server = Server();
  ChatRequest request = Request("a lake", {});
  request.form.gbnf = "root ::= gone";
  EXPECT_EQ(server->Complete(request, {}, kProgress).status().code(), StatusCode::kInvalidArgument);
  request.form = {};
  request.messages[0].image_png = "png";
  EXPECT_EQ(server->Complete(request, {}, kProgress).status().code(), StatusCode::kInvalidArgument);
  request.messages.clear();
  request.temperature = -1.0;
  EXPECT_EQ(server->Complete(request, {}, kProgress).status().code(), StatusCode::kInvalidArgument);
  EXPECT_FALSE(server->sees());
}

}  // namespace
}  // namespace latticeworld
