#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "language/local/tiny_model.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/generation/bundle/rebuild.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

TinyModel Noise(std::uint64_t seed) {
  TinyModel model;
  model.layers = 1;
  model.width = 32;
  model.hidden = 32;
  model.context = 5000;  // a layout and what is said before it, but no environment
  model.seed = seed;
  return model;
}

GenerationRequest Request() {
  GenerationRequest request;
  request.layout_instruction = "A lake in the north.";
  request.environment_instruction = "Two sheep graze.";
  request.vocabulary = "suburb";
  request.generator = "local";
  request.seed = 7;
  request.size_m = 64.0;
  request.resolution_m = 1.0;
  return request;
}

Result<std::shared_ptr<const World>> Generate(const LocalModelOptions& options) {
  LW_ASSIGN_OR_RETURN(LoadedLanguage language, LoadLanguage({}, options));
  EXPECT_EQ(language.stack.default_generator, "local");
  return WorldGenerator(std::move(language.stack)).Generate(Request(), Progress());
}

void ExpectMadeAgain(const World& world) {
  const auto rebuilt = RebuildWorld(world, Progress());
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
  EXPECT_EQ((*rebuilt)->id, world.id);
  EXPECT_EQ((*rebuilt)->warnings, world.warnings);
}

TEST(LocalModelTest, AWorldOfAModelInThisProcessIsMadeAgainWithoutIt) {
  LocalModelOptions options;
  options.fallback = true;
  std::string id;
  {
    const ModelFile file(TinyGguf(Noise(1)));
    options.layout_model = file.path();
    const auto world = Generate(options);
    ASSERT_TRUE(world.ok()) << world.status().ToString();
    ASSERT_FALSE((*world)->replies.empty());
    EXPECT_EQ((*world)->replies[0].purpose, "layout");
    EXPECT_EQ((*world)->replies[0].model, "tiny");
    const auto rebuilt = RebuildWorld(**world, Progress());
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
    EXPECT_EQ(ToText((*rebuilt)->layout), ToText((*world)->layout));
    EXPECT_EQ((*rebuilt)->id, (*world)->id);
    EXPECT_EQ((*rebuilt)->warnings, (*world)->warnings);
    id = (*world)->id;
  }
  const ModelFile other(TinyGguf(Noise(2)));
  options.layout_model = other.path();
  const auto world = Generate(options);
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  EXPECT_NE((*world)->id, id);
}

TEST(LocalModelTest, WhatTheModelCannotWriteIsAnErrorOrTheGroundedBackEnds) {
  const ModelFile file(TinyGguf(Noise(1)));
  LocalModelOptions options;
  options.layout_model = file.path();
  const auto refused = Generate(options);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code(), StatusCode::kResourceExhausted) << refused.status().ToString();
  options.fallback = true;
  const auto world = Generate(options);
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  ASSERT_EQ((*world)->replies.size(), 2u);
  EXPECT_EQ((*world)->replies[1].failure.code(), StatusCode::kResourceExhausted);
  ASSERT_FALSE((*world)->warnings.empty());
  EXPECT_NE((*world)->warnings[0].find("grounded back end answered"), std::string::npos);
}

TEST(LocalModelTest, AnEnvironmentOfNoiseKeepsToTheRulesAndIsMadeAgain) {
  TinyModel noise = Noise(3);
  noise.context = 30000;  // an environment too
  const ModelFile file(TinyGguf(noise));
  LocalModelOptions options;
  options.layout_model = file.path();
  const auto world = Generate(options);
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  ASSERT_EQ((*world)->replies.size(), 2u) << "nothing went back to the model";
  EXPECT_EQ((*world)->replies[1].purpose, "environment");
  EXPECT_TRUE(Validate((*world)->environment).empty());
  const auto& warnings = (*world)->warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find(" cannot be ") != std::string::npos;
  })) << "noise knows no rules";
  ExpectMadeAgain(**world);
}

