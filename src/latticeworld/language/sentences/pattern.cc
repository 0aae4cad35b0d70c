#include "latticeworld/language/sentences/pattern.h"

#include <cctype>
#include <cstddef>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// The brackets, slots, strokes and words of a pattern, in their order. A colon or comma at the end
// of a word is a token of its own, as it is in sentences.
std::vector<std::string> TokensOf(std::string_view text) {
  std::vector<std::string> tokens;
  const std::string_view brackets = "[]()*";
  std::size_t at = 0;
  while (at < text.size()) {
    if (text[at] == ' ') {
      ++at;
    } else if (brackets.find(text[at]) != std::string_view::npos) {
      tokens.emplace_back(1, text[at++]);
    } else {
      const std::size_t begin = at;
      while (at < text.size() && text[at] != ' ' &&
             brackets.find(text[at]) == std::string_view::npos) {
        ++at;
      }
      std::string word(text.substr(begin, at - begin));
      const char last = word.back();
      const bool stop = word.size() > 1 && (last == ':' || last == ',');
      if (stop) word.pop_back();
      tokens.push_back(std::move(word));
      if (stop) tokens.emplace_back(1, last);
    }
  }
  return tokens;
}

class PatternParser {
 public:
  explicit PatternParser(std::string_view text) : text_(text), tokens_(TokensOf(text)) {}

  Result<Pattern> Parse() {
    Pattern pattern = Choice();
    if (wrong_.empty() && at_ < tokens_.size())
      wrong_ = "'" + tokens_[at_] + "' without its fellow";
    if (!wrong_.empty()) {
      return InvalidArgument("pattern " + Quote(text_) + ": " + wrong_);
    }
    return pattern;
  }

 private:
  bool At(std::string_view token) const { return at_ < tokens_.size() && tokens_[at_] == token; }

  // Alternatives parted by strokes, up to a closing bracket or the end.
  Pattern Choice() {
    Pattern choice;
    choice.kind = Pattern::Kind::kChoice;
    choice.parts.push_back(Sequence());
    while (At("/")) {
      ++at_;
      choice.parts.push_back(Sequence());
    }
    return choice.parts.size() == 1 ? std::move(choice.parts.front()) : choice;
  }

  Pattern Sequence() {
    Pattern sequence;
    while (at_ < tokens_.size() && !At("/") && !At("]") && !At(")") && wrong_.empty()) {
      sequence.parts.push_back(Item());
    }
    if (sequence.parts.empty() && wrong_.empty()) wrong_ = "nothing between two marks";
    return sequence.parts.size() == 1 ? std::move(sequence.parts.front()) : sequence;
  }

  Pattern Item() {
    const std::string token = tokens_[at_++];
    Pattern item;
    if (token == "[" || token == "(") {
      Pattern inner = Choice();
      if (!At(token == "[" ? "]" : ")")) {
        if (wrong_.empty()) wrong_ = "'" + token + "' without its fellow";
        return item;
      }
      ++at_;
      if (token == "[") {
        item.kind = Pattern::Kind::kOptional;
      } else if (At("*")) {
        ++at_;
        item.kind = Pattern::Kind::kRepeat;
      }
      item.parts.push_back(std::move(inner));
      return item;
    }
    if (token.front() == '{') {
      item.kind = Pattern::Kind::kSlot;
      if (token.size() < 3 || token.back() != '}') wrong_ = "'" + token + "' is no slot";
      item.name = token.substr(1, token.size() - 2);
      return item;
    }
    item.kind = Pattern::Kind::kWords;
    item.words = Split(token, '|');
    return item;
  }

  std::string_view text_;
  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  std::string wrong_;
};

}  // namespace

Result<Pattern> ParsePattern(std::string_view text) { return PatternParser(text).Parse(); }

}  // namespace latticeworld
