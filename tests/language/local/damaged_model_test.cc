// Model files that say nonsense: every answer is one of the form, or an error.

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "language/local/tiny_model.h"
#include "language/remote/form_checkers.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/local/local.h"

namespace latticeworld {
namespace {

constexpr char kForm[] = "root ::= [abefghorstw]{8} [.!]";
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const Progress kProgress;

TinyModel Smallest(std::uint32_t weight_type, bool guided) {
  TinyModel model;
  model.layers = 1;
  model.width = 32;
  model.hidden = 32;
  model.weight_type = weight_type;
  model.chat_template = "<|im_start|>";
  if (guided) model.guidance = 3.0f;
  return model;
}

Result<std::shared_ptr<ChatServer>> Open(const std::string& content) {
  const ModelFile file(content);
  return MakeLocalChatServer(file.path(), 1);
}

Result<ChatReply> Answer(ChatServer* server, const std::string& form, double temperature) {
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "a lake", ""}};
  request.form.gbnf = form;
  request.temperature = temperature;
  request.max_tokens = 12;
  return server->Complete(request, {}, kProgress);
}

// Whether it is an answer, which then is one of the form unless it was cut.
bool IsLegal(const Result<ChatReply>& reply) {
  if (!reply.ok()) return false;
  if (reply->finish_reason == "stop") {
    EXPECT_TRUE(MatchesGbnf(kForm, reply->text)) << reply->text;
  } else {
    EXPECT_EQ(reply->finish_reason, "length");
  }
  return true;
}

using Damage = std::tuple<std::uint32_t, bool>;  // type of the weights, guided
class DamagedWeightsTest : public testing::TestWithParam<Damage> {
 protected:
  // The model with one tensor spoilt.
  std::shared_ptr<ChatServer> Spoilt(const std::string& tensor, float with) const {
    TinyModel model = Smallest(std::get<0>(GetParam()), std::get<1>(GetParam()));
    model.spoilt = tensor;
    model.spoilt_with = with;
    auto server = Open(TinyGguf(model));
    EXPECT_TRUE(server.ok()) << server.status().ToString();
    return *std::move(server);
  }
};

const char* const kTensors[] = {"token_embd.weight",     "output_norm.weight",
                                "output.weight",         "blk.0.attn_norm.weight",
                                "blk.0.attn_q.weight",   "blk.0.attn_k.weight",
                                "blk.0.attn_v.weight",   "blk.0.attn_output.weight",
                                "blk.0.ffn_gate.weight", "blk.0.ffn_down.weight"};

TEST_P(DamagedWeightsTest, ThatAreNoNumbersAreAnErrorThatNamesTheModel) {
  for (const char* tensor : kTensors) {
    const auto server = Spoilt(tensor, kNan);
    for (const double temperature : {0.0, 1.0}) {
      for (const char* form : {kForm, ""}) {
        const auto reply = Answer(server.get(), form, temperature);
        ASSERT_EQ(reply.status().code(), StatusCode::kDataLoss)
            << tensor << ", temperature " << temperature << ", form '" << form << "'";
        EXPECT_NE(reply.status().message().find("'tiny' gives no number to any token"),
                  std::string::npos)
            << reply.status().ToString();
      }
    }
  }
}

