#include "latticeworld/language/chat/retry_policy.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

namespace latticeworld {
namespace {

TEST(RetryPolicyTest, WaitsDoubleWithJitterAndEndAtAMinute) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RetryPolicy policy(0.5, seed);
    for (int retry = 0; retry < 20; ++retry) {
      const double whole_s = retry < 7 ? 0.5 * (1 << retry) : 60.0;
      const double wait_s = policy.WaitSeconds(retry, std::nullopt);
      EXPECT_GE(wait_s, 0.5 * whole_s);
      EXPECT_LE(wait_s, whole_s);
    }
  }
}

TEST(RetryPolicyTest, TheSameSeedWaitsTheSameAndAnotherDoesNot) {
  RetryPolicy one(1.0, 7), same(1.0, 7), other(1.0, 8);
  const double wait_s = one.WaitSeconds(0, std::nullopt);
  EXPECT_EQ(wait_s, same.WaitSeconds(0, std::nullopt));
  EXPECT_NE(wait_s, other.WaitSeconds(0, std::nullopt));
}

TEST(RetryPolicyTest, NeverComesBackBeforeTheServerWishes) {
  RetryPolicy policy(0.5, 7);
  EXPECT_EQ(policy.WaitSeconds(0, 90.0), 90.0);
  EXPECT_GE(policy.WaitSeconds(0, 0.0), 0.25);  // and not at once although it would let us
}

TEST(RetryPolicyTest, ReadsSecondsAndDates) {
  const char* now = "Sun, 06 Nov 1994 08:49:37 GMT";
  struct Row {
    const char* retry_after;
    const char* date;
    std::optional<double> seconds;
  };
  const Row rows[] = {
      {"", now, std::nullopt},
      {"0", "", 0.0},
      {"120", "", 120.0},
      {"999999999999999999999999", "", 1e9},
      {"-5", now, std::nullopt},
      {"1.5", now, std::nullopt},
      {"soon", now, std::nullopt},
      {"Sun, 06 Nov 1994 08:50:07 GMT", now, 30.0},
      {"Sunday, 06-Nov-94 08:50:07 GMT", now, 30.0},
      {"Sun Nov  6 08:50:07 1994", now, 30.0},
      {"Sun, 06 Nov 1994 08:49:00 GMT", now, 0.0},
      {"Sun, 06 Nov 1994 08:50:07 GMT", "", std::nullopt},
      {"Sun, 06 Nov 1994 08:50:07 GMT", "today", std::nullopt},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(ParseRetryAfter(row.retry_after, row.date), row.seconds)
        << row.retry_after << " at " << row.date;
  }
}

}  // namespace
}  // namespace latticeworld
