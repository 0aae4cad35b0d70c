#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Lists along a direction, and what two sides share.
namespace latticeworld {
namespace {

// The things of a list that goes on to the next stop, "a beach, grass and forest"; 0: it is none,
// or a line is among them.
int ListTo(const std::vector<Token>& tokens, std::size_t at) {
  constexpr int kLongest = 4;  // words of one of them
  int things = 0;
  int words = 0;
  bool named = false;
  for (;; ++at) {
    if (IsPauseAt(tokens, at) || IsOneOf(WordAt(tokens, at), {"and", "then", "finally"})) {
      if (words > 0 && !named) return 0;
      words = 0;
      named = false;
      if (IsStopAt(tokens, at)) return things;
      continue;
    }
    const ClassWordMatch match = MatchClassWord(tokens, at);
    if (named || ++words > kLongest) return 0;
    if (match.word == nullptr) continue;
    if (match.word->shape == WordShape::kLine) return 0;
    at += match.tokens - 1;
    named = true;
    ++things;
  }
}

// "From south to north a beach, grass, and forest": a pause before the list. "From the top: snow,
// rock, forest": from north to south.
void TurnAxisLists(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "from" || (at > 0 && !IsStopAt(*tokens, at - 1))) continue;
    const std::size_t from = at + (WordAt(*tokens, at + 1) == "the" ? 2 : 1);
    const AxisMatch axis = MatchAxis(*tokens, from);
    Heading heading;
    const std::size_t colon = TakeHeading(*tokens, from, &heading);
    const bool first = colon > 0 && !heading.IsDiagonal() && IsMark(*tokens, colon) &&
                       (*tokens)[colon].text == ":" && ListTo(*tokens, colon + 1) > 2;
    if (first) {
      const Heading to{-heading.east, -heading.south};
      ReplaceTokens(tokens, from, colon - from, {NameOf(heading), "to", NameOf(to)});
      continue;
    }
    if (axis.tokens == 0) continue;
    const std::size_t end = from + axis.tokens;
    if (IsPauseAt(*tokens, end) || ListTo(*tokens, end) < 2) continue;
    const Token& beside = (*tokens)[end];
    InsertTokens(tokens, end, {{TokenKind::kComma, ",", beside.begin, beside.begin}});
  }
}

// "north of it grass, north of that forest": to the north of the grass there is forest.
void TurnOnFromThat(std::vector<Token>* tokens) {
  std::vector<Token> last;
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const ClassWordMatch match = MatchClassWord(*tokens, at);
    if (match.word != nullptr) {
      last.assign(tokens->begin() + static_cast<std::ptrdiff_t>(at),
                  tokens->begin() + static_cast<std::ptrdiff_t>(at + match.tokens));
      at += match.tokens - 1;
      continue;
    }
    Heading heading;
    if (last.empty() || at == 0 || !IsPauseAt(*tokens, at - 1)) continue;
    const std::size_t of = TakeHeading(*tokens, at, &heading);
    if (of == 0 || WordAt(*tokens, of) != "of" || WordAt(*tokens, of + 1) != "that") continue;
    const ClassWordMatch noun = MatchClassWord(*tokens, of + 2);
    if (noun.word == nullptr || !IsPauseAt(*tokens, of + 2 + noun.tokens)) continue;
    const Token beside = (*tokens)[at];
    std::vector<Token> turned = {{TokenKind::kStop, ".", beside.begin, beside.begin}};
    for (const std::string_view word :
         {std::string_view("to"), std::string_view("the"), NameOf(heading), std::string_view("of"),
          std::string_view("the")}) {
      turned.push_back(WordLike(word, beside));
    }
    for (const Token& token : last) turned.push_back(WordLike(token.text, beside));
    turned.push_back(WordLike("there", beside));
    turned.push_back(WordLike("is", beside));
    EraseTokens(tokens, at, of + 2 - at);
    InsertTokens(tokens, at, turned);
    at += turned.size() - 1;
  }
}