TEST(LocalModelTest, AModelOfLayoutsGoesWithTheGroundedBackEndsEnvironments) {
  const ModelFile file(TinyGguf(Noise(1)));
  LocalModelOptions options;
  options.layout_model = file.path();
  options.environment_model = "grounded";
  const auto world = Generate(options);
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  ASSERT_EQ((*world)->replies.size(), 1u);
  EXPECT_EQ((*world)->replies[0].purpose, "layout");
  EXPECT_EQ((*world)->environment.agents.size(), 1u);
  ExpectMadeAgain(**world);
}

// As much of a text as is legal, of whole pieces.
std::string AsMuchAsIsLegal(const std::string& piece) {
  std::string text;
  while (text.size() + piece.size() <= kMaxInstructionBytes) text += piece;
  return text;
}

TEST(ReaderModelTest, ALegalTextOfAnyLengthIsAnsweredAndItsWorldMadeAgain) {
  const ModelFile file(TinyGguf(Noise(1)));
  ReaderModelOptions options;
  options.model = file.path();
  WorldGenerator generator(std::move(LoadLanguage({}, {}, options)->stack));
  GenerationRequest request = Request();
  request.generator = "grounded";
  const std::pair<std::string, std::string> texts[] = {
      {"A lake in the north. ", "Two sheep graze in the rain. "},
      {"1234567890", "1234567890"},
      {"\xE6\xB9\x96", "\xE9\x9B\xA8"},          // Chinese: lake, rain
      {"\xF0\x9F\x8C\xB2", "\xF0\x9F\x90\x91"},  // a tree, a sheep
      {std::string(1, 'a'), "\xF0\x9F\x90\x91, and "},
  };
  for (const std::string reader : {"model", "checked"}) {
    for (const auto& [layout, environment] : texts) {
      request.reader = reader;
      request.layout_instruction = AsMuchAsIsLegal(layout) + "?";
      request.layout_instruction.resize(kMaxInstructionBytes, '?');
      request.environment_instruction = AsMuchAsIsLegal(environment);
      const auto world = generator.Generate(request, Progress());
      ASSERT_TRUE(world.ok()) << world.status().ToString();
      ASSERT_EQ((*world)->replies.size(), 2u) << layout;
      const auto& warnings = (*world)->warnings;
      EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                              [&reader](const std::string& warning) {
                                return warning.rfind(
                                           "the reader rules read the text, because the "
                                           "reader " +
                                               reader + " failed (RESOURCE_",
                                           0) == 0;
                              }),
                2)
          << layout;
      ExpectMadeAgain(**world);
    }
  }
}

TEST(ReaderModelTest, BothReadersOfAModelHaveTheRulesReadingBesideTheirs) {
  const ModelFile file(TinyGguf(Noise(1)));
  ReaderModelOptions options;
  options.model = file.path();
  WorldGenerator generator(std::move(LoadLanguage({}, {}, options)->stack));
  GenerationRequest request = Request();
  request.generator = "grounded";
  request.layout_instruction = "There is a lake up north.";
  request.environment_instruction = "A couple of sheep graze.";
  for (const std::string reader : {"model", "checked"}) {
    request.reader = reader;
    const auto world = generator.Generate(request, Progress());
    ASSERT_TRUE(world.ok()) << world.status().ToString();
    EXPECT_FALSE((*world)->fidelity.second.empty()) << reader;
    // Noise reads something else than the rules do.
    const auto& warnings = (*world)->warnings;
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
      return warning.rfind("a second reading differs: it does not ask for ", 0) == 0 &&
             warning.find("; it asks for ") != std::string::npos;
    })) << reader;
    const auto rebuilt = RebuildWorld(**world, Progress());
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.status().ToString();
    EXPECT_EQ((*rebuilt)->warnings, (*world)->warnings);
  }
}

TEST(LocalModelTest, SaysWhatIsWrongWithItsOptionsAndFiles) {
  LocalModelOptions options;
  options.layout_model = "/nowhere/layout.gguf";
  EXPECT_EQ(LoadLanguage({}, options).status().code(), StatusCode::kNotFound);
  options.temperature = 3.0;
  EXPECT_EQ(LoadLanguage({}, options).status().code(), StatusCode::kInvalidArgument);
  const ModelFile file(TinyGguf(Noise(1)));
  options.temperature = 0.5;
  options.layout_model = file.path();
  options.environment_model = "/tmp";
  EXPECT_EQ(LoadLanguage({}, options).status().code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
