#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// A word with "'s" takes two bytes more than its letters.
bool IsPossessive(const Token& token) {
  return token.kind == TokenKind::kWord && token.end - token.begin >= token.text.size() + 2;
}

bool IsSideNoun(std::string_view word) {
  return IsOneOf(word, {"side", "bank", "shore", "edge", "end", "half", "flank", "border", "coast",
                        "corner", "margin", "rim", "fringe"});
}

}  // namespace

// "the river's right side": the right side of the river.
void TurnPossessives(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (!IsPossessive((*tokens)[at]) || MatchClassWord(*tokens, at).word == nullptr) continue;
    PlaceCursor cursor(*tokens, at + 1);
    const Direction direction = TakeDirection(&cursor);
    const std::size_t side = cursor.at();
    if (!direction.found || !IsSideNoun(WordAt(*tokens, side))) continue;
    std::size_t first = at;
    if (first > 0 && MatchClassWord(*tokens, first - 1).tokens > 1) --first;
    if (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"the", "this", "that"})) --first;
    std::vector<Token> owner(tokens->begin() + static_cast<std::ptrdiff_t>(first),
                             tokens->begin() + static_cast<std::ptrdiff_t>(at + 1));
    if (owner.front().text != "the") owner.insert(owner.begin(), WordLike("the", owner.front()));
    owner.insert(owner.begin(), WordLike("of", (*tokens)[side]));
    InsertTokens(tokens, side + 1, owner);
    EraseTokens(tokens, first, at + 1 - first);
    InsertTokens(tokens, first, {WordLike("the", (*tokens)[first])});
    // Each word of them stands for all of these.
    const std::size_t end = first + 1 + (side - at) + owner.size();
    std::size_t begin_byte = (*tokens)[first].begin;
    std::size_t end_byte = 0;
    for (std::size_t i = first; i < end; ++i) {
      begin_byte = std::min(begin_byte, (*tokens)[i].begin);
      end_byte = std::max(end_byte, (*tokens)[i].end);
    }
    for (std::size_t i = first; i < end; ++i) {
      (*tokens)[i].begin = begin_byte;
      (*tokens)[i].end = end_byte;
    }
    at = end - 1;
  }
}

// "bounded to the east by a road, and to the south by a river", of the map: there is a road in the
// east.
void TurnBounds(std::vector<Token>* tokens) {
  bool thing = false;
  bool bounded = false;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if ((*tokens)[at].kind == TokenKind::kStop) {
      thing = bounded = false;
      continue;
    }
    // A verb that no thing stands before, or a later part of its list: the map is bounded.
    const ClassWordMatch noun = MatchClassWord(*tokens, at);
    std::size_t next = at;
    const bool verb = IsOneOf(WordAt(*tokens, at), {"bounded", "bordered", "limited", "flanked",
                                                    "closed", "delimited", "edged", "hemmed"});
    if (verb) ++next;
    if (IsOneOf(WordAt(*tokens, next), {"off", "in"}) && verb) ++next;
    if ((verb && !thing) || bounded) {
      if (IsOneOf(WordAt(*tokens, next), {"to", "on", "in", "at"}) &&
          WordAt(*tokens, next + 1) == "the") {
        // "to the east by": there is ... in the east.
        PlaceCursor cursor(*tokens, next + 2);
        const Direction direction = TakeDirection(&cursor);
        std::size_t by = cursor.at();
        if (IsSideNoun(WordAt(*tokens, by))) ++by;
        if (direction.found && WordAt(*tokens, by) == "by") {
          const Token beside = (*tokens)[by];
          EraseTokens(tokens, by, 1);
          InsertTokens(tokens, by, {WordLike("there", beside), WordLike("is", beside)});
          (*tokens)[next].text = "in";
          if (next > at) {
            std::size_t first = at;
            if (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"is", "be"})) --first;
            EraseTokens(tokens, first, next - first);
            InsertTokens(tokens, first, {{TokenKind::kComma, ",", beside.begin, beside.end}});
            at = first;
          }
          bounded = true;
          continue;
        }
      }
    }
    thing = thing || (noun.word != nullptr && !bounded);
  }
}

namespace {

// "Houses south of the lake, and beyond them": to the south of the houses.
bool TurnFurther(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "beyond" || WordAt(*tokens, at + 1) != "them") return false;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  const std::size_t begin = SentenceBegin(*tokens, at);
  for (const NamedThing& thing : named) {
    if (thing.begin < begin) return false;
    std::size_t side = thing.end;
    while (IsOneOf(WordAt(*tokens, side), {"to", "the", "lie", "are"})) ++side;
    Heading heading;
    const std::size_t of = TakeHeading(*tokens, side, &heading);
    if (of == 0 || WordAt(*tokens, of) != "of") continue;
    if (!MatchClassWord(*tokens, thing.begin).plural) return false;
    std::vector<Token> said = SaidLike("to the", (*tokens)[at]);
    for (const std::string_view word : {NameOf(heading), std::string_view("of")})
      said.push_back(WordLike(word, (*tokens)[at]));
    said.push_back(WordLike("the", (*tokens)[at]));
    for (std::size_t i = thing.begin; i < thing.end; ++i) said.push_back((*tokens)[i]);
    EraseTokens(tokens, at, 2);
    InsertTokens(tokens, at, said);
    return true;
  }
  return false;
}

}  // namespace

// "beyond these", "outside all that": what lies there is what is left over.
void TurnBeyond(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"beyond", "outside", "past"})) continue;
    std::size_t next = at + 1;
    if (WordAt(*tokens, next) == "of") ++next;
    const bool all = WordAt(*tokens, next) == "all";
    if (all) ++next;
    const bool points =
        IsOneOf(WordAt(*tokens, next), {"these", "those", "them"}) ||
        (all && IsOneOf(WordAt(*tokens, next), {"that", "this", "of"})) ||
        (IsOneOf(WordAt(*tokens, next), {"this", "that"}) && IsPauseAt(*tokens, next + 1));
    const ClassWordMatch noun = MatchClassWord(*tokens, next + 1);
    const bool many = IsOneOf(WordAt(*tokens, next), {"these", "those", "them"});
    const bool named = noun.word != nullptr && (noun.plural || !many);  // "beyond these fields"
    // "a village beyond them" says where the village is.
    const bool fronted = IsPauseAt(*tokens, at - 1) || at == 0 ||
                         IsOneOf(WordAt(*tokens, at - 1), {"and", "while", "but", "everything"});
    if (!points || named || !fronted || IsPauseAt(*tokens, next + 1) ||
        WordAt(*tokens, next + 1) == "on") {
      continue;
    }
    if (TurnFurther(tokens, at)) continue;
    if (all && WordAt(*tokens, next) == "of") ++next;
    const Token first = (*tokens)[at];
    EraseTokens(tokens, at, next + 1 - at);
    InsertTokens(tokens, at, {WordLike("elsewhere", first)});
  }
}

}  // namespace latticeworld
