#include "latticeworld/common/strict_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace latticeworld {
namespace {

// "code pointer" of every violation.
std::vector<std::string> Faults(const std::string& text, const JsonLimits& limits = {}) {
  nlohmann::json json;
  std::vector<Violation> violations;
  ParseStrictly(text, "a#", limits, &json, &violations);
  std::vector<std::string> faults;
  for (const Violation& violation : violations) {
    faults.push_back(violation.code + " " + violation.pointer);
  }
  return faults;
}

std::string Nested(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']');
}

using Strings = std::vector<std::string>;

TEST(StrictJsonTest, KeepsWhatIsWithinTheLimits) {
  nlohmann::json json;
  std::vector<Violation> violations;
  const std::string text = R"({"a":[1,{"b":"c"},[]],"d":null})";
  EXPECT_TRUE(ParseStrictly(text, "", JsonLimits(), &json, &violations));
  EXPECT_EQ(json.dump(), text);
  EXPECT_TRUE(violations.empty());
}

TEST(StrictJsonTest, EveryKeyThatStandsTwiceIsPlaced) {
  EXPECT_EQ(Faults(R"({"a":1,"b":[0,{"c/d":1,"c/d":2}],"a":3,"e":{"a":1}})"),
            Strings({"duplicate_key a#/b/1/c~1d", "duplicate_key a#/a"}));
}

TEST(StrictJsonTest, AKeyIsReportedOnceForEachObjectItRepeatsIn) {
  EXPECT_EQ(Faults(R"({"a":1,"a":2,"a":3,"b":{"a":1,"a":2,"a":3},"a":4})"),
            Strings({"duplicate_key a#/a", "duplicate_key a#/b/a"}));
}

TEST(StrictJsonTest, WhatIsNoDocumentIsNamed) {
  EXPECT_EQ(Faults(""), Strings({"parse_error a#"}));
  EXPECT_EQ(Faults("{\"a\": 1e400}"), Strings({"parse_error a#"}));
  EXPECT_EQ(Faults("[1] x"), Strings({"parse_error a#"}));
  EXPECT_EQ(Faults("\"\xff\""), Strings({"bad_encoding a#"}));
  JsonLimits limits;
  limits.max_bytes = 3;
  EXPECT_EQ(Faults("[1]", limits), Strings());
  EXPECT_EQ(Faults("[12]", limits), Strings({"too_long a#"}));
}

TEST(StrictJsonTest, DepthHasALimit) {
  EXPECT_EQ(Faults(Nested(8)), Strings());
  EXPECT_EQ(Faults(Nested(9)), Strings({"too_deep a#/0/0/0/0/0/0/0/0"}));
  EXPECT_EQ(Faults(Nested(200000)).size(), 1u);
}

// Twice the same key at each of 80,000 levels: paths to all of them would take gigabytes.
TEST(StrictJsonTest, KeysBelowTheLimitOfDepthAreNotCounted) {
  std::string text;
  while (text.size() < 900000) text += "{\"a\":0,\"a\":";
  text += "0" + std::string(text.size() / 11, '}');
  EXPECT_EQ(Faults(text).size(), 9u);  // of 8 levels, and that it is too deep
}

TEST(StrictJsonTest, WhatIsTooManyIsDroppedAndTheRestKeepsItsPlace) {
  JsonLimits limits;
  limits.max_keys = 2;
  limits.max_elements = 3;
  nlohmann::json json;
  std::vector<Violation> violations;
  EXPECT_TRUE(ParseStrictly(R"({"a":[0,1,2,{"x":{"x":0,"x":1}},4],"b":{},"c":[{"y":1,"y":2}]})", "",
                            limits, &json, &violations));
  EXPECT_EQ(json.dump(), R"({"a":[0,1,2],"b":{}})");
  // Within a member that is dropped keys are still compared, within an element they are not.
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].pointer, "/c/0/y");
}

TEST(StrictJsonTest, PointerTokensAreEscapedAndCut) {
  EXPECT_EQ(PointerToken("a/b~c"), "a~1b~0c");
  EXPECT_LT(PointerToken(std::string(1000, 'k')).size(), 100u);
}

TEST(StrictJsonTest, ViolationsAreCutToFiveHundred) {
  std::vector<Violation> violations(500);
  LimitViolations(&violations);
  EXPECT_EQ(violations.size(), 500u);
  violations.resize(733);
  LimitViolations(&violations);
  ASSERT_EQ(violations.size(), 501u);
  EXPECT_EQ(violations.back().code, "more_violations");
  EXPECT_NE(violations.back().message.find("233"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
