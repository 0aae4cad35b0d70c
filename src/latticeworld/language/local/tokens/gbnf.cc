#include "latticeworld/language/local/tokens/gbnf.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace latticeworld {
namespace {

constexpr int kMostDepth = 100;        // of groups in groups
constexpr int kMostRepeats = 100'000;  // that a number in {} may ask for

using Expression = GrammarExpression;

bool IsNameByte(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Result<std::map<std::string, Expression>> Rules() {
    std::map<std::string, Expression> rules;
    for (SkipBlank(true); at_ < text_.size() && status_.ok(); SkipBlank(true)) {
      const std::string name = Name();
      if (name.empty()) Fail("a rule's name is wanted");
      SkipBlank(false);
      if (!Eat("::=")) Fail("'::=' is wanted after '" + name + "'");
      SkipBlank(true);
      Expression body = Choice(0);
      if (!rules.emplace(name, std::move(body)).second) Fail("'" + name + "' is there twice");
    }
    LW_RETURN_IF_ERROR(status_);
    return rules;
  }

 private:
  void Fail(const std::string& what) {
    if (status_.ok())
      status_ = InvalidArgument("grammar, line " + std::to_string(line_) + ": " + what);
    at_ = text_.size();
  }
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool Eat(std::string_view what) {
    if (text_.substr(at_, what.size()) != what) return false;
    at_ += what.size();
    return true;
  }
  void SkipBlank(bool lines) {
    while (at_ < text_.size()) {
      if (Peek() == '#') {
        while (at_ < text_.size() && Peek() != '\n') ++at_;
      } else if (Peek() == ' ' || Peek() == '\t' || Peek() == '\r') {
        ++at_;
      } else if (Peek() == '\n' && lines) {
        ++at_;
        ++line_;
      } else {
        return;
      }
    }
  }
  std::string Name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && IsNameByte(Peek())) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  // The byte of a character in a literal or a class; several for what is no
  // ASCII.
  std::string Character() {
    if (Peek() != '\\') return std::string(1, text_[at_++]);
    ++at_;
    if (at_ >= text_.size()) {
      Fail("the text ends after '\\'");
      return std::string();
    }
    const char c = text_[at_++];
    switch (c) {
      case 'n':
        return "\n";
      case 'r':
        return "\r";
      case 't':
        return "\t";
      case 'x': {
        int byte = 0;
        for (int i = 0; i < 2; ++i) {
          const auto digit = static_cast<unsigned char>(Peek());
          if (std::isxdigit(digit) == 0) {
            Fail("two hexadecimal digits are wanted after '\\x'");
            return std::string();
          }
          byte =
              byte * 16 + (std::isdigit(digit) != 0 ? digit - '0' : std::tolower(digit) - 'a' + 10);
          ++at_;
        }
        return std::string(1, static_cast<char>(byte));
      }
      case '\\':
      case '"':
      case '[':
      case ']':
        return std::string(1, c);
      default:
        Fail(std::string("'\\") + c +
             "' means nothing; legal are \\n \\r \\t \\xHH \\\\ \\\" \\[ \\]");
        return std::string();
    }
  }

  Expression Literal() {
    Expression sequence;
    ++at_;
    while (at_ < text_.size() && Peek() != '"') {
      if (Peek() == '\n') Fail("a literal ends with its line; write \\n");
      for (const char c : at_ < text_.size() ? Character() : std::string()) {
        Expression one;
        one.kind = Expression::Kind::kBytes;
        one.bytes.set(static_cast<unsigned char>(c));
        sequence.parts.push_back(std::move(one));
      }
    }
    if (!Eat("\"")) Fail("a literal is not closed");
    return sequence;
  }

