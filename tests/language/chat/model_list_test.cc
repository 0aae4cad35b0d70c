#include "latticeworld/language/chat/model_list.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(ModelListTest, TakesTheFirstNameOfEitherShape) {
  EXPECT_EQ(FirstModel(R"({"object":"list","data":[{"id":"a"},{"id":"b"}]})"), "a");
  EXPECT_EQ(FirstModel(R"({"models":[{"name":"c","model":"d"}]})"), "c");
  EXPECT_EQ(FirstModel(R"({"models":[{"name":"c"}],"data":[{"id":"a"}]})"), "a");
  EXPECT_EQ(FirstModel(R"({"data":[7,{"id":null},{"id":"b"}]})"), "b");
}

TEST(ModelListTest, FindsNoneInAnythingElse) {
  for (const char* list : {"", "{}", "[]", "{\"data\":{}}", "{\"data\":[]}", "{\"data\":[\"a\"]}",
                           "<html>", "{\"data\":"}) {
    EXPECT_EQ(FirstModel(list), "") << list;
  }
}

}  // namespace
}  // namespace latticeworld
