#include "latticeworld/language/sentences/sentence.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <functional>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

struct Word {
  std::string text;  // lower case
  std::string written;
};

// The words of a sentence; commas, colons and percent signs are words of their own.
std::vector<Word> WordsOf(std::string_view sentence) {
  std::vector<Word> words;
  const auto add = [&](std::string_view text) {
    if (!text.empty()) words.push_back({ToLowerAscii(text), std::string(text)});
  };
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= sentence.size(); ++at) {
    const char c = at < sentence.size() ? sentence[at] : ' ';
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!blank && c != ',' && c != ':' && c != '%') continue;
    add(sentence.substr(begin, at - begin));
    if (!blank) add(sentence.substr(at, 1));
    begin = at + 1;
  }
  return words;
}

bool IsNumber(std::string_view text) {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view rest =
      point == std::string_view::npos ? std::string_view("0") : text.substr(point + 1);
  constexpr std::size_t kMostDigits = 9;
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.size() <= kMostDigits &&
           std::all_of(part.begin(), part.end(), IsDigit);
  };
  return digits(whole) && digits(rest);
}

// Finds how a pattern covers a sentence's words, by trying what may stand at each place.
class Matcher {
 public:
  explicit Matcher(const std::vector<Word>& words) : words_(words) {}

  // The slots of a sentence that the pattern covers from its first word to its last.
  std::optional<Phrase> Match(const Pattern& pattern) {
    Phrase whole;
    const bool found =
        Try(pattern, 0, &whole, [&](std::size_t end) { return end == words_.size(); });
    if (!found) return std::nullopt;
    whole.text = TextOf(0, words_.size());
    return whole;
  }

 private:
  // What is to be tried once a part has covered the words before `end`.
  using Then = std::function<bool(std::size_t end)>;

  std::string TextOf(std::size_t begin, std::size_t end) const {
    std::string text;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) text += ' ';
      const bool label = std::find(labels_.begin(), labels_.end(), i) != labels_.end();
      text += label ? words_[i].written : words_[i].text;
    }
    return text;
  }

  // Every way in which the pattern covers words from `at` on is offered to `then`, until one is
  // taken. The slots of the way that is taken stay in `into`.
  bool Try(const Pattern& pattern, std::size_t at, Phrase* into, const Then& then) {
    switch (pattern.kind) {
      case Pattern::Kind::kWords:
        return at < words_.size() &&
               std::find(pattern.words.begin(), pattern.words.end(), words_[at].text) !=
                   pattern.words.end() &&
               then(at + 1);
      case Pattern::Kind::kSlot:
        return TrySlot(pattern.name, at, into, then);
      case Pattern::Kind::kSequence:
        return TrySequence(pattern, 0, at, into, then);
      case Pattern::Kind::kChoice:
        return std::any_of(pattern.parts.begin(), pattern.parts.end(),
                           [&](const Pattern& part) { return Try(part, at, into, then); });
      case Pattern::Kind::kOptional:
        return Try(pattern.parts.front(), at, into, then) || then(at);
      case Pattern::Kind::kRepeat: {
        const auto again = [&](std::size_t end) {
          return end > at && Try(pattern, end, into, then);
        };
        return Try(pattern.parts.front(), at, into, again) || then(at);
      }
    }
    return false;
  }

  bool TrySequence(const Pattern& pattern, std::size_t part, std::size_t at, Phrase* into,
                   const Then& then) {
    if (part == pattern.parts.size()) return then(at);
    return Try(pattern.parts[part], at, into,
               [&](std::size_t end) { return TrySequence(pattern, part + 1, end, into, then); });
  }

  bool TrySlot(const std::string& name, std::size_t at, Phrase* into, const Then& then) {
    if (at >= words_.size()) return false;
    if (name == "n") return IsNumber(words_[at].text) && Take(name, at, at + 1, into, then);
    if (name == "label") {
      const std::string& written = words_[at].written;
      return written.size() == 1 && std::isupper(static_cast<unsigned char>(written[0])) != 0 &&
             Take(name, at, at + 1, into, then);
    }
    if (const Pattern* pattern = SlotPattern(name); pattern != nullptr) {
      // The slot's own parts are collected apart and belong to the way that is taken.
      Phrase filled;
      filled.slot = name;
      return Try(*pattern, at, &filled, [&](std::size_t end) {
        Phrase whole = filled;
        whole.text = TextOf(at, end);
        into->parts.push_back(std::move(whole));
        if (then(end)) return true;
        into->parts.pop_back();
        return false;
      });
    }
    return std::any_of(SentenceWords(name).begin(), SentenceWords(name).end(),
                       [&](const std::string& word) {
                         const std::size_t end = EndOf(word, at);
                         return end > at && Take(name, at, end, into, then);
                       });
  }

  // Returns where the phrase ends if it stands at `at`, else `at`.
  std::size_t EndOf(std::string_view phrase, std::size_t at) const {
    if (phrase.front() != words_[at].text.front()) return at;  // as most of a list
    std::size_t end = at;
    for (std::size_t begin = 0; begin <= phrase.size(); ++end) {
      const std::size_t blank = std::min(phrase.find(' ', begin), phrase.size());
      if (end >= words_.size() || words_[end].text != phrase.substr(begin, blank - begin))
        return at;
      begin = blank + 1;
    }
    return end;
  }

  bool Take(const std::string& slot, std::size_t at, std::size_t end, Phrase* into,
            const Then& then) {
    if (slot == "label") labels_.push_back(at);
    Phrase phrase;
    phrase.slot = slot;
    phrase.text = TextOf(at, end);
    into->parts.push_back(std::move(phrase));
    if (then(end)) return true;
    into->parts.pop_back();
    if (slot == "label") labels_.pop_back();
    return false;
  }

  const std::vector<Word>& words_;
  std::vector<std::size_t> labels_;  // which words are labels on the way that is tried
};

}  // namespace

