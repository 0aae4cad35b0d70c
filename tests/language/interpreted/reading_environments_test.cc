#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpreting_reader.h"

namespace latticeworld {
namespace {

constexpr char kNight[] =
    R"({"sentences": ["Time: night.", "3 sheep grazing in the north-west."]})";

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

TEST_F(ReadingEnvironmentsTest, SentencesOfTheLanguageAreSet) {
  server_->Say(kNight);
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(answer->environment.coarse.time_of_day, TimeOfDay::kNight);
  ASSERT_EQ(answer->environment.agents.size(), 1u);
  EXPECT_EQ(answer->environment.agents[0].quantity, 3);
  EXPECT_EQ(replies_.at(0).purpose, "environment_words");
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
