#include "latticeworld/language/reading/words/topics.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "latticeworld/language/reading/words/table_words.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {

std::string_view TopicWordFile(std::string_view file_name);  // data, compiled in

namespace {

using Words = std::set<std::string>;

constexpr std::string_view kCoarse[] = {"season", "weather", "time", "style", "terrain"};

// Agents of no kind of their own: whoever speaks of any kind speaks of them.
constexpr std::string_view kAnyAgent[] = {"agent", "animal", "robot"};

const std::map<std::string, Words, std::less<>>& TopicWords() {
  static const std::map<std::string, Words, std::less<>> table = [] {
    std::map<std::string, Words, std::less<>> words;
    for (const auto& [topic, list] : LinesOfTable(TopicWordFile("topic_words.txt")))
      words[topic] = Words(list.begin(), list.end());
    Words of_any;
    for (const std::string& who : SentenceWords("who")) {
      const auto found = words.find(who);
      if (found != words.end()) of_any.insert(found->second.begin(), found->second.end());
    }
    for (const std::string_view topic : kAnyAgent) words[std::string(topic)] = of_any;
    return words;
  }();
  return table;
}

// Whether a topic that begins with the word is a value of it: "season winter", "forest maple".
bool IsOf(std::string_view word) {
  if (std::find(std::begin(kCoarse), std::end(kCoarse), word) != std::end(kCoarse)) return true;
  const std::vector<std::string>& assets = SentenceWords("asset");
  return std::find(assets.begin(), assets.end(), word) != assets.end();
}

}  // namespace

std::vector<std::string> TopicsOf(std::string_view sentence) {
  const std::optional<Sentence> read = ReadSentence(sentence, SentenceKind::kEnvironment);
  std::vector<std::string> topics;
  if (!read) return topics;
  const std::string& form = read->form->name;
  const auto add = [&](std::string topic) {
    if (std::find(topics.begin(), topics.end(), topic) == topics.end())
      topics.push_back(std::move(topic));
  };
  const std::string asset = read->whole.Has("asset") ? read->whole.Find("asset")->text : "";
  if (form == "wind") add("wind");
  if (form == "level") add("lake level");
  if (form == "scale") add("building scale");
  if (form == "turned") add("building heading");
  if (form == "pitch") add("snow slope");
  if (form == "density") add(asset + " density");
  for (const Phrase* value : read->whole.FindAll("value")) add(asset + " " + value->text);
  for (const std::string_view coarse : kCoarse) {
    if (form != coarse) continue;
    for (const Phrase* value : read->whole.FindAll(coarse)) add(form + " " + value->text);
  }
  for (const Phrase* one : read->whole.FindAll("one")) add(SingularNoun("who", one->text));
  return topics;
}

std::set<std::string> OwnWordsOf(const std::string& topic) {
  const std::size_t blank = topic.find(' ');
  const bool is_value = blank != std::string::npos && IsOf(topic.substr(0, blank));
  return TableWordsOf(is_value ? topic.substr(blank) : topic);
}

bool SpeakOf(const std::set<std::string>& words, const std::string& topic) {
  const auto say_one = [&words](const std::set<std::string>& of_topic) {
    return std::any_of(of_topic.begin(), of_topic.end(),
                       [&words](const std::string& word) { return words.count(word) > 0; });
  };
  const auto found = TopicWords().find(topic);
  return say_one(found != TopicWords().end() ? found->second : OwnWordsOf(topic));
}

}  // namespace latticeworld
