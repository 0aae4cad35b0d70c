#include "latticeworld/language/sentences/sentence_grammar.h"

#include <cctype>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace latticeworld {
namespace {

constexpr std::string_view kNumber = "\"-\"? [0-9]{1,5} (\".\" [0-9]{1,3})?";

// Writes patterns as expressions of a grammar. Every word takes the blank before it along, but for
// the first of a sentence, which has a capital letter in its place.
class GrammarWriter {
 public:
  std::string Write(SentenceKind kind) {
    std::string rules = "root ::= \"-\" | sentence (\" \" sentence){0," +
                        std::to_string(kMostSentences - 1) + "}\n";
    // Forms that begin with the same slot share it, so that few ways are open at a time.
    std::vector<std::string> forms;
    std::map<std::string, std::vector<std::string>> rests;
    for (const SentenceForm& form : SentenceForms(kind)) {
      const std::vector<Pattern>& parts = form.pattern.parts;
      if (parts.size() > 1 && parts.front().kind == Pattern::Kind::kSlot) {
        rests[parts.front().name].push_back(Sequence(form.pattern, 1, /*first=*/false));
      } else {
        forms.push_back(Expression(form.pattern, /*first=*/true));
      }
    }
    for (const auto& [slot, rest] : rests) {
      Pattern first;
      first.kind = Pattern::Kind::kSlot;
      first.name = slot;
      forms.push_back(Expression(first, /*first=*/true) + " " + Choice(rest));
    }
    rules += "sentence ::= " + Choice(forms) + " \".\"\n";
    for (std::size_t i = 0; i < pending_.size(); ++i) {  // grows while rules are written
      const auto [slot, first] = pending_[i];
      rules += RuleOf(slot, first) + " ::= " + SlotExpression(slot, first) + "\n";
    }
    return rules;
  }

 private:
  static std::string Choice(const std::vector<std::string>& choices) {
    std::string text = "(";
    for (std::size_t i = 0; i < choices.size(); ++i) text += (i > 0 ? " | " : "") + choices[i];
    return text + ")";
  }

  static std::string Literal(std::string_view words, bool first) {
    std::string text = "\"";
    const bool stop = words == "," || words == ":";
    if (!first && !stop) text += ' ';
    text += words;
    if (first) {
      text[1] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[1])));
    }
    return text + "\"";
  }

  static std::string RuleOf(const std::string& slot, bool first) {
    std::string rule = slot + (first ? "-first" : "");
    for (char& c : rule)
      if (c == '_') c = '-';
    return rule;
  }

  std::string SlotExpression(const std::string& slot, bool first) {
    if (slot == "n") return (first ? "" : "\" \" ") + std::string(kNumber);
    if (slot == "label") return "\" \" [A-Z]";
    if (const Pattern* pattern = SlotPattern(slot); pattern != nullptr) {
      return Expression(*pattern, first);
    }
    std::vector<std::string> words;
    for (const std::string& word : SentenceWords(slot)) words.push_back(Literal(word, first));
    return Choice(words);
  }

  std::string Expression(const Pattern& pattern, bool first) {
    switch (pattern.kind) {
      case Pattern::Kind::kWords: {
        std::vector<std::string> words;
        for (const std::string& word : pattern.words) words.push_back(Literal(word, first));
        return words.size() == 1 ? words.front() : Choice(words);
      }
      case Pattern::Kind::kSlot:
        if (asked_.insert({pattern.name, first}).second) pending_.emplace_back(pattern.name, first);
        return RuleOf(pattern.name, first);
      case Pattern::Kind::kSequence:
        return Sequence(pattern, 0, first);
      case Pattern::Kind::kChoice: {
        std::vector<std::string> choices;
        for (const Pattern& part : pattern.parts) choices.push_back(Expression(part, first));
        return Choice(choices);
      }
      case Pattern::Kind::kOptional:
        return "(" + Expression(pattern.parts.front(), first) + ")?";
      case Pattern::Kind::kRepeat:
        return "(" + Expression(pattern.parts.front(), first) + ")*";
    }
    return {};
  }

  // The parts from `at` on. Of what may be missing at the beginning of a sentence both ways are
  // written, for the capital letter goes to what follows.
  std::string Sequence(const Pattern& pattern, std::size_t at, bool first) {
    std::string text;
    for (; at < pattern.parts.size(); ++at) {
      const Pattern& part = pattern.parts[at];
      if (!text.empty()) text += ' ';
      const bool may_miss =
          part.kind == Pattern::Kind::kOptional || part.kind == Pattern::Kind::kRepeat;
      if (first && may_miss) {
        std::string with = Expression(part.parts.front(), true);
        if (part.kind == Pattern::Kind::kRepeat) with += " " + Expression(part, false);
        return "(" + with + " " + Sequence(pattern, at + 1, false) + " | " +
               Sequence(pattern, at + 1, true) + ")";
      }
      text += Expression(part, first);
      first = false;
    }
    return text;
  }

  std::set<std::pair<std::string, bool>> asked_;
  std::vector<std::pair<std::string, bool>> pending_;  // slots whose rules are to be written
};

}  // namespace

std::string SentenceGrammar(SentenceKind kind) { return GrammarWriter().Write(kind); }

}  // namespace latticeworld
