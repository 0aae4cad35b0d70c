#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What one meets on the way, what the land is as a whole, and what is left of it.
namespace latticeworld {
namespace {

// "down": as on the map. "" where it is no heading of four.
std::string_view HeadingOfWay(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"down", "downwards", "downward"})) return "south";
  if (IsOneOf(WordAt(tokens, at), {"up", "upwards", "upward"})) return "north";
  const std::string_view word = WordAt(tokens, at);
  return word.size() > 3 && word.substr(word.size() - 3) == "ern" ? "" : HeadingWord(word);
}

void InsertSpan(std::vector<Token>* tokens, std::size_t at, std::string_view to, bool pause) {
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  for (const std::string_view word :
       {std::string_view("from"), OppositeOf(to), std::string_view("to"), to})
    said.push_back(WordLike(word, beside));
  if (pause) said.push_back(CommaLike(beside));
  InsertTokens(tokens, at, said);
}

// "Snow, then rock, then forest as you go down": from north to south, snow, then ...
void TurnWayBehind(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"as", "when"}) || at == 0 ||
      !IsOneOf(WordAt(*tokens, at + 1), {"you", "one", "we"}) ||
      !IsOneOf(WordAt(*tokens, at + 2), {"go", "goes", "move", "moves", "travel", "travels", "head",
                                         "heads", "walk", "walks", "drive", "drives"})) {
    return;
  }
  const std::string heading(HeadingOfWay(*tokens, at + 3));
  if (heading.empty() || !IsStopAt(*tokens, at + 4)) return;
  std::size_t begin = at;
  bool rows = false;
  while (begin > 0 && !IsStopAt(*tokens, begin - 1)) {
    --begin;
    rows = rows || WordAt(*tokens, begin) == "then";
  }
  if (!rows) return;
  EraseTokens(tokens, at, 4);
  if (at > begin && (*tokens)[at - 1].kind == TokenKind::kComma) EraseTokens(tokens, at - 1, 1);
  InsertSpan(tokens, begin, heading, true);
}

// "From the top down: snow, rock": from north to south. "Starting at the north edge you cross sand,
// then grass": from north to south, sand, then grass.
void TurnWayAhead(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  const std::size_t from = WordAt(*tokens, at) == "from" ? at + 1 : at;
  const std::size_t top = from + (WordAt(*tokens, from) == "the" ? 1 : 0);
  const bool down = WordAt(*tokens, top) == "top" && WordAt(*tokens, top + 1) == "down";
  const bool up = WordAt(*tokens, top) == "bottom" && WordAt(*tokens, top + 1) == "up";
  if ((down || up) && top + 2 < tokens->size() && (*tokens)[top + 2].kind == TokenKind::kComma) {
    EraseTokens(tokens, at, top + 2 - at);
    InsertSpan(tokens, at, down ? "south" : "north", false);
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at), {"starting", "beginning", "start"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"at", "from", "in", "on"})) {
    return;
  }
  const std::size_t place = at + 2 + (WordAt(*tokens, at + 2) == "the" ? 1 : 0);
  const std::string_view start = HeadingOfWay(*tokens, place);
  if (start.empty()) return;
  std::size_t next = place + 1;
  if (IsOneOf(WordAt(*tokens, next), {"edge", "side", "end", "border"})) ++next;
  if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
  bool verb = false;
  if (IsOneOf(WordAt(*tokens, next), {"you", "one", "we", "there"}) &&
      IsOneOf(WordAt(*tokens, next + 1),
              {"cross", "meet", "find", "see", "pass", "have", "get", "is", "are", "first"})) {
    next += 2;
    verb = true;
    if (IsOneOf(WordAt(*tokens, next), {"cross", "meet", "find", "see", "pass", "first"})) ++next;
  }
  bool rows = false;
  for (std::size_t i = next; !IsStopAt(*tokens, i); ++i)
    rows = rows || WordAt(*tokens, i) == "then";
  if (!rows || !verb) return;
  const std::string to(OppositeOf(start));
  EraseTokens(tokens, at, next - at);
  if (at < tokens->size()) InsertSpan(tokens, at, to, true);
}

