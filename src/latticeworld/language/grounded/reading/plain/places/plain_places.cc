#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What lies in each of some places, in all but one of them, and everywhere else.
namespace latticeworld {
namespace {

// "A lake and grass everywhere else", "some houses and forest for the rest": a lake. Grass
// everywhere else. Not "fields and forest elsewhere".
void TurnAndElsewhere(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "and" || at == 0) return;
  std::size_t noun = at + 1;
  while (IsOneOf(WordAt(*tokens, noun), {"just", "only", "then"})) ++noun;
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  const std::size_t end = noun + match.tokens;
  const bool elsewhere =
      IsOneOf(WordAt(*tokens, end), {"elsewhere", "otherwise"}) ||
      (IsOneOf(WordAt(*tokens, end), {"everywhere", "anywhere"}) &&
       WordAt(*tokens, end + 1) == "else") ||
      (IsOneOf(WordAt(*tokens, end), {"for", "as"}) && WordAt(*tokens, end + 1) == "the" &&
       IsOneOf(WordAt(*tokens, end + 2), {"rest", "remainder"}));
  if (match.word == nullptr || !elsewhere) return;
  std::size_t begin = at;
  while (begin > 0 && !IsPauseAt(*tokens, begin - 1)) --begin;
  if (begin == at && at > 0) {  // ", and grass elsewhere": of the item before the comma
    begin = at - 1;
    while (begin > 0 && !IsPauseAt(*tokens, begin - 1)) --begin;
  }
  bool told = MatchNumber(*tokens, begin).tokens > 0;
  for (std::size_t i = begin; i < at; ++i) {
    told = told || IsOneOf(WordAt(*tokens, i), {"a", "an", "one", "some", "few", "several", "many",
                                                "single", "two", "three", "four", "in", "on"});
  }
  if (!told) return;
  (*tokens)[at] = StopLike((*tokens)[at]);
  if (IsMark(*tokens, at - 1)) EraseTokens(tokens, at - 1, 1);
}

// "A single house, else forest": the rest is forest. "Almost no water, almost everything is rock":
// two sentences.
void TurnElse(std::vector<Token>* tokens, std::size_t at) {
  if (IsMark(*tokens, at) &&
      IsOneOf(WordAt(*tokens, at + 1), {"almost", "nearly", "practically"}) &&
      WordAt(*tokens, at + 2) == "everything") {
    (*tokens)[at] = StopLike((*tokens)[at]);
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at), {"else", "otherwise"}) || at == 0 ||
      !IsPauseAt(*tokens, at - 1))
    return;
  std::size_t noun = at + 1;
  while (IsOneOf(WordAt(*tokens, noun), {"just", "only", "all", "nothing", "but"})) ++noun;
  const std::size_t end = noun + MatchClassWord(*tokens, noun).tokens;
  if (end == noun || !IsStopAt(*tokens, end)) return;
  (*tokens)[at - 1] = StopLike((*tokens)[at - 1]);
  ReplaceTokens(tokens, at, noun - at, {"the", "rest", "is"});
}

// NounOfPlace(), and a border is an edge.
std::string_view PlaceNoun(std::string_view word) {
  const std::string_view noun = NounOfPlace(word);
  return noun == "border" ? "edge" : noun;
}

// "All four corners", "every edge", "the four quarters"; the token after it, `at`: none.
std::size_t AllPlacesEnd(const std::vector<Token>& tokens, std::size_t at, std::string* noun) {
  std::size_t next = at;
  const bool every = IsOneOf(WordAt(tokens, next), {"all", "every", "each"});
  if (every) ++next;
  if (WordAt(tokens, next) == "of") ++next;
  if (WordAt(tokens, next) == "the") ++next;
  const bool four = WordAt(tokens, next) == "four";
  if (four) ++next;
  *noun = PlaceNoun(WordAt(tokens, next));
  if ((!every && !four) || noun->empty()) return at;
  ++next;
  if (WordAt(tokens, next) == "of" && WordAt(tokens, next + 1) == "the" &&
      IsMapWord(WordAt(tokens, next + 2))) {
    next += 3;
  }
  return next;
}

// "The northern edge", "the upper left corner" of a heading.
std::string NameOfPlace(Heading heading, const std::string& noun) {
  std::string name = "the ";
  if (heading.IsDiagonal()) {
    name += heading.south < 0 ? "upper " : "lower ";
    name += heading.east < 0 ? "left " : "right ";
    return name + noun;
  }
  const std::string side(NameOf(heading));
  return name + side + "ern " + (noun == "side" ? "edge" : noun);
}

