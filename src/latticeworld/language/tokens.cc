#include "latticeworld/language/tokens.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

enum class Glyph { kLetter, kDigit, kSpace, kHyphen, kApostrophe, kComma, kStop, kWords };

struct Decoded {
  Glyph glyph;
  std::size_t bytes;
  std::string_view words = {};  // what a glyph of kWords stands for
};

// Signs that are written for words.
struct SignWords {
  std::uint32_t code;
  std::string_view words;
};
constexpr SignWords kSignWords[] = {
    {'%', "percent"},
    {'&', "and"},
    {'+', "and"},
    {'@', "at"},
    {0xBC, "one quarter"},
    {0xBD, "one half"},
    {0xBE, "three quarters"},
    {0xD7, "x"},
    {0x2030, "percent"},
    {0x2153, "one third"},
    {0x2154, "two thirds"},
    {0x2155, "one fifth"},
    {0x2156, "two fifths"},
    {0x2157, "three fifths"},
    {0x2158, "four fifths"},
    {0x215B, "one eighth"},
    {0x215C, "three eighths"},
    {0x2190, "to"},
    {0x2191, "to"},
    {0x2192, "to"},
    {0x2193, "to"},
    {0x2194, "to"},
    {0x2195, "to"},
    {0x21D2, "to"},
    {0x21D4, "to"},
    {0x27F6, "to"},
    {0x2248, "about"},
    {0x2264, "at most"},
    {0x2265, "at least"},
    {0xFF05, "percent"},
    {0xFF06, "and"},
};

std::string_view WordsOfSign(std::uint32_t code) {
  for (const SignWords& sign : kSignWords) {
    if (sign.code == code) return sign.words;
  }
  return {};
}

Glyph GlyphOfAscii(char c) {
  if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) return Glyph::kLetter;
  if (c >= '0' && c <= '9') return Glyph::kDigit;
  switch (c) {
    case '-':
    case '/':
      return Glyph::kHyphen;
    case '\'':
      return Glyph::kApostrophe;
    case ',':
    case ':':
    case '(':
    case ')':
    case '[':
    case ']':
    case '{':
    case '}':
    case '=':
    case '|':
      return Glyph::kComma;
    case '.':
    case ';':
    case '!':
    case '?':
    case '\n':
      return Glyph::kStop;
    default:
      return Glyph::kSpace;
  }
}

// Contractions as they are written in haste, without their apostrophe, and what they stand for.
// "its" is left: it is a word as well.
struct Contraction {
  std::string_view written;
  std::string_view words;
};
constexpr Contraction kContractions[] = {
    {"isnt", "is not"},       {"arent", "are not"},
    {"wasnt", "was not"},     {"werent", "were not"},
    {"dont", "do not"},       {"doesnt", "does not"},
    {"didnt", "did not"},     {"shouldnt", "should not"},
    {"couldnt", "could not"}, {"wouldnt", "would not"},
    {"mustnt", "must not"},   {"hasnt", "has not"},
    {"havent", "have not"},   {"cant", "can not"},
    {"wont", "will not"},     {"theres", "there is"},
    {"heres", "here is"},     {"thats", "that is"},
    {"theyre", "they are"},   {"im", "i"},
    {"oclock", "o"},
};

std::string_view WordsOfContraction(std::string_view written) {
  for (const Contraction& contraction : kContractions) {
    if (contraction.written == written) return contraction.words;
  }
  return {};
}

// The typographic punctuation that editors put in the place of ASCII.
Glyph GlyphOfCodePoint(std::uint32_t code) {
  if (code == 0x2019 || code == 0x02BC) return Glyph::kApostrophe;
  if (code == 0x2010 || code == 0x2011) return Glyph::kHyphen;
  if (code >= 0x2012 && code <= 0x2015) return Glyph::kComma;
  if (code == 0x2212) return Glyph::kHyphen;
  if (code == 0x3001 || code == 0xFF0C || code == 0xFF1A) return Glyph::kComma;
  if (code == 0x2026 || code == 0x3002 || code == 0xFF0E || code == 0xFF01 || code == 0xFF1F ||
      code == 0xFF1B || code == 0x2022 || code == 0x2023 || code == 0x2028 || code == 0x2029 ||
      code == 0x204F || code == 0xB7 || (code >= 0x25A0 && code <= 0x25FF) || code == 0x2219) {
    return Glyph::kStop;
  }
  if (code == 0xA0 || code == 0xFEFF || code == 0x3000 || code == 0xAB || code == 0xBB ||
      (code >= 0x2000 && code <= 0x206F)) {
    return Glyph::kSpace;
  }
  return Glyph::kLetter;
}

