#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

// Stands for the embedded back end.
class Embedded final : public LayoutGenerator, public EnvironmentGenerator {
 public:
  explicit Embedded(Status error = Status()) : error_(std::move(error)) {}
  std::string_view name() const override { return "embedded"; }
  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress&,
                                std::vector<ModelReply>*) override {
    if (!error_.ok()) return error_;
    LayoutAnswer answer;
    answer.layout = ParseLayout(LegalMatrix(), request.vocabulary).value();
    answer.warnings = {"own warning"};
    return answer;
  }
  Result<EnvironmentAnswer> Generate(const EnvironmentRequest&, const Progress&,
                                     std::vector<ModelReply>*) override {
    if (!error_.ok()) return error_;
    EnvironmentAnswer answer;
    answer.environment = ParseEnvironment(LegalEnvironment()).value();
    return answer;
  }

 private:
  Status error_;
};

class FallbackTest : public testing::Test {
 protected:
  Result<LayoutAnswer> Generate(Status embedded = Status()) {
    auto generator = MakeFallbackLayoutGenerator(MakeRemoteLayoutGenerator(server_, {}),
                                                 std::make_unique<Embedded>(std::move(embedded)));
    EXPECT_EQ(generator->name(), "remote");
    return generator->Generate(request_, progress_, &replies_);
  }

  std::shared_ptr<FakeChatServer> server_ = std::make_shared<FakeChatServer>();
  LayoutRequest request_{"a lake", Vocabulary::kSuburb, nullptr, 9};
  Progress progress_;
  std::vector<ModelReply> replies_;
};

TEST_F(FallbackTest, AServerThatAnswersIsNotReplaced) {
  server_->Say(LegalMatrix());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok());
  EXPECT_TRUE(answer->warnings.empty());
  ASSERT_EQ(replies_.size(), 1u);
  EXPECT_TRUE(replies_[0].failure.ok());
}

TEST_F(FallbackTest, EveryFailureButACancelFallsBackWithAWarningThatSaysWhy) {
  for (int code = 1; code <= 16; ++code) {
    server_ = std::make_shared<FakeChatServer>();
    const auto status = static_cast<StatusCode>(code);
    server_->Fail(Status(status, "the server's own words"));
    const auto answer = Generate();
    if (status == StatusCode::kCancelled) {
      EXPECT_EQ(answer.status().code(), StatusCode::kCancelled);
      continue;
    }
    ASSERT_TRUE(answer.ok()) << ToString(status) << ": " << answer.status().ToString();
    ASSERT_EQ(answer->warnings.size(), 2u);
    EXPECT_NE(answer->warnings[0].find(ToString(status)), std::string::npos);
    EXPECT_NE(answer->warnings[0].find("the server's own words"), std::string::npos);
    EXPECT_NE(answer->warnings[0].find("embedded"), std::string::npos);
    EXPECT_EQ(answer->warnings[1], "own warning");
  }
}

TEST_F(FallbackTest, AnswersThatNoTurnRepairsFallBackToo) {
  server_->Say("no").Say("never").Say("not at all");
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok());
  EXPECT_NE(answer->warnings[0].find("DATA_LOSS"), std::string::npos);
  // What was refused is kept, and why nothing came of it.
  ASSERT_EQ(replies_.size(), 4u);
  EXPECT_EQ(replies_[0].text, "no");
  EXPECT_EQ(replies_[2].text, "not at all");
  EXPECT_EQ(replies_[3].purpose, "layout");
  EXPECT_EQ(replies_[3].failure.code(), StatusCode::kDataLoss);
}

TEST_F(FallbackTest, WhatFailedAsItWasRecordedIsAnsweredTheSameWayWithoutAServer) {
  server_->Say("no").Fail(Unavailable("gone"));
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok());
  ASSERT_EQ(replies_.size(), 2u);
  std::vector<ModelReply> replies;
  const auto again = MakeFallbackLayoutGenerator(MakeFailedLayoutGenerator("remote", replies_),
                                                 std::make_unique<Embedded>())
                         ->Generate(request_, progress_, &replies);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->warnings, answer->warnings);
  ASSERT_EQ(replies.size(), 2u);
  EXPECT_EQ(replies[0].text, "no");
  EXPECT_EQ(replies[1].purpose, "layout");
  EXPECT_EQ(replies[1].failure.ToString(), replies_[1].failure.ToString());
}

TEST_F(FallbackTest, AnInvalidRequestIsRefusedByBoth) {
  request_.instruction = "";
  const auto answer = Generate();
  EXPECT_EQ(answer.status().code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(server_->requests().empty());
}

TEST_F(FallbackTest, ACancelDuringAFailureIsACancel) {
  server_->Say({Unavailable("gone"), "", "", 1, [this] { progress_.Cancel(); }});
  EXPECT_EQ(Generate().status().code(), StatusCode::kCancelled);
}

TEST_F(FallbackTest, WhenBothFailBothAreNamed) {
  server_->Fail(Unavailable("nobody there"));
  const auto answer = Generate(Internal("broken"));
  EXPECT_EQ(answer.status().code(), StatusCode::kInternal);
  EXPECT_NE(answer.status().message().find("nobody there"), std::string::npos);
  EXPECT_NE(answer.status().message().find("broken"), std::string::npos);
}

TEST_F(FallbackTest, EnvironmentFallsBackByTheSameRule) {
  const SymbolicLayout layout = ParseLayout(LegalMatrix(), Vocabulary::kSuburb).value();
  EnvironmentRequest request;
  request.layout = &layout;
  server_->Fail(Status(StatusCode::kUnauthenticated, "bad key"));
  auto generator = MakeFallbackEnvironmentGenerator(MakeRemoteEnvironmentGenerator(server_, {}),
                                                    std::make_unique<Embedded>());
  const auto answer = generator->Generate(request, progress_, &replies_);
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToJson(answer->environment), LegalEnvironment());
  EXPECT_NE(answer->warnings[0].find("UNAUTHENTICATED"), std::string::npos);
  ASSERT_EQ(replies_.size(), 1u);
  EXPECT_EQ(replies_[0].purpose, "environment");
  EXPECT_EQ(replies_[0].failure.code(), StatusCode::kUnauthenticated);
  request.layout = nullptr;
  EXPECT_EQ(generator->Generate(request, progress_).status().code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
