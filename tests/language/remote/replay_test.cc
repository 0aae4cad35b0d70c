#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

bool Same(const std::vector<ModelReply>& a, const std::vector<ModelReply>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].purpose != b[i].purpose || a[i].model != b[i].model || a[i].text != b[i].text ||
        a[i].finish_reason != b[i].finish_reason || a[i].prompt_tokens != b[i].prompt_tokens ||
        a[i].completion_tokens != b[i].completion_tokens || a[i].retries != b[i].retries ||
        a[i].seconds != b[i].seconds) {
      return false;
    }
  }
  return true;
}

TEST(ReplayTest, GivesTheSameAnswersWithoutTheModelByteForByte) {
  auto server = std::make_shared<FakeChatServer>();
  // A bad answer that is cut short, bytes that are no text, then good ones.
  server->Say(MatrixWithRow(3, std::string(32, 'X')))
      .Say("\xFF")
      .Say("```\n" + LegalMatrix() + "```")
      .Say({Status(), LegalEnvironment().substr(0, 900), "length"})
      .Say("<think>hm</think>" + LegalEnvironment());
  const LayoutRequest request{"a lake", Vocabulary::kSuburb, nullptr, 9};
  std::vector<ModelReply> replies;
  const auto layout =
      MakeRemoteLayoutGenerator(server, {})->Generate(request, Progress(), &replies);
  ASSERT_TRUE(layout.ok()) << layout.status().ToString();
  EnvironmentRequest environment_request;
  environment_request.layout = &layout->layout;
  const auto environment = MakeRemoteEnvironmentGenerator(server, {})
                               ->Generate(environment_request, Progress(), &replies);
  ASSERT_TRUE(environment.ok()) << environment.status().ToString();

  // One recording of both, asked in the other order.
  ASSERT_EQ(replies.size(), 5u);
  const auto replay = MakeReplayServer(replies);
  std::vector<ModelReply> again;
  const auto environment_again =
      MakeRemoteEnvironmentGenerator(replay, {})->Generate(environment_request, Progress(), &again);
  ASSERT_TRUE(environment_again.ok()) << environment_again.status().ToString();
  const auto layout_again =
      MakeRemoteLayoutGenerator(replay, {})->Generate(request, Progress(), &again);
  ASSERT_TRUE(layout_again.ok()) << layout_again.status().ToString();
  EXPECT_EQ(ToText(layout_again->layout), ToText(layout->layout));
  EXPECT_EQ(ToJson(environment_again->environment), ToJson(environment->environment));
  std::rotate(again.begin(), again.begin() + 2, again.end());
  EXPECT_TRUE(Same(again, replies));
}

TEST(ReplayTest, SaysWhenTheRecordingIsAtItsEnd) {
  const auto replay = MakeReplayServer({{"layout", "m", "no", "stop"}});
  const LayoutRequest request{"a lake", Vocabulary::kSuburb, nullptr, 9};
  const auto layout = MakeRemoteLayoutGenerator(replay, {})->Generate(request, Progress());
  EXPECT_EQ(layout.status().code(), StatusCode::kOutOfRange) << layout.status().ToString();
}

TEST(ReplayTest, NobodyNeedsToListen) {
  const auto replay = MakeReplayServer({{"layout_words", "m", "A lake.", "stop"}});
  ChatRequest request;
  request.form.name = "layout_words";
  const auto reply = replay->Complete(request, {}, Progress());
  ASSERT_TRUE(reply.ok()) << reply.status().ToString();
  EXPECT_EQ(reply->text, "A lake.");
}

TEST(ReplayTest, CanBeCancelled) {
  const auto replay = MakeReplayServer({{"layout", "m", LegalMatrix(), "stop"}});
  Progress progress;
  progress.Cancel();
  const LayoutRequest request{"a lake", Vocabulary::kSuburb, nullptr, 9};
  EXPECT_EQ(MakeRemoteLayoutGenerator(replay, {})->Generate(request, progress).status().code(),
            StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
