#include "latticeworld/language/grounded/layout_lexer.h"

#include <algorithm>
#include <utility>

#include "latticeworld/language/grounded/numbers.h"

namespace latticeworld {
namespace {

constexpr std::size_t kLookAhead = 4;  // words between "of" and its noun: "of the large dense"

// Whether a class is named within the next few words.
bool NounFollows(const std::vector<Token>& tokens, std::size_t at) {
  for (std::size_t i = at; i < std::min(tokens.size(), at + kLookAhead); ++i) {
    if (tokens[i].kind != TokenKind::kWord) return false;
    if (MatchClassWord(tokens, i).word != nullptr) return true;
    if (MatchPlace(tokens, i).tokens > 0) return false;
  }
  return false;
}

bool EndsWithOf(const std::vector<Token>& tokens, std::size_t last) {
  return last > 0 && tokens[last - 1].text == "of";
}

LayoutItem ReadItem(const std::vector<Token>& tokens, std::size_t at) {
  LayoutItem item;
  item.first = at;
  item.last = at + 1;
  if (tokens[at].kind == TokenKind::kComma || tokens[at].kind == TokenKind::kStop) {
    item.kind =
        tokens[at].kind == TokenKind::kComma ? LayoutItemKind::kComma : LayoutItemKind::kStop;
    return item;
  }
  // The longest reading wins; among equals the noun, then the place, then the number.
  std::size_t longest = 0;
  if (const ClassWordMatch match = MatchClassWord(tokens, at); match.word != nullptr) {
    item.kind = LayoutItemKind::kNoun;
    item.noun = match.word;
    item.plural = match.plural;
    longest = match.tokens;
  }
  if (PlaceMatch match = MatchPlace(tokens, at); match.tokens > longest) {
    item.kind = LayoutItemKind::kPlace;
    item.places = std::move(match.places);
    longest = match.tokens;
    const std::size_t after = at + longest;
    item.relative =
        after < tokens.size() && tokens[after].text == "of" && NounFollows(tokens, after + 1);
  }
  if (const NumberMatch match = MatchNumber(tokens, at); match.tokens > longest) {
    item.kind = LayoutItemKind::kNumber;
    item.number = match.value;
    longest = match.tokens;
  }
  if (const LayoutWordMatch match = MatchLayoutWord(tokens, at); match.tokens > longest) {
    // "in the middle of" is a tie to a noun, or else the place of the map that it names.
    if (match.tokens > 1 && EndsWithOf(tokens, at + match.tokens) &&
        !NounFollows(tokens, at + match.tokens) &&
        (match.word == LayoutWord::kSurroundedBy || match.word == LayoutWord::kNextTo)) {
      item.kind = LayoutItemKind::kWord;
      item.word = LayoutWord::kFunction;
      longest = 1;
    } else {
      item.kind = LayoutItemKind::kWord;
      item.word = match.word;
      longest = match.tokens;
    }
  }
  item.last = at + std::max<std::size_t>(longest, 1);
  return item;
}

}  // namespace

std::vector<LayoutItem> LexLayout(const std::vector<Token>& tokens) {
  std::vector<LayoutItem> items;
  for (std::size_t at = 0; at < tokens.size();) {
    LayoutItem item = ReadItem(tokens, at);
    at = item.last;
    // "mountain lake": the last of two nouns in a row is the thing, the one before it its kind.
    if (item.kind == LayoutItemKind::kNoun && !items.empty() &&
        items.back().kind == LayoutItemKind::kNoun && !items.back().plural &&
        items.back().last == item.first) {
      item.first = items.back().first;
      items.back() = std::move(item);
    } else {
      items.push_back(std::move(item));
    }
  }
  return items;
}

}  // namespace latticeworld
