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

// Banks of rivers, flanks of towns and other sides that words name only by halves.
namespace latticeworld {
namespace {

// "all forest", ", all of it forest", "(forest)", "of pure forest": where the class begins.
std::size_t SkipToClass(const std::vector<Token>& tokens, std::size_t at) {
  if (IsMark(tokens, at)) ++at;
  while (IsOneOf(WordAt(tokens, at), {"all", "of", "it", "which", "that", "is", "entirely", "only",
                                      "purely", "pure", "with", "nothing", "but", "full"})) {
    ++at;
  }
  return at;
}

// "half", "side", "one" of "the left one".
std::size_t SkipPart(const std::vector<Token>& tokens, std::size_t at) {
  while (IsFlank(WordAt(tokens, at)) ||
         IsOneOf(WordAt(tokens, at), {"one", "half", "part", "piece"})) {
    ++at;
  }
  return at;
}

// "into two halves;", "in half, with": what comes after it; at, where nothing of this stands.
std::size_t SkipTwoHalves(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"two", "half"})) return at;
  ++at;
  if (IsOneOf(WordAt(tokens, at), {"halves", "parts", "pieces", "sides"})) ++at;
  if (at < tokens.size() && IsPauseAt(tokens, at)) ++at;
  if (IsOneOf(WordAt(tokens, at), {"with", "and"})) ++at;
  return at;
}

// "splits the land into a western part, all forest, and an eastern part, all fields", "splits the
// map into two halves; the left one is forest and the right one fields": to the west of it forest,
// to the east of it fields.
void TurnHalves(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 6 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"splits", "divides", "cuts", "parts", "splitting",
                                       "dividing", "cutting", "parting", "separates"})) {
      continue;
    }
    // "the map into", "the land in"
    std::size_t into = at + 1;
    if (WordAt(*tokens, into) == "the") ++into;
    if (!IsMapWord(WordAt(*tokens, into)) &&
        !IsOneOf(WordAt(*tokens, into), {"land", "country", "ground", "terrain", "valley"})) {
      continue;
    }
    ++into;
    if (!IsOneOf(WordAt(*tokens, into), {"into", "in"})) continue;
    // Both parts follow, each with its side and what it is.
    Heading first;
    std::size_t part = TakeHeading(*tokens, SkipTwoHalves(*tokens, into + 1), &first);
    if (part == 0) continue;
    const std::size_t first_class = SkipToClass(*tokens, SkipPart(*tokens, part));
    const ClassWordMatch one = MatchClassWord(*tokens, first_class);
    if (one.word == nullptr) continue;
    std::size_t second_part = first_class + one.tokens;
    if (IsMark(*tokens, second_part)) ++second_part;
    if (WordAt(*tokens, second_part) == ",") ++second_part;
    if (!IsOneOf(WordAt(*tokens, second_part), {"and", "while"})) continue;
    Heading second;
    part = TakeHeading(*tokens, second_part + 1, &second);
    if (part == 0) continue;
    const std::size_t second_class = SkipToClass(*tokens, SkipPart(*tokens, part));
    const ClassWordMatch two = MatchClassWord(*tokens, second_class);
    if (two.word == nullptr) continue;
    // The line crosses the map, and each side of it gets a sentence.
    const Token beside = (*tokens)[into];
    std::vector<Token> turned = {WordLike("crosses", beside), WordLike("the", beside),
                                 WordLike("map", beside)};
    const auto append = [&](Heading side, std::size_t begin, std::size_t count) {
      const Token& near = (*tokens)[begin];
      turned.push_back({TokenKind::kStop, ".", near.begin, near.begin});
      for (const std::string_view word : {"to", "the"}) turned.push_back(WordLike(word, near));
      turned.push_back(WordLike(NameOf(side), near));
      for (const std::string_view word : {"of", "it", "there", "is"}) {
        turned.push_back(WordLike(word, near));
      }
      for (std::size_t i = 0; i < count; ++i) turned.push_back((*tokens)[begin + i]);
    };
    append(first, first_class, one.tokens);
    append(second, second_class, two.tokens);
    EraseTokens(tokens, at, second_class + two.tokens - at);
    InsertTokens(tokens, at, turned);
    at += turned.size() - 1;
  }
}

// "North and south of it the coast is wooded": there is forest there.
void TurnCoastIs(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 3 < tokens->size(); ++at) {
    const bool land = WordAt(*tokens, at) == "the" &&
                      IsOneOf(WordAt(*tokens, at + 1),
                              {"coast", "shore", "land", "ground", "country", "bank", "terrain"}) &&
                      IsOneOf(WordAt(*tokens, at + 2), {"is", "are", "lies", "was"});
    if (!land) continue;
    // A side of something stands right before it.
    std::size_t of = at;
    while (of > 0 && of + 5 > at && WordAt(*tokens, of) != "of") --of;
    Heading heading;
    bool sided = false;
    for (std::size_t i = of; i > 0 && i + 4 > of; --i) {
      sided = sided || TakeHeading(*tokens, i - 1, &heading) > 0;
    }
    if (WordAt(*tokens, of) == "of" && sided) {
      ReplaceTokens(tokens, at, 3, {"there", "is"});
    }
  }
}

