#include "latticeworld/common/request_fields.h"

#include <gtest/gtest.h>

#include <array>

namespace latticeworld {
namespace {

enum class Size { kVerySmall, kLarge };
constexpr std::array<EnumName<Size>, 2> EnumNames(Size) {
  return {{{Size::kVerySmall, "very small"}, {Size::kLarge, "large"}}};
}

TEST(RequestFieldsTest, NamesAreReadWithLowLinesTooAndOthersRefused) {
  std::vector<Violation> violations;
  EXPECT_EQ(ReadName<Size>("size", "very_small", &violations), Size::kVerySmall);
  EXPECT_EQ(ReadName<Size>("size", "large", &violations), Size::kLarge);
  EXPECT_TRUE(violations.empty());
  EXPECT_FALSE(ReadName<Size>("size", "huge", &violations).has_value());
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].pointer, "size");
  EXPECT_EQ(violations[0].message, "\"huge\" is unknown; legal are very small, large");
}

TEST(RequestFieldsTest, WhatCannotBeReadIsToldBesideWhatIsIllegal) {
  const Status status =
      RefuseUnread("spawn", {{"", "state", "is unknown", ""}}, {{"", "team", "is 99", ""}});
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.message(), "spawn (2 violations): state: is unknown; team: is 99");
}

TEST(RequestFieldsTest, ViolationsAreCalledAsTheirReadersKnowThem) {
  std::vector<Violation> violations = {{"", "size", "", ""}, {"", "seed", "", ""}};
  Rename({{"size", "size_m"}, {"mass", "mass_kg"}}, &violations);
  EXPECT_EQ(violations[0].pointer, "size_m");
  EXPECT_EQ(violations[1].pointer, "seed");
}

}  // namespace
}  // namespace latticeworld
