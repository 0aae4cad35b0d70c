#include "latticeworld/language/reading/words/table_words.h"

#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

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
