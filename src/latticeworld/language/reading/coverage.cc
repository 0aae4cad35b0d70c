#include "latticeworld/language/reading/coverage.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

// Returns where the stops and commas of a text are, then its end [bytes].
std::vector<std::size_t> StopsOf(std::string_view text) {
  std::vector<std::size_t> stops;
  for (const Token& token : Tokenize(text)) {
    if (token.kind == TokenKind::kStop || token.kind == TokenKind::kComma) {
      stops.push_back(token.begin);
    }
  }
  stops.push_back(text.size());
  return stops;
}

}  // namespace

TextCoverage CoverageOf(std::string_view text, const std::vector<std::string>& sentences,
                        SentenceKind kind, Vocabulary vocabulary) {
  return CoverageOfKeys(text, KeysOf(sentences, kind, vocabulary), kind, vocabulary);
}

TextCoverage CoverageOfKeys(std::string_view text, std::set<std::string> keys, SentenceKind kind,
                            Vocabulary vocabulary) {
  TextCoverage coverage;
  coverage.keys = std::move(keys);
  for (const TextUnit& unit : UnitsOf(text, kind, vocabulary)) {
    ++coverage.words;
    if (IsCarried(unit, coverage.keys)) {
      ++coverage.carried;
      continue;
    }
    std::string words(text.substr(unit.begin, unit.end - unit.begin));
    const bool told =
        std::find(coverage.lost.begin(), coverage.lost.end(), words) != coverage.lost.end();
    if (unit.known && !told) coverage.lost.push_back(std::move(words));
  }
  return coverage;
}

void AddLost(const TextCoverage& coverage, const std::vector<std::string>& warnings,
             std::vector<std::string>* not_understood) {
  const auto holds = [](const std::vector<std::string>& texts, const std::string& words) {
    return std::any_of(texts.begin(), texts.end(), [&words](const std::string& text) {
      return text.find(words) != std::string::npos;
    });
  };
  for (const std::string& words : coverage.lost) {
    if (!holds(warnings, words) && !holds(*not_understood, words)) not_understood->push_back(words);
  }
}

void TakeOffCarried(const TextCoverage& coverage, SentenceKind kind, Vocabulary vocabulary,
                    std::vector<std::string>* not_understood) {
  const auto is_carried = [&](const std::string& words) {
    const std::vector<TextUnit> units = UnitsOf(words, kind, vocabulary);
    return !units.empty() && std::all_of(units.begin(), units.end(), [&](const TextUnit& unit) {
      return IsCarried(unit, coverage.keys);
    });
  };
  not_understood->erase(std::remove_if(not_understood->begin(), not_understood->end(), is_carried),
                        not_understood->end());
}

QuotedText::QuotedText(std::string_view text, SentenceKind kind, Vocabulary vocabulary)
    : text_(text),
      kind_(kind),
      vocabulary_(vocabulary),
      units_(UnitsOf(text, kind, vocabulary)),
      stops_(StopsOf(text)) {}

std::string QuotedText::QuoteOf(const std::string& sentence) const {
  const std::set<std::string> wanted = KeysOf({sentence}, kind_, vocabulary_);
  const std::vector<TextUnit> of_sentence = UnitsOf(sentence, kind_, vocabulary_);
  // What a sentence begins with is what it is about.
  const auto is_about = [&of_sentence](const std::string& key) {
    if (of_sentence.empty()) return false;
    const std::vector<std::string>& keys = of_sentence.front().keys;
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  std::size_t most = 0;
  std::string quote = sentence;
  for (std::size_t at = 0, stop = 0; at < units_.size();) {
    while (stops_[stop] <= units_[at].begin) ++stop;
    std::set<std::string> said;
    std::size_t first = text_.size();
    std::size_t last = 0;
    for (; at < units_.size() && units_[at].begin < stops_[stop]; ++at) {
      if (!IsCarried(units_[at], wanted)) continue;
      for (const std::string& key : units_[at].keys) {
        if (wanted.count(key) > 0) said.insert(key);
      }
      first = std::min(first, units_[at].begin);
      last = units_[at].end;
    }
    const bool about = std::any_of(said.begin(), said.end(), is_about);
    if (const std::size_t score = 2 * said.size() + (about ? 1 : 0); score > most) {
      most = score;
      quote = text_.substr(first, last - first);
    }
  }
  return quote;
}

}  // namespace latticeworld
