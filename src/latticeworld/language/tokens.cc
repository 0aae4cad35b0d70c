#include "latticeworld/language/tokens.h"

#include <algorithm>
#include <cstdint>

namespace latticeworld {
namespace {

enum class Glyph { kLetter, kDigit, kSpace, kHyphen, kApostrophe, kComma, kStop };

struct Decoded {
  Glyph glyph;
  std::size_t bytes;
};

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

// The typographic punctuation that editors put in the place of ASCII.
Glyph GlyphOfCodePoint(std::uint32_t code) {
  if (code == 0x2019 || code == 0x02BC) return Glyph::kApostrophe;
  if (code == 0x2010 || code == 0x2011) return Glyph::kHyphen;
  if (code >= 0x2012 && code <= 0x2015) return Glyph::kComma;
  if (code == 0x3001 || code == 0xFF0C) return Glyph::kComma;
  if (code == 0x2026 || code == 0x3002 || code == 0xFF0E || code == 0xFF01 || code == 0xFF1F ||
      code == 0xFF1B || code == 0x2022 || code == 0x2028 || code == 0x2029) {
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
  if (lead < 0x80) return {GlyphOfAscii(text[at]), 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (at + length > text.size()) return {Glyph::kSpace, text.size() - at};
  std::uint32_t code = lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    code = (code << 6) | (static_cast<unsigned char>(text[at + i]) & 0x3Fu);
  }
  return {GlyphOfCodePoint(code), length};
}

std::string LowerAscii(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// What follows an apostrophe: "isn't" is "is not", "there's" is "there is", "farmer's" is "farmer".
void AddContracted(std::string word, std::string_view tail, std::size_t begin, std::size_t end,
                   std::vector<Token>* tokens) {
  std::string_view second;
  if (tail == "t" && EndsWith(word, "n")) {
    word.pop_back();
    second = "not";
  } else if (tail == "s" && (word == "there" || word == "it" || word == "that")) {
    second = "is";
  } else if (tail == "re" || tail == "ve") {
    second = "are";
  }
  if (!word.empty()) tokens->push_back({TokenKind::kWord, std::move(word), begin, end});
  if (!second.empty()) tokens->push_back({TokenKind::kWord, std::string(second), begin, end});
}

}  // namespace

std::vector<Token> Tokenize(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t at = 0;
  const auto glyph_at = [&](std::size_t i) {
    return i < text.size() ? DecodeAt(text, i).glyph : Glyph::kStop;
  };
  while (at < text.size()) {
    const Decoded here = DecodeAt(text, at);
    const std::size_t begin = at;
    switch (here.glyph) {
      case Glyph::kLetter: {
        while (at < text.size() && glyph_at(at) == Glyph::kLetter) at += DecodeAt(text, at).bytes;
        std::string word = LowerAscii(text.substr(begin, at - begin));
        if (glyph_at(at) == Glyph::kApostrophe) {
          const std::size_t tail = at + DecodeAt(text, at).bytes;
          std::size_t end = tail;
          while (end < text.size() && glyph_at(end) == Glyph::kLetter) {
            end += DecodeAt(text, end).bytes;
          }
          AddContracted(std::move(word), LowerAscii(text.substr(tail, end - tail)), begin, end,
                        &tokens);
          at = end;
        } else {
          tokens.push_back({TokenKind::kWord, std::move(word), begin, at});
        }
        break;
      }
      case Glyph::kDigit: {
        // "1,000" and "2.5" are one number; "3, 4" and "in 2." are not.
        while (at < text.size() &&
               (glyph_at(at) == Glyph::kDigit ||
                ((text[at] == ',' || text[at] == '.') && glyph_at(at + 1) == Glyph::kDigit))) {
          ++at;
        }
        std::string digits(text.substr(begin, at - begin));
        digits.erase(std::remove(digits.begin(), digits.end(), ','), digits.end());
        tokens.push_back({TokenKind::kNumber, std::move(digits), begin, at});
        break;
      }
      case Glyph::kComma:
      case Glyph::kStop:
        at += here.bytes;
        tokens.push_back({here.glyph == Glyph::kComma ? TokenKind::kComma : TokenKind::kStop,
                          std::string(text.substr(begin, here.bytes)), begin, at});
        break;
      case Glyph::kHyphen: {
        // A hyphen between spaces is a dash.
        const bool dash =
            at > 0 && text[at - 1] == ' ' && at + here.bytes < text.size() &&
            (text[at + here.bytes] == ' ' || glyph_at(at + here.bytes) == Glyph::kHyphen);
        at += here.bytes;
        if (dash) tokens.push_back({TokenKind::kComma, "-", begin, at});
        break;
      }
      case Glyph::kSpace:
      case Glyph::kApostrophe:
        at += here.bytes;
        break;
    }
  }
  return tokens;
}

std::string Singular(std::string_view word) {
  const auto cut = [&](std::size_t n) { return std::string(word.substr(0, word.size() - n)); };
  if (word.size() > 4 && EndsWith(word, "ies")) return cut(3) + "y";
  for (const std::string_view end : {"shes", "ches", "sses", "xes"}) {
    if (word.size() > end.size() + 1 && EndsWith(word, end)) return cut(2);
  }
  if (word.size() > 3 && EndsWith(word, "s") && !EndsWith(word, "ss") && !EndsWith(word, "us")) {
    return cut(1);
  }
  return std::string(word);
}

std::string JoinWords(const std::vector<Token>& tokens, std::size_t first, std::size_t last) {
  std::string joined;
  for (std::size_t i = first; i < last; ++i) {
    if (i > first) joined += ' ';
    joined += tokens[i].text;
  }
  return joined;
}

}  // namespace latticeworld
