#include "latticeworld/language/chat/api_key.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace latticeworld {
namespace {

constexpr char kVariable[] = "LATTICEWORLD_TEST_KEY";

Result<ApiKey> KeyFrom(const char* value) {
  EXPECT_EQ(setenv(kVariable, value, 1), 0);
  return ApiKey::FromEnvironment(kVariable);
}

TEST(ApiKeyTest, IsTrimmed) {
  const auto key = KeyFrom(" \tsk-secret+/=_.~\r\n");
  ASSERT_TRUE(key.ok());
  EXPECT_EQ(key->value(), "sk-secret+/=_.~");
}

TEST(ApiKeyTest, NoVariableIsNoKey) {
  const auto key = ApiKey::FromEnvironment("");
  ASSERT_TRUE(key.ok());
  EXPECT_TRUE(key->empty());
  EXPECT_EQ(key->Scrub("any text"), "any text");
  EXPECT_FALSE(key->IsGivenAwayBy("any text"));
}

TEST(ApiKeyTest, RefusesWhatIsNoKeyAndNamesTheVariableOnly) {
  for (const char* value :
       {"", "  \n", "sk secret", "sk\nsecret: x", "sk\x01secret", "sk-\xC3\xB6"}) {
    const auto key = KeyFrom(value);
    ASSERT_FALSE(key.ok()) << value;
    EXPECT_EQ(key.status().code(), StatusCode::kUnauthenticated);
    EXPECT_NE(key.status().message().find(kVariable), std::string::npos);
    EXPECT_EQ(key.status().message().find("sk"), std::string::npos) << key.status().message();
    EXPECT_EQ(key.status().message().find("secret"), std::string::npos);
  }
  unsetenv(kVariable);
  const auto unset = ApiKey::FromEnvironment(kVariable);
  EXPECT_EQ(unset.status().code(), StatusCode::kUnauthenticated);
  EXPECT_NE(unset.status().message().find("is not set"), std::string::npos);
}

TEST(ApiKeyTest, ScrubsEveryPlaceWhereItStands) {
  const auto key = KeyFrom("aba-secret");
  ASSERT_TRUE(key.ok());
  EXPECT_EQ(key->Scrub("aba-secret and aba-secretaba-secret"), "[key] and [key][key]");
  EXPECT_EQ(key->Scrub("aba-secre"), "aba-secre");
  EXPECT_EQ(key->Scrub(""), "");
}

TEST(ApiKeyTest, AWordThatAnyServerTakesIsNoSecret) {
  EXPECT_TRUE(KeyFrom("sk-secret")->IsGivenAwayBy("it is sk-secret!"));
  EXPECT_FALSE(KeyFrom("none")->IsGivenAwayBy("none of it"));
}

}  // namespace
}  // namespace latticeworld
