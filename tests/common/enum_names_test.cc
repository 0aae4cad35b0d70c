#include "latticeworld/common/enum_names.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

enum class Fruit { kApple, kPear, kUnnamed };
constexpr std::array<EnumName<Fruit>, 2> EnumNames(Fruit) {
  return {{{Fruit::kApple, "apple"}, {Fruit::kPear, "pear"}}};
}

TEST(EnumNamesTest, NamesAndValuesAreInverse) {
  for (const auto& entry : EnumNames(Fruit{})) {
    EXPECT_EQ(FromName<Fruit>(NameOf(entry.value)), entry.value);
  }
}

TEST(EnumNamesTest, WhatIsNotInTheTableHasNoValue) {
  EXPECT_EQ(NameOf(Fruit::kUnnamed), "?");
  EXPECT_FALSE(FromName<Fruit>("Apple").has_value());
  EXPECT_FALSE(FromName<Fruit>("").has_value());
}

TEST(EnumNamesTest, LegalNamesListsAll) { EXPECT_EQ(LegalNames<Fruit>(), "apple, pear"); }

}  // namespace
}  // namespace latticeworld
