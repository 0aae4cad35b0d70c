#include <algorithm>
#include <set>
#include <string>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/spelling.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Made by the build: the files of data/.
std::string_view WordFile(std::string_view file_name);

namespace {

// The words of a file, whose lines that begin with # are comments.
void AddWordsOfFile(std::string_view file_name, std::set<std::string>* words) {
  std::string_view text = WordFile(file_name);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.front() == '#') continue;
    while (!line.empty()) {
      const std::size_t length = std::min(line.find(' '), line.size());
      if (length > 0) words->emplace(line.substr(0, length));
      line.remove_prefix(std::min(length + 1, line.size()));
    }
  }
}

std::string PluralOf(const std::string& word) {
  const auto ends = [&](std::string_view end) {
    return word.size() > end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0;
  };
  if (ends("s") || ends("x") || ends("ch") || ends("sh")) return word + "es";
  const bool vowel = ends("ay") || ends("ey") || ends("oy") || ends("uy");
  if (ends("y") && !vowel) return word.substr(0, word.size() - 1) + "ies";
  return word + "s";
}

const std::set<std::string>& OwnedLayoutWords() {
  static const std::set<std::string> words = [] {
    std::set<std::string> own;
    AddWordsOfFile("layout_words.txt", &own);
    for (const ClassWord& word : AllClassWords()) {
      const std::vector<Token> tokens = Tokenize(word.phrase);
      for (const Token& token : tokens) own.insert(token.text);
      const std::string& last = tokens.back().text;
      if (Singular(last) == last) own.insert(PluralOf(last));
    }
    return own;
  }();
  return words;
}

}  // namespace

const std::vector<std::string_view>& LayoutWords() {
  static const std::vector<std::string_view> words(OwnedLayoutWords().begin(),
                                                   OwnedLayoutWords().end());
  return words;
}

const std::vector<std::string_view>& CommonEnglishWords() {
  static const std::set<std::string> own = [] {
    std::set<std::string> read;
    AddWordsOfFile("english_words.txt", &read);
    return read;
  }();
  static const std::vector<std::string_view> words(own.begin(), own.end());
  return words;
}

}  // namespace latticeworld