// "Trees on every side except the south", "every edge is forest except the southern one", "all
// edges are forest, only the western one is water": the three others by their names.
void TurnAllPlacesBut(std::vector<Token>* tokens, std::size_t at) {
  std::string noun;
  const std::size_t all_end = AllPlacesEnd(*tokens, at, &noun);
  if (all_end == at) return;
  // The sides of something are not those of the map.
  if (WordAt(*tokens, all_end) == "of" && !IsMapWord(WordAt(*tokens, all_end + 2))) return;
  std::size_t but = all_end;
  while (!IsStopAt(*tokens, but) &&
         !IsOneOf(WordAt(*tokens, but), {"except", "but", "save", "only", "apart", "bar"})) {
    ++but;
  }
  if (IsStopAt(*tokens, but)) return;
  std::size_t one = but + 1;
  const std::string word((*tokens)[but].text);
  while (IsOneOf(WordAt(*tokens, one), {"for", "from", "only", "in", "on", "at", "the", "not"}))
    ++one;
  PlaceCursor cursor(*tokens, one);
  const Direction direction = TakeDirection(&cursor);
  const bool diagonal = noun == "corner" || noun == "quarter" || noun == "quadrant";
  if (!direction.found || direction.center || direction.heading.IsDiagonal() != diagonal) return;
  std::size_t end = cursor.at();
  if (WordAt(*tokens, end) == "one" || !PlaceNoun(WordAt(*tokens, end)).empty()) ++end;
  // "only the western one is water"
  // "every quarter except the top left is water": the others are.
  const bool within = but == all_end + (IsMark(*tokens, all_end) ? 1 : 0);
  const bool is = IsOneOf(WordAt(*tokens, end), {"is", "are", "has", "have"});
  // "except the southern one, which is water"
  std::size_t which = end + (IsMark(*tokens, end) ? 1 : 0);
  const bool told = which > end && IsOneOf(WordAt(*tokens, which), {"which", "where", "that"});
  if (told) ++which;
  if (told && WordAt(*tokens, which) == "there") ++which;
  const bool other =
      (is && !within) || (told && IsOneOf(WordAt(*tokens, which), {"is", "are", "has"}));
  if (told && other) end = which;
  if (within && is) (*tokens)[end].text = "are";
  if (!is && !other && (word == "only" || !IsPauseAt(*tokens, end))) return;
  if (noun == "side") {
    for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i) {
      if (IsOneOf(WordAt(*tokens, i),
                  {"surrounded", "enclosed", "with", "has", "its", "around", "bordered", "lined",
                   "fringed", "ringed", "hemmed", "surrounds", "borders", "bounded", "flanked"})) {
        return;
      }
    }
  }
  const std::size_t preposition =
      at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"in", "on", "at", "along"}) ? 1 : 0;
  if (preposition == 0 && at > 0 && !IsPauseAt(*tokens, at - 1)) return;
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  for (const int south : {-1, 0, 1}) {
    for (const int east : {-1, 0, 1}) {
      const Heading heading{east, south};
      const bool excepted = east == direction.heading.east && south == direction.heading.south;
      if ((east == 0 && south == 0) || heading.IsDiagonal() != diagonal || excepted) continue;
      const std::string lead = said.empty() ? "" : preposition > 0 ? "and in " : "and ";
      for (const Token& token : SaidLike(lead + NameOfPlace(heading, noun), beside))
        said.push_back(token);
    }
  }
  const std::size_t middle = but - (IsMark(*tokens, but - 1) ? 1 : 0);
  std::vector<Token> after;
  if (other) {
    after.push_back(StopLike(beside));
    for (const Token& token : SaidLike(NameOfPlace(direction.heading, noun), beside))
      after.push_back(token);
  }
  EraseTokens(tokens, middle, end - middle);
  InsertTokens(tokens, middle, after);
  if (middle > all_end && IsOneOf(WordAt(*tokens, all_end), {"is", "has", "have", "gets", "get"}))
    (*tokens)[all_end].text = "are";
  // "every edge wooded"
  if (preposition == 0 && middle > all_end && !LandOfAdjective(WordAt(*tokens, all_end)).empty())
    InsertTokens(tokens, all_end, {WordLike("are", beside)});
  EraseTokens(tokens, at, all_end - at);
  InsertTokens(tokens, at, said);
  if (preposition > 0) (*tokens)[at - 1].text = "in";
}

