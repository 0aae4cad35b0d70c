#include "latticeworld/language/reading/model_reader.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/sentences/sentence_grammar.h"

namespace latticeworld {
namespace {

class ModelReaderTest : public testing::Test {
 protected:
  Result<LayoutReading> Read(const std::string& text) {
    LayoutRequest request;
    request.instruction = text;
    return MakeModelReader(server_)->ReadLayout(request, Progress(), &replies_);
  }
  const std::shared_ptr<FakeChatServer> server_ = std::make_shared<FakeChatServer>();
  std::vector<ModelReply> replies_;
};

TEST_F(ModelReaderTest, TheModelSaysTheSentences) {
  server_->Say("A lake in the north. Forest surrounds the lake.");
  const auto reading = Read("up north a lake with woods all round it");
  ASSERT_TRUE(reading.ok()) << reading.status().ToString();
  EXPECT_EQ(reading->sentences,
            (std::vector<std::string>{"A lake in the north", "Forest surrounds the lake"}));
  EXPECT_EQ(reading->plan.features.size(), 2u);
  ASSERT_EQ(server_->requests().size(), 1u);
  const ChatRequest& asked = server_->requests().front();
  EXPECT_EQ(asked.messages.front().text, "layout");
  EXPECT_EQ(asked.messages.back().text, "up north a lake with woods all round it");
  EXPECT_EQ(asked.temperature, 0.0);
  EXPECT_EQ(asked.max_prompt_tokens, 512);
  EXPECT_EQ(asked.form.gbnf, SentenceGrammar(SentenceKind::kLayout));
  ASSERT_EQ(replies_.size(), 1u);
  EXPECT_EQ(replies_.front().purpose, "layout_words");
}

TEST_F(ModelReaderTest, TheSmallLanguageIsReadWithoutTheModel) {
  const auto reading = Read("A lake in the north. Forest surrounds the lake.");
  ASSERT_TRUE(reading.ok());
  EXPECT_EQ(reading->sentences.size(), 2u);
  EXPECT_TRUE(server_->requests().empty());
  EXPECT_TRUE(Read(" \n ").ok());
  EXPECT_TRUE(server_->requests().empty());
}

TEST_F(ModelReaderTest, SingleThingsAreTakenOutBeforeTheModelReads) {
  server_->Say("A village.");
  const auto reading = Read("Three oaks in a row beside a neighborhood.");
  ASSERT_TRUE(reading.ok()) << reading.status().ToString();
  ASSERT_EQ(reading->plan.things.size(), 1u);
  EXPECT_EQ(reading->plan.things[0].kind, "oak");
  EXPECT_EQ(reading->plan.things[0].count, 3);
  ASSERT_EQ(server_->requests().size(), 1u);
  EXPECT_EQ(server_->requests().front().messages.back().text, "a neighborhood.");
  EXPECT_TRUE(reading->plan.not_understood.empty());
}

// What is known and no sentence speaks of is never dropped in silence.
TEST_F(ModelReaderTest, LandThatNoSentenceCarriesIsNotUnderstood) {
  server_->Say("A lake in the north.");
  const auto reading = Read("a lake up north, a dense forest, and no houses by the lake");
  ASSERT_TRUE(reading.ok());
  EXPECT_EQ(reading->plan.not_understood, (std::vector<std::string>{"dense forest", "houses"}));
}

TEST_F(ModelReaderTest, AnotherLanguageIsSaid) {
  for (const std::string text : {"Ein See in der Mitte, ringsum Wald, und eine Stra\xC3\x9F"
                                 "e.",
                                 "Un lago en el centro rodeado de bosque y casas al norte"}) {
    server_->Say("A lake.");
    const auto reading = Read(text);
    ASSERT_TRUE(reading.ok());
    ASSERT_FALSE(reading->plan.warnings.empty()) << text;
    EXPECT_NE(reading->plan.warnings[0].find("English"), std::string::npos);
  }
  for (const std::string text : {"lake NW, village SE, road between", "snow mountain",
                                 "up north a lake with woods all round it"}) {
    server_->Say("A lake.");
    const auto reading = Read(text);
    ASSERT_TRUE(reading.ok());
    for (const std::string& warning : reading->plan.warnings) {
      EXPECT_EQ(warning.find("English"), std::string::npos) << text;
    }
  }
}

TEST_F(ModelReaderTest, ADashIsNothing) {
  server_->Say("-");
  const auto reading = Read("what a lovely day");
  ASSERT_TRUE(reading.ok());
  EXPECT_TRUE(reading->sentences.empty());
  EXPECT_TRUE(reading->plan.claims.empty());
}

TEST_F(ModelReaderTest, RepeatsAndCutEndsAreLeftOut) {
  FakeChatServer::Answer cut;
  cut.text = "A lake. A lake. A pond in the";
  cut.finish_reason = "length";
  server_->Say(cut);
  const auto reading = Read("lakes and lakes and lakes");
  ASSERT_TRUE(reading.ok());
  EXPECT_EQ(reading->sentences, std::vector<std::string>{"A lake"});
}

TEST_F(ModelReaderTest, AFailureOfTheServerIsTheReaders) {
  server_->Fail(Unavailable("gone"));
  EXPECT_EQ(Read("woods").status().code(), StatusCode::kUnavailable);
}

TEST_F(ModelReaderTest, EnvironmentsAreReadToo) {
  server_->Say("Weather: fog. 2 goblins patrolling in the forest.");
  const SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  EnvironmentRequest request;
  request.layout = &layout;
  request.instruction = "misty, and a couple of orcs walk about in the woods";
  const auto reading = MakeModelReader(server_)->ReadEnvironment(request, Progress(), &replies_);
  ASSERT_TRUE(reading.ok());
  EXPECT_EQ(reading->heard.agents.size(), 1u);
  EXPECT_EQ(server_->requests().front().messages.front().text, "environment");
  EXPECT_TRUE(reading->heard.not_understood.empty());
  EXPECT_EQ(reading->heard.agents[0].words, "a couple of orcs walk about in the woods");
}

TEST_F(ModelReaderTest, NumbersAndPlacesThatNoSentenceCarriesAreNotUnderstood) {
  server_->Say("Ponds. Forest.");
  const auto reading = Read("five ponds in the south-east, woods at the top");
  ASSERT_TRUE(reading.ok());
  EXPECT_EQ(reading->plan.not_understood, (std::vector<std::string>{"five", "south-east", "top"}));
}

TEST_F(ModelReaderTest, ClaimsQuoteTheWordsThatTheyComeFrom) {
  server_->Say("2 small ponds in the west. Forest surrounds the ponds.");
  const auto reading = Read("Left of it all, two little tarns; trees stand all around them");
  ASSERT_TRUE(reading.ok());
  ASSERT_FALSE(reading->plan.claims.empty());
  EXPECT_EQ(reading->plan.claims.front().words, "two little tarns");
  EXPECT_EQ(reading->plan.claims.back().words, "trees stand");
}

}  // namespace
}  // namespace latticeworld