Decoded DecodeAt(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) {
    const std::string_view words = WordsOfSign(lead);
    return {words.empty() ? GlyphOfAscii(text[at]) : Glyph::kWords, 1, words};
  }
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (at + length > text.size()) return {Glyph::kSpace, text.size() - at};
  std::uint32_t code = lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    code = (code << 6) | (static_cast<unsigned char>(text[at + i]) & 0x3Fu);
  }
  const std::string_view words = WordsOfSign(code);
  return {words.empty() ? GlyphOfCodePoint(code) : Glyph::kWords, length, words};
}

std::string LowerAscii(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

bool IsAsciiDigit(char c) { return c >= '0' && c <= '9'; }

constexpr std::array<std::string_view, 13> kOrdinals = {
    "",        "first",  "second", "third", "fourth",   "fifth",  "sixth",
    "seventh", "eighth", "ninth",  "tenth", "eleventh", "twelfth"};
constexpr std::array<std::string_view, 13> kParts = {
    "",        "",       "half",  "third", "quarter",  "fifth",  "sixth",
    "seventh", "eighth", "ninth", "tenth", "eleventh", "twelfth"};

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) {}

  std::vector<Token> Run() {
    while (at_ < text_.size()) {
      if (TakeListMarker()) continue;
      const Decoded here = DecodeAt(text_, at_);
      switch (here.glyph) {
        case Glyph::kLetter:
          TakeWord();
          break;
        case Glyph::kDigit:
          if (!TakeFraction()) TakeNumber();
          break;
        case Glyph::kWords:
          AddWords(here.words, at_, at_ + here.bytes);
          at_ += here.bytes;
          break;
        case Glyph::kComma:
        case Glyph::kStop:
          Add(here.glyph == Glyph::kComma ? TokenKind::kComma : TokenKind::kStop,
              std::string(text_.substr(at_, here.bytes)), at_, at_ + here.bytes);
          if (text_[at_] == '(') ++parentheses_;
          if (text_[at_] == ')' && parentheses_ > 0) --parentheses_;
          at_ += here.bytes;
          break;
        case Glyph::kHyphen:
          TakeHyphen(here.bytes);
          break;
        case Glyph::kSpace:
          // "~30" is about 30.
          if (text_[at_] == '~' && IsAsciiDigit(At(at_ + 1))) AddWords("about", at_, at_ + 1);
          if (TakeBound()) break;
          at_ += here.bytes;
          break;
        case Glyph::kApostrophe:
          at_ += here.bytes;
          break;
      }
    }
    EndBeforeLabels();
    return std::move(tokens_);
  }

 private:
  // Whether a thing is named with it, "a lake", and no key.
  static bool OpensThing(std::string_view word) {
    return word == "a" || word == "an" || word == "the" || word == "one" || word == "two";
  }

  // Whether what ends with the comma is a place and no key with its value.
  bool FrontsPlace(std::size_t comma) const {
    std::size_t begin = comma;
    while (begin > 0 && tokens_[begin - 1].kind == TokenKind::kWord) --begin;
    const bool opens = begin == 0 || tokens_[begin - 1].kind == TokenKind::kStop;
    for (const std::string_view word : {"in", "on", "at", "to", "around", "along", "near"})
      if (opens && begin < comma && tokens_[begin].text == word) return true;
    return false;
  }

  // "season: spring, weather: rain", "forest=70 %, water=10 %": a comma before up to kMostOfLabel
  // words and a colon or "=" ends what went before.
  void EndBeforeLabels() {
    constexpr std::size_t kMostOfLabel = 3;
    for (std::size_t colon = 0; colon < tokens_.size(); ++colon) {
      if (tokens_[colon].text != ":" && tokens_[colon].text != "=") continue;
      std::size_t at = colon;
      while (at > 0 && tokens_[at - 1].kind == TokenKind::kWord) --at;
      if (at == colon || at == 0 || colon - at > kMostOfLabel || tokens_[at - 1].text != ",")
        continue;
      // "to the left of it, in this order: ..."
      if (tokens_[colon - 1].text == "order" || tokens_[colon - 1].text == "follows") continue;
      // "in the north, a lake: deep and wide", "around the lake, trees: many"
      if (OpensThing(tokens_[at].text) || FrontsPlace(at - 1)) continue;
      tokens_[at - 1].kind = TokenKind::kStop;
    }
  }

  // "> 40 %", "<= 20": more than, at most.
  bool TakeBound() {
    const char sign = text_[at_];
    if (sign != '<' && sign != '>') return false;
    const std::size_t end = at_ + (At(at_ + 1) == '=' ? 2 : 1);
    if (!IsAsciiDigit(At(end + (At(end) == ' ' ? 1 : 0)))) return false;
    const bool or_equal = end == at_ + 2;
    if (sign == '>') AddWords(or_equal ? "at least" : "more than", at_, end);
    if (sign == '<') AddWords(or_equal ? "at most" : "less than", at_, end);
    at_ = end;
    return true;
  }

  // '\0' outside the text, which holds none.
  char At(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }
  Glyph GlyphAt(std::size_t i) const {
    return i < text_.size() ? DecodeAt(text_, i).glyph : Glyph::kStop;
  }
  std::size_t EndOfLetters(std::size_t i) const {
    while (GlyphAt(i) == Glyph::kLetter) i += DecodeAt(text_, i).bytes;
    return i;
  }
  bool IsSpaceOrEnd(std::size_t i) const {
    return i >= text_.size() || text_[i] == ' ' || text_[i] == '\t' || text_[i] == '\n';
  }

  void Add(TokenKind kind, std::string text, std::size_t begin, std::size_t end) {
    tokens_.push_back({kind, std::move(text), begin, end});
  }
  // Words apart by single spaces, all of which stand for the same bytes.
  void AddWords(std::string_view words, std::size_t begin, std::size_t end) {
    while (!words.empty()) {
      const std::size_t length = std::min(words.find(' '), words.size());
      Add(TokenKind::kWord, std::string(words.substr(0, length)), begin, end);
      words.remove_prefix(std::min(length + 1, words.size()));
    }
  }

  bool AtLineStart() const {
    return tokens_.empty() || tokens_.back().text == "\n" ||
           tokens_.back().kind == TokenKind::kStop;
  }

  // "1. ", "2) ", "(3) " and "a) " at the start of a line, and their followers within it: a stop.
  bool TakeListMarker() {
    if (at_ > 0 && !IsSpaceOrEnd(at_ - 1)) return false;
    std::size_t i = at_;
    const bool open = At(i) == '(';
    if (open) ++i;
    const std::size_t first = i;
    while (IsAsciiDigit(At(i)) && i - first < 3) ++i;
    const bool digits = i > first;
    if (!digits && At(i) >= 'a' && At(i) <= 'z') ++i;
    if (i == first) return false;
    const bool closed = At(i) == ')';
    if (!closed && (open || !digits || At(i) != '.')) return false;
    if (!IsSpaceOrEnd(i + 1)) return false;
    const int number = digits ? std::atoi(std::string(text_.substr(first, i - first)).c_str())
                              : At(first) - 'a' + 1;
    const bool follows = next_item_ > 1 && number == next_item_;
    // A number that ends a sentence ("there are 2.") begins no line and follows no marker.
    if (!AtLineStart() && !follows) return false;
    if (!open && closed && parentheses_ > 0) return false;
    // "it has 3. Then 4. a lake" is too rare to be held against "1. a lake 2. a wood".
    next_item_ = number + 1;
    Add(TokenKind::kStop, std::string(text_.substr(at_, i + 1 - at_)), at_, i + 1);
    at_ = i + 1;
    return true;
  }

  void TakeWord() {
    const std::size_t begin = at_;
    at_ = EndOfLetters(at_);
    std::string word = LowerAscii(text_.substr(begin, at_ - begin));
    if (GlyphAt(at_) == Glyph::kApostrophe) {
      const std::size_t tail = at_ + DecodeAt(text_, at_).bytes;
      at_ = EndOfLetters(tail);
      AddContracted(std::move(word), LowerAscii(text_.substr(tail, at_ - tail)), begin);
      return;
    }
    if (word == "w" && At(at_) == '/') {
      // "w/ trees", "w/o houses"
      const bool without = (At(at_ + 1) == 'o' || At(at_ + 1) == 'O') && IsSpaceOrEnd(at_ + 2);
      if (without || IsSpaceOrEnd(at_ + 1) || !IsCompassLetter(At(at_ + 1))) {
        at_ += without ? 2 : 1;
        AddWords(without ? "without" : "with", begin, at_);
        return;
      }
    }
    if (const std::string_view words = WordsOfContraction(word); !words.empty()) {
      AddWords(words, begin, at_);
      return;
    }
    // "Id like" wishes, as "I'd like" does.
    if (word == "id" && LowerAscii(text_.substr(at_, 5)) == " like") word = "i";
    if (word.size() == 1) TakeInitials(&word);
    // The full stop of an abbreviation ends no sentence.
    if (At(at_) == '.' && (word == "approx" || word == "ca" || word == "incl" || word == "vs" ||
                           word == "esp" || IsCompassAbbreviation(word))) {
      ++at_;
    }
    Add(TokenKind::kWord, std::move(word), begin, at_);
  }

  static bool IsCompassLetter(char c) {
    return c == 'n' || c == 's' || c == 'e' || c == 'w' || c == 'N' || c == 'S' || c == 'E' ||
           c == 'W';
  }
  // "the N. edge": a compass letter and more of the sentence.
  bool IsCompassAbbreviation(std::string_view word) const {
    if (word.size() > 2 || !IsCompassLetter(word.front()) || !IsCompassLetter(word.back())) {
      return false;
    }
    if (At(at_ + 1) != ' ' || At(at_ + 2) < 'a' || At(at_ + 2) > 'z') return false;
    // "both N to S. fields left of them": the one before has no full stop.
    const std::size_t said = tokens_.size();
    if (said > 1 && tokens_[said - 1].text == "to" && tokens_[said - 2].text.size() <= 2 &&
        IsCompassLetter(tokens_[said - 2].text.front()) &&
        text_[tokens_[said - 2].end - 1] != '.') {
      return false;
    }
    // "villages: SE. lake: W", "SE. lake - W": a key and its value follow.
    std::size_t key = EndOfLetters(at_ + 2);
    while (At(key) == ' ') ++key;
    return At(key) != ':' && At(key) != '=' && !(At(key) == '-' && At(key - 1) == ' ');
  }

  // "N.W.", "e.g.", "a.m.": single letters with stops between them are one word.
  void TakeInitials(std::string* word) {
    std::size_t i = at_;
    std::string initials = *word;
    while (At(i) == '.' && GlyphAt(i + 1) == Glyph::kLetter && EndOfLetters(i + 1) == i + 2) {
      initials += LowerAscii(text_.substr(i + 1, 1));
      i += 2;
    }
    if (initials.size() == 1) return;
    // The last stop is the word's where the sentence goes on.
    if (At(i) == '.' && !IsSpaceOrEnd(i + 1)) ++i;
    if (At(i) == '.' && At(i + 1) == ' ' && At(i + 2) >= 'a' && At(i + 2) <= 'z') ++i;
    at_ = i;
    *word = std::move(initials);
  }

  // What follows an apostrophe: "isn't" is "is not", "there's" is "there is", "farmer's" is
  // "farmer".
  void AddContracted(std::string word, std::string_view tail, std::size_t begin) {
    std::string_view second;
    if (tail == "t" && EndsWith(word, "n")) {
      if (word == "won") {
        word = "will";
      } else if (word != "can") {
        word.pop_back();
      }
      second = "not";
    } else if (tail == "s" && (word == "there" || word == "it" || word == "that" ||
                               word == "here" || word == "what" || word == "where")) {
      second = "is";
    } else if (tail == "re" || tail == "ve") {
      second = "are";
    }
    if (!word.empty()) Add(TokenKind::kWord, std::move(word), begin, at_);
    if (!second.empty()) Add(TokenKind::kWord, std::string(second), begin, at_);
  }

  // "1/3", "2/3": the words for it. Other slashes part numbers.
  bool TakeFraction() {
    std::size_t i = at_;
    while (IsAsciiDigit(At(i))) ++i;
    if (At(i) != '/' || i - at_ > 2) return false;
    const std::size_t second = i + 1;
    std::size_t end = second;
    while (IsAsciiDigit(At(end))) ++end;
    if (end == second || end - second > 2 || At(end) == '/' ||
        (at_ > 0 && (text_[at_ - 1] == '/' || IsAsciiDigit(text_[at_ - 1])))) {
      return false;
    }
    const int numerator = std::atoi(std::string(text_.substr(at_, i - at_)).c_str());
    const int denominator = std::atoi(std::string(text_.substr(second, end - second)).c_str());
    if (numerator < 1 || numerator >= denominator || denominator > 12) return false;
    std::string part(kParts[static_cast<std::size_t>(denominator)]);
    if (numerator == 1) {
      AddWords("one", at_, end);
    } else {
      Add(TokenKind::kNumber, std::to_string(numerator), at_, end);
      part += 's';
    }
    AddWords(part, at_, end);
    at_ = end;
    return true;
  }

  // "1,000" and "2.5" are one number; "3, 4" and "in 2." are not. "3rd" is "third".
  void TakeNumber() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (IsAsciiDigit(text_[at_]) ||
            ((text_[at_] == ',' || text_[at_] == '.') && IsAsciiDigit(At(at_ + 1))))) {
      ++at_;
    }
    std::string digits(text_.substr(begin, at_ - begin));
    digits.erase(std::remove(digits.begin(), digits.end(), ','), digits.end());
    const std::size_t end = EndOfLetters(at_);
    const std::string suffix = LowerAscii(text_.substr(at_, end - at_));
    if (suffix == "st" || suffix == "nd" || suffix == "rd" || suffix == "th") {
      at_ = end;
      const int value = digits.size() < 3 ? std::atoi(digits.c_str()) : 0;
      const bool named = value >= 1 && value < static_cast<int>(kOrdinals.size());
      Add(TokenKind::kWord,
          named ? std::string(kOrdinals[static_cast<std::size_t>(value)]) : digits + suffix, begin,
          at_);
      return;
    }
    Add(TokenKind::kNumber, std::move(digits), begin, at_);
  }

  // A hyphen parts words; between spaces or doubled it is a dash, and "->" is "to".
  void TakeHyphen(std::size_t bytes) {
    const std::size_t begin = at_;
    std::size_t end = at_ + bytes;
    if (text_[at_] == '-') {
      while (At(end) == '-') ++end;
      if (At(end) == '>') {
        at_ = end + 1;
        AddWords("to", begin, at_);
        return;
      }
    }
    const bool doubled = end > at_ + bytes;
    const bool spaced = at_ > 0 && text_[at_ - 1] == ' ' && end < text_.size() && text_[end] == ' ';
    at_ = end;
    // "left half town / right half woods": two lines of a poem.
    const bool line = spaced && text_[begin] == '/';
    if (doubled || spaced) {
      Add(line ? TokenKind::kStop : TokenKind::kComma, line ? "/" : "-", begin, at_);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int parentheses_ = 0;  // open ones
  int next_item_ = 0;    // what follows the last list marker; 0: there was none
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> Tokenize(std::string_view text) { return Tokenizer(text).Run(); }

std::string JoinWords(const std::vector<Token>& tokens, std::size_t first, std::size_t last) {
  std::string joined;
  for (std::size_t i = first; i < last; ++i) {
    if (i > first) joined += ' ';
    joined += tokens[i].text;
  }
  return joined;
}

}  // namespace latticeworld
