#ifndef LATTICEWORLD_LANGUAGE_CHAT_API_KEY_H_
#define LATTICEWORLD_LANGUAGE_CHAT_API_KEY_H_

#include <string>
#include <string_view>

#include "latticeworld/common/result.h"

namespace latticeworld {

// ApiKey holds the secret that a server wants to see, and takes care that it shows up nowhere else.
class ApiKey {
 public:
  ApiKey() = default;  // no key

  // Returns the key in an environment variable, without the blanks around it; no key where
  // `variable` is "". Errors: UNAUTHENTICATED when the variable is unset or empty or holds anything
  // but visible ASCII; no message repeats what it holds.
  static Result<ApiKey> FromEnvironment(const std::string& variable);

  bool empty() const { return value_.empty(); }
  // Returns the key for the request's header, and for nothing else.
  const std::string& value() const { return value_; }

  // Returns the text with "[key]" wherever the key stands in it. Scrub a text before it is cut for
  // a message, so that no half of a key stays.
  std::string Scrub(std::string_view text) const;

  // Returns whether a text gives the key away. A key of a few letters, such as "none" for a server
  // that wants just any, occurs in texts by itself and is no secret.
  bool IsGivenAwayBy(std::string_view text) const;

 private:
  explicit ApiKey(std::string value) : value_(std::move(value)) {}

  std::string value_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_API_KEY_H_
