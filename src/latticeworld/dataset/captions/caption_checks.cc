#include "latticeworld/dataset/captions/caption_checks.h"

#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostBytes = 2000;  // a caption is a paragraph
constexpr std::size_t kRowLetters = 24;   // so many capitals in a row are a matrix

void CheckProse(std::string_view text, std::vector<Violation>* violations) {
  const auto add = [&](std::string message) {
    violations->push_back({"not_prose", "", std::move(message), Quote(text)});
  };
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return add("there is no text; a paragraph is asked for");
  }
  if (const Status status = ValidateText("the text", text, kMostBytes); !status.ok()) {
    return add(status.message());
  }
  std::size_t capitals = 0;
  for (const char c : text) {
    capitals = c >= 'A' && c <= 'Z' ? capitals + 1 : 0;
    if (capitals >= kRowLetters) return add("the text holds a matrix; write sentences only");
  }
}

}  // namespace

Status CheckLayoutCaption(std::string_view text, const SymbolicLayout& layout, int least_claims,
                          std::vector<Claim>* claims) {
  std::vector<Violation> violations;
  CheckProse(text, &violations);
  if (!violations.empty()) return Status::FromViolations("caption", std::move(violations));
  const auto check = [&](const Claim& claim) {
    const ClaimMeasure measure = Measure(claim, layout);
    if (measure.holds) return;
    const bool told = std::any_of(violations.begin(), violations.end(),
                                  [&](const Violation& one) { return one.given == claim.words; });
    if (told) return;
    violations.push_back({"contradiction", "",
                          "you wrote " + Quote(claim.words) + ", but " + measure.explanation,
                          claim.words});
  };
  LayoutReading reading = ReadLayoutInstruction(text, layout.vocabulary);
  for (const Claim& claim : reading.plan.claims) check(claim);
  // If a text contradicts itself, the reader keeps one side; a "no" has to hold by itself.
  for (const std::string& sentence : Split(std::string(text), '.')) {
    if (sentence.find_first_not_of(" \t\r\n") == std::string::npos) continue;
    for (const Claim& claim : ReadLayoutInstruction(sentence, layout.vocabulary).plan.claims) {
      if (claim.kind == ClaimKind::kAbsent) check(claim);
    }
  }
  if (static_cast<int>(reading.plan.claims.size()) < least_claims) {
    violations.push_back({"says_too_little", "",
                          "only " + std::to_string(reading.plan.claims.size()) +
                              " statements about the land were understood; at least " +
                              std::to_string(least_claims) + " are asked, in plain words",
                          std::to_string(reading.plan.claims.size())});
  }
  if (!violations.empty()) return Status::FromViolations("caption", std::move(violations));
  *claims = std::move(reading.plan.claims);
  return Status();
}

Status CheckEnvironmentCaption(std::string_view text, const SymbolicLayout& layout,
                               const EnvironmentConfig& environment, double size_m) {
  std::vector<Violation> violations;
  // The text must be prose, and claim nothing that does not hold.
  CheckProse(text, &violations);
  if (!violations.empty()) return Status::FromViolations("caption", std::move(violations));
  for (const EnvironmentClaim& claim : ReadEnvironmentInstruction(text, &layout).claims) {
    const EnvironmentClaimMeasure measure = Measure(claim, environment);
    if (measure.holds) continue;
    violations.push_back({"contradiction", "",
                          "you wrote " + Quote(claim.words) + ", but " + measure.explanation,
                          claim.words});
  }
  // What a reader makes of the words alone.
  EnvironmentRequest request;
  request.instruction = std::string(text);
  request.layout = &layout;
  request.size_m = size_m;
  const auto answer = MakeGroundedEnvironmentGenerator()->Generate(request, Progress());
  if (!answer.ok()) return answer.status();
  const CoarseAttributes& read = answer->environment.coarse;
  const CoarseAttributes& meant = environment.coarse;
  const auto demand = [&](const char* what, std::string_view is, std::string_view asked) {
    if (is == asked) return;
    violations.push_back({"left_out", "",
                          "the text must say that the " + std::string(what) + " is " +
                              std::string(asked) + "; it was understood as " + std::string(is),
                          std::string(is)});
  };
  // It must say what a reader would not suppose: attributes, and every group of agents.
  demand("season", NameOf(read.season), NameOf(meant.season));
  demand("time of day", NameOf(read.time_of_day), NameOf(meant.time_of_day));
  demand("weather", NameOf(read.weather), NameOf(meant.weather));
  demand("style", NameOf(read.artistic_style), NameOf(meant.artistic_style));
  for (const AgentGroup& group : environment.agents) {
    const bool found =
        std::any_of(answer->environment.agents.begin(), answer->environment.agents.end(),
                    [&](const AgentGroup& one) {
                      return one.category == group.category && one.quantity == group.quantity &&
                             one.state == group.state && one.position == group.position;
                    });
    if (found) continue;
    std::string asked = std::to_string(group.quantity) + " " + std::string(NameOf(group.category)) +
                        ", " + std::string(NameOf(group.state));
    if (group.position != Region::kAnywhere) asked += ", " + std::string(NameOf(group.position));
    violations.push_back({"left_out", "", "the text must say plainly: " + asked, asked});
  }
  if (!violations.empty()) return Status::FromViolations("caption", std::move(violations));
  return Status();
}

}  // namespace latticeworld
