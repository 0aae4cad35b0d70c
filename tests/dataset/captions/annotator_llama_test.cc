// The remote annotator against real llama.cpp. The model's weights are noise: it never describes a
// place, and so nothing that it says may pass.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "dataset/made_layouts.h"
#include "language/remote/llama/llama_process.h"
#include "latticeworld/dataset/captions/remote_annotator.h"
#include "latticeworld/language/chat/openai_client.h"

namespace latticeworld {
namespace {

TEST(AnnotatorLlamaTest, NoiseIsRefusedTurnAfterTurn) {
  const LlamaProcess process;
  ASSERT_FALSE(process.url().empty()) << "llama.cpp did not start";
  OpenAiOptions server;
  server.url = process.url();
  server.dialect = ChatDialect::kLlamaCpp;
  server.first_token_timeout_s = server.total_timeout_s = 600.0;  // on a busy machine
  auto client = MakeOpenAiClient(server);
  ASSERT_TRUE(client.ok()) << client.status().ToString();
  const std::shared_ptr<OpenAiClient> shared = *std::move(client);

  RemoteAnnotatorOptions options;
  options.repair_turns = 2;
  options.max_tokens = 64;
  const auto annotator = MakeRemoteAnnotator(shared, options);
  const Instance instance = MadeInstance(Vocabulary::kSuburb, 4, true);
  const auto caption = annotator->DescribeLayout(instance, 1, Progress());
  ASSERT_FALSE(caption.ok()) << caption->text;
  EXPECT_EQ(caption.status().code(), StatusCode::kDataLoss) << caption.status().ToString();
  EXPECT_EQ(shared->statistics().requests, 3u) << "the question and two repairs";
  EXPECT_GT(shared->statistics().prompt_tokens, 1000u);

  const auto environment = annotator->DescribeEnvironment(instance, {}, 1, Progress());
  ASSERT_FALSE(environment.ok()) << environment->text;
  EXPECT_EQ(environment.status().code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
