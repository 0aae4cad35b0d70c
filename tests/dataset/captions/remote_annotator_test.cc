#include "latticeworld/dataset/captions/remote_annotator.h"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "dataset/answering_server.h"
#include "dataset/made_layouts.h"
#include "latticeworld/dataset/captions/caption_checks.h"
#include "latticeworld/dataset/captions/written_annotator.h"
#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld/layout/picture.h"

namespace latticeworld {
namespace {

// Forest in the north, grassland in the south, a lake in the middle of the grassland.
Instance Lakeside() {
  std::string rows;
  for (int row = 0; row < kLayoutSize; ++row) {
    std::string line(kLayoutSize, row < 12 ? 'F' : 'G');
    if (row >= 18 && row < 25) line.replace(12, 8, 8, 'W');
    rows += line + "\n";
  }
  return {"lakeside", "lakeside", ParseLayout(rows, Vocabulary::kSuburb).value(), nullptr};
}

constexpr char kTrue[] =
    "There is forest in the north. A lake lies south of the forest, and the lake is surrounded by "
    "grassland. No roads.";
constexpr char kFalse[] =
    "There is forest in the south. A lake lies south of the forest, with a village beside it.";

class RemoteAnnotatorTest : public testing::Test {
 protected:
  void Answer(const nlohmann::json& answers, bool sees = false) {
    peer_ = std::make_unique<AnsweringServer>(answers);
    OpenAiOptions options;
    options.url = peer_->url();
    options.sees = sees;
    options.backoff_s = 0.01;
    client_ = MakeOpenAiClient(options).value();
  }
  Result<LayoutCaption> Describe(int repair_turns = 2) {
    RemoteAnnotatorOptions options;
    options.repair_turns = repair_turns;
    return MakeRemoteAnnotator(client_, options)->DescribeLayout(Lakeside(), 5, progress_);
  }
  static std::string TextOf(const nlohmann::json& message) {
    const nlohmann::json& content = message.at("content");
    if (content.is_string()) return content;
    std::string text;
    for (const nlohmann::json& part : content) {
      if (part.at("type") == "text") text += part.at("text").get<std::string>();
    }
    return text;
  }