// "The lake comes first from the left, the village second, the forest third": from left to right,
// the lake, then the village, then the forest.
void TurnOrdinalsBehind(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"comes", "is"}) || WordAt(*tokens, at + 1) != "first" ||
      WordAt(*tokens, at + 2) != "from") {
    return;
  }
  const std::size_t side = at + 3 + (WordAt(*tokens, at + 3) == "the" ? 1 : 0);
  const bool left = IsOneOf(WordAt(*tokens, side), {"left", "west"});
  const bool top = IsOneOf(WordAt(*tokens, side), {"top", "north"});
  if (!left && !top && !IsOneOf(WordAt(*tokens, side), {"right", "east", "bottom", "south"}))
    return;
  const bool across = left || IsOneOf(WordAt(*tokens, side), {"right", "east"});
  std::vector<std::size_t> ordinals;
  std::size_t end = side + 1;
  for (; !IsStopAt(*tokens, end); ++end)
    if (IsOneOf(WordAt(*tokens, end), {"second", "third", "fourth", "fifth", "last"}) &&
        IsPauseAt(*tokens, end + 1)) {
      ordinals.push_back(end);
    }
  if (ordinals.empty()) return;
  for (std::size_t i = ordinals.size(); i-- > 0;) {
    std::size_t begin = ordinals[i];
    while (begin > side + 1 && !IsPauseAt(*tokens, begin - 1) &&
           WordAt(*tokens, begin - 1) != "and")
      --begin;
    const Token beside = (*tokens)[begin];
    EraseTokens(tokens, ordinals[i], 1);
    InsertTokens(tokens, begin, {WordLike("then", beside)});
  }
  EraseTokens(tokens, at, side + 1 - at);
  std::size_t begin = SentenceBegin(*tokens, at);
  InsertSpan(tokens, begin, across ? (left ? "east" : "west") : (top ? "south" : "north"), true);
}

struct Landscape {
  std::string_view adjective, noun;
};
constexpr Landscape kLandscapes[] = {
    {"wooded", "forest"}, {"forested", "forest"},  {"grassy", "grassland"},
    {"sandy", "sand"},    {"rocky", "rock"},       {"snowy", "snow"},
    {"farm", "farmland"}, {"farming", "farmland"}, {"agricultural", "farmland"},
    {"desert", "desert"}, {"forest", "forest"},    {"built-up", "town"},
    {"urban", "town"},    {"watery", "water"},     {"barren", "bare land"},
};

// "A wooded country with two ponds", "this is farm country": mostly forest with two ponds. "A sea
// of grass with a few trees", "the place is one big meadow": mostly grass, mostly meadow.
void TurnLandscape(std::vector<Token>* tokens, std::size_t at) {
  std::size_t before = at;  // the word that says that the whole land is meant
  if (before > 0 && IsOneOf(WordAt(*tokens, before - 1), {"basically", "really", "simply", "just"}))
    --before;
  const bool opens = before == 0 || IsStopAt(*tokens, before - 1) ||
                     IsOneOf(WordAt(*tokens, before - 1), {"is", "want", "need", "make", "have"});
  if (!opens) return;
  std::size_t first = at;
  if (IsOneOf(WordAt(*tokens, first), {"a", "an", "one", "some"})) ++first;
  if (IsOneOf(WordAt(*tokens, first), {"sea", "ocean"}) && WordAt(*tokens, first + 1) == "of" &&
      first > at) {
    // "Sea of grass" is a word of its own, "sea of trees" none.
    const bool word = MatchClassWord(*tokens, first).tokens > 1;
    if (word || MatchClassWord(*tokens, first + 2).tokens > 0)
      ReplaceTokens(tokens, at, (word ? first : first + 2) - at, {"mostly"});
    return;
  }
  const bool big = IsOneOf(WordAt(*tokens, first), {"big", "single", "huge", "large", "vast"});
  if (big && first > at && before >= 2 && WordAt(*tokens, before - 1) == "is") {
    const ClassWordMatch noun = MatchClassWord(*tokens, first + 1);
    const bool whole = IsMapWord(WordAt(*tokens, before - 2)) && noun.word != nullptr &&
                       noun.word->shape != WordShape::kLine;
    if (whole) ReplaceTokens(tokens, at, first + 1 - at, {"mostly"});
    return;
  }
  for (const Landscape& landscape : kLandscapes) {
    if (WordAt(*tokens, first) != landscape.adjective) continue;
    const std::string_view head = WordAt(*tokens, first + 1);
    const bool land = IsOneOf(head, {"country", "landscape", "countryside", "scenery", "scene",
                                     "region", "terrain", "territory", "world", "map"});
    const bool ends = IsPauseAt(*tokens, first + 2) || WordAt(*tokens, first + 2) == "with";
    if (land && ends) ReplaceTokens(tokens, at, first + 2 - at, {"mostly", landscape.noun});
    return;
  }
}