const Phrase* Phrase::Find(std::string_view name) const {
  for (const Phrase& part : parts) {
    if (part.slot == name) return &part;
    if (const Phrase* inner = part.Find(name); inner != nullptr) return inner;
  }
  return nullptr;
}

std::vector<const Phrase*> Phrase::FindAll(std::string_view name) const {
  std::vector<const Phrase*> found;
  for (const Phrase& part : parts) {
    if (part.slot == name) found.push_back(&part);
    for (const Phrase* inner : part.FindAll(name)) found.push_back(inner);
  }
  return found;
}

bool Sentence::Says(std::string_view word) const {
  const std::vector<std::string> words = Split(whole.text, ' ');
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string> SplitSentences(std::string_view text) {
  std::vector<std::string> sentences;
  const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    const bool end = at == text.size() || text[at] == '\n' ||
                     (text[at] == '.' && (at + 1 == text.size() || is_blank(text[at + 1])));
    if (!end) continue;
    std::string_view sentence = text.substr(begin, at - begin);
    while (!sentence.empty() && is_blank(sentence.front())) sentence.remove_prefix(1);
    while (!sentence.empty() && is_blank(sentence.back())) sentence.remove_suffix(1);
    if (!sentence.empty()) sentences.emplace_back(sentence);
    begin = at + 1;
  }
  return sentences;
}

std::optional<Sentence> ReadSentence(std::string_view text, SentenceKind kind) {
  constexpr std::size_t kMostWords = 64;
  if (!text.empty() && text.back() == '.') text.remove_suffix(1);
  const std::vector<Word> words = WordsOf(text);
  if (words.empty() || words.size() > kMostWords) return std::nullopt;
  for (const SentenceForm& form : SentenceForms(kind)) {
    std::optional<Phrase> whole = Matcher(words).Match(form.pattern);
    if (whole.has_value()) return Sentence{&form, std::move(*whole)};
  }
  return std::nullopt;
}

}  // namespace latticeworld
