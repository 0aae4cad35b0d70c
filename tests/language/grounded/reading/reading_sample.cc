#include "language/grounded/reading/reading_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/language/grounded/reading/layout_parser.h"

namespace latticeworld {
namespace {

std::string HeadingName(Claim::Heading heading) {
  std::string name;
  if (heading.south != 0) name += heading.south < 0 ? "N" : "S";
  if (heading.east != 0) name += heading.east < 0 ? "W" : "E";
  return name;
}

// "amount F 32..48": an amount with its bounds, percent; without a bound above: "amount F 32..".
std::string ShowShare(const Claim& claim) {
  const auto percent = [](double share) {
    return std::to_string(static_cast<int>(std::lround(100.0 * share)));
  };
  std::string text = "amount " + std::string(1, claim.subject) + " ";
  if (claim.least != Claim::kUnsaid) text += percent(claim.least);
  text += "..";
  if (claim.most != Claim::kUnsaid) text += percent(claim.most);
  return text + (claim.zone.is_anywhere() ? "" : "@" + claim.zone.name);
}

}  // namespace

std::string Show(const Claim& claim) {
  std::string text(NameOf(claim.kind));
  text += ' ';
  if (claim.kind == ClaimKind::kOrder) {
    return text + claim.sequence + ">" + HeadingName(claim.heading);
  }
  text += claim.subject;
  if (claim.object != '\0') text += std::string(" ") + claim.object;
  if (claim.second_object != '\0') text += std::string(" ") + claim.second_object;
  if (claim.kind == ClaimKind::kCourse) text += " " + claim.from.name + ">" + claim.to.name;
  if (claim.kind == ClaimKind::kDirection) text += " " + HeadingName(claim.heading);
  if (claim.kind == ClaimKind::kShape) text += " " + std::string(NameOf(claim.shape));
  if (claim.kind == ClaimKind::kCount) {
    text += " " + std::to_string(static_cast<int>(claim.least)) + "..";
    if (claim.most != Claim::kUnsaid) text += std::to_string(static_cast<int>(claim.most));
  }
  if (!claim.zone.is_anywhere()) text += "@" + claim.zone.name;
  return text;
}

std::vector<std::string> Claims(const LayoutPlan& plan) {
  std::vector<std::string> shown;
  for (const Claim& claim : plan.claims) shown.push_back(Show(claim));
  return shown;
}

std::string Listed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

void ExpectRead(const Sample& sample) {
  const LayoutPlan plan = ParseLayoutInstruction(sample.instruction, sample.vocabulary);
  std::vector<std::string> claims = Claims(plan);
  for (const Claim& claim : plan.claims)
    if (claim.kind == ClaimKind::kAmount) claims.push_back(ShowShare(claim));
  for (const std::string& claim : sample.claims) {
    EXPECT_NE(std::find(claims.begin(), claims.end(), claim), claims.end())
        << claim << " is not among" << Listed(claims);
  }
  for (const std::string& claim : sample.wrong) {
    EXPECT_EQ(std::find(claims.begin(), claims.end(), claim), claims.end())
        << claim << " is among" << Listed(claims);
  }
}

void ExpectReadInCapitals(const Sample& sample) {
  std::string capitals = sample.instruction;
  for (char& c : capitals) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  EXPECT_EQ(Claims(ParseLayoutInstruction(sample.instruction, sample.vocabulary)),
            Claims(ParseLayoutInstruction(capitals, sample.vocabulary)));
}

}  // namespace latticeworld
