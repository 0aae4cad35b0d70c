#include "latticeworld/dataset/captions/phrase_book.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

std::string_view DatasetFile(std::string_view file_name);  // compiled in from data/ and prompts/

namespace {

constexpr std::string_view kVoiceLetters = "tlsx";  // in the order of Voice

// The voices of a field: "*" or letters of kVoiceLetters; 0: neither.
std::uint8_t VoicesOf(std::string_view field) {
  if (field == "*") return 0x0F;
  std::uint8_t voices = 0;
  for (const char letter : field) {
    const std::size_t at = kVoiceLetters.find(letter);
    if (at == std::string_view::npos) return 0;
    voices |= static_cast<std::uint8_t>(1u << at);
  }
  return voices;
}

bool IsLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}  // namespace

Result<PhraseBook> PhraseBook::Parse(std::string_view text) {
  PhraseBook book;
  std::vector<Violation> violations;
  int number = 0;
  for (const std::string& line : Split(text, '\n')) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> fields = Split(line, '\t');
    const std::uint8_t voices = fields.size() == 3 ? VoicesOf(fields[1]) : 0;
    if (fields.size() != 3 || fields[0].empty() || voices == 0 || fields[2].empty()) {
      violations.push_back({"bad_line", "line " + std::to_string(number),
                            "a line is key<TAB>voices<TAB>phrase; voices are * or letters of " +
                                std::string(kVoiceLetters) + "; given " + Quote(line),
                            line});
      continue;
    }
    book.phrases_[fields[0]].push_back({fields[2], voices});
  }
  if (!violations.empty()) return Status::FromViolations("phrases", std::move(violations));
  return book;
}

const PhraseBook& PhraseBook::BuiltIn() {
  static const PhraseBook book = [] {
    std::string text;
    for (const char* file : {"layout_phrases.txt", "layout_nouns.txt", "relief_phrases.txt",
                             "environment_phrases.txt"}) {
      text.append(DatasetFile(file)).append("\n");
    }
    return Parse(text).value();
  }();
  return book;
}

const std::string& PhraseBook::Pick(std::string_view key, Voice voice, RandomStream* random) const {
  const auto found = phrases_.find(key);
  LW_CHECK(found != phrases_.end(), "no phrase has the key " + std::string(key));
  const std::vector<Phrase>& phrases = found->second;
  const unsigned bit = 1u << static_cast<unsigned>(voice);
  int fitting = 0;
  for (const Phrase& phrase : phrases) fitting += (phrase.voices & bit) != 0;
  // A key without a phrase of the voice lends one of another's.
  const bool any = fitting == 0;
  int left = random->UniformInt(1, any ? static_cast<int>(phrases.size()) : fitting);
  for (const Phrase& phrase : phrases) {
    if ((any || (phrase.voices & bit) != 0) && --left == 0) return phrase.text;
  }
  return phrases.back().text;
}

std::vector<std::string> PhraseBook::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, phrases] : phrases_) keys.push_back(key);
  return keys;
}

std::vector<std::string> PhraseBook::PhrasesOf(std::string_view key) const {
  std::vector<std::string> texts;
  const auto found = phrases_.find(key);
  if (found == phrases_.end()) return texts;
  for (const Phrase& phrase : found->second) texts.push_back(phrase.text);
  return texts;
}

std::string FillPhrase(std::string_view phrase, const std::vector<Slot>& slots, bool plural) {
  std::string text;
  for (std::size_t at = 0; at < phrase.size();) {
    const char open = phrase[at];
    if (open != '{' && open != '[') {
      text += open;
      ++at;
      continue;
    }
    const std::size_t end = phrase.find(open == '{' ? '}' : ']', at);
    LW_CHECK(end != std::string_view::npos, "open bracket in " + std::string(phrase));
    const std::string_view inside = phrase.substr(at + 1, end - at - 1);
    if (open == '{') {
      const auto slot = std::find_if(slots.begin(), slots.end(),
                                     [&](const Slot& one) { return one.name == inside; });
      LW_CHECK(slot != slots.end(), "no slot of this name in " + std::string(phrase));
      text += slot->text;
    } else {
      const std::size_t bar = inside.find('|');
      LW_CHECK(bar != std::string_view::npos, "no choice in " + std::string(phrase));
      text += plural ? inside.substr(bar + 1) : inside.substr(0, bar);
    }
    at = end + 1;
  }
  return text;
}

std::string Capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string NumberWord(int number) {
  static constexpr std::string_view kWords[] = {"no",   "one",    "two",   "three", "four",
                                                "five", "six",    "seven", "eight", "nine",
                                                "ten",  "eleven", "twelve"};
  if (number >= 0 && number <= 12) return std::string(kWords[number]);
  return std::to_string(number);
}

std::string Mistyped(std::string text, double share_of_words, RandomStream* random) {
  constexpr std::size_t kShortest = 5;  // shorter words become other words
  std::string typed;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && IsLetter(text[end])) ++end;
    if (end == at) {
      typed += text[at++];
      continue;
    }
    std::string word = text.substr(at, end - at);
    at = end;
    if (word.size() >= kShortest && random->Chance(share_of_words)) {
      const auto place =
          static_cast<std::size_t>(random->UniformInt(1, static_cast<int>(word.size()) - 2));
      switch (random->UniformInt(0, 2)) {
        case 0:
          std::swap(word[place], word[place + 1]);
          break;
        case 1:
          word.insert(place, 1, word[place]);
          break;
        default:
          word.erase(place, 1);
      }
    }
    typed += word;
  }
  return typed;
}

}  // namespace latticeworld
