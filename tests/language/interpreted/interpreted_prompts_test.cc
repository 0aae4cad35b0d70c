#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "latticeworld/language/interpreted/prompts.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/sentences/sentence_guide.h"

namespace latticeworld {
namespace {

// The sentences that a prompt quotes as examples: "A lake in the north."
std::vector<std::string> Examples(const std::string& prompt) {
  std::vector<std::string> examples;
  const std::regex quoted("\"([A-Z][^\"]*\\.)\"");
  for (std::sregex_iterator at(prompt.begin(), prompt.end(), quoted), end; at != end; ++at)
    examples.push_back((*at)[1]);
  return examples;
}

std::string SystemText(const std::vector<ChatMessage>& messages) { return messages.at(0).text; }

TEST(InterpretedPromptsTest, EverythingIsFilledInForBothVocabularies) {
  for (const auto vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    const auto messages = LayoutWordsMessages({"a {{tarn}}", vocabulary, nullptr, 1});
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[0].text.find("{{"), std::string::npos);
    EXPECT_NE(messages[1].text.find("a {{tarn}}"), std::string::npos);
    const bool wild = vocabulary == Vocabulary::kWild;
    EXPECT_EQ(messages[0].text.find("snow-capped land") != std::string::npos, wild);
    EXPECT_EQ(messages[0].text.find("farmland: fields") != std::string::npos, !wild);
  }
  EnvironmentRequest request;
  request.instruction = "at dusk";
  const std::string system = SystemText(EnvironmentWordsMessages(request));
  EXPECT_EQ(system.find("{{"), std::string::npos);
  for (const char* name : {"sandstorm", "cyberpunk", "robotic dog", "wetland"})
    EXPECT_NE(system.find(name), std::string::npos) << name;
  EXPECT_NE(SentencesRepairText({{"x", "", "is wrong", ""}}).find("- is wrong"), std::string::npos);
}

// A model that keeps to the examples is read: otherwise they mislead it.
TEST(InterpretedPromptsTest, EveryExampleIsASentenceOfTheLanguage) {
  const auto expect_read = [](const std::vector<std::string>& examples, SentenceKind kind) {
    EXPECT_GT(examples.size(), SentenceForms(kind).size() / 2);
    for (const std::string& example : examples) {
      for (const std::string& sentence : SplitSentences(example))
        EXPECT_TRUE(ReadSentence(sentence, kind).has_value()) << sentence;
    }
  };
  expect_read(Examples(SystemText(LayoutWordsMessages({"x", Vocabulary::kSuburb, nullptr, 1}))),
              SentenceKind::kLayout);
  expect_read(Examples(SystemText(EnvironmentWordsMessages({}))), SentenceKind::kEnvironment);
}

TEST(InterpretedPromptsTest, EveryFormAndEveryWordOfTheLanguageIsShown) {
  const std::string layout =
      SystemText(LayoutWordsMessages({"x", Vocabulary::kSuburb, nullptr, 1}));
  for (const SentenceForm& form : SentenceForms(SentenceKind::kLayout))
    EXPECT_NE(layout.find(form.written), std::string::npos) << form.name;
  for (const char* list : {"countable", "mass", "side", "exact", "heading", "shape"}) {
    for (const std::string& word : SentenceWords(list))
      EXPECT_NE(layout.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace latticeworld