// "One house in every corner", "two lakes in each quarter", "one lake per quadrant": four houses in
// every corner, eight lakes.
void TurnOneInEach(std::vector<Token>* tokens, std::size_t at) {
  const bool per = WordAt(*tokens, at) == "per";
  const std::size_t every = at + (per ? 0 : 1);
  if (!per && (!IsOneOf(WordAt(*tokens, at), {"in", "at", "on"}) ||
               !IsOneOf(WordAt(*tokens, every), {"every", "each"}))) {
    return;
  }
  const std::string_view noun = PlaceNoun(WordAt(*tokens, every + 1));
  if (noun.empty() || (noun == "side" && !(WordAt(*tokens, every + 2) == "of" &&
                                           IsMapWord(WordAt(*tokens, every + 4))))) {
    return;
  }
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.empty() || named[0].end != at || MatchClassWord(*tokens, named[0].begin).is_line())
    return;
  std::size_t count = named[0].begin;
  while (count > 0 && IsSize(WordAt(*tokens, count - 1))) --count;
  if (count == 0) return;
  --count;
  NumberMatch number = MatchNumber(*tokens, count);
  if (per && IsOneOf(WordAt(*tokens, count), {"a", "an"})) number = {1, 1};
  if (number.tokens != 1 || number.value < 1) return;
  for (std::size_t i = at; !IsStopAt(*tokens, i); ++i)
    if (IsOneOf(WordAt(*tokens, i), {"but", "except", "save"})) return;
  if (per) ReplaceTokens(tokens, at, 1, {"in", "every"});
  (*tokens)[count].text = std::to_string(4 * number.value);
  (*tokens)[count].kind = TokenKind::kNumber;
}

// "A road along every edge": along each of them, by its name.
void TurnAlongEach(std::vector<Token>* tokens, std::size_t at) {
  std::string noun;
  const std::size_t end = AllPlacesEnd(*tokens, at, &noun);
  if (end == at || at == 0 || WordAt(*tokens, at - 1) != "along" || !IsPauseAt(*tokens, end) ||
      (noun != "edge" && noun != "side")) {
    return;
  }
  const std::vector<NamedThing> named = NamedBefore(*tokens, at - 1);
  if (named.empty() || named[0].end != at - 1) return;
  const ClassWordMatch line = MatchClassWord(*tokens, named[0].begin);
  if (!line.is_line() || line.plural) return;
  // "a lake with a path along all sides": the sides of the lake
  if (noun == "side" && named.size() > 1 && named[1].begin >= SentenceBegin(*tokens, at) &&
      !IsMapWord(WordAt(*tokens, end - 1))) {
    return;
  }
  const std::string name = JoinWords(*tokens, named[0].begin, named[0].end);
  std::string said = "the northern edge";
  for (const std::string_view side : {"southern", "western", "eastern"})
    said += " . another " + name + " along the " + std::string(side) + " edge";
  const std::vector<Token> words = SaidLike(said, (*tokens)[at]);
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, words);
  if (WordAt(*tokens, named[0].begin - 1) == "one") (*tokens)[named[0].begin - 1].text = "a";
}

// "The corner in the top right", "the quarter at the bottom left": the top right corner.
void TurnCornerIn(std::vector<Token>* tokens, std::size_t at) {
  const std::string noun(PlaceNoun(WordAt(*tokens, at)));
  if (noun.empty() || noun != WordAt(*tokens, at) || at == 0 || WordAt(*tokens, at - 1) != "the" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"in", "at", "on"}) || WordAt(*tokens, at + 2) != "the") {
    return;
  }
  PlaceCursor cursor(*tokens, at + 3);
  const Direction direction = TakeDirection(&cursor);
  const bool diagonal = noun == "corner" || noun == "quarter" || noun == "quadrant";
  if (!direction.found || direction.center || direction.heading.IsDiagonal() != diagonal) return;
  const std::vector<Token> name = SaidLike(NameOfPlace(direction.heading, noun), (*tokens)[at]);
  EraseTokens(tokens, at - 1, cursor.at() - at + 1);
  InsertTokens(tokens, at - 1, name);
}

}  // namespace

void TurnPlaces(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAndElsewhere(tokens, at);
    TurnElse(tokens, at);
    TurnCornerIn(tokens, at);
    TurnAllPlacesBut(tokens, at);
    TurnOneInEach(tokens, at);
    TurnAlongEach(tokens, at);
  }
}

}  // namespace latticeworld
