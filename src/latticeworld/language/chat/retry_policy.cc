#include "latticeworld/language/chat/retry_policy.h"

#include <curl/curl.h>

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kLongestWaitS = 60.0;

}  // namespace

RetryPolicy::RetryPolicy(double first_wait_s, std::uint64_t seed)
    : first_wait_s_(first_wait_s), jitter_(seed, "chat_backoff") {}

double RetryPolicy::WaitSeconds(int retry, std::optional<double> retry_after_s) {
  const double whole_s = std::min(std::ldexp(first_wait_s_, retry), kLongestWaitS);
  return std::max(whole_s * jitter_.Uniform(0.5, 1.0), retry_after_s.value_or(0.0));
}

std::optional<double> ParseRetryAfter(const std::string& retry_after, const std::string& date) {
  if (retry_after.empty()) return std::nullopt;
  if (retry_after.find_first_not_of("0123456789") == std::string::npos) {
    // More digits than any wait has: as good as for ever.
    return retry_after.size() > 9 ? 1e9 : static_cast<double>(std::stol(retry_after));
  }
  const time_t then = curl_getdate(retry_after.c_str(), nullptr);
  const time_t now = curl_getdate(date.c_str(), nullptr);
  if (then == -1 || now == -1) return std::nullopt;
  return std::max(0.0, static_cast<double>(then - now));
}

}  // namespace latticeworld
