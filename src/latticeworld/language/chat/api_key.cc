#include "latticeworld/language/chat/api_key.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::size_t kShortestSecret = 8;  // characters

}  // namespace

Result<ApiKey> ApiKey::FromEnvironment(const std::string& variable) {
  if (variable.empty()) return ApiKey();
  const auto refuse = [&](std::string_view why) {
    return Status(StatusCode::kUnauthenticated, "the environment variable " + Quote(variable) +
                                                    " that is to hold the server's key " +
                                                    std::string(why));
  };
  const char* found = std::getenv(variable.c_str());
  if (found == nullptr) return refuse("is not set");
  std::string_view value = found;
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = value.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return refuse("is empty");
  value = value.substr(begin, value.find_last_not_of(kBlanks) - begin + 1);
  // A line end within it would let it write headers of its own.
  if (!std::all_of(value.begin(), value.end(), [](char c) { return c > 0x20 && c < 0x7F; })) {
    return refuse("holds something else than visible ASCII characters");
  }
  return ApiKey(std::string(value));
}

std::string ApiKey::Scrub(std::string_view text) const {
  std::string clean;
  if (!empty()) {
    for (std::size_t at = text.find(value_); at != std::string_view::npos; at = text.find(value_)) {
      clean += text.substr(0, at);
      clean += "[key]";
      text.remove_prefix(at + value_.size());
    }
  }
  return clean += text;
}

bool ApiKey::IsGivenAwayBy(std::string_view text) const {
  return value_.size() >= kShortestSecret && text.find(value_) != std::string_view::npos;
}

}  // namespace latticeworld
