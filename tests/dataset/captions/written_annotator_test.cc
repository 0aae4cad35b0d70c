#include "latticeworld/dataset/captions/written_annotator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "dataset/made_layouts.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/layout_facts.h"
#include "latticeworld/dataset/sources/generated_source.h"
#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

constexpr int kSeeds = 150;  // of each vocabulary

std::vector<Instance> Instances() {
  std::vector<Instance> instances;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
      instances.push_back(MadeInstance(vocabulary, seed, seed % 3 == 0));
    }
  }
  return instances;
}

TEST(WrittenAnnotatorTest, NeverSaysWhatTheLayoutContradicts) {
  const auto annotator = MakeWrittenAnnotator();
  int claims = 0;
  for (const Instance& instance : Instances()) {
    const auto caption = annotator->DescribeLayout(instance, 1, Progress());
    ASSERT_TRUE(caption.ok()) << caption.status().ToString();
    for (const Claim& claim : caption->claims) {
      const ClaimMeasure measure = Measure(claim, instance.layout);
      EXPECT_TRUE(measure.holds) << caption->text << "\n" << measure.explanation;
      ++claims;
    }
  }
  EXPECT_GT(claims, 2 * kSeeds * 4);
}

// A reader who knows nothing of how the captions are made finds them true. What it reads wrongly is
// its own share of the three in a hundred.
TEST(WrittenAnnotatorTest, AReaderFindsTheCaptionsTrue) {
  const auto annotator = MakeWrittenAnnotator();
  int read = 0, satisfied = 0, not_understood = 0;
  std::set<ClaimKind> kinds;
  for (const Instance& instance : Instances()) {
    const auto caption = annotator->DescribeLayout(instance, 2, Progress());
    ASSERT_TRUE(caption.ok());
    const LayoutReading reading = ReadLayoutInstruction(caption->text, instance.layout.vocabulary);
    not_understood += !reading.plan.not_understood.empty();
    for (const Claim& claim : reading.plan.claims) {
      ++read;
      satisfied += Measure(claim, instance.layout).holds;
      kinds.insert(claim.kind);
    }
  }
  const double share = static_cast<double>(satisfied) / read;
  std::cout << "read " << read << " claims of " << 2 * kSeeds << " captions, " << 100.0 * share
            << " % satisfied; " << not_understood
            << " captions hold words that were not understood\n";
  EXPECT_GE(share, 0.97);
  EXPECT_GE(read, 2 * kSeeds * 4) << "the words say what the facts are";
  EXPECT_LE(not_understood, 2 * kSeeds / 50);
  EXPECT_GE(kinds.size(), 14u) << "captions speak of all kinds of things";
}

// Slips that a program makes and a person does not.
TEST(WrittenAnnotatorTest, NothingIsWrittenThatNobodyWouldWrite) {
  const std::pair<const char*, std::regex> slips[] = {
      {"a word twice", std::regex("\\b([A-Za-z]+) \\1\\b")},
      {"one of many", std::regex("\\b[Oo]ne [a-z]+s\\b")},
      {"a wrong article", std::regex("\\b[Aa] [aeiou]|\\b[Aa]n [^aeiou]")},
      {"a pronoun without a verb",
       std::regex("(^|\\. )(It|They) (all|only|in|on|at|next|within|between|far)\\b")},
      {"a wrong number",
       std::regex("[Tt]hey (is|lies|runs|covers)\\b|\\b[Ii]t (are|lie|run|cover)\\b")},
      {"a subject twice in a sentence",
       std::regex(
           "(?:^|\\. )(?:the )?(?!it |there )([a-z ]+) (?:lies?|is|are) [^.]*[,;] (?:while |and )?"
           "(?:the )?\\1 (?:lies?|is|are)",
           std::regex::icase)},
      {"a wish joined with a statement", std::regex(", (and|while) put |please, (and|while)")},
      {"a share of several",
       std::regex("(half|thirds?|quarters?|tenth|fifths?|%) of (the|it) [a-z]+ are ")},
      {"an endless fraction", std::regex("[0-9]\\.[0-9]{4}")}};
  const auto annotator = MakeWrittenAnnotator();
  std::vector<Instance> instances = Instances();
  instances.resize(100);
  GeneratedSourceOptions generated;
  generated.groups = 100;
  for (std::size_t i = 0; i < generated.groups; ++i)
    instances.push_back(GeneratePlace(generated, i).instance);
  for (const Instance& instance : instances) {
    const auto layout = annotator->DescribeLayout(instance, 3, Progress());
    ASSERT_TRUE(layout.ok());
    const auto environment = annotator->DescribeEnvironment(instance, *layout, 3, Progress());
    ASSERT_TRUE(environment.ok());
    for (const std::string& text : {layout->text, layout->relief_text, environment->text}) {
      for (const auto& [slip, pattern] : slips) {
        EXPECT_FALSE(std::regex_search(text, pattern)) << slip << ": " << text;
      }
    }
  }
}

TEST(WrittenAnnotatorTest, ACaptionIsRefutedByAnotherLayout) {
  // What is said of one place is not said of every place: on others, many claims fail.
  const auto annotator = MakeWrittenAnnotator();
  const std::vector<Instance> instances = Instances();
  int claims = 0, hold = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const auto caption = annotator->DescribeLayout(instances[i], 3, Progress());
    ASSERT_TRUE(caption.ok());
    for (const Claim& claim : caption->claims) {
      ++claims;
      hold += Measure(claim, instances[i + 100].layout).holds;
    }
  }
  EXPECT_LT(hold, 0.6 * claims);
}

