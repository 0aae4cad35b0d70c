#include "latticeworld/language/reading/words/subjects.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <map>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/words/table_words.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {

std::string_view SubjectWordFile(std::string_view file_name);  // data, compiled in

namespace {

// By how much words speak for one of two kinds: natural logarithm of the odds.
constexpr double kClearly = 3.0;   // those of a sentence together
constexpr double kStrongly = 2.0;  // one word, which keeps a sentence of both kinds

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool IsBlankText(std::string_view text) { return std::all_of(text.begin(), text.end(), IsBlank); }

// For each word by how much it speaks for an environment; below 0: for land.
const std::map<std::string, double, std::less<>>& SubjectWords() {
  static const std::map<std::string, double, std::less<>> table = [] {
    std::map<std::string, double, std::less<>> weights;
    for (const auto& [weight, words] : LinesOfTable(SubjectWordFile("subject_words.txt")))
      for (const std::string& word : words) weights[word] = std::atof(weight.c_str());
    return weights;
  }();
  return table;
}

bool IsOfSmallLanguage(std::string_view sentence, SentenceKind kind) {
  const std::vector<std::string> sentences = SplitSentences(sentence);
  return std::all_of(sentences.begin(), sentences.end(), [kind](const std::string& one) {
    return ReadSentence(one, kind).has_value();
  });
}

struct Weight {
  double sum = 0.0;
  double most = 0.0;   // for an environment
  double least = 0.0;  // for land, below 0
};

Weight WeightOf(std::string_view sentence) {
  Weight weight;
  for (const std::string& word : TableWordsOf(sentence)) {
    const auto found = SubjectWords().find(word);
    if (found == SubjectWords().end()) continue;
    weight.sum += found->second;
    weight.most = std::max(weight.most, found->second);
    weight.least = std::min(weight.least, found->second);
  }
  return weight;
}

bool MayBeOf(SentenceKind kind, std::string_view sentence) {
  const Weight weight = WeightOf(sentence);
  return kind == SentenceKind::kEnvironment ? weight.sum >= -kClearly || weight.most >= kStrongly
                                            : weight.sum <= kClearly || weight.least <= -kStrongly;
}

}  // namespace

std::vector<std::string_view> FreeSentences(std::string_view text) {
  std::vector<std::string_view> sentences;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool stops = std::string_view(".!?;\n").find(text[at]) != std::string_view::npos;
    if (!stops || (text[at] != '\n' && at + 1 < text.size() && !IsBlank(text[at + 1]))) continue;
    while (at + 1 < text.size() && IsBlank(text[at + 1])) ++at;
    sentences.push_back(text.substr(begin, at + 1 - begin));
    begin = at + 1;
  }
  if (begin < text.size()) sentences.push_back(text.substr(begin));
  return sentences;
}

std::string TextOf(SentenceKind kind, std::string_view text) {
  std::string of_kind;
  for (const std::string_view sentence : FreeSentences(text))
    if (MayBeOf(kind, sentence)) of_kind += sentence;
  return of_kind;
}

std::string EnvironmentText(std::string_view layout_instruction,
                            std::string_view environment_instruction) {
  if (!IsBlankText(environment_instruction)) return std::string(environment_instruction);
  std::string text;
  for (const std::string_view sentence : FreeSentences(layout_instruction)) {
    const bool is_small_language = IsOfSmallLanguage(sentence, SentenceKind::kLayout);
    if (!is_small_language && WeightOf(sentence).sum > 0.0) text += sentence;
  }
  return text;
}

std::vector<std::string> WarningsOfUnread(std::string_view layout_instruction,
                                          std::string_view environment_instruction) {
  std::vector<std::string> warnings;
  const auto warn = [&warnings](SentenceKind kind, std::string_view text, std::string_view other,
                                const std::string& name_of_other) {
    if (IsBlankText(other)) return;
    std::vector<std::string> unread;
    for (std::string_view sentence : FreeSentences(text)) {
      while (!sentence.empty() && IsBlank(sentence.back())) sentence.remove_suffix(1);
      if (!MayBeOf(kind, sentence) && !IsOfSmallLanguage(sentence, kind) &&
          other.find(sentence) == std::string_view::npos) {
        unread.push_back(Quote(sentence));
      }
    }
    if (unread.empty()) return;
    warnings.push_back("not read, for it speaks of what " + name_of_other +
                       " describes: " + Join(unread, ", "));
  };
  warn(SentenceKind::kLayout, layout_instruction, environment_instruction,
       "environment_instruction");
  warn(SentenceKind::kEnvironment, environment_instruction, layout_instruction,
       "layout_instruction");
  return warnings;
}

LayoutRequest OfItsKind(LayoutRequest request) {
  request.instruction = TextOf(SentenceKind::kLayout, request.instruction);
  return request;
}

EnvironmentRequest OfItsKind(EnvironmentRequest request) {
  request.instruction = TextOf(SentenceKind::kEnvironment, request.instruction);
  return request;
}

}  // namespace latticeworld
