#include "latticeworld/language/sentences/sentence_matcher.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {
namespace {

bool IsNumber(std::string_view text) {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view rest =
      point == std::string_view::npos ? std::string_view("0") : text.substr(point + 1);
  constexpr std::size_t kMostDigits = 9;
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.size() <= kMostDigits &&
           std::all_of(part.begin(), part.end(),
                       [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  };
  return digits(whole) && digits(rest);
}

bool IsLabel(std::string_view written) {
  return written.size() == 1 && std::isupper(static_cast<unsigned char>(written[0])) != 0;
}

}  // namespace

SentenceMatcher::SentenceMatcher(std::string_view sentence)
    : words_(WordsOf(sentence)), ends_of_slots_(words_.size()) {}

std::optional<Phrase> SentenceMatcher::Match(const Pattern& pattern) {
  if (words_.empty() || words_.size() > kMostWords) return std::nullopt;
  if (!EndsOf(pattern, Places().set(0)).test(words_.size())) return std::nullopt;
  Phrase whole;
  const bool found = Try(pattern, 0, &whole, [&](std::size_t end) { return end == words_.size(); });
  if (!found) return std::nullopt;
  whole.text = TextOf(0, words_.size());
  labels_.clear();
  return whole;
}

// Commas, colons and percent signs are words of their own.
std::vector<SentenceMatcher::Word> SentenceMatcher::WordsOf(std::string_view sentence) {
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

std::string SentenceMatcher::TextOf(std::size_t begin, std::size_t end) const {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin) text += ' ';
    const bool label = std::find(labels_.begin(), labels_.end(), i) != labels_.end();
    text += label ? words_[i].written : words_[i].text;
  }
  return text;
}

SentenceMatcher::Places SentenceMatcher::EndsOf(const Pattern& pattern, const Places& begins) {
  Places ends;
  switch (pattern.kind) {
    case Pattern::Kind::kWords:
      for (std::size_t at = 0; at < words_.size(); ++at) {
        ends[at + 1] = begins[at] && std::find(pattern.words.begin(), pattern.words.end(),
                                               words_[at].text) != pattern.words.end();
      }
      break;
    case Pattern::Kind::kSlot:
      for (std::size_t at = 0; at < words_.size(); ++at)
        if (begins[at]) ends |= EndsOfSlot(pattern.name, at);
      break;
    case Pattern::Kind::kSequence:
      ends = begins;
      for (const Pattern& part : pattern.parts)
        if (ends.any()) ends = EndsOf(part, ends);
      break;
    case Pattern::Kind::kChoice:
      for (const Pattern& part : pattern.parts) ends |= EndsOf(part, begins);
      break;
    case Pattern::Kind::kOptional:
      ends = begins | EndsOf(pattern.parts.front(), begins);
      break;
    case Pattern::Kind::kRepeat:
      ends = begins;
      for (Places more = begins; more.any();) {
        more = EndsOf(pattern.parts.front(), more) & ~ends;
        ends |= more;
      }
      break;
  }
  return ends;
}

const SentenceMatcher::Places& SentenceMatcher::EndsOfSlot(const std::string& slot,
                                                           std::size_t at) {
  auto& known = ends_of_slots_[at];
  const auto found = known.find(slot);
  if (found != known.end()) return found->second;
  return known.emplace(slot, FindEndsOfSlot(slot, at)).first->second;
}

SentenceMatcher::Places SentenceMatcher::FindEndsOfSlot(const std::string& slot, std::size_t at) {
  Places ends;
  if (slot == "n" || slot == "label") {
    ends[at + 1] = slot == "n" ? IsNumber(words_[at].text) : IsLabel(words_[at].written);
  } else if (const Pattern* const pattern = SlotPattern(slot); pattern != nullptr) {
    ends = EndsOf(*pattern, Places().set(at));
  } else {
    for (const std::string& phrase : SentenceWords(slot)) {
      const std::size_t end = EndOf(phrase, at);
      if (end > at) ends.set(end);
    }
  }
  return ends;
}

std::size_t SentenceMatcher::EndOf(std::string_view phrase, std::size_t at) const {
  if (phrase.front() != words_[at].text.front()) return at;  // as most of a list
  std::size_t end = at;
  for (std::size_t begin = 0; begin <= phrase.size(); ++end) {
    const std::size_t blank = std::min(phrase.find(' ', begin), phrase.size());
    if (end >= words_.size() || words_[end].text != phrase.substr(begin, blank - begin)) return at;
    begin = blank + 1;
  }
  return end;
}

bool SentenceMatcher::Try(const Pattern& pattern, std::size_t at, Phrase* into, const Then& then) {
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
      const auto again = [&](std::size_t end) { return end > at && Try(pattern, end, into, then); };
      return Try(pattern.parts.front(), at, into, again) || then(at);
    }
  }
  return false;
}

bool SentenceMatcher::TrySequence(const Pattern& pattern, std::size_t part, std::size_t at,
                                  Phrase* into, const Then& then) {
  if (part == pattern.parts.size()) return then(at);
  return Try(pattern.parts[part], at, into,
             [&](std::size_t end) { return TrySequence(pattern, part + 1, end, into, then); });
}

bool SentenceMatcher::TrySlot(const std::string& slot, std::size_t at, Phrase* into,
                              const Then& then) {
  if (at >= words_.size() || EndsOfSlot(slot, at).none()) return false;
  if (slot == "n" || slot == "label") return Take(slot, at, at + 1, into, then);
  if (const Pattern* const pattern = SlotPattern(slot); pattern != nullptr) {
    // The slot's own parts are collected apart and belong to the way that is taken.
    Phrase filled;
    filled.slot = slot;
    return Try(*pattern, at, &filled, [&](std::size_t end) {
      Phrase whole = filled;
      whole.text = TextOf(at, end);
      into->parts.push_back(std::move(whole));
      if (then(end)) return true;
      into->parts.pop_back();
      return false;
    });
  }
  const std::vector<std::string>& phrases = SentenceWords(slot);
  return std::any_of(phrases.begin(), phrases.end(), [&](const std::string& phrase) {
    const std::size_t end = EndOf(phrase, at);
    return end > at && Take(slot, at, end, into, then);
  });
}

bool SentenceMatcher::Take(const std::string& slot, std::size_t at, std::size_t end, Phrase* into,
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

}  // namespace latticeworld