// "Grass wherever there is no water", "grass covers what isn't water", "everything that is neither
// road nor house is grass", "grass surrounds everything": elsewhere, everything else.
void TurnWhatIsLeft(std::vector<Token>* tokens, std::size_t at) {
  const bool apart = IsOneOf(WordAt(*tokens, at), {"apart", "other", "aside", "besides"}) &&
                     (at == 0 || IsStopAt(*tokens, at - 1));
  // "Apart from that, everything is grass": the rest is grass.
  if (apart) {
    std::size_t next = at + 1;
    if (IsOneOf(WordAt(*tokens, next), {"from", "than"})) ++next;
    if (!IsOneOf(WordAt(*tokens, next), {"that", "this", "it"})) return;
    ++next;
    if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
    if (IsOneOf(WordAt(*tokens, next), {"it", "there", "everything"}) &&
        IsOneOf(WordAt(*tokens, next + 1), {"is", "are"})) {
      next += 2;
      if (WordAt(*tokens, next) == "all") ++next;
      ReplaceTokens(tokens, at, next - at, {"the", "rest", "is"});
    }
    return;
  }
  // "wherever there is no water": elsewhere.
  if (IsOneOf(WordAt(*tokens, at), {"wherever", "where"}) &&
      IsOneOf(WordAt(*tokens, at + 1), {"there", "it"}) && WordAt(*tokens, at + 2) == "is" &&
      IsOneOf(WordAt(*tokens, at + 3), {"no", "not"}) && at > 0 && !IsStopAt(*tokens, at - 1)) {
    const std::size_t length = MatchClassWord(*tokens, at + 4).tokens;
    if (length > 0 && IsPauseAt(*tokens, at + 4 + length))
      ReplaceTokens(tokens, at, 4 + length, {"elsewhere"});
    return;
  }
  // "what is neither road nor house": everything else.
  if (IsOneOf(WordAt(*tokens, at), {"what", "whatever", "everything"})) {
    std::size_t next = at + 1;
    if (WordAt(*tokens, next) == "that") ++next;
    if (WordAt(*tokens, next) != "is" || !IsOneOf(WordAt(*tokens, next + 1), {"not", "neither"})) {
      return;
    }
    const bool neither = WordAt(*tokens, next + 1) == "neither";
    next += 2;
    if (WordAt(*tokens, next) == "a") ++next;
    std::size_t length = MatchClassWord(*tokens, next).tokens;
    if (length == 0) return;
    next += length;
    while (neither && WordAt(*tokens, next) == "nor") {
      const std::size_t noun = next + 1 + (WordAt(*tokens, next + 1) == "a" ? 1 : 0);
      length = MatchClassWord(*tokens, noun).tokens;
      if (length == 0) break;
      next = noun + length;
    }
    ReplaceTokens(tokens, at, next - at, {"everything", "else"});
    return;
  }
  // "surrounds everything": covers everything else.
  if (IsOneOf(WordAt(*tokens, at), {"surrounds", "surround"}) &&
      WordAt(*tokens, at + 1) == "everything" && IsPauseAt(*tokens, at + 2)) {
    ReplaceTokens(tokens, at, 2, {"covers", "everything", "else"});
  }
}

// "A road goes up the left side", "river down the left third": along the left edge from bottom to
// top, in the left third from top to bottom.
void TurnUpTheSide(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"up", "down"}) || at == 0 ||
      WordAt(*tokens, at + 1) != "the" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"left", "right", "west", "east", "western", "eastern"})) {
    return;
  }
  const bool edge = IsOneOf(WordAt(*tokens, at + 3), {"side", "edge", "border", "margin"});
  const bool part = IsOneOf(WordAt(*tokens, at + 3), {"third", "half", "part"});
  const bool ends = IsPauseAt(*tokens, at + 4) ||
                    (WordAt(*tokens, at + 4) == "of" && WordAt(*tokens, at + 5) == "the" &&
                     IsMapWord(WordAt(*tokens, at + 6)));
  if ((!edge && !part) || !ends) return;
  std::size_t behind = at;  // the line, which "the coast, which runs down the side", is none
  if (IsOneOf(WordAt(*tokens, at - 1),
              {"goes", "runs", "go", "run", "going", "running", "flows", "leads", "comes"})) {
    --behind;
  }
  bool line = false;
  for (std::size_t i = behind; i-- > 0 && i + 3 >= behind;) {
    const ClassWordMatch noun = MatchClassWord(*tokens, i);
    line = line || (noun.word != nullptr && noun.word->shape == WordShape::kLine &&
                    i + noun.tokens == behind);
  }
  if (!line) return;
  const bool up = WordAt(*tokens, at) == "up";
  const std::string side(WordAt(*tokens, at + 2)), what(WordAt(*tokens, at + 3));
  ReplaceTokens(tokens, at, 4,
                {"from", up ? "bottom" : "top", "to", up ? "top" : "bottom", edge ? "along" : "in",
                 "the", side, edge ? "edge" : what});
}

