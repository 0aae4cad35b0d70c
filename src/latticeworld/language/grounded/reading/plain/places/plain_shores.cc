#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Shores and sides whose owner is named elsewhere.
namespace latticeworld {
namespace {

// "The village is on the left bank. The river runs ...": of the river, which is named later.
void FillBanks(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 40;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const ClassWordMatch known = MatchClassWord(*tokens, at);
    const bool water = known.word != nullptr && known.word->wild == 'W';
    if (water) return;
    if (WordAt(*tokens, at) != "the") continue;
    Heading heading;
    const std::size_t end = TakeHeading(*tokens, at, &heading);
    if (end == 0 || !IsOneOf(WordAt(*tokens, end), {"bank", "shore"}) ||
        WordAt(*tokens, end + 1) == "of") {
      continue;
    }
    for (std::size_t i = end + 1; i < end + kReach && i < tokens->size(); ++i) {
      const ClassWordMatch match = MatchClassWord(*tokens, i);
      if (match.word == nullptr || match.word->wild != 'W') continue;
      const std::vector<Token> name(
          tokens->begin() + static_cast<std::ptrdiff_t>(i),
          tokens->begin() + static_cast<std::ptrdiff_t>(i + match.tokens));
      std::vector<Token> owner = {WordLike("of", (*tokens)[end]), WordLike("the", (*tokens)[end])};
      for (const Token& token : name) owner.push_back(WordLike(token.text, (*tokens)[end]));
      InsertTokens(tokens, end + 1, owner);
      return;
    }
  }
}

// "a forest at their foot": next to them.
void TurnFeet(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    if (IsOneOf(WordAt(*tokens, at), {"its", "their"}) &&
        IsOneOf(WordAt(*tokens, at + 1), {"foot", "feet", "base"}) &&
        IsOneOf(WordAt(*tokens, at - 1), {"at", "around", "round", "along"})) {
      const std::string_view whom = WordAt(*tokens, at) == "its" ? "it" : "them";
      ReplaceTokens(tokens, at - 1, 3, {"next", "to", whom});
    }
  }
}

// "a lake whose northern shore is wooded": its northern shore is.
void TurnWhoseSide(std::vector<Token>* tokens, std::size_t at) {
  Heading heading;
  const std::size_t end = TakeHeading(*tokens, at + 1, &heading);
  const bool is =
      end > 0 && IsFlank(WordAt(*tokens, end)) && IsOneOf(WordAt(*tokens, end + 1), {"is", "are"});
  if (!is) return;
  const Token beside = (*tokens)[at];
  (*tokens)[at].text = "its";
  const Token stop{TokenKind::kStop, ".", beside.begin, beside.begin};
  if (WordAt(*tokens, at - 1) == "and" || IsMark(*tokens, at - 1)) {
    (*tokens)[at - 1] = stop;
  } else {
    InsertTokens(tokens, at, {stop});
  }
}

// "bordered by forest on its west side and by rocks on its east side": it has forest ...
void TurnBorderedSides(std::vector<Token>* tokens, std::size_t at) {
  std::size_t its = at + 2;
  while (!IsStopAt(*tokens, its) && WordAt(*tokens, its) != "its") ++its;
  Heading heading;
  const std::size_t side = TakeHeading(*tokens, its + 1, &heading);
  if (WordAt(*tokens, its) != "its" || side == 0 || !IsFlank(WordAt(*tokens, side))) return;
  for (std::size_t i = its; !IsStopAt(*tokens, i); ++i)
    if (WordAt(*tokens, i) == "and" && WordAt(*tokens, i + 1) == "by")
      EraseTokens(tokens, i + 1, 1);
  ReplaceTokens(tokens, at - 1, 3, {"has"});
}

// "South of the road it is all houses": there are houses.
void TurnItIs(std::vector<Token>* tokens, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && begin + 9 > at && !IsPauseAt(*tokens, begin - 1)) --begin;
  if (begin == at && at > 1 && IsMark(*tokens, at - 1)) {
    begin = at - 1;
    while (begin > 0 && begin + 9 > at && !IsPauseAt(*tokens, begin - 1)) --begin;
  }
  if (WordAt(*tokens, begin) == "to" || WordAt(*tokens, begin) == "and") ++begin;
  const bool above = IsOneOf(WordAt(*tokens, begin), {"above", "below", "behind", "beyond"});
  Heading heading;
  const std::size_t of = TakeHeading(*tokens, begin, &heading);
  // "to the south it is open fields", of what was spoken of
  const bool flank = of == at && begin > 0 && WordAt(*tokens, begin - 1) == "to";
  if (begin < at && (above || flank || (of > 0 && of < at && WordAt(*tokens, of) == "of"))) {
    (*tokens)[at].text = "there";
  }
}