// "two villages, one north and one south of the river": one north of the river too.
void TurnSharedOwners(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 6 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "one") continue;
    Heading first;
    Heading second;
    const bool to = WordAt(*tokens, at + 1) == "to";
    const std::size_t end = TakeHeading(*tokens, at + (to ? 2 : 1), &first);
    std::size_t next = end;
    if (end == 0) continue;
    if (IsMark(*tokens, next)) ++next;
    if (WordAt(*tokens, next) == "and") ++next;
    if (next == end || !IsOneOf(WordAt(*tokens, next), {"one", "another"})) continue;
    ++next;
    if (WordAt(*tokens, next) == "to") ++next;
    const std::size_t of = TakeHeading(*tokens, next, &second);
    if (of == 0 || WordAt(*tokens, of) != "of" || WordAt(*tokens, of + 1) != "the") continue;
    const ClassWordMatch noun = MatchClassWord(*tokens, of + 2);
    if (noun.word == nullptr) continue;
    const Token beside = (*tokens)[end - 1];
    std::vector<Token> owner;
    for (std::size_t i = of; i < of + 2 + noun.tokens; ++i) {
      owner.push_back(WordLike((*tokens)[i].text, beside));
    }
    InsertTokens(tokens, end, owner);
    at = of + owner.size();
  }
}

// "the southern half is split between fields on the left and houses on the right": the quarters.
void TurnSplitHalves(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 8 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "the") continue;
    // "the southern half is split between"
    Heading half;
    const std::size_t noun = TakeHeading(*tokens, at, &half);
    if (noun == 0 || half.IsDiagonal() || WordAt(*tokens, noun) != "half" ||
        WordAt(*tokens, noun + 1) != "is" ||
        !IsOneOf(WordAt(*tokens, noun + 2), {"split", "divided", "shared"}) ||
        !IsOneOf(WordAt(*tokens, noun + 3), {"between", "into"})) {
      continue;
    }
    // Both parts follow, each with the side of the half that it is on: together they name a
    // quarter.
    std::vector<Token> turned;
    std::size_t next = noun + 4;
    const Token beside = (*tokens)[at];
    int parts = 0;
    while (parts < 2) {
      std::size_t side = next;
      while (!IsStopAt(*tokens, side) && !(IsOneOf(WordAt(*tokens, side), {"on", "to", "in"}) &&
                                           WordAt(*tokens, side + 1) == "the")) {
        ++side;
      }
      Heading heading;
      const std::size_t end =
          IsStopAt(*tokens, side) ? 0 : TakeHeading(*tokens, side + 1, &heading);
      const Heading both{half.east + heading.east, half.south + heading.south};
      if (end == 0 || side == next || heading.IsDiagonal() || both.east * both.east != 1 ||
          both.south * both.south != 1) {
        break;
      }
      if (parts > 0) turned.push_back({TokenKind::kStop, ".", beside.begin, beside.begin});
      for (const std::string_view word : {std::string_view("the"), NameOf(both),
                                          std::string_view("quarter"), std::string_view("is")}) {
        turned.push_back(WordLike(word, beside));
      }
      turned.insert(turned.end(), tokens->begin() + static_cast<std::ptrdiff_t>(next),
                    tokens->begin() + static_cast<std::ptrdiff_t>(side));
      next = end;
      if (++parts == 2) break;
      if (IsMark(*tokens, next)) ++next;
      if (WordAt(*tokens, next) == "and") ++next;
    }
    if (parts != 2 || !IsPauseAt(*tokens, next)) continue;
    EraseTokens(tokens, at, next - at);
    InsertTokens(tokens, at, turned);
    at += turned.size() - 1;
  }
}

}  // namespace

void TurnLists(std::vector<Token>* tokens) {
  TurnAxisLists(tokens);
  TurnOnFromThat(tokens);
  TurnSharedOwners(tokens);
  TurnSplitHalves(tokens);
}

}  // namespace latticeworld
