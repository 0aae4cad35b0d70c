#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/token_edits.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"

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

// "a lake whose northern shore is wooded": its northern shore is. "South of the road it is all
// houses": there are houses. "Surrounded by fields on three sides; the fourth, the eastern, is
// forest": to the east of it.
void TurnOwnSides(std::vector<Token>* tokens) {
  bool three = false;
  for (std::size_t at = 1; at + 3 < tokens->size(); ++at) {
    Heading heading;
    if (WordAt(*tokens, at) == "whose") {
      const std::size_t end = TakeHeading(*tokens, at + 1, &heading);
      const bool is = end > 0 && IsFlank(WordAt(*tokens, end)) &&
                      IsOneOf(WordAt(*tokens, end + 1), {"is", "are"});
      if (!is) continue;
      const Token beside = (*tokens)[at];
      (*tokens)[at].text = "its";
      const Token stop{TokenKind::kStop, ".", beside.begin, beside.begin};
      if (WordAt(*tokens, at - 1) == "and" || IsMark(*tokens, at - 1)) {
        (*tokens)[at - 1] = stop;
      } else {
        InsertTokens(tokens, at, {stop});
      }
      continue;
    }
    // Behind "of it" or "of the road" at the beginning of a clause.
    const bool owns = IsOneOf(WordAt(*tokens, at - 1), {"of", "above", "below"});
    if (WordAt(*tokens, at) == "it" && owns && IsOneOf(WordAt(*tokens, at + 1), {"all", "only"}) &&
        MatchClassWord(*tokens, at + 2).word != nullptr) {
      InsertTokens(tokens, at + 1,
                   {WordLike("there", (*tokens)[at]), WordLike("is", (*tokens)[at])});
      continue;
    }
    const bool all = !owns && WordAt(*tokens, at) == "it" && WordAt(*tokens, at + 1) == "is";
    if (all) {
      std::size_t begin = at;
      while (begin > 0 && begin + 9 > at && !IsPauseAt(*tokens, begin - 1)) --begin;
      if (begin == at && at > 1 && IsMark(*tokens, at - 1)) {
        begin = at - 1;
        while (begin > 0 && begin + 9 > at && !IsPauseAt(*tokens, begin - 1)) --begin;
      }
      if (WordAt(*tokens, begin) == "to" || WordAt(*tokens, begin) == "and") ++begin;
      const bool above = IsOneOf(WordAt(*tokens, begin), {"above", "below", "behind", "beyond"});
      const std::size_t of = TakeHeading(*tokens, begin, &heading);
      if (begin < at && (above || (of > 0 && of < at && WordAt(*tokens, of) == "of"))) {
        (*tokens)[at].text = "there";
      }
      continue;
    }
    three = three ||
            (WordAt(*tokens, at) == "three" && IsOneOf(WordAt(*tokens, at + 1), {"sides", "side"}));
    if (!three || WordAt(*tokens, at) != "the" ||
        !IsOneOf(WordAt(*tokens, at + 1), {"fourth", "other", "last"})) {
      continue;
    }
    std::size_t next = at + 2;
    if (WordAt(*tokens, next) == "side") ++next;
    if (!IsMark(*tokens, next)) continue;
    std::size_t end = TakeHeading(*tokens, next + 1, &heading);
    if (end == 0) continue;
    if (IsFlank(WordAt(*tokens, end)) || WordAt(*tokens, end) == "one") ++end;
    if (!IsMark(*tokens, end)) continue;
    ++end;
    if (WordAt(*tokens, end) == "there") ++end;
    if (IsOneOf(WordAt(*tokens, at - 1), {"on", "to", "at"})) --at;
    while (IsOneOf(WordAt(*tokens, end), {"is", "has", "faces", "touches", "open", "to", "borders",
                                          "on", "facing", "by"})) {
      ++end;
    }
    ReplaceTokens(tokens, at, end - at, {"to", "the", NameOf(heading), "of", "it", "there", "is"});
    three = false;
  }
}

// "forest on its southern side, heath on the north": on its northern side.
void FillOwners(std::vector<Token>* tokens) {
  Heading side;
  std::string noun;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) noun.clear();
    if (!IsOneOf(WordAt(*tokens, at), {"on", "to", "along"})) continue;
    const std::string owner(WordAt(*tokens, at + 1));
    Heading heading;
    const std::size_t end = TakeHeading(*tokens, at + 1, &heading);
    if (end == 0) continue;
    if (owner == "its" && IsFlank(WordAt(*tokens, end))) {
      side = heading;
      noun = WordAt(*tokens, end);
      continue;
    }
    const bool opposite = heading.east == -side.east && heading.south == -side.south;
    if (noun.empty() || owner != "the" || !opposite) continue;
    const bool said = WordAt(*tokens, end) == noun;
    if (!said && !IsPauseAt(*tokens, end)) continue;
    (*tokens)[at].text = "on";
    (*tokens)[at + 1].text = "its";
    if (!said) InsertTokens(tokens, end, {WordLike(noun, (*tokens)[end - 1])});
  }
}

}  // namespace

void TurnShores(std::vector<Token>* tokens) {
  FillBanks(tokens);
  TurnOwnSides(tokens);
  FillOwners(tokens);
}

}  // namespace latticeworld
