#include "latticeworld/language/grounded/reading/sense.h"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "latticeworld/common/text.h"

namespace latticeworld {

std::string_view ReadingFile(std::string_view file_name);

namespace {

constexpr std::size_t kMaxPhraseTokens = 7;

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool EndsWithAny(std::string_view word, std::initializer_list<std::string_view> ends) {
  return std::any_of(ends.begin(), ends.end(), [&](std::string_view end) {
    return word.size() > end.size() && word.substr(word.size() - end.size()) == end;
  });
}

// "cross over": itself, "crosses over", "crossing over".
std::vector<std::string> Inflected(std::string_view phrase) {
  const std::size_t space = std::min(phrase.find(' '), phrase.size());
  const std::string verb(phrase.substr(0, space));
  const std::string rest(phrase.substr(space));
  const std::string stem = verb.substr(0, verb.size() - 1);
  const bool vowel_y = EndsWithAny(verb, {"ay", "ey", "oy", "uy"});
  std::string third = verb + "s";
  if (EndsWithAny(verb, {"y"}) && !vowel_y) third = stem + "ies";
  if (EndsWithAny(verb, {"s", "x", "ch", "sh", "z", "go", "do"})) third = verb + "es";
  const bool drops_e = EndsWithAny(verb, {"e"}) && !EndsWithAny(verb, {"ee"});
  const bool is_lie = EndsWithAny(verb, {"ie"});
  // "hug", "skid": the last letter is doubled.
  const auto is_vowel = [](char c) {
    return std::string_view("aeiou").find(c) != std::string::npos;
  };
  const std::size_t n = verb.size();
  const bool doubles = n >= 3 && n <= 4 && !is_vowel(verb[n - 1]) && is_vowel(verb[n - 2]) &&
                       !is_vowel(verb[n - 3]) && !EndsWithAny(verb, {"w", "x", "y"});
  const std::string participle = is_lie    ? verb.substr(0, verb.size() - 2) + "ying"
                                 : drops_e ? stem + "ing"
                                 : doubles ? verb + verb.back() + "ing"
                                           : verb + "ing";
  return {verb + rest, third + rest, participle + rest};
}

// Phrases are told apart as the tokens of an instruction are.
std::string Normal(std::string_view phrase) {
  const std::vector<Token> tokens = Tokenize(phrase);
  return JoinWords(tokens, 0, tokens.size());
}

struct Table {
  std::unordered_map<std::string, Sense> by_phrase;
  std::unordered_map<std::string, std::size_t> longest_by_first_word;
  std::set<std::string> words;
  std::vector<std::string> errors;

  // Phrases given as they are come before inflected ones.
  explicit Table(std::string_view text) {
    std::vector<std::pair<std::string, Sense>> inflected;
    std::size_t number = 0;
    for (const std::string& line : Split(text, '\n')) {
      ++number;
      if (line.empty() || line[0] == '#') continue;
      const std::string where = "line " + std::to_string(number) + ": ";
      const std::size_t colon = line.find(':');
      const std::string_view name = std::string_view(line).substr(0, std::min(colon, line.size()));
      const std::optional<Sense> sense = FromName<Sense>(name);
      if (colon == std::string::npos || !sense.has_value()) {
        errors.push_back(where + Quote(name) + " is no sense; legal are " + LegalNames<Sense>());
        continue;
      }
      for (const std::string& part : Split(std::string_view(line).substr(colon + 1), '|')) {
        const std::string_view phrase = Trimmed(part);
        if (phrase.empty()) {
          errors.push_back(where + "an empty phrase");
        } else if (phrase[0] == '~') {
          for (const std::string& form : Inflected(phrase.substr(1))) {
            inflected.emplace_back(Normal(form), *sense);
          }
        } else if (!Add(Normal(phrase), *sense)) {
          errors.push_back(where + Quote(phrase) + " stands in the file twice");
        }
      }
    }
    for (const auto& [phrase, sense] : inflected) Add(phrase, sense);
  }

  bool Add(const std::string& phrase, Sense sense) {
    if (!by_phrase.emplace(phrase, sense).second) return false;
    std::size_t count = 0;
    for (const std::string& word : Split(phrase, ' ')) {
      words.insert(word);
      ++count;
    }
    std::size_t& longest = longest_by_first_word[phrase.substr(0, phrase.find(' '))];
    longest = std::max(longest, std::min(count, kMaxPhraseTokens));
    return true;
  }
};

const Table& Senses() {
  static const Table table(SenseFile());
  return table;
}

}  // namespace

std::string_view SenseFile() { return ReadingFile("layout_senses.txt"); }

std::vector<std::string> CheckSenses(std::string_view text) { return Table(text).errors; }

std::vector<std::string_view> SenseWords() {
  return {Senses().words.begin(), Senses().words.end()};
}

SenseMatch MatchSense(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != TokenKind::kWord) return {};
  const Table& table = Senses();
  const auto first = table.longest_by_first_word.find(tokens[at].text);
  if (first == table.longest_by_first_word.end()) return {};
  std::size_t words = 1;
  while (words < first->second && at + words < tokens.size() &&
         tokens[at + words].kind == TokenKind::kWord) {
    ++words;
  }
  for (; words > 0; --words) {
    const auto found = table.by_phrase.find(JoinWords(tokens, at, at + words));
    if (found != table.by_phrase.end()) return {found->second, words};
  }
  return {};
}

}  // namespace latticeworld
