// Answers that move away from what the model says to nothing.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "language/local/tiny_model.h"
#include "language/remote/form_checkers.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/local/tokens/chat_text.h"
#include "latticeworld/language/local/tokens/tokenizer.h"
#include "latticeworld/language/local/weights/gguf_file.h"
#include "latticeworld/language/remote/forms.h"

namespace latticeworld {
namespace {

const Progress kProgress;

TinyModel Guided(std::optional<float> guidance) {
  TinyModel tiny;
  tiny.chat_template = "<|im_start|>";
  tiny.guidance = guidance;
  return tiny;
}

Result<std::shared_ptr<ChatServer>> Open(const TinyModel& tiny) {
  const ModelFile file(TinyGguf(tiny));
  return MakeLocalChatServer(file.path());
}

ChatRequest Request(AnswerForm form = {}) {
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "a lake", ""}};
  request.form = std::move(form);
  request.temperature = 0.0;
  return request;
}

std::string Answer(std::optional<float> guidance, const ChatRequest& request) {
  const auto server = Open(Guided(guidance));
  EXPECT_TRUE(server.ok()) << server.status().ToString();
  const auto reply = (*server)->Complete(request, {}, kProgress);
  EXPECT_TRUE(reply.ok()) << reply.status().ToString();
  return reply.ok() ? reply->text : "";
}

TEST(GuidanceTest, EachTokenIsTheLikeliestOfTheGuidedLogits) {
  const float guidance = 3.0f;
  const ModelFile file(TinyGguf(Guided(guidance)));
  const auto opened = GgufFile::Open(file.path());
  ASSERT_TRUE(opened.ok());
  const auto tokenizer = Tokenizer::Read(*opened);
  const auto model = std::make_shared<const LlamaModel>(*ReadLlamaModel(*opened));
  LlamaDecoder asked(model), unasked(model);
  ChatRequest request = Request();
  request.max_tokens = 12;
  ASSERT_TRUE(
      asked.Append(ChatTokens(*tokenizer, ChatStyle::kChatMl, request.messages), kProgress).ok());
  ASSERT_TRUE(unasked.Append(ChatTokens(*tokenizer, ChatStyle::kChatMl, {}), kProgress).ok());
  std::string expected;
  for (int i = 0; i < request.max_tokens; ++i) {
    TokenId best = 0;
    float highest = -1e30f;
    for (TokenId token = 0; token < tokenizer->size(); ++token) {
      const float u = unasked.logits()[token];
      const float logit = u + guidance * (asked.logits()[token] - u);
      const bool says =
          !tokenizer->BytesOf(token).empty() || token == AnswerEnd(*tokenizer, ChatStyle::kChatMl);
      if (!says || !(logit > highest)) continue;
      best = token;
      highest = logit;
    }
    if (best == AnswerEnd(*tokenizer, ChatStyle::kChatMl)) break;
    expected += tokenizer->BytesOf(best);
    ASSERT_TRUE(asked.Append({best}, kProgress).ok());
    ASSERT_TRUE(unasked.Append({best}, kProgress).ok());
  }
  EXPECT_EQ(Answer(guidance, request), expected);
  EXPECT_NE(Answer(std::nullopt, request), expected);
}

TEST(GuidanceTest, OfOneIsNone) {
  ChatRequest request = Request();
  request.max_tokens = 30;
  EXPECT_EQ(Answer(1.0f, request), Answer(std::nullopt, request));
}

TEST(GuidanceTest, KeepsToTheFormAndRepeatsItself) {
  ChatRequest request = Request(LayoutForm(Vocabulary::kWild));
  request.temperature = 1.0;
  const auto server = Open(Guided(4.0f));
  ASSERT_TRUE(server.ok());
  const auto first = (*server)->Complete(request, {}, kProgress);
  ASSERT_TRUE(first.ok()) << first.status().ToString();
  EXPECT_TRUE(MatchesGbnf(request.form.gbnf, first->text)) << first->text;
  Progress progress;
  const auto cancelled = (*server)->Complete(
      request,
      [&](std::string_view text) {
        if (text.size() > 100) progress.Cancel();
        return true;
      },
      progress);
  EXPECT_EQ(cancelled.status().code(), StatusCode::kCancelled);
  EXPECT_EQ((*server)->Complete(request, {}, kProgress)->text, first->text);
}

TEST(GuidanceTest, OutsideItsRangeIsRefused) {
  for (const float guidance : {0.5f, 21.0f, -1.0f}) {
    const auto server = Open(Guided(guidance));
    EXPECT_EQ(server.status().code(), StatusCode::kDataLoss);
    EXPECT_NE(server.status().message().find("legal are 1 to 20"), std::string::npos)
        << server.status().ToString();
  }
}

}  // namespace
}  // namespace latticeworld