  Expression Class() {
    Expression one;
    one.kind = Expression::Kind::kBytes;
    ++at_;
    const bool inverted = Eat("^");
    while (at_ < text_.size() && Peek() != ']') {
      const std::string low = Character();
      std::string high = low;
      if (Peek() == '-' && at_ + 1 < text_.size() && text_[at_ + 1] != ']') {
        ++at_;
        high = Character();
      }
      if (low.empty() || high.empty()) return one;
      const auto from = static_cast<unsigned char>(low[0]);
      const auto to = static_cast<unsigned char>(high[0]);
      if (from >= 0x80 || to >= 0x80) Fail("a class of what is no ASCII, which is not read here");
      if (from > to) Fail("a range of a class runs backwards");
      for (unsigned byte = from; byte <= to; ++byte) one.bytes.set(byte);
    }
    if (!Eat("]")) Fail("a class is not closed");
    if (inverted) one.bytes.flip();
    return one;
  }

  int Number() {
    long number = 0;
    if (std::isdigit(static_cast<unsigned char>(Peek())) == 0) Fail("a number is wanted");
    while (std::isdigit(static_cast<unsigned char>(Peek())) != 0)
      number = std::min<long>(number * 10 + (text_[at_++] - '0'), kMostRepeats + 1);
    if (number > kMostRepeats) Fail("more than " + std::to_string(kMostRepeats) + " repetitions");
    return static_cast<int>(number);
  }

  // What follows a part: how often it comes.
  Expression Repeated(Expression part) {
    int least = 1, most = 1;
    if (Eat("?")) {
      least = 0;
    } else if (Eat("*")) {
      least = 0;
      most = -1;
    } else if (Eat("+")) {
      most = -1;
    } else if (Eat("{")) {
      least = most = Number();
      if (Eat(",")) most = Peek() == '}' ? -1 : Number();
      if (!Eat("}")) Fail("'}' is wanted after the repetitions");
      if (most >= 0 && most < least) Fail("fewer repetitions at most than at least");
    } else {
      return part;
    }
    Expression repeat;
    repeat.kind = Expression::Kind::kRepeat;
    repeat.least = least;
    repeat.most = most;
    repeat.parts.push_back(std::move(part));
    return repeat;
  }

  // A name is a rule's reference unless '::=' follows: then the next rule
  // begins.
  bool BeginsRule() const {
    std::size_t at = at_;
    while (at < text_.size() && IsNameByte(text_[at])) ++at;
    while (at < text_.size() && (text_[at] == ' ' || text_[at] == '\t')) ++at;
    return text_.substr(at, 3) == "::=";
  }

  Expression Sequence(int depth) {
    Expression sequence;
    for (;;) {
      SkipBlank(true);
      if (Peek() == '"') {
        sequence.parts.push_back(Repeated(Literal()));
      } else if (Peek() == '[') {
        sequence.parts.push_back(Repeated(Class()));
      } else if (Peek() == '(') {
        ++at_;
        Expression group = Choice(depth + 1);
        SkipBlank(true);
        if (!Eat(")")) Fail("')' is wanted");
        sequence.parts.push_back(Repeated(std::move(group)));
      } else if (IsNameByte(Peek()) && !BeginsRule()) {
        Expression rule;
        rule.kind = Expression::Kind::kRule;
        rule.line = line_;
        rule.rule = Name();
        sequence.parts.push_back(Repeated(std::move(rule)));
      } else {
        const bool ends =
            at_ >= text_.size() || Peek() == '|' || Peek() == ')' || IsNameByte(Peek());
        if (!ends) Fail(std::string("'") + Peek() + "' begins nothing");
        return sequence;
      }
    }
  }

  Expression Choice(int depth) {
    Expression choice;
    choice.kind = Expression::Kind::kChoice;
    if (depth > kMostDepth) {
      Fail("more than " + std::to_string(kMostDepth) + " groups in groups");
      return choice;
    }
    do {
      choice.parts.push_back(Sequence(depth));
      SkipBlank(true);
    } while (Eat("|"));
    return choice;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  Status status_;
};

}  // namespace

Result<std::map<std::string, GrammarExpression>> ParseGbnf(std::string_view text) {
  return Parser(text).Rules();
}

}  // namespace latticeworld
