#include "latticeworld/language/sentences/sentence_writer.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

// What the slots of a phrase were filled with, those of the form itself and not what they hold.
std::vector<Filling> FillingsOf(const Sentence& sentence) {
  std::vector<Filling> fillings;
  for (const Phrase& part : sentence.whole.parts) fillings.emplace_back(part.slot, part.text);
  return fillings;
}

std::string Written(SentenceKind kind, const std::string& form,
                    const std::vector<Filling>& fillings) {
  return WriteSentence(kind, form, fillings);
}

TEST(SentenceWriterTest, WritesTheExampleOfEveryFormFromItsSlots) {
  for (const SentenceKind kind : {SentenceKind::kLayout, SentenceKind::kEnvironment}) {
    for (const SentenceForm& form : SentenceForms(kind)) {
      const std::optional<Sentence> sentence = ReadSentence(form.example, kind);
      ASSERT_TRUE(sentence.has_value()) << form.example;
      const std::string written = Written(kind, form.name, FillingsOf(*sentence));
      const std::optional<Sentence> again = ReadSentence(written, kind);
      ASSERT_TRUE(again.has_value()) << written;
      EXPECT_EQ(again->form, sentence->form) << written;
      EXPECT_EQ(FillingsOf(*again), FillingsOf(*sentence)) << written;
    }
  }
}

TEST(SentenceWriterTest, AVerbAgreesWithItsSubject) {
  const auto covers = [](const std::string& subject) {
    return Written(SentenceKind::kLayout, "cover", {{"x", subject}, {"percent", "30 %"}});
  };
  EXPECT_EQ(covers("forest"), "Forest covers 30 % of the map");
  EXPECT_EQ(covers("the lakes"), "The lakes cover 30 % of the map");
  EXPECT_EQ(covers("2 small ponds"), "2 small ponds cover 30 % of the map");
}

TEST(SentenceWriterTest, SaysWhatMayBeMissingWhereItIsFilled) {
  EXPECT_EQ(Written(SentenceKind::kLayout, "there", {{"x", "a lake"}}), "A lake");
  EXPECT_EQ(Written(SentenceKind::kLayout, "there", {{"x", "a lake"}, {"zone", "the north"}}),
            "A lake in the north");
}

}  // namespace
}  // namespace latticeworld
