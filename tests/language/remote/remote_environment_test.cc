#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "catalogue/larch.h"
#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

class RemoteEnvironmentTest : public testing::Test {
 protected:
  RemoteEnvironmentTest() {
    request_.instruction = "an autumn day, nine sheep";
    request_.layout = &layout_;
    request_.seed = 7;
  }
  Result<EnvironmentAnswer> Generate() {
    return MakeRemoteEnvironmentGenerator(server_, {})->Generate(request_, progress_, &replies_);
  }

  std::shared_ptr<FakeChatServer> server_ = std::make_shared<FakeChatServer>();
  SymbolicLayout layout_ = ParseLayout(LegalMatrix(), Vocabulary::kSuburb).value();
  EnvironmentRequest request_;
  std::vector<ModelReply> replies_;
  std::vector<double> fractions_;
  Progress progress_{[this](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "environment");
    fractions_.push_back(fraction);
  }};
};

TEST_F(RemoteEnvironmentTest, AsksOnceForALegalAnswer) {
  server_->Say(LegalEnvironment());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToJson(answer->environment), LegalEnvironment());
  ASSERT_EQ(replies_.size(), 1u);
  EXPECT_EQ(replies_[0].purpose, "environment");
  const ChatRequest& asked = server_->requests()[0];
  EXPECT_EQ(asked.form.name, "environment");
  EXPECT_EQ(asked.form.json_schema, EnvironmentForm().json_schema);
  EXPECT_EQ(asked.seed, 7u);
  EXPECT_EQ(asked.max_tokens, 4096);
}

TEST_F(RemoteEnvironmentTest, AnAnswerOutOfTheFormThatTheServerWasToldIsAWarning) {
  FakeChatServer::Answer fenced;
  fenced.text = "```json\n" + LegalEnvironment() + "\n```";
  fenced.form = FormLanguage::kJsonSchema;
  FakeChatServer::Answer bare = fenced;
  bare.text = LegalEnvironment();
  server_->Say(fenced).Say(bare);
  const auto warned = Generate();
  ASSERT_TRUE(warned.ok()) << warned.status().ToString();
  ASSERT_EQ(warned->warnings.size(), 1u);
  EXPECT_NE(warned->warnings[0].find("does not enforce the form"), std::string::npos);
  const auto quiet = Generate();
  ASSERT_TRUE(quiet.ok()) << quiet.status().ToString();
  EXPECT_TRUE(quiet->warnings.empty()) << quiet->warnings[0];
}

TEST_F(RemoteEnvironmentTest, WhatTheSchemaLetThroughGoesBackToTheModel) {
  std::string bad = LegalEnvironment();
  bad.replace(bad.find("\"autumn\""), 8, "\"winter\"");
  server_->Say(bad).Say(LegalEnvironment());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  const std::string& repair = server_->requests()[1].messages.back().text;
  const auto parsed = ParseEnvironment(bad);
  ASSERT_GT(parsed.status().violations().size(), 1u);
  for (const Violation& violation : parsed.status().violations()) {
    EXPECT_NE(repair.find("- " + violation.pointer + ": " + violation.message), std::string::npos)
        << violation.message;
  }
}

// The same answer is legal with a user's catalogue that has its value, and only with that.
TEST_F(RemoteEnvironmentTest, AUsersCatalogueIsToldEnforcedAndRead) {
  request_.catalogue = Catalogue::Extended({{"larch.json", LarchFile()}}).value();
  EnvironmentConfig environment;
  environment.coarse.season = Season::kAutumn;
  environment.fine = DeriveFineAttributes(environment.coarse, *request_.catalogue);
  environment.fine_of(AssetType::kForest).season_variant = "golden larch";
  environment.fine_of(AssetType::kForest).material = "larch bark";
  const std::string said = ToJson(environment, *request_.catalogue);
  server_->Say(said);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToJson(answer->environment, *request_.catalogue), said);
  const ChatRequest& asked = server_->requests()[0];
  EXPECT_EQ(asked.form.json_schema, EnvironmentForm(*request_.catalogue).json_schema);
  EXPECT_NE(asked.form.json_schema.find("\"golden larch\""), std::string::npos);
  EXPECT_NE(asked.form.json_schema.find("\"larch bark\""), std::string::npos);
  EXPECT_NE(asked.messages[0].text.find("golden larch (autumn)"), std::string::npos);

  EXPECT_FALSE(ParseEnvironment(said).ok());
  EXPECT_EQ(EnvironmentForm().json_schema.find("larch"), std::string::npos);
}

TEST_F(RemoteEnvironmentTest, GivesUpWithDataLoss) {
  server_->Say("{}").Say("{}").Say("{\"coarse\": 1}");
  const auto answer = Generate();
  EXPECT_EQ(answer.status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(answer.status().violations().size(), 3u) << answer.status().ToString();
}

TEST_F(RemoteEnvironmentTest, ProgressGrowsAndStaysBelowTheEnd) {
  server_->Say(LegalEnvironment() + std::string(5000, '-'));
  ASSERT_TRUE(Generate().ok());
  ASSERT_GT(fractions_.size(), 10u);
  for (std::size_t i = 1; i < fractions_.size(); ++i) EXPECT_GT(fractions_[i], fractions_[i - 1]);
  EXPECT_LT(fractions_.back(), 1.0);
}

TEST_F(RemoteEnvironmentTest, AnInvalidRequestIsNotSent) {
  request_.layout = nullptr;
  EXPECT_EQ(Generate().status().code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(server_->requests().empty());
}

}  // namespace
}  // namespace latticeworld