// "the fourth, the eastern, is forest", where three sides were told: to the east of it. Whether it
// was; *at becomes the first word that is put in.
bool TurnFourthSide(std::vector<Token>* tokens, std::size_t* at) {
  if (WordAt(*tokens, *at) != "the" ||
      !IsOneOf(WordAt(*tokens, *at + 1), {"fourth", "other", "last"})) {
    return false;
  }
  std::size_t next = *at + 2;
  if (WordAt(*tokens, next) == "side") ++next;
  if (!IsMark(*tokens, next)) return false;
  Heading heading;
  std::size_t end = TakeHeading(*tokens, next + 1, &heading);
  if (end == 0) return false;
  if (IsFlank(WordAt(*tokens, end)) || WordAt(*tokens, end) == "one") ++end;
  if (!IsMark(*tokens, end)) return false;
  ++end;
  if (WordAt(*tokens, end) == "there") ++end;
  if (IsOneOf(WordAt(*tokens, *at - 1), {"on", "to", "at"})) --*at;
  while (IsOneOf(WordAt(*tokens, end), {"is", "has", "faces", "touches", "open", "to", "borders",
                                        "on", "facing", "by"})) {
    ++end;
  }
  ReplaceTokens(tokens, *at, end - *at, {"to", "the", NameOf(heading), "of", "it", "there", "is"});
  return true;
}

// Sides that belong to what was spoken of, each told in a way of its own.
void TurnOwnSides(std::vector<Token>* tokens) {
  bool three = false;  // "on three sides" was said
  for (std::size_t at = 1; at + 3 < tokens->size(); ++at) {
    const std::string_view word = WordAt(*tokens, at);
    const std::string_view next = WordAt(*tokens, at + 1);
    const std::string_view before = WordAt(*tokens, at - 1);
    // What follows "of it" or "of the road" at the beginning of a clause belongs to that owner.
    const bool owns = IsOneOf(before, {"of", "above", "below"});
    if (word == "whose") {
      TurnWhoseSide(tokens, at);
    } else if (IsOneOf(word, {"bordered", "flanked", "fringed", "edged", "lined"}) &&
               IsOneOf(before, {"is", "are"}) && next == "by") {
      TurnBorderedSides(tokens, at);
    } else if (word == "it" && owns && IsOneOf(next, {"all", "only"}) &&
               MatchClassWord(*tokens, at + 2).word != nullptr) {
      InsertTokens(tokens, at + 1,
                   {WordLike("there", (*tokens)[at]), WordLike("is", (*tokens)[at])});
    } else if (word == "it" && !owns && next == "is") {
      TurnItIs(tokens, at);
    } else {
      three = three || (word == "three" && IsOneOf(next, {"sides", "side"}));
      if (three && TurnFourthSide(tokens, &at)) three = false;
    }
  }
}

// The words "of it", "of the lake" at `at`; empty: it says nothing of the kind.
std::vector<Token> OwnerAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) != "of") return {};
  const bool it = WordAt(tokens, at + 1) == "it";
  const std::size_t thing = at + (WordAt(tokens, at + 1) == "the" ? 2 : 1);
  const ClassWordMatch noun = MatchClassWord(tokens, thing);
  if (!it && noun.word == nullptr) return {};
  const std::size_t end = it ? at + 2 : thing + noun.tokens;
  return {tokens.begin() + static_cast<std::ptrdiff_t>(at),
          tokens.begin() + static_cast<std::ptrdiff_t>(end)};
}

// "forest on its southern side, heath on the north": on its northern side. "Forest on the north
// side of the lake, heath on the south side": of the lake.
void FillOwners(std::vector<Token>* tokens) {
  Heading side;
  std::string noun;
  std::vector<Token> of;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) noun.clear();
    if (!IsOneOf(WordAt(*tokens, at), {"on", "to", "along"})) continue;
    const std::string owner(WordAt(*tokens, at + 1));
    Heading heading;
    const std::size_t end = TakeHeading(*tokens, at + 1, &heading);
    if (end == 0) continue;
    const std::vector<Token> owned = OwnerAt(*tokens, end + 1);
    if (IsFlank(WordAt(*tokens, end)) && (owner == "its" || (owner == "the" && !owned.empty()))) {
      side = heading;
      noun = WordAt(*tokens, end);
      of = owned;
      continue;
    }
    const bool opposite = heading.east == -side.east && heading.south == -side.south;
    if (noun.empty() || owner != "the" || !opposite) continue;
    const bool said = WordAt(*tokens, end) == noun;
    if (!IsPauseAt(*tokens, said ? end + 1 : end)) continue;
    (*tokens)[at].text = "on";
    if (of.empty()) (*tokens)[at + 1].text = "its";
    std::vector<Token> left_out;
    if (!said) left_out.push_back(WordLike(noun, (*tokens)[end - 1]));
    for (const Token& word : of) left_out.push_back(WordLike(word.text, (*tokens)[end - 1]));
    InsertTokens(tokens, end + (said ? 1 : 0), left_out);
  }
}

}  // namespace

void TurnShores(std::vector<Token>* tokens) {
  FillBanks(tokens);
  TurnFeet(tokens);
  TurnOwnSides(tokens);
  FillOwners(tokens);
}

}  // namespace latticeworld
