#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpreting_reader.h"

namespace latticeworld {
namespace {

constexpr char kNight[] = R"({"sentences": ["Night.", "Three sheep graze in the upper left."]})";

class ReadingEnvironmentsTest : public testing::Test {
 protected:
  ReadingEnvironmentsTest() {
    layout_ = MakeGroundedLayoutGenerator()
                  ->Generate({"A lake in the north.", Vocabulary::kSuburb, nullptr, 1}, Progress())
                  ->layout;
    request_.instruction = "the flock, when all good people sleep";
    request_.layout = &layout_;
    request_.seed = 5;
  }
  Result<EnvironmentAnswer> Generate() {
    LW_ASSIGN_OR_RETURN(
        const EnvironmentReading reading,
        MakeInterpretingReader(server_, {})->ReadEnvironment(request_, Progress(), &replies_));
    EnvironmentRequest read = request_;
    read.reading = &reading;
    return MakeGroundedEnvironmentGenerator()->Generate(read, Progress(), &replies_);
  }

  SymbolicLayout layout_;
  EnvironmentRequest request_;
  std::vector<ModelReply> replies_;
  std::shared_ptr<FakeChatServer> server_ = std::make_shared<FakeChatServer>();
};

TEST_F(ReadingEnvironmentsTest, WhatTheModelSaysTwiceIsSet) {
  server_->Say(kNight).Say(kNight);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EnvironmentRequest plain = request_;
  plain.instruction = "Night. Three sheep graze in the upper left.";
  const auto embedded = MakeGroundedEnvironmentGenerator()->Generate(plain, Progress());
  EXPECT_EQ(ToJson(answer->environment), ToJson(embedded->environment));
  EXPECT_EQ(answer->environment.coarse.time_of_day, TimeOfDay::kNight);
  EXPECT_EQ(answer->warnings.at(0), "read as: \"" + plain.instruction + "\"");
  EXPECT_EQ(replies_.at(0).purpose, "environment_words");
  const std::string shown = server_->requests().at(1).messages.back().text;
  EXPECT_NE(shown.find("\"sheep\""), std::string::npos) << shown;
}

TEST_F(ReadingEnvironmentsTest, NobodyIsAskedWhereNothingWasSaid) {
  request_.instruction = "";
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_TRUE(server_->requests().empty());
  EXPECT_TRUE(replies_.empty());
}

TEST_F(ReadingEnvironmentsTest, TheServersErrorsAreItsOwn) {
  server_->Fail(Status(StatusCode::kUnauthenticated, "no key"));
  EXPECT_EQ(Generate().status().code(), StatusCode::kUnauthenticated);
}

}  // namespace
}  // namespace latticeworld
