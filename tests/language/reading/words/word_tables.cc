#include "language/reading/words/word_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/words/subjects.h"
#include "latticeworld/language/reading/words/table_words.h"
#include "latticeworld/language/reading/words/topics.h"

namespace latticeworld {
namespace {

constexpr int kFewestTexts = 8;  // with the topic and the word
constexpr int kFewestTextsOfTopic = 20;
constexpr double kLift = 8.0;        // by how much a word makes a topic more likely
constexpr double kLikely = 0.4;      // enough, however likely the topic is anyway
constexpr double kOtherTexts = 2.0;  // with the word, that were not seen

constexpr int kFewestSentences = 20;  // with the word
constexpr double kLeastWeight = 1.0;
constexpr double kMostWeight = 3.0;

struct Topic {
  int texts = 0;
  std::map<std::string, int> words;  // in how many of its texts each is
};

struct Counts {
  int texts = 0;
  std::map<std::string, int> words;
  std::map<std::string, Topic> topics;
};

void Count(const nlohmann::json& example, Counts* counts) {
  const std::set<std::string> words = TableWordsOf(example["text"].get<std::string>());
  ++counts->texts;
  for (const std::string& word : words) ++counts->words[word];
  if (example["kind"] != "environment") return;
  std::set<std::string> topics;
  for (const auto& sentence : example["sentences"]) {
    const std::vector<std::string> of = TopicsOf(sentence.get<std::string>());
    topics.insert(of.begin(), of.end());
  }
  for (const std::string& name : topics) {
    Topic& topic = counts->topics[name];
    ++topic.texts;
    for (const std::string& word : words) ++topic.words[word];
  }
}

std::vector<nlohmann::json> ReadExamples(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<nlohmann::json> examples;
  for (const auto& file : files) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);)
      examples.push_back(nlohmann::json::parse(line));
  }
  return examples;
}

}  // namespace

std::string TopicTable(const std::filesystem::path& examples) {
  Counts counts;
  for (const nlohmann::json& example : ReadExamples(examples)) Count(example, &counts);
  std::string table;
  for (const auto& [name, topic] : counts.topics) {
    if (topic.texts < kFewestTextsOfTopic) continue;
    const double likely = std::min(kLikely, kLift * topic.texts / counts.texts);
    std::set<std::string> words = OwnWordsOf(name);
    for (const auto& [word, texts] : topic.words) {
      if (texts >= kFewestTexts && texts >= likely * (counts.words.at(word) + kOtherTexts))
        words.insert(word);
    }
    table += name + "\t" + Join(std::vector<std::string>(words.begin(), words.end()), " ") + "\n";
  }
  return table;
}

std::string SubjectTable(const std::filesystem::path& examples) {
  std::map<std::string, std::array<int, 2>> words;  // in how many sentences of either kind each is
  std::array<double, 2> sentences = {};
  for (const nlohmann::json& example : ReadExamples(examples)) {
    const std::size_t kind = example["kind"] == "environment" ? 1 : 0;
    const auto text = example["text"].get<std::string>();
    for (const std::string_view sentence : FreeSentences(text)) {
      ++sentences[kind];
      for (const std::string& word : TableWordsOf(sentence)) ++words[word][kind];
    }
  }
  std::map<int, std::string> lines;  // by tenths of the weight
  for (const auto& [word, count] : words) {
    const double weight = std::log((count[1] + 1.0) / (sentences[1] + 2.0)) -
                          std::log((count[0] + 1.0) / (sentences[0] + 2.0));
    if (count[0] + count[1] < kFewestSentences || std::abs(weight) < kLeastWeight) continue;
    const double bounded = std::clamp(weight, -kMostWeight, kMostWeight);
    lines[static_cast<int>(std::lround(10.0 * bounded))] += " " + word;
  }
  std::string table;
  for (const auto& [tenths, line] : lines) {
    std::array<char, 16> weight;
    std::snprintf(weight.data(), weight.size(), "%.1f", tenths / 10.0);
    table += weight.data() + ("\t" + line.substr(1)) + "\n";
  }
  return table;
}

}  // namespace latticeworld
