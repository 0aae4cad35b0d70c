#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

// Stands for the embedded back end.
class Embedded final : public LayoutGenerator, public EnvironmentGenerator {
 public:
  explicit Embedded(Status error = Status()) : error_(std::move(error)) {}
  std::string_view name() const override { return "embedded"; }
  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress&) override {
    if (!error_.ok()) return error_;
    LayoutAnswer answer;
    answer.layout = ParseLayout(LegalMatrix(), request.vocabulary).value();
    answer.warnings = {"own warning"};
    return answer;
  }
  Result<EnvironmentAnswer> Generate(const EnvironmentRequest&, const Progress&) override {
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
    return generator->Generate(request_, progress_);
  }

  std::shared_ptr<FakeChatServer> server_ = std::make_shared<FakeChatServer>();
  LayoutRequest request_{"a lake", Vocabulary::kSuburb, nullptr, 9};
  Progress progress_;
};

TEST_F(FallbackTest, AServerThatAnswersIsNotReplaced) {
  server_->Say(LegalMatrix());
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok());
  EXPECT_TRUE(answer->warnings.empty());
  EXPECT_EQ(answer->replies.size(), 1u);
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
  server_->Say("no").Say("no").Say("no");
  const auto answer = Generate();
  ASSERT_TRUE(answer.ok());
  EXPECT_NE(answer->warnings[0].find("DATA_LOSS"), std::string::npos);
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
  const auto answer = generator->Generate(request, progress_);
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_EQ(ToJson(answer->environment), LegalEnvironment());
  EXPECT_NE(answer->warnings[0].find("UNAUTHENTICATED"), std::string::npos);
  request.layout = nullptr;
  EXPECT_EQ(generator->Generate(request, progress_).status().code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