TEST_P(DamagedWeightsTest, ThatAreInfiniteOrOverflowGiveAnErrorOrALegalAnswer) {
  for (const char* tensor : kTensors) {
    for (const float value : {kInfinity, -kInfinity, 3e38f, -3e38f, 60000.0f}) {
      const auto server = Spoilt(tensor, value);
      for (const double temperature : {0.0, 1.0}) {
        const auto reply = Answer(server.get(), kForm, temperature);
        if (!IsLegal(reply))
          EXPECT_EQ(reply.status().code(), StatusCode::kDataLoss) << reply.status().ToString();
        const auto any = Answer(server.get(), "", temperature);
        if (!any.ok())
          EXPECT_EQ(any.status().code(), StatusCode::kDataLoss) << any.status().ToString();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Types, DamagedWeightsTest,
                         testing::Combine(testing::Values(0u, 1u, 8u), testing::Bool()));

TEST(DamagedModelTest, TheTokenOfTheEndIsNoPartOfAnAnswer) {
  // Token 261 + 2 + ('a' - '!') is "a".
  TinyModel model = Smallest(0, false);
  model.chat_template.clear();
  model.end_token = 261 + 2 + ('a' - '!');
  const auto server = Open(TinyGguf(model));
  ASSERT_TRUE(server.ok()) << server.status().ToString();
  for (int seed = 0; seed < 20; ++seed) {
    ChatRequest request;
    request.messages = {{ChatRole::kUser, "a lake", ""}};
    request.form.gbnf = "root ::= [a] [a] [b]";
    request.temperature = 1e5;
    request.seed = seed;
    const auto reply = (*server)->Complete(request, {}, kProgress);
    ASSERT_TRUE(reply.ok()) << reply.status().ToString();
    EXPECT_EQ(reply->text, "aab");
    EXPECT_EQ(reply->finish_reason, "stop");
  }
}

TEST(DamagedModelTest, GuidanceWithNothingToHearIsRefused) {
  TinyModel model = Smallest(0, true);
  model.chat_template = "[INST]";
  EXPECT_TRUE(Open(TinyGguf(model)).ok());
  model.without = {"tokenizer.ggml.bos_token_id"};
  const Status status = Open(TinyGguf(model)).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_NE(status.message().find("latticeworld.guidance"), std::string::npos) << status.ToString();
  model.guidance.reset();
  EXPECT_TRUE(Open(TinyGguf(model)).ok());
}

// A file with some of its bytes changed, within the header or anywhere. Bytes of ones and zeros
// make what is large, negative or no number.
std::string Damaged(std::string file, RandomStream* random) {
  constexpr int kHeader = 16000;
  constexpr unsigned char kBytes[] = {0x00, 0x7F, 0x80, 0xFF};
  const bool in_header = random->UniformInt(0, 2) == 0;
  const int last = in_header ? kHeader : static_cast<int>(file.size()) - 1;
  const int changes = in_header ? random->UniformInt(1, 3) : random->UniformInt(1, 60);
  for (int i = 0; i < changes; ++i) {
    const int byte = random->UniformInt(0, 1) == 0 ? kBytes[random->UniformInt(0, 3)]
                                                   : random->UniformInt(0, 255);
    file[random->UniformInt(0, last)] = static_cast<char>(byte);
  }
  return file;
}

TEST(DamagedModelTest, WithAnyBytesChangedAnswersInItsFormOrWithAnError) {
  constexpr int kSeeds = 600;
  std::vector<std::string> whole;
  for (const std::uint32_t type : {0u, 1u, 8u})
    for (const bool guided : {false, true}) whole.push_back(TinyGguf(Smallest(type, guided)));
  int refused = 0, failed = 0, answered = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    RandomStream random(seed, "damage");
    const auto server = Open(Damaged(whole[seed % whole.size()], &random));
    if (!server.ok()) {
      EXPECT_EQ(server.status().code(), StatusCode::kDataLoss) << server.status().ToString();
      ++refused;
      continue;
    }
    for (const double temperature : {0.0, 1.0}) {
      const auto reply = Answer(server->get(), kForm, temperature);
      (IsLegal(reply) ? answered : failed) += 1;
    }
  }
  RecordProperty("outcomes", std::to_string(refused) + " refused, " + std::to_string(failed) +
                                 " failed, " + std::to_string(answered) + " answered");
  // Damage of all kinds is among them.
  EXPECT_GT(refused, kSeeds / 20);
  EXPECT_GT(failed, kSeeds / 20);
  EXPECT_GT(answered, kSeeds / 4);
}

}  // namespace
}  // namespace latticeworld