// "Houses along one road, and behind the houses, on both sides, fields": on both sides of the road.
void TurnBehindBoth(std::vector<Token>* tokens) {
  std::size_t line = 0;
  std::size_t line_end = 0;
  bool both = false;  // "reeds on both sides of it, and behind the reeds on both sides rocks"
  for (std::size_t at = 0; at + 6 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) {
      line_end = 0;
      both = false;
    }
    both = both || (IsOneOf(WordAt(*tokens, at), {"both", "either"}) &&
                    IsOneOf(WordAt(*tokens, at + 1), {"sides", "side", "banks"}));
    const ClassWordMatch noun = MatchClassWord(*tokens, at);
    if (noun.word != nullptr && noun.word->shape == WordShape::kLine) {
      line = at;
      line_end = at + noun.tokens;
    }
    if (line_end == 0 || both || WordAt(*tokens, at) != "behind") continue;
    const std::size_t thing = at + (IsOneOf(WordAt(*tokens, at + 1), {"the", "these"}) ? 2 : 1);
    const ClassWordMatch row = MatchClassWord(*tokens, thing);
    std::size_t next = thing + row.tokens;
    if (row.word == nullptr && WordAt(*tokens, thing) == "them") ++next;
    if (next == thing) continue;
    if (IsMark(*tokens, next)) ++next;
    if (WordAt(*tokens, next) != "on" ||
        !IsOneOf(WordAt(*tokens, next + 1), {"both", "either", "each"}) ||
        !IsOneOf(WordAt(*tokens, next + 2), {"side", "sides", "hand"})) {
      continue;
    }
    next += 3;
    if (WordAt(*tokens, next) == "of") continue;
    if (IsMark(*tokens, next)) ++next;
    std::vector<std::string> name;
    for (std::size_t i = line; i < line_end; ++i) name.emplace_back((*tokens)[i].text);
    std::vector<std::string_view> words = {"on", "both", "sides", "of", "the"};
    for (const std::string& word : name) words.push_back(word);
    ReplaceTokens(tokens, at, next - at, words);
  }
}

// "its western side is wooded, its eastern side is not: there are only fields": only fields there.
// "on its southern bank only": on that bank.
void TurnSideIsNot(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    Heading heading;
    const bool own = IsOneOf(WordAt(*tokens, at), {"its", "the"});
    const std::size_t end = own ? TakeHeading(*tokens, at, &heading) : 0;
    if (end == 0 || !IsFlank(WordAt(*tokens, end))) continue;
    const bool bank = IsOneOf(WordAt(*tokens, end), {"bank", "shore", "side"});
    if (bank && WordAt(*tokens, end + 1) == "only" && IsPauseAt(*tokens, end + 2)) {
      EraseTokens(tokens, end + 1, 1);
      continue;
    }
    std::size_t next = end + 1;
    if (!IsOneOf(WordAt(*tokens, next), {"is", "are"}) || WordAt(*tokens, next + 1) != "not") {
      continue;
    }
    next += 2;
    if (!IsMark(*tokens, next) || !IsOneOf(WordAt(*tokens, next + 1), {"there", "here"})) continue;
    EraseTokens(tokens, end + 1, next - end);
    InsertTokens(tokens, at, {WordLike("on", (*tokens)[at])});
  }
}

// "you look north over a lake to a wood, and south over fields": to the north of it a lake, then a
// wood; to the south of it fields.
void TurnViews(std::vector<Token>* tokens) {
  bool looking = false;
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) looking = false;
    std::size_t next = at;
    const bool one = IsOneOf(WordAt(*tokens, next), {"you", "one", "we", "i"});
    if (one) ++next;
    const bool looks = IsOneOf(WordAt(*tokens, next), {"look", "looks", "gaze", "see", "sees"});
    if (looks) ++next;
    const bool again = looking && WordAt(*tokens, next) == "and";
    if (again) ++next;
    if (!(one && looks) && !again) continue;
    if (WordAt(*tokens, next) == "to") ++next;
    Heading heading;
    const std::size_t over = TakeHeading(*tokens, next, &heading);
    if (over == 0 || !IsOneOf(WordAt(*tokens, over), {"over", "across", "onto"})) continue;
    // "to a wood", farther on.
    for (std::size_t i = over + 1; !IsPauseAt(*tokens, i); ++i) {
      if (!IsOneOf(WordAt(*tokens, i), {"to", "towards", "toward"})) continue;
      const std::size_t thing = i + (IsOneOf(WordAt(*tokens, i + 1), {"a", "the", "an"}) ? 2 : 1);
      if (MatchClassWord(*tokens, thing).word == nullptr) continue;
      ReplaceTokens(tokens, i, 1, {"x", "then"});
      (*tokens)[i] = {TokenKind::kComma, ",", (*tokens)[i].begin, (*tokens)[i].begin};
      break;
    }
    const Token beside = (*tokens)[at];
    ReplaceTokens(tokens, at, over + 1 - at,
                  {"x", "to", "the", NameOf(heading), "of", "it", "there", "is"});
    (*tokens)[at] = {TokenKind::kStop, ".", beside.begin, beside.begin};
    if (at > 0 && (*tokens)[at - 1].kind == TokenKind::kComma) EraseTokens(tokens, at - 1, 1);
    looking = true;
    at += 5;
  }
}

}  // namespace

void TurnBanks(std::vector<Token>* tokens) {
  TurnHalves(tokens);
  TurnCoastIs(tokens);
  TurnBehindBoth(tokens);
  TurnSideIsNot(tokens);
  TurnViews(tokens);
}

}  // namespace latticeworld
