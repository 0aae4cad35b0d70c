#include "latticeworld/language/sentences/sentence.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/sentences/sentence_matcher.h"

namespace latticeworld {

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
  if (!text.empty() && text.back() == '.') text.remove_suffix(1);
  SentenceMatcher matcher(text);
  for (const SentenceForm& form : SentenceForms(kind)) {
    std::optional<Phrase> whole = matcher.Match(form.pattern);
    if (whole.has_value()) return Sentence{&form, std::move(*whole)};
  }
  return std::nullopt;
}

}  // namespace latticeworld
