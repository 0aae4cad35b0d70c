#include "latticeworld/language/chat/model_list.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

TEST(ModelListTest, TakesTheFirstNameOfEitherShape) {
  EXPECT_EQ(FirstModel(R"({"object":"list","data":[{"id":"a"},{"id":"b"}]})"), "a");
  EXPECT_EQ(FirstModel(R"({"models":[{"name":"c","model":"d"}]})"), "c");
  EXPECT_EQ(FirstModel(R"({"models":[{"name":"c"}],"data":[{"id":"a"}]})"), "a");
  EXPECT_EQ(FirstModel(R"({"data":[7,{"id":null},{"id":"b"}]})"), "b");
}

TEST(ModelListTest, PassesOverModelsThatAnswerNothing) {
  for (const char* other :
       {"nomic-embed-text:latest", "text-embedding-3-small", "embeddinggemma", "BAAI/bge-m3",
        "bge-reranker-v2-m3", "Qwen3-Embedding-0.6B", "jina-rerank", "all-minilm", "tts-1",
        "whisper-1", "omni-moderation-latest", "dall-e-3"}) {
    const std::string list =
        R"({"data":[{"id":")" + std::string(other) + R"("},{"id":"qwen3:8b"}]})";
    EXPECT_EQ(FirstModel(list), "qwen3:8b") << other;
  }
}

TEST(ModelListTest, TakesWhatThereIsWhereAllSeemToAnswerNothing) {
  EXPECT_EQ(FirstModel(R"({"data":[{"id":"my-embedded"},{"id":"bge-m3"}]})"), "my-embedded");
}

TEST(ModelListTest, GoesByWholeWordsOfTheNameAndNotByItsFolder) {
  for (const char* name : {"/models/embedding/qwen.gguf", "code5-bgex", "ttsx", "Dallas-7B"}) {
    const std::string list = R"({"data":[{"id":")" + std::string(name) + R"("},{"id":"second"}]})";
    EXPECT_EQ(FirstModel(list), name);
  }
}

TEST(ModelListTest, FindsNoneInAnythingElse) {
  for (const char* list : {"", "{}", "[]", "{\"data\":{}}", "{\"data\":[]}", "{\"data\":[\"a\"]}",
                           "<html>", "{\"data\":"}) {
    EXPECT_EQ(FirstModel(list), "") << list;
  }
}

}  // namespace
}  // namespace latticeworld
