#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Sides and places that stand apart from what they are the sides of.
namespace latticeworld {
namespace {

// "A road from the lake south to a village": to a village to the south of the lake.
void TurnSouthTo(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "from" || WordAt(*tokens, at + 1) != "the") return;
  const std::size_t side = at + 2 + MatchClassWord(*tokens, at + 2).tokens;
  const std::string heading(HeadingWord(WordAt(*tokens, side)));
  const std::size_t to = side + 1;
  if (side == at + 2 || heading.empty() || WordAt(*tokens, to) != "to" ||
      !IsOneOf(WordAt(*tokens, to + 1), {"a", "the", "another"})) {
    return;
  }
  const std::size_t end = to + 2 + MatchClassWord(*tokens, to + 2).tokens;
  if (end == to + 2 || IsMapWord(WordAt(*tokens, to + 2)) || !IsPauseAt(*tokens, end)) return;
  const Token beside = (*tokens)[side];
  std::vector<Token> said;
  for (const std::string_view word : {"to", "the"}) said.push_back(WordLike(word, beside));
  said.push_back(WordLike(heading, beside));
  said.push_back(WordLike("of", beside));
  for (const Token& token : TokensBetween(*tokens, at + 1, side))
    said.push_back(WordLike(token.text, beside));
  InsertTokens(tokens, end, said);
  EraseTokens(tokens, side, 1);
}

// "And behind it, to the north, a rock": to the north of it. "A town on the river, on the south
// side": on the south side of the river.
void TurnSideAside(std::vector<Token>* tokens, std::size_t at) {
  const bool behind = WordAt(*tokens, at) == "behind" && WordAt(*tokens, at + 1) == "it";
  if (behind && IsMark(*tokens, at + 2) &&
      IsOneOf(WordAt(*tokens, at + 3), {"to", "towards", "in"}) &&
      WordAt(*tokens, at + 4) == "the" && IsMark(*tokens, at + 6)) {
    const std::string side(SideWord(WordAt(*tokens, at + 5)));
    if (!side.empty()) ReplaceTokens(tokens, at, 7, {"to", "the", side, "of", "it"});
    return;
  }
  if (!IsMark(*tokens, at) || !IsOneOf(WordAt(*tokens, at + 1), {"on", "at"}) ||
      !IsOneOf(WordAt(*tokens, at + 2), {"the", "its"}) ||
      !IsOneOf(WordAt(*tokens, at + 4), {"side", "bank", "shore"}) || !IsPauseAt(*tokens, at + 5)) {
    return;
  }
  const std::string side(SideWord(WordAt(*tokens, at + 3)));
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (side.empty() || named.empty() || named.front().end != at || named.front().begin < 2) return;
  const std::size_t on = named.front().begin - 2;
  if (!IsOneOf(WordAt(*tokens, on), {"on", "by", "at", "beside"}) ||
      !IsOneOf(WordAt(*tokens, on + 1), {"the", "a"})) {
    return;
  }
  EraseTokens(tokens, at, 5);
  ReplaceTokens(tokens, on, 1, {"on", "the", side, "side", "of"});
}

// "The forest borders the lake in the north and the fields in the south": is bordered by the lake
// on the north and by the fields on the south.
void TurnBordersOn(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"borders", "adjoins", "touches", "meets"})) return;
  const std::size_t first = at + (WordAt(*tokens, at + 1) == "on" ? 2 : 1);
  const auto side_at = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i), {"in", "on", "to"}) && WordAt(*tokens, i + 1) == "the" &&
           !HeadingWord(WordAt(*tokens, i + 2)).empty();
  };
  std::size_t on = first;
  while (!IsPauseAt(*tokens, on) && !side_at(on)) ++on;
  if (!side_at(on) || WordAt(*tokens, on + 3) != "and") return;
  const std::size_t second = on + 4;
  std::size_t end = second;
  while (!IsPauseAt(*tokens, end) && !side_at(end)) ++end;
  if (!side_at(end) || !IsPauseAt(*tokens, end + 3)) return;
  if (!NamesThing(*tokens, first) || !NamesThing(*tokens, second)) return;
  (*tokens)[end].text = (*tokens)[on].text = "on";
  InsertTokens(tokens, second, {WordLike("by", (*tokens)[second])});
  ReplaceTokens(tokens, at, first - at, {"is", "bordered", "by"});
}

// "In the corner, bottom left": in the bottom left corner.
void TurnCornerAside(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "corner" || WordAt(*tokens, at - (at > 0 ? 1 : 0)) != "the") return;
  std::size_t place = at + (IsMark(*tokens, at + 1) ? 2 : 1);
  if (place == at + 1 && WordAt(*tokens, place) != "at") return;
  while (IsOneOf(WordAt(*tokens, place), {"at", "in", "on", "the"})) ++place;
  Heading heading;
  const std::size_t end = TakeHeading(*tokens, place, &heading);
  if (end == 0 || !heading.IsDiagonal() || !IsPauseAt(*tokens, end)) return;
  EraseTokens(tokens, at + 1, end - at - 1);
  InsertTokens(tokens, at, {WordLike(NameOf(heading), (*tokens)[at])});
}

// "The middle of the map stays empty": keep the middle empty.
void TurnStaysEmpty(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"stays", "remains", "is", "left", "stay"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"empty", "free", "open", "clear"}) ||
      !IsPauseAt(*tokens, at + 2)) {
    return;
  }
  std::size_t begin = at;
  while (begin > 0 && !IsPauseAt(*tokens, begin - 1) && WordAt(*tokens, begin - 1) != "and")
    --begin;
  if (WordAt(*tokens, begin) != "the") return;
  PlaceCursor cursor(*tokens, begin + 1);
  if (!TakeDirection(&cursor).found) return;
  std::size_t end = cursor.at();
  while (IsFlank(WordAt(*tokens, end)) ||
         IsOneOf(WordAt(*tokens, end), {"edge", "corner", "third", "quarter"})) {
    ++end;
  }
  const std::size_t place_end = end;
  if (WordAt(*tokens, end) == "of" && IsMapWord(WordAt(*tokens, end + 2))) end += 3;
  while (IsOneOf(WordAt(*tokens, end), {"should", "must", "is", "be", "to"}) && end < at) ++end;
  if (end != at) return;
  EraseTokens(tokens, place_end, at - place_end + 1);
  InsertTokens(tokens, begin, {WordLike("keep", (*tokens)[begin])});
}

// "Behind the village, towards the north, rises a forest": to the north of the village.
void TurnBehindTowards(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "behind" || WordAt(*tokens, at + 1) != "the") return;
  const std::size_t noun_end = at + 2 + MatchClassWord(*tokens, at + 2).tokens;
  if (noun_end == at + 2 || !IsMark(*tokens, noun_end) ||
      !IsOneOf(WordAt(*tokens, noun_end + 1), {"to", "towards", "toward"}) ||
      WordAt(*tokens, noun_end + 2) != "the") {
    return;
  }
  const std::string side(SideWord(WordAt(*tokens, noun_end + 3)));
  if (side.empty() || !IsMark(*tokens, noun_end + 4)) return;
  EraseTokens(tokens, noun_end, 5);
  ReplaceTokens(tokens, at, 1, {"to", "the", side, "of"});
}

}  // namespace

void TurnPlacing(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnSouthTo(tokens, at);
    TurnSideAside(tokens, at);
    TurnBehindTowards(tokens, at);
    TurnBordersOn(tokens, at);
    TurnCornerAside(tokens, at);
    TurnStaysEmpty(tokens, at);
  }
}

}  // namespace latticeworld
