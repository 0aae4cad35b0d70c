#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpreting_reader.h"

namespace latticeworld {
namespace {

constexpr char kLake[] = R"({"sentences": ["A lake in the south."]})";
constexpr char kRound[] = R"({"sentences": ["A lake in the south.", "The lake is round."]})";
constexpr char kFrobs[] = R"({"sentences": ["A lake in the south.", "Frobs."]})";

class ReadingLayoutsTest : public testing::Test {
 protected:
  Result<LayoutAnswer> Generate(RemoteOptions options = {}) {
    replies_.clear();
    return Drawn(server_, options, progress_, &replies_);
  }
  // The layout of what a reader over the server reads.
  Result<LayoutAnswer> Drawn(const std::shared_ptr<ChatServer>& server,
                             const RemoteOptions& options, const Progress& progress,
                             std::vector<ModelReply>* replies) const {
    LW_ASSIGN_OR_RETURN(
        const LayoutReading reading,
        MakeInterpretingReader(server, options)->ReadLayout(request_, progress, replies));
    LayoutRequest read = request_;
    read.reading = &reading;
    return MakeGroundedLayoutGenerator()->Generate(read, progress, replies);
  }
  // What is drawn of these words as another reader reads them.
  std::string DrawnBy(InstructionReader* reader, const std::string& words) const {
    LayoutRequest request = request_;
    request.instruction = words;
    std::vector<ModelReply> none;
    const LayoutReading reading = *reader->ReadLayout(request, Progress(), &none);
    request = request_;
    request.reading = &reading;
    return ToText(MakeGroundedLayoutGenerator()->Generate(request, Progress())->layout);
  }
  std::string OfSentences(const std::string& words) const {
    return DrawnBy(MakeControlledReader().get(), words);
  }

  std::shared_ptr<FakeChatServer> server_ = std::make_shared<FakeChatServer>();
  LayoutRequest request_{"where the sun stands at noon, something to swim in", Vocabulary::kSuburb,
                         nullptr, 42};
  Progress progress_;
  std::vector<ModelReply> replies_;  // of the last call
};

TEST_F(ReadingLayoutsTest, SentencesOfTheLanguageAreLaidOutAtOnce) {
  server_->Say(kLake);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToText(answer->layout), OfSentences("A lake in the south."));
  ASSERT_EQ(replies_.size(), 1u);
  EXPECT_EQ(replies_[0].purpose, "layout_words");
  EXPECT_EQ(server_->requests()[0].form.name, "layout_words");
  EXPECT_NE(server_->requests()[0].messages.back().text.find(request_.instruction),
            std::string::npos);
}

TEST_F(ReadingLayoutsTest, SingleThingsOfTheTextComeBeforeThoseOfTheSentences) {
  request_.instruction = "A well, three lamps along the road, and somewhere to rest";
  server_->Say(R"({"sentences": ["A road.", "A bench is near a tower."]})");
  const auto reading =
      MakeInterpretingReader(server_, {})->ReadLayout(request_, progress_, &replies_);
  ASSERT_TRUE(reading.ok()) << reading.status().ToString();
  const std::vector<ThingWish>& things = reading->plan.things;
  ASSERT_EQ(things.size(), 4u);
  EXPECT_EQ(things[0].kind, "well");
  EXPECT_EQ(things[1].kind, "lamp");
  EXPECT_EQ(things[2].kind, "tower");
  EXPECT_EQ(things[3].kind, "bench");
  EXPECT_EQ(things[3].target.wish, 2);  // the tower, not what is third of the sentences
  EXPECT_EQ(server_->requests()[0].messages.back().text.find("lamps"), std::string::npos);
}

TEST_F(ReadingLayoutsTest, WarningsOfTheServerComeFirst) {
  FakeChatServer::Answer said;
  said.text = kLake;
  said.warnings = {"the chat server has cut the prompt: 7"};
  server_->Say(said);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  ASSERT_FALSE(answer->warnings.empty());
  EXPECT_EQ(answer->warnings[0], said.warnings[0]);
}

TEST_F(ReadingLayoutsTest, ASentenceOfNoFormGoesBack) {
  server_->Say(kFrobs).Say(kRound);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToText(answer->layout), OfSentences("A lake in the south. The lake is round."));
  const std::string told = server_->requests()[1].messages.back().text;
  EXPECT_NE(told.find("\"Frobs\" has none of the forms"), std::string::npos) << told;
}

