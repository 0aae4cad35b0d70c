#ifndef LATTICEWORLD_LANGUAGE_CHAT_RETRY_POLICY_H_
#define LATTICEWORLD_LANGUAGE_CHAT_RETRY_POLICY_H_

#include <cstdint>
#include <optional>
#include <string>

#include "latticeworld/common/random.h"

namespace latticeworld {

// RetryPolicy says how long to wait before the next try: exponential backoff with jitter, so that
// clients that failed together do not come back together. The jitter is drawn from the request's
// own seed.
class RetryPolicy {
 public:
  // first_wait_s, at least 0, is the wait before the first retry.
  RetryPolicy(double first_wait_s, std::uint64_t seed);

  // Returns the wait before a retry, where `retry` is 0 for the first: between half of and the
  // whole first_wait_s * 2^retry, at most a minute, and never less than what the server asks for.
  double WaitSeconds(int retry, std::optional<double> retry_after_s);

 private:
  double first_wait_s_;
  RandomStream jitter_;
};

// Reads a Retry-After header (RFC 9110, section 10.2.3): seconds, or a date that is taken relative
// to the Date header of the same answer, so that no clock here has to agree with the server's.
// Returns nullopt where it is absent, or neither.
std::optional<double> ParseRetryAfter(const std::string& retry_after, const std::string& date);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_RETRY_POLICY_H_