TEST(WrittenAnnotatorTest, TheSameSeedWritesTheSameAndAnotherSeedOtherWords) {
  const auto annotator = MakeWrittenAnnotator();
  const Instance instance = MadeInstance(Vocabulary::kSuburb, 12, true);
  const auto caption = annotator->DescribeLayout(instance, 4, Progress());
  const auto again = MakeWrittenAnnotator()->DescribeLayout(instance, 4, Progress());
  EXPECT_EQ(caption->text, again->text);
  EXPECT_EQ(caption->relief_text, again->relief_text);
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    texts.insert(annotator->DescribeLayout(instance, seed, Progress())->text);
  }
  EXPECT_GE(texts.size(), 49u);
}

TEST(WrittenAnnotatorTest, RotationsOfAPlaceAreDescribedAnew) {
  const auto annotator = MakeWrittenAnnotator();
  Instance instance = MadeInstance(Vocabulary::kSuburb, 8, false);
  const std::string text = annotator->DescribeLayout(instance, 4, Progress())->text;
  instance.id += "_r90";
  EXPECT_NE(annotator->DescribeLayout(instance, 4, Progress())->text, text);
}

TEST(WrittenAnnotatorTest, VoicesAndOpeningsVary) {
  const auto annotator = MakeWrittenAnnotator();
  std::map<std::string, int> first_words;
  double shortest = 1e9, longest = 0;
  const std::vector<Instance> instances = Instances();
  for (const Instance& instance : instances) {
    const std::string text = annotator->DescribeLayout(instance, 5, Progress())->text;
    const std::vector<std::string> words = Split(text, ' ');
    ++first_words[words.front()];
    shortest = std::min<double>(shortest, static_cast<double>(words.size()));
    longest = std::max<double>(longest, static_cast<double>(words.size()));
    EXPECT_EQ(text.find("  "), std::string::npos) << text;
    EXPECT_EQ(text.find_first_of("{}[]|"), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.') << text;
  }
  EXPECT_GE(first_words.size(), 15u);
  for (const auto& [word, count] : first_words) EXPECT_LE(count, 2 * kSeeds / 3) << word;
  EXPECT_GE(longest, 3 * shortest);
}

TEST(WrittenAnnotatorTest, AReliefIsToldWhereThereIsOne) {
  const auto annotator = MakeWrittenAnnotator();
  EXPECT_TRUE(annotator->DescribeLayout(MadeInstance(Vocabulary::kWild, 4, false), 1, Progress())
                  ->relief_text.empty());
  EXPECT_FALSE(annotator->DescribeLayout(MadeInstance(Vocabulary::kWild, 4, true), 1, Progress())
                   ->relief_text.empty());
}

TEST(WrittenAnnotatorTest, TypingMistakesAreAnOptionAndCanBeRead) {
  WrittenOptions options;
  options.mistyped = 0.1;
  const auto slips = MakeWrittenAnnotator(options);
  const auto clean = MakeWrittenAnnotator();
  int changed = 0, read = 0, satisfied = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Instance instance = MadeInstance(Vocabulary::kSuburb, seed, false);
    const std::string text = slips->DescribeLayout(instance, 6, Progress())->text;
    changed += text != clean->DescribeLayout(instance, 6, Progress())->text;
    for (const Claim& claim : ReadLayoutInstruction(text, Vocabulary::kSuburb).plan.claims) {
      ++read;
      satisfied += Measure(claim, instance.layout).holds;
    }
  }
  EXPECT_GE(changed, 40);
  EXPECT_GE(satisfied, 0.93 * read) << satisfied << " of " << read;
}

TEST(WrittenAnnotatorTest, EveryLayoutOfOneClassHasWords) {
  for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    for (const LayoutClass& entry : ClassesOf(vocabulary)) {
      Instance instance{"one", "one", {vocabulary, Grid<char>(32, 32, entry.letter)}, nullptr};
      const auto caption = MakeWrittenAnnotator()->DescribeLayout(instance, 1, Progress());
      ASSERT_TRUE(caption.ok()) << entry.letter << ": " << caption.status().ToString();
      for (const Claim& claim : caption->claims) {
        EXPECT_TRUE(Measure(claim, instance.layout).holds) << caption->text;
      }
    }
  }
}

TEST(WrittenAnnotatorTest, ACancelledCallWritesNothing) {
  Progress progress;
  progress.Cancel();
  const Instance instance = MadeInstance(Vocabulary::kSuburb, 1, false);
  EXPECT_EQ(MakeWrittenAnnotator()->DescribeLayout(instance, 1, progress).status().code(),
            StatusCode::kCancelled);
}

TEST(WrittenOptions, EveryViolationIsNamed) {
  EXPECT_TRUE(Validate(WrittenOptions()).empty());
  WrittenOptions options;
  options.least_facts = 0;
  options.most_facts = 40;
  options.mistyped = 0.9;
  options.size_m = -1.0;
  EXPECT_EQ(Validate(options).size(), 4u);
}

}  // namespace
}  // namespace latticeworld