// "Side by side, never crossing": side by side.
void TurnNeverCrossing(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "never" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"crossing", "touching", "meeting"}) ||
      !IsPauseAt(*tokens, at + 2)) {
    return;
  }
  const bool comma = at > 0 && (*tokens)[at - 1].kind == TokenKind::kComma;
  EraseTokens(tokens, at - (comma ? 1 : 0), comma ? 3 : 2);
}

// "The wood is cut in two by a road going from the left to the right": a road going from the left
// to the right runs through the wood.
void TurnCutInTwo(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  const std::size_t article = IsOneOf(WordAt(*tokens, at), {"a", "the"}) ? 1 : 0;
  const ClassWordMatch noun = MatchClassWord(*tokens, at + article);
  const std::size_t is = at + article + noun.tokens;
  if (noun.word == nullptr || noun.is_line() || !IsOneOf(WordAt(*tokens, is), {"is", "are"}) ||
      !IsOneOf(WordAt(*tokens, is + 1), {"cut", "split", "divided"}) ||
      WordAt(*tokens, is + 2) != "in" ||
      !IsOneOf(WordAt(*tokens, is + 3), {"two", "half", "halves"}) ||
      WordAt(*tokens, is + 4) != "by") {
    return;
  }
  std::size_t end = is + 5;
  bool goes = false;
  for (; !IsPauseAt(*tokens, end); ++end)
    goes = goes || IsOneOf(WordAt(*tokens, end), {"going", "running", "flowing", "from"});
  if (!goes) return;
  std::vector<Token> said = TokensBetween(*tokens, is + 5, end);
  said.push_back(WordLike("through", (*tokens)[is]));
  for (const Token& token : TokensBetween(*tokens, at, is)) said.push_back(token);
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

// "River no.": no river. "No bridges": which says nothing of where there are any.
void TurnDenials(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t length = MatchClassWord(*tokens, at).tokens;
  const bool opens = at == 0 || IsPauseAt(*tokens, at - 1);
  if (opens && length > 0 && WordAt(*tokens, at + length) == "no" &&
      IsStopAt(*tokens, at + length + 1)) {
    const Token no = (*tokens)[at + length];
    EraseTokens(tokens, at + length, 1);
    InsertTokens(tokens, at, {no});
    return;
  }
  if (opens && WordAt(*tokens, at) == "no" &&
      IsOneOf(WordAt(*tokens, at + 1), {"bridge", "bridges"}) && IsPauseAt(*tokens, at + 2)) {
    EraseTokens(tokens, at, 2);
  }
}

// "N: forest, S: lake, center: village": a sentence each.
void TurnLabels(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || (*tokens)[at].kind != TokenKind::kComma || (*tokens)[at].text == ":") return;
  PlaceCursor cursor(*tokens, at + 1 + (WordAt(*tokens, at + 1) == "the" ? 1 : 0));
  if (!TakeDirection(&cursor).found) return;
  std::size_t end = cursor.at();
  if (IsOneOf(WordAt(*tokens, end), {"half", "third", "quarter", "corner", "part", "edge", "side"}))
    ++end;
  const bool label = end < tokens->size() && (*tokens)[end].kind == TokenKind::kComma &&
                     (*tokens)[end].text == ":";
  if (label) (*tokens)[at] = {TokenKind::kStop, ".", (*tokens)[at].begin, (*tokens)[at].end};
}

}  // namespace

void TurnWays(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnLabels(tokens, at);
    TurnCutInTwo(tokens, at);
    TurnDenials(tokens, at);
    TurnWayBehind(tokens, at);
    TurnWayAhead(tokens, at);
    TurnOrdinalsBehind(tokens, at);
    TurnLandscape(tokens, at);
    TurnWhatIsLeft(tokens, at);
    TurnUpTheSide(tokens, at);
    TurnNeverCrossing(tokens, at);
  }
}

}  // namespace latticeworld