  std::unique_ptr<AnsweringServer> peer_;
  std::shared_ptr<OpenAiClient> client_;
  Progress progress_;
};

TEST_F(RemoteAnnotatorTest, KeepsAnAnswerThatTheLayoutBears) {
  Answer({kTrue});
  const auto caption = Describe();
  ASSERT_TRUE(caption.ok()) << caption.status().ToString();
  EXPECT_EQ(caption->text, kTrue);
  EXPECT_GE(caption->claims.size(), 4u);
  for (const Claim& claim : caption->claims) {
    EXPECT_TRUE(Measure(claim, Lakeside().layout).holds) << claim.words;
  }
}

TEST_F(RemoteAnnotatorTest, SendsBackWhatContradictsTheLayoutAndTakesTheMendedAnswer) {
  Answer({kFalse, kTrue});
  const auto caption = Describe();
  ASSERT_TRUE(caption.ok()) << caption.status().ToString();
  EXPECT_EQ(caption->text, kTrue);
  const auto requests = peer_->Requests();
  ASSERT_EQ(requests.size(), 2u);
  const nlohmann::json& messages = requests[1].at("messages");
  ASSERT_EQ(messages.size(), 4u);
  EXPECT_EQ(TextOf(messages[2]), kFalse);
  const std::string repair = TextOf(messages[3]);
  EXPECT_NE(repair.find("forest in the south"), std::string::npos) << repair;
  EXPECT_NE(repair.find("village"), std::string::npos) << "both mistakes are told: " << repair;
}

TEST_F(RemoteAnnotatorTest, RefusesATextThatContradictsItself) {
  Answer({"There is no forest. There is forest in the north. A lake lies south of the forest.",
          kTrue});
  const auto caption = Describe();
  ASSERT_TRUE(caption.ok()) << caption.status().ToString();
  EXPECT_EQ(caption->text, kTrue);
  const std::string repair = TextOf(peer_->Requests()[1].at("messages")[3]);
  EXPECT_NE(repair.find("no forest"), std::string::npos) << repair;
}

TEST_F(RemoteAnnotatorTest, GivesUpWithWhatWasWrong) {
  Answer({kFalse, "A nice place.", kFalse});
  const auto caption = Describe(2);
  ASSERT_FALSE(caption.ok());
  EXPECT_EQ(caption.status().code(), StatusCode::kDataLoss);
  EXPECT_NE(caption.status().message().find("forest in the south"), std::string::npos)
      << caption.status().ToString();
  EXPECT_EQ(peer_->Requests().size(), 3u);
}

TEST_F(RemoteAnnotatorTest, RefusesAMatrixAndSilence) {
  Answer({ToText(Lakeside().layout), "", kTrue});
  const auto caption = Describe(2);
  ASSERT_TRUE(caption.ok()) << caption.status().ToString();
  EXPECT_NE(TextOf(peer_->Requests()[1].at("messages")[3]).find("matrix"), std::string::npos);
}

TEST_F(RemoteAnnotatorTest, TakesThinkingAndQuotationMarksOff) {
  Answer({"<think>Forest in the south? No.</think>\n\"" + std::string(kTrue) + "\"\n"});
  const auto caption = Describe(0);
  ASSERT_TRUE(caption.ok()) << caption.status().ToString();
  EXPECT_EQ(caption->text, kTrue);
}

TEST_F(RemoteAnnotatorTest, AServerThatIsBusyIsAskedAgainByTheClient) {
  Answer({503, kTrue});
  const auto caption = Describe(0);
  ASSERT_TRUE(caption.ok()) << caption.status().ToString();
  EXPECT_EQ(client_->statistics().retries, 1u);
}

TEST_F(RemoteAnnotatorTest, AnErrorOfTheServerIsPassedOn) {
  Answer(nlohmann::json::array({401}));
  const auto caption = Describe();
  ASSERT_FALSE(caption.ok());
  EXPECT_EQ(caption.status().code(), StatusCode::kUnauthenticated) << caption.status().ToString();
}

TEST_F(RemoteAnnotatorTest, AModelThatDoesNotSeeReadsTheLetters) {
  Answer({kTrue});
  ASSERT_TRUE(Describe().ok());
  const nlohmann::json messages = peer_->Requests()[0].at("messages");
  std::string matrix = ToText(Lakeside().layout);
  matrix.pop_back();
  EXPECT_NE(TextOf(messages[1]).find(matrix), std::string::npos);
  EXPECT_NE(TextOf(messages[0]).find("W = "), std::string::npos) << TextOf(messages[0]);
}

TEST_F(RemoteAnnotatorTest, AModelThatSeesGetsThePictureAndWhatItsColoursMean) {
  Answer({kTrue}, true);
  ASSERT_TRUE(Describe().ok());
  const nlohmann::json messages = peer_->Requests()[0].at("messages");
  for (const LayoutClass& entry : ClassesOf(Vocabulary::kSuburb)) {
    char colour[16];
    std::snprintf(colour, sizeof(colour), "#%02X%02X%02X", entry.color.r, entry.color.g,
                  entry.color.b);
    EXPECT_NE(TextOf(messages[0]).find(colour), std::string::npos) << colour;
  }
  EXPECT_EQ(TextOf(messages[1]).find("FFFF"), std::string::npos) << "no letters beside the picture";
  bool image = false;
  for (const nlohmann::json& part : messages[1].at("content")) {
    image = image || part.at("type") == "image_url";
  }
  EXPECT_TRUE(image) << messages[1].dump().substr(0, 300);
}

TEST_F(RemoteAnnotatorTest, AnEnvironmentIsDescribedUntilTheWordsLeadBackToIt) {
  const Instance lakeside = Lakeside();
  const auto written = MakeWrittenAnnotator()->DescribeEnvironment(lakeside, {}, 5, progress_);
  ASSERT_TRUE(written.ok());
  Answer({"A sandstorm blows on a winter night, and a hundred goblins attack.", written->text});
  const auto caption =
      MakeRemoteAnnotator(client_)->DescribeEnvironment(lakeside, {}, 5, progress_);
  ASSERT_TRUE(caption.ok()) << caption.status().ToString();
  EXPECT_EQ(caption->text, written->text);
  EXPECT_EQ(ToJson(caption->environment), ToJson(written->environment))
      << "the same draw, other words";
  EXPECT_NE(TextOf(peer_->Requests()[1].at("messages")[3]).find("goblins"), std::string::npos);
}

TEST_F(RemoteAnnotatorTest, ACancelledCallAsksNobody) {
  Answer({kTrue});
  progress_.Cancel();
  const auto caption = Describe();
  ASSERT_FALSE(caption.ok());
  EXPECT_EQ(caption.status().code(), StatusCode::kCancelled);
  EXPECT_TRUE(peer_->Requests().empty());
}

TEST(RemoteAnnotatorOptions, EveryViolationIsNamed) {
  RemoteAnnotatorOptions options;
  EXPECT_TRUE(Validate(options).empty());
  options = {9, 3.0, 10, 0, 100, 0.0, "x"};
  EXPECT_EQ(Validate(options).size(), 6u);
}

TEST(CaptionChecks, WhatIsLeftOutOfAnEnvironmentIsNamed) {
  const Instance lakeside = Lakeside();
  EnvironmentConfig environment;
  environment.coarse.season = Season::kWinter;
  environment.coarse.weather = Weather::kRain;
  environment.agents = {{AgentCategory::kSheep, 7, AgentState::kIdle, Region::kLower}};
  const Status status =
      CheckEnvironmentCaption("It is winter.", lakeside.layout, environment, 512.0);
  ASSERT_EQ(status.violations().size(), 2u) << status.ToString();
  EXPECT_NE(status.violations()[0].message.find("rain"), std::string::npos);
  EXPECT_NE(status.violations()[1].message.find("7 sheep"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
