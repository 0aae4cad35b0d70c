#include "latticeworld/common/status.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"

namespace latticeworld {
namespace {

TEST(StatusTest, ViolationsAreAllInTheMessage) {
  const Status status = Status::FromViolations(
      "illegal world grid", {{"out_of_range", "size", "must be positive", "-1"},
                             {"out_of_range", "resolution", "must be a number", "nan"}});
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.ToString(),
            "INVALID_ARGUMENT: illegal world grid (2 violations): size: must be positive; "
            "resolution: must be a number");
  ASSERT_EQ(status.violations().size(), 2u);
  EXPECT_EQ(status.violations()[1].given, "nan");
}

TEST(StatusTest, TellsTheFirstViolationsAndKeepsAll) {
  std::vector<Violation> violations;
  for (int i = 0; i < Status::kViolationsTold + 7; ++i) {
    violations.push_back({"bad", "row " + std::to_string(i), "is bad", "?"});
  }
  const Status status = Status::FromViolations("illegal layout", violations);
  EXPECT_NE(status.message().find("(27 violations)"), std::string::npos);
  EXPECT_NE(status.message().find("row 19: is bad; and 7 more"), std::string::npos);
  EXPECT_EQ(status.message().find("row 20"), std::string::npos);
  EXPECT_EQ(status.violations().size(), violations.size());

  violations.resize(Status::kViolationsTold);
  const Status whole = Status::FromViolations("illegal layout", violations);
  EXPECT_EQ(whole.message().find("more"), std::string::npos);
}

TEST(StatusTest, NoViolationIsOk) { EXPECT_TRUE(Status::FromViolations("x", {}).ok()); }

TEST(StatusTest, ContextKeepsCodeAndViolations) {
  const Status inner = Status::FromViolations("inner", {{"a", "b", "c", "d"}});
  const Status outer = inner.WithContext("while loading");
  EXPECT_EQ(outer.code(), inner.code());
  EXPECT_EQ(outer.message(), "while loading: inner: b: c");
  EXPECT_EQ(outer.violations().size(), 1u);
  EXPECT_TRUE(Status().WithContext("anything").ok());
}

Result<int> Half(int value) {
  if (value % 2 != 0) return InvalidArgument("odd");
  return value / 2;
}

Result<int> Quarter(int value) {
  LW_ASSIGN_OR_RETURN(const int half, Half(value));
  return Half(half);
}

TEST(ResultTest, ATemporaryHandsOutItsValueAndNoReference) {
  using Temporary = Result<std::vector<int>>;
  static_assert(std::is_same_v<decltype(std::declval<Temporary>().value()), std::vector<int>>);
  static_assert(std::is_same_v<decltype(*std::declval<Temporary>()), std::vector<int>>);
  int sum = 0;
  for (const int value : *Temporary(std::vector<int>{1, 2, 3})) sum += value;
  EXPECT_EQ(sum, 6);
}

TEST(ResultTest, FailurePassesThrough) {
  EXPECT_EQ(*Quarter(8), 2);
  EXPECT_EQ(Quarter(6).status().message(), "odd");
  EXPECT_EQ(Quarter(5).status().code(), StatusCode::kInvalidArgument);
}

TEST(ResultDeathTest, ValueOfAFailureIsABug) {
  EXPECT_DEATH((void)Half(1).value(), "value of a failed Result: INVALID_ARGUMENT: odd");
}

TEST(ProgressTest, ReportsAndCancels) {
  std::string reported;
  Progress progress([&](std::string_view stage, double fraction) {
    reported = std::string(stage) + " " + std::to_string(fraction);
  });
  progress.Report("terrain", 0.5);
  EXPECT_EQ(reported, "terrain 0.500000");
  EXPECT_TRUE(progress.CheckCancelled().ok());
  progress.Cancel();
  EXPECT_EQ(progress.CheckCancelled().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
