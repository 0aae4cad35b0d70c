#include "latticeworld/language/reading/words/table_words.h"

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

std::string Singular(std::string word) {
  if (word.size() <= 3 || word.back() != 's' || word[word.size() - 2] == 's') return word;
  word.pop_back();
  if (EndsWith(word, "ie")) word.replace(word.size() - 2, 2, "y");
  return word;
}

}  // namespace

std::set<std::string> TableWordsOf(std::string_view text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : ToLowerAscii(text) + " ") {
    if (c >= 'a' && c <= 'z') {
      word += c;
    } else if (!word.empty()) {
      words.insert(Singular(std::exchange(word, "")));
    }
  }
  return words;
}

std::vector<std::pair<std::string, std::vector<std::string>>> LinesOfTable(std::string_view table) {
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;
  for (const std::string& line : Split(table, '\n')) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> parts = Split(line, '\t');
    lines.emplace_back(parts.at(0), Split(parts.at(1), ' '));
  }
  return lines;
}

}  // namespace latticeworld