TEST_F(ReadingLayoutsTest, KnownWordsThatNoSentenceCarriesGoBackOnce) {
  request_.instruction = "something to swim in, and three farms";
  server_->Say(kLake).Say(kLake);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  const std::string told = server_->requests()[1].messages.back().text;
  EXPECT_NE(told.find("no sentence says anything of \"three\""), std::string::npos) << told;
  EXPECT_EQ(ToText(answer->layout), OfSentences("A lake in the south.")) << "it said so twice";
}

TEST_F(ReadingLayoutsTest, TheLastSentencesCountWhenTheTurnsAreUsedUp) {
  RemoteOptions options;
  options.repair_turns = 1;
  server_->Say(kFrobs).Say(kRound);
  const auto answer = Generate(options);
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToText(answer->layout), OfSentences("A lake in the south. The lake is round."));
  options.repair_turns = 0;
  server_->Say(kFrobs);
  const auto at_once = Generate(options);
  ASSERT_TRUE(at_once.ok()) << at_once.status().ToString();
  EXPECT_EQ(replies_.size(), 1u);
}

TEST_F(ReadingLayoutsTest, AnAnswerWithoutSentencesGoesBackWithWhatIsWrongWithIt) {
  server_->Say("A lake, I think.").Say(kLake);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_NE(server_->requests()[1].messages.back().text.find("no JSON object"), std::string::npos);
  server_->Say("No.").Say("No!").Say("Never.");
  EXPECT_EQ(Generate().status().code(), StatusCode::kDataLoss);
}

TEST_F(ReadingLayoutsTest, AServerThatFailsAfterwardsTakesNothingAway) {
  server_->Say(kFrobs).Fail(Status(StatusCode::kUnavailable, "gone"));
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToText(answer->layout), OfSentences("A lake in the south."));
  server_->Fail(Status(StatusCode::kUnavailable, "gone"));
  EXPECT_EQ(Generate().status().code(), StatusCode::kUnavailable);
}

TEST_F(ReadingLayoutsTest, CancellingEndsItWhateverWasSaid) {
  server_->Say({Status(), kLake, "stop", 7, [this] { progress_.Cancel(); }});
  EXPECT_EQ(Generate().status().code(), StatusCode::kCancelled);
}

TEST_F(ReadingLayoutsTest, WhereNothingIsAskedTheOwnWordsAreRead) {
  request_.instruction = "A forest.";
  server_->Say(R"({"sentences": []})").Say(R"({"sentences": []})");
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToText(answer->layout), DrawnBy(MakeRuleReader().get(), "A forest."));
}

TEST_F(ReadingLayoutsTest, ARecordingGivesTheSameLayout) {
  server_->Say("?").Say(kRound);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  RemoteOptions options;
  options.repair_turns = 3;  // as many as there are replies
  std::vector<ModelReply> given;
  const auto again = Drawn(MakeReplayServer(replies_), options, Progress(), &given);
  ASSERT_TRUE(again.ok()) << again.status().ToString();
  EXPECT_EQ(ToText(again->layout), ToText(answer->layout));
}

TEST_F(ReadingLayoutsTest, AnIllegalRequestIsRefusedBeforeAnybodyIsAsked) {
  request_.instruction = "\xFF";
  EXPECT_EQ(Generate().status().code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(server_->requests().empty());
}

}  // namespace
}  // namespace latticeworld
