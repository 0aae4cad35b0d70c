#include "latticeworld/language/grounded/synthesis/relief_conflicts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

// Shares of the relief's height, as its summary has them.
constexpr double kLow = 0.3;
constexpr double kHigh = 0.7;
constexpr double kClimb = 0.2;  // between two places, one clearly above the other

std::string Percent(double share) { return std::to_string(std::lround(100.0 * share)); }

// The part of the zone that suits the class best: a quarter of its cells may be the high (low)
// ones that it is meant for. The zone must not be empty.
double BestQuarterOf(const LayoutMask& zone, bool wants_height, const Relief& relief) {
  std::vector<double> heights;
  for (int id = 0; id < kCellCount; ++id) {
    if (zone.Contains(CellOf(id))) heights.push_back(relief.summary[CellOf(id)]);
  }
  const std::size_t rank = wants_height ? heights.size() * 3 / 4 : heights.size() / 4;
  std::nth_element(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(rank),
                   heights.end());
  return heights[rank];
}

// Whether the words tell which end of a course is its beginning: "from north to south", "left to
// right", "enters in the west", but not "a vertical river", "from side to side".
bool NameBeginning(const std::string& words) {
  const std::vector<Token> tokens = Tokenize(words);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& word = tokens[i].text;
    const std::string next = i + 1 < tokens.size() ? tokens[i + 1].text : "";
    if (word == "from" && !IsOneOf(next, {"side", "one", "edge", "end", "border"})) return true;
    if (IsOneOf(word, {"enters", "rises", "springs", "starts", "begins", "originates"}))
      return true;
    const bool side = IsOneOf(word, {"north", "south", "east", "west", "left", "right", "top",
                                     "bottom", "northeast", "northwest", "southeast", "southwest"});
    if (side && next == "to") return true;
  }
  return false;
}

// How water that keeps to a course would run uphill; "": it would not.
std::string UphillCourse(const Claim& course, const Relief& relief) {
  const LayoutMask from = MaskOf(course.from);
  const LayoutMask to = MaskOf(course.to);
  if (course.from.is_anywhere() || course.to.is_anywhere() || from.empty() || to.empty()) return "";
  const double beginning = BestQuarterOf(from, /*wants_height=*/true, relief);
  const double end = BestQuarterOf(to, /*wants_height=*/false, relief);
  if (end - beginning <= kClimb || !NameBeginning(course.words)) return "";
  return "the " + course.from.name + " lies lower than the " + course.to.name + ", at " +
         Percent(beginning) + " and " + Percent(end) +
         " percent of the relief's height: water does not run uphill";
}

}  // namespace

std::vector<std::string> ReliefConflicts(const std::vector<Claim>& claims, Vocabulary vocabulary,
                                         const Relief& relief) {
  std::vector<std::string> warnings;
  for (const Claim& claim : claims) {
    const auto warn = [&](const std::string& conflict) {
      const std::string warning = "against the relief: " + Quote(claim.words) + ": " + conflict;
      // Several claims may come from the same words.
      if (warnings.empty() || warnings.back() != warning) warnings.push_back(warning);
    };
    if (claim.kind == ClaimKind::kCourse && claim.subject == 'W') {
      const std::string uphill = UphillCourse(claim, relief);
      if (!uphill.empty()) warn(uphill);
      continue;
    }
    const bool places = claim.kind == ClaimKind::kPresent || claim.kind == ClaimKind::kDominant ||
                        claim.kind == ClaimKind::kLocated ||
                        (claim.kind == ClaimKind::kAmount && claim.least != Claim::kUnsaid);
    if (!places || claim.zone.is_anywhere()) continue;
    const bool wants_height =
        vocabulary == Vocabulary::kWild && (claim.subject == 'S' || claim.subject == 'R');
    if (!wants_height && claim.subject != 'W') continue;
    const LayoutMask zone = MaskOf(claim.zone);
    if (zone.empty()) continue;
    const double height = BestQuarterOf(zone, wants_height, relief);
    if (wants_height ? height >= kLow : height <= kHigh) continue;
    warn("the " + claim.zone.name + " lies " +
         (wants_height ? "low, not above " : "high, not below ") + Percent(height) +
         " percent of the relief's height for the most part");
  }
  return warnings;
}

}  // namespace latticeworld
