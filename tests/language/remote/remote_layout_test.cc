#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

class RemoteLayoutTest : public testing::Test {
 protected:
  Result<LayoutAnswer> Generate(RemoteOptions options = {}) {
    return MakeRemoteLayoutGenerator(server_, options)->Generate(request_, progress_, &replies_);
  }

  std::shared_ptr<FakeChatServer> server_ = std::make_shared<FakeChatServer>();
  LayoutRequest request_{"a lake in the north", Vocabulary::kSuburb, nullptr, 42};
  std::vector<ModelReply> replies_;
  std::vector<double> fractions_;
  Progress progress_{[this](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "layout");
    fractions_.push_back(fraction);
  }};
};

TEST_F(RemoteLayoutTest, AsksOnceForALegalAnswer) {
  server_->Say(LegalMatrix());
  RemoteOptions options;
  options.temperature = 0.3;
  options.layout_max_tokens = 1500;
  const auto answer = Generate(options);
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToText(answer->layout), LegalMatrix());
  EXPECT_TRUE(answer->warnings.empty());
  ASSERT_EQ(server_->requests().size(), 1u);
  const ChatRequest& asked = server_->requests()[0];
  EXPECT_EQ(asked.seed, 42u);
  EXPECT_EQ(asked.temperature, 0.3);
  EXPECT_EQ(asked.max_tokens, 1500);
  EXPECT_EQ(asked.form.name, "layout");
  EXPECT_EQ(asked.form.gbnf, LayoutForm(Vocabulary::kSuburb).gbnf);
}

TEST_F(RemoteLayoutTest, RecordsEveryReplyAsItCame) {
  const std::string refused = "Sorry, I cannot.";
  server_->Say(refused).Say("Here:\n" + LegalMatrix());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  ASSERT_EQ(replies_.size(), 2u);
  EXPECT_EQ(replies_[0].text, refused);
  const ModelReply& last = replies_[1];
  EXPECT_EQ(last.purpose, "layout");
  EXPECT_EQ(last.model, "fake");
  EXPECT_EQ(last.text, "Here:\n" + LegalMatrix());
  EXPECT_EQ(last.finish_reason, "stop");
  EXPECT_EQ(last.prompt_tokens, 101);
  EXPECT_EQ(last.completion_tokens, 11);
  EXPECT_EQ(last.retries, 1);
  EXPECT_EQ(last.seconds, 0.5);
}

TEST_F(RemoteLayoutTest, SendsEveryViolationBackAndTakesTheRepairedAnswer) {
  const std::string bad = MatrixWithRow(2, "GGGGGGGGGGGGGGGGGGGGGGGGGGGGGGGX");
  server_->Say({Status(), bad, "stop", bad.size()}).Say(LegalMatrix());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  ASSERT_EQ(server_->requests().size(), 2u);
  const auto& first = server_->requests()[0].messages;
  const auto& second = server_->requests()[1].messages;
  ASSERT_EQ(second.size(), first.size() + 2);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(second[i].text, first[i].text);
  EXPECT_EQ(second[2].role, ChatRole::kAssistant);
  EXPECT_EQ(second[2].text, bad);
  EXPECT_EQ(second[3].role, ChatRole::kUser);
  const auto layout = ParseLayout(bad, Vocabulary::kSuburb);
  ASSERT_EQ(layout.status().violations().size(), 1u);
  const Violation& violation = layout.status().violations()[0];
  EXPECT_NE(second[3].text.find("- " + violation.pointer + ": " + violation.message),
            std::string::npos)
      << second[3].text;
  EXPECT_NE(server_->requests()[1].seed, 42u);
}

TEST_F(RemoteLayoutTest, KeepsTheHistoryBoundedAndGivesEachTurnItsSeed) {
  for (int i = 0; i < 4; ++i) server_->Say("attempt " + std::to_string(i));
  server_->Say(LegalMatrix());
  RemoteOptions options;
  options.repair_turns = 4;
  ASSERT_TRUE(Generate(options).ok());
  std::vector<std::uint64_t> seeds;
  for (const ChatRequest& asked : server_->requests()) {
    EXPECT_LE(asked.messages.size(), 4u);
    for (const std::uint64_t seed : seeds) EXPECT_NE(asked.seed, seed);
    seeds.push_back(asked.seed);
  }
  EXPECT_EQ(server_->requests()[4].messages[2].text, "attempt 3");
}

