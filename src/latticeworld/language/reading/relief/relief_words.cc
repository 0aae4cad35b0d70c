#include "latticeworld/language/reading/relief/relief_words.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

std::string_view ReliefWordFile(std::string_view file_name);  // data, compiled in

namespace {

struct Words {
  std::map<std::string, ReliefKind, std::less<>> kinds;
  std::set<std::string, std::less<>> land;
};

Words ReadWords() {
  Words words;
  for (const std::string& line : Split(ReliefWordFile("relief_words.txt"), '\n')) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> fields = Split(line, '\t');
    LW_CHECK(fields.size() == 2, "a line of relief words has a word and a kind");
    if (fields[0] == "wide") {
      for (std::string& word : Split(fields[1], ' ')) words.land.insert(std::move(word));
      continue;
    }
    const std::optional<ReliefKind> kind = FromName<ReliefKind>(fields[1]);
    LW_CHECK(kind.has_value(), "relief words name kinds of relief");
    words.kinds.emplace(fields[0], *kind);
  }
  return words;
}

const Words& All() {
  static const Words words = ReadWords();
  return words;
}

}  // namespace

std::optional<ReliefKind> ReliefOfWord(std::string_view word) {
  const auto found = All().kinds.find(word);
  if (found == All().kinds.end()) return std::nullopt;
  return found->second;
}

std::optional<ReliefKind> ReliefOfNoun(std::string_view phrase) {
  const std::vector<std::string> words = Split(phrase, ' ');
  std::optional<ReliefKind> kind = ReliefOfWord(Singular(words.back()));
  if (kind && !IsTexture(*kind)) return kind;
  if (words.size() == 1 || IsLandWord(Singular(words.back()))) kind = ReliefOfWord(words.front());
  return kind;
}

bool IsLandWord(std::string_view word) { return All().land.count(word) == 1; }

}  // namespace latticeworld
