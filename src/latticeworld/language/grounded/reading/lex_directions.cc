#include "latticeworld/language/grounded/reading/lex_directions.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace latticeworld {
namespace {

bool IsWord(const std::vector<Token>& tokens, std::size_t at,
            std::initializer_list<std::string_view> words) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord &&
         std::find(words.begin(), words.end(), tokens[at].text) != words.end();
}

// The words for a part of a thing's border, after a heading: "the northern shore of".
std::size_t SkipSideWord(const std::vector<Token>& tokens, std::size_t at) {
  return IsWord(tokens, at,
                {"side", "shore", "shores", "bank", "banks", "edge", "end", "coast", "flank",
                 "border", "rim", "waterfront", "tip", "fringe"})
             ? 1
             : 0;
}

}  // namespace

// "north of the lake", "to its west", "on the southern shore of it".
bool LexDirection(const std::vector<Token>& tokens, std::size_t at, Lexeme* lexeme) {
  const bool own = IsWord(tokens, at, {"its", "their", "whose"});
  const HeadingMatch match = MatchHeading(tokens, at + (own ? 1 : 0));
  if (match.tokens == 0) return false;
  std::size_t next = at + (own ? 1 : 0) + match.tokens;
  const bool said_side = tokens[next - 1].kind == TokenKind::kWord &&
                         SkipSideWord(tokens, next - 1) > 0 && match.tokens > 1;
  const std::size_t side = SkipSideWord(tokens, next);
  next += side;
  const bool at_side = side > 0 || said_side;
  const bool after_in = at > 0 && IsWord(tokens, at - 1, {"in"});
  if (own) {
    // "its northern half" is the map's, or its owner's: a place.
    if (IsWord(tokens, next, {"half", "third", "quarter", "part", "corner", "parts"})) return false;
    lexeme->of_it = true;
    lexeme->use = at_side ? DirectionUse::kAtSide : DirectionUse::kBeyond;
  } else {
    // "on the right bank": of the water that was spoken of
    const bool bank = at_side && IsWord(tokens, next - 1, {"bank", "banks", "shore", "shores"});
    if (bank && !IsWord(tokens, next, {"of", "from"})) {
      lexeme->kind = LexemeKind::kDirection;
      lexeme->heading = match.heading;
      lexeme->use = DirectionUse::kAtSide;
      lexeme->of_it = true;
      lexeme->last = next;
      return true;
    }
    if (!IsWord(tokens, next, {"of", "from"})) return false;
    if (IsWord(tokens, next, {"from"}) && !IsWord(tokens, next + 1, {"the", "it", "there"})) {
      return false;
    }
    // "separates the fields in the north from the town"
    const bool placed =
        after_in || (at > 0 && IsWord(tokens, at - 1, {"on"})) ||
        (at > 1 && IsWord(tokens, at - 1, {"the"}) && IsWord(tokens, at - 2, {"in", "on"}));
    if (IsWord(tokens, next, {"from"}) && placed) return false;
    const std::size_t object =
        next + 1 + (IsWord(tokens, next + 1, {"the", "this", "that"}) ? 1 : 0);
    if (MatchPlace(tokens, object).tokens > 0) return false;
    // "from the top of the picture"
    const PlaceMatch whole = MatchPlace(tokens, at);
    if (!whole.of_other && at + whole.tokens > next) return false;
    ++next;
    lexeme->use = at_side    ? DirectionUse::kAtSide
                  : after_in ? DirectionUse::kInside
                             : DirectionUse::kBeyond;
  }
  lexeme->kind = LexemeKind::kDirection;
  lexeme->heading = match.heading;
  lexeme->last = next;
  return true;
}

// "south and east of the lake": between the two.
bool LexCornerDirection(const std::vector<Token>& tokens, std::size_t at, Lexeme* lexeme) {
  const HeadingMatch first = MatchHeading(tokens, at);
  const std::size_t join = at + first.tokens;
  if (first.tokens == 0 || !IsWord(tokens, join, {"and"})) return false;
  const HeadingMatch second = MatchHeading(tokens, join + 1);
  const Heading a = first.heading;
  const Heading b = second.heading;
  const bool corner =
      second.tokens > 0 && !a.IsDiagonal() && !b.IsDiagonal() && (a.east != 0) != (b.east != 0);
  const std::size_t end = join + 1 + second.tokens;
  if (!corner || !IsWord(tokens, end, {"of"})) return false;
  const std::size_t object = end + 1 + (IsWord(tokens, end + 1, {"the", "this", "that"}) ? 1 : 0);
  if (MatchPlace(tokens, object).tokens > 0 || IsWord(tokens, object, {"map"})) return false;
  lexeme->kind = LexemeKind::kDirection;
  lexeme->use = DirectionUse::kBeyond;
  lexeme->heading = {a.east + b.east, a.south + b.south};
  lexeme->last = end + 1;
  return true;
}

// "north and south of", "on the E and W sides of": how many tokens; 0: none.
std::size_t MatchTwoSides(const std::vector<Token>& tokens, std::size_t at) {
  const HeadingMatch first = MatchHeading(tokens, at);
  const std::size_t join = at + first.tokens;
  if (first.tokens == 0 || !IsWord(tokens, join, {"and", "plus", "n"})) return 0;
  const HeadingMatch second = MatchHeading(tokens, join + 1);
  const bool opposite =
      second.heading.east == -first.heading.east && second.heading.south == -first.heading.south;
  if (second.tokens == 0 || !opposite) return 0;
  std::size_t end = join + 1 + second.tokens;
  if (IsWord(tokens, end, {"side", "sides", "bank", "banks", "shore", "shores"})) ++end;
  const bool of_place = MatchPlace(tokens, end + 1).tokens > 0 ||
                        (IsWord(tokens, end + 1, {"the"}) && IsWord(tokens, end + 2, {"map"}));
  return IsWord(tokens, end, {"of"}) && !of_place ? end + 1 - at : 0;
}

}  // namespace latticeworld