TEST_F(RemoteLayoutTest, GivesUpAfterTheLastTurnWithTheViolationsOfTheLastAnswer) {
  server_->Say("no").Say("no").Say(MatrixWithRow(9, std::string(31, 'G')));
  const auto answer = Generate();
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(server_->requests().size(), 3u);
  ASSERT_FALSE(answer.status().violations().empty());
  EXPECT_EQ(answer.status().violations().back().pointer, "row 10");
  EXPECT_NE(answer.status().message().find("in 3 answers"), std::string::npos)
      << answer.status().message();
}

TEST_F(RemoteLayoutTest, WithoutRepairTurnsTheFirstAnswerIsTheLast) {
  server_->Say("no");
  RemoteOptions options;
  options.repair_turns = 0;
  EXPECT_EQ(Generate(options).status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(server_->requests().size(), 1u);
}

TEST_F(RemoteLayoutTest, ReportsRowsAsTheyArrive) {
  server_->Say("Here is the map:\n```\n" + LegalMatrix() + "```\n");
  ASSERT_TRUE(Generate().ok());
  ASSERT_EQ(fractions_.size(), 32u);
  for (int row = 1; row <= 32; ++row) {
    EXPECT_EQ(fractions_[static_cast<std::size_t>(row - 1)], row / 32.0);
  }
}

TEST_F(RemoteLayoutTest, TheLastRowNeedsNoNewlineToBeReported) {
  server_->Say(LegalMatrix().substr(0, 1055));
  ASSERT_TRUE(Generate().ok());
  EXPECT_EQ(fractions_.size(), 32u);
  EXPECT_EQ(fractions_.back(), 1.0);
}

TEST_F(RemoteLayoutTest, CutsABadAnswerShortAndRepairsIt) {
  const std::string bad = MatrixWithRow(5, std::string(32, 'X'));
  server_->Say(bad).Say(LegalMatrix());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(replies_[0].finish_reason, "cut");
  EXPECT_LT(replies_[0].text.size(), 7u * 33u);
}

TEST_F(RemoteLayoutTest, CutsBlanksWithoutEndShort) {
  server_->Say(LegalMatrix() + std::string(100000, '\n'));
  ASSERT_TRUE(Generate().ok());
  EXPECT_LT(server_->said(), 3000u);
}

TEST_F(RemoteLayoutTest, ARetryThatBeginsAnewIsNotTakenForTheSameAnswer) {
  // What a client does when its stream breaks: the listener hears the text from its start again.
  class Breaking final : public ChatServer {
   public:
    bool sees() const override { return false; }
    Result<ChatReply> Complete(const ChatRequest&, const AnswerListener& listener,
                               const Progress&) override {
      EXPECT_TRUE(listener("Sure!\n" + LegalMatrix().substr(0, 5 * 33 + 2)));
      ChatReply reply;
      reply.text = LegalMatrix();
      EXPECT_TRUE(listener(reply.text.substr(0, 8 * 33)));
      EXPECT_TRUE(listener(reply.text));
      return reply;
    }
  };
  const auto generator = MakeRemoteLayoutGenerator(std::make_shared<Breaking>(), {});
  const auto answer = generator->Generate(request_, progress_);
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(fractions_.back(), 1.0);
}

TEST_F(RemoteLayoutTest, ACutAnswerIsToldSo) {
  server_->Say({Status(), "<think>Let me see. A lake, in the north, so", "length"})
      .Say(LegalMatrix());
  ASSERT_TRUE(Generate().ok());
  const auto& repair = server_->requests()[1].messages;
  EXPECT_EQ(repair[2].text, "(no answer)");
  EXPECT_NE(repair[3].text.find("limit of 2048 tokens"), std::string::npos) << repair[3].text;
}

TEST_F(RemoteLayoutTest, ACompleteMatrixCountsEvenWhenTheAnswerWasCutLater) {
  server_->Say({Status(), LegalMatrix() + "\nThis map shows a", "length"});
  EXPECT_TRUE(Generate().ok());
}

TEST_F(RemoteLayoutTest, BytesThatAreNoTextNeverGetAnyFurther) {
  const std::string bytes = std::string("\xFF\xC0 hm \0 ", 8) + "\xE6";
  server_->Say(bytes).Say(LegalMatrix());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(replies_[0].text, "?? hm ? ?");
  EXPECT_EQ(server_->requests()[1].messages[2].text, "?? hm ? ?");
}

TEST_F(RemoteLayoutTest, ALongAnswerGoesBackCutBetweenTwoCharacters) {
  std::string text = "a ";
  for (int i = 0; i < 20000; ++i) text += "\xE6\xA3\xAE";
  server_->Say({Status(), text, "stop", text.size()}).Say(LegalMatrix());
  ASSERT_TRUE(Generate().ok());
  const std::string& said = server_->requests()[1].messages[2].text;
  EXPECT_GT(said.size(), 11900u);
  EXPECT_LT(said.size(), 12100u);
  EXPECT_TRUE(ValidateText("said", said, said.size()).ok());
}

FakeChatServer::Answer Told(const std::string& text, FormLanguage form,
                            const std::string& finish_reason = "stop") {
  FakeChatServer::Answer answer;
  answer.text = text;
  answer.finish_reason = finish_reason;
  answer.form = form;
  return answer;
}

std::string RowsJson() {
  std::string json = LegalMatrix();
  json.pop_back();
  for (std::size_t at = json.find('\n'); at != std::string::npos; at = json.find('\n', at)) {
    json.replace(at, 1, "\",\"");
  }
  return "{\"rows\":[\"" + json + "\"]}";
}

TEST_F(RemoteLayoutTest, AnAnswerOutOfTheFormThatTheServerWasToldIsAWarning) {
  const std::string texts[] = {"Here is the map:\n" + LegalMatrix(), LegalMatrix(),
                               "```json\n" + RowsJson() + "\n```"};
  for (const std::string& text : texts) {
    server_ = std::make_shared<FakeChatServer>();
    server_->Say(Told(text, FormLanguage::kJsonSchema));
    const auto answer = Generate();
    ASSERT_TRUE(answer.ok()) << answer.status().ToString();
    ASSERT_EQ(answer->warnings.size(), 1u) << text;
    EXPECT_NE(answer->warnings[0].find("does not enforce the form"), std::string::npos)
        << answer->warnings[0];
  }
}

TEST_F(RemoteLayoutTest, AnswersInTheirFormAndServersThatWereToldNoneAreNoWarning) {
  const std::string plain = LegalMatrix();
  const FakeChatServer::Answer answers[] = {
      Told(RowsJson(), FormLanguage::kJsonSchema),
      Told("<think>hm</think>\n" + RowsJson(), FormLanguage::kJsonSchema),
      Told(plain.substr(0, plain.size() - 1), FormLanguage::kGbnf),
      Told(plain.substr(0, plain.size() - 1), FormLanguage::kGbnf, "length"),
      Told("Here is the map:\n" + plain, FormLanguage::kNone)};
  for (const FakeChatServer::Answer& said : answers) {
    server_ = std::make_shared<FakeChatServer>();
    server_->Say(said);
    const auto answer = Generate();
    ASSERT_TRUE(answer.ok()) << answer.status().ToString();
    EXPECT_TRUE(answer->warnings.empty()) << answer->warnings[0];
  }
}

TEST_F(RemoteLayoutTest, WarningsOfTheServerAreSaidOnceAndAgainOfARecording) {
  FakeChatServer::Answer bad = Told("no", FormLanguage::kJsonSchema);
  bad.warnings = {"the chat server has cut the prompt: 2048"};
  FakeChatServer::Answer good = Told(RowsJson(), FormLanguage::kJsonSchema);
  good.warnings = {"the chat server has cut the prompt: 2050"};
  server_->Say(bad).Say(good);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  ASSERT_EQ(answer->warnings.size(), 2u);
  EXPECT_EQ(answer->warnings[0], bad.warnings[0]);
  EXPECT_NE(answer->warnings[1].find("\"no\""), std::string::npos) << answer->warnings[1];
  const auto again =
      MakeRemoteLayoutGenerator(MakeReplayServer(replies_), {})->Generate(request_, Progress());
  ASSERT_TRUE(again.ok()) << again.status().ToString();
  EXPECT_EQ(again->warnings, answer->warnings);
}

TEST_F(RemoteLayoutTest, AFailureSaysWhatTheServerDidToThePrompt) {
  FakeChatServer::Answer bad = Told("no", FormLanguage::kNone);
  bad.warnings = {"the chat server has cut the prompt: 2048"};
  server_->Say(bad);
  RemoteOptions options;
  options.repair_turns = 0;
  const Status failure = Generate(options).status();
  EXPECT_EQ(failure.code(), StatusCode::kDataLoss);
  EXPECT_NE(failure.ToString().find(bad.warnings[0]), std::string::npos) << failure.ToString();
}

TEST_F(RemoteLayoutTest, PassesTheServersErrorOn) {
  server_->Fail(Unavailable("connection refused"));
  const auto answer = Generate();
  EXPECT_EQ(answer.status().code(), StatusCode::kUnavailable);
  EXPECT_NE(answer.status().message().find("connection refused"), std::string::npos);
}

TEST_F(RemoteLayoutTest, AnInvalidRequestIsNotSent) {
  request_.instruction = "  ";
  EXPECT_EQ(Generate().status().code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(server_->requests().empty());
}

TEST_F(RemoteLayoutTest, CancelEndsItBetweenTurns) {
  server_->Say({Status(), "no", "stop", 7, [this] { progress_.Cancel(); }}).Say(LegalMatrix());
  EXPECT_EQ(Generate().status().code(), StatusCode::kCancelled);
  EXPECT_EQ(server_->requests().size(), 1u);
}

TEST_F(RemoteLayoutTest, ShowsTheReliefToAServerThatSees) {
  Grid<float> height_m(40, 40, 3.0f);
  height_m(0, 0) = 50.0f;
  const Relief relief = MakeRelief(std::move(height_m));
  request_.relief = &relief;
  server_->set_sees(true);
  server_->Say(LegalMatrix());
  ASSERT_TRUE(Generate().ok());
  EXPECT_FALSE(server_->requests()[0].messages[1].image_png.empty());
}

TEST_F(RemoteLayoutTest, NoiseNeverBecomesAnIllegalLayout) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "noise");
    auto server = std::make_shared<FakeChatServer>();
    for (int turn = 0; turn < 3; ++turn) {
      std::string text = LegalMatrix();
      for (int i = random.UniformInt(0, 3); i > 0; --i) {
        text[static_cast<std::size_t>(random.UniformInt(0, 1055))] =
            static_cast<char>(random.UniformInt(0, 255));
      }
      if (random.Chance(0.2)) {
        text.resize(static_cast<std::size_t>(random.UniformInt(0, 1055)));
      }
      server->Say({Status(), text, random.Chance(0.5) ? "stop" : "length",
                   static_cast<std::size_t>(random.UniformInt(1, 100))});
    }
    const auto answer = MakeRemoteLayoutGenerator(server, {})->Generate(request_, Progress());
    if (answer.ok()) {
      EXPECT_TRUE(ParseLayout(ToText(answer->layout), Vocabulary::kSuburb).ok());
    } else {
      EXPECT_EQ(answer.status().code(), StatusCode::kDataLoss) << answer.status().ToString();
      EXPECT_FALSE(answer.status().violations().empty());
    }
  }
}

}  // namespace
}  // namespace latticeworld
