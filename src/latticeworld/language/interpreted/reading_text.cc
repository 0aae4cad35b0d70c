#include "latticeworld/language/interpreted/reading_text.h"

#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_claims_json.h"
#include "latticeworld/language/interpreted/sentences.h"
#include "latticeworld/layout/claims_json.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostBytesShown = 4000;  // to a person

std::string WithNotUnderstood(std::string claims, const std::vector<std::string>& words) {
  if (claims.empty()) claims = "(nothing)";
  for (const std::string& each : words) claims += "\nnot understood: " + Quote(each);
  return claims;
}

}  // namespace

std::string TextOf(const LayoutReading& reading) {
  return WithNotUnderstood(
      reading.plan.claims.empty() ? "" : std::string(Trimmed(EncodeClaims(reading.plan.claims))),
      reading.plan.not_understood);
}

std::string TextOf(const EnvironmentClaims& reading) {
  std::vector<std::string> lines;
  for (const EnvironmentClaim& claim : reading.claims) lines.push_back(ToJson(claim));
  return WithNotUnderstood(Join(lines, "\n"), reading.not_understood);
}

std::string ReadAsWarning(std::string_view words) {
  return "read as: " + Quote(words, kMostBytesShown);
}

}  // namespace latticeworld
