#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// How much of what was named or denied lies elsewhere, and how little of something there is.
namespace latticeworld {
namespace {

// "Some", "a few", "hardly any", "plenty of them": where these words end; `at`: no such words.
std::size_t QuantityEnd(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t next = at;
  if (IsOneOf(WordAt(tokens, next), {"only", "just", "quite", "very", "so"})) ++next;
  const std::string_view word = WordAt(tokens, next), after = WordAt(tokens, next + 1);
  if (IsOneOf(word, {"a", "an"}) &&
      IsOneOf(after, {"few", "lot", "little", "bit", "couple", "handful"})) {
    next += 2;
  } else if (IsOneOf(word, {"hardly", "barely", "scarcely"}) && after == "any") {
    next += 2;
  } else if (IsOneOf(word,
                     {"some", "many", "several", "few", "lots", "plenty", "much", "little"})) {
    ++next;
  } else {
    return at;
  }
  if (WordAt(tokens, next) == "of" && IsOneOf(WordAt(tokens, next + 1), {"them", "it", "those"}))
    next += 2;
  return next;
}

// "In the north", "on the left", "along the edges".
bool PlaceAt(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"in", "on", "at", "along"})) return false;
  const std::size_t place = at + 1 + (WordAt(tokens, at + 1) == "the" ? 1 : 0);
  PlaceCursor cursor(tokens, place);
  return TakeDirection(&cursor).found ||
         IsOneOf(WordAt(tokens, place), {"edges", "corners", "borders", "edge", "border"});
}

// The noun of "no houses in the north" or "lots of water on the left", the nearest before `at`; its
// end is 0 where no thing with a place was named.
struct Placed {
  std::size_t begin = 0, end = 0;
  bool denied = false;
};

// "houses near the lake", "a row of houses along the road": told only to say where something is.
bool OnlySaysWhere(const std::vector<Token>& tokens, const NamedThing& named) {
  const std::size_t first = PhraseBegin(tokens, named.end);
  if (first == 0) return false;
  const std::string_view before = WordAt(tokens, first - 1);
  // "covered by trees"
  if (before == "by" && first > 1 &&
      IsOneOf(WordAt(tokens, first - 2), {"covered", "filled", "surrounded", "bordered"})) {
    return false;
  }
  return IsOneOf(before, {"near", "along", "alongside", "by", "around", "beside", "behind",
                          "between", "through", "from"}) ||
         (before == "to" && first > 1 &&
          IsOneOf(WordAt(tokens, first - 2), {"next", "close", "adjacent"})) ||
         (before == "of" && first > 1 &&
          IsOneOf(WordAt(tokens, first - 2), {"side", "sides", "bank", "banks", "shore", "shores",
                                              "edge", "north", "south", "east", "west"}));
}

// What there cannot be many or a few of: "a lake".
bool IsOneThing(const std::vector<Token>& tokens, const NamedThing& named) {
  const ClassWordMatch match = MatchClassWord(tokens, named.begin);
  return match.word != nullptr && !match.plural && match.word->shape != WordShape::kMass &&
         IsOneOf(WordAt(tokens, named.begin > 0 ? named.begin - 1 : 0), {"a", "an", "the", "one"});
}

Placed PlacedBefore(const std::vector<Token>& tokens, std::size_t at) {
  for (const NamedThing& named : NamedBefore(tokens, at)) {
    if (OnlySaysWhere(tokens, named) || IsOneThing(tokens, named)) continue;
    std::size_t first = named.begin;
    while (first > 0 && IsSize(WordAt(tokens, first - 1))) --first;
    const std::string_view before = first > 0 ? WordAt(tokens, first - 1) : std::string_view();
    const bool denied = IsOneOf(before, {"no", "any", "without"});
    // "the north has no trees", "the centre is free of trees"
    const bool owned =
        denied || (before == "of" && first > 1 && WordAt(tokens, first - 2) == "free");
    // "the west has many houses"
    bool had = false;
    for (std::size_t i = first; i > 0 && first - i < 4 && !IsPauseAt(tokens, i - 1); --i)
      had = had || IsOneOf(WordAt(tokens, i - 1), {"has", "have"});
    const std::string_view near = WordAt(tokens, named.end);
    const bool ends = IsPauseAt(tokens, named.end) ||
                      IsOneOf(near, {"near", "along", "by", "around", "next", "beside"});
    if (had && ends) return {named.begin, named.end, owned};
    // "houses near the lake in the north"
    std::size_t place = named.end;
    if (ends && !IsPauseAt(tokens, place)) {
      place += WordAt(tokens, place + 1) == "to" ? 2 : 1;
      place = PhraseEnd(tokens, place);
    }
    if (PlaceAt(tokens, place) || (owned && IsPauseAt(tokens, named.end)))
      return {named.begin, named.end, owned};
  }
  return {};
}

// "No houses in the north, but some in the south", "the north has no trees, the south has many",
// "mostly forest in the west, hardly any in the east": no houses in the north. Some houses in the
// south.
void TurnSomeElsewhere(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !(IsPauseAt(*tokens, at - 1) ||
                   IsOneOf(WordAt(*tokens, at - 1), {"but", "and", "while", "yet"}))) {
    return;
  }
  // "there are many in the south", "the south has many"
  std::size_t amount = at;
  const bool there =
      WordAt(*tokens, at) == "there" && IsOneOf(WordAt(*tokens, at + 1), {"is", "are"});
  if (there) amount += 2;
  bool has = false;
  if (WordAt(*tokens, at) == "the") {
    amount = at + 1;
    while (!IsPauseAt(*tokens, amount) && amount < at + 5 &&
           !IsOneOf(WordAt(*tokens, amount), {"has", "have"}) &&
           QuantityEnd(*tokens, amount) == amount) {
      ++amount;
    }
    const bool verb = IsOneOf(WordAt(*tokens, amount), {"has", "have"});
    has = verb || QuantityEnd(*tokens, amount) > amount;
    if (!has) return;
    if (verb)
      ++amount;
    else if (IsPauseAt(*tokens, QuantityEnd(*tokens, amount)))
      InsertTokens(tokens, amount++, {WordLike("has", (*tokens)[at])});
    else
      return;
  }
  if (IsStopAt(*tokens, at - 1) && !there && !has) return;
  std::size_t end = QuantityEnd(*tokens, amount);
  // "the south has none"
  if (has && WordAt(*tokens, amount) == "none" && IsPauseAt(*tokens, amount + 1)) {
    (*tokens)[amount].text = "no";
    end = amount + 1;
  }
  const Placed placed = PlacedBefore(*tokens, at - 1);
  if (placed.end == 0) return;
  const NumberMatch number = MatchNumber(*tokens, amount);
  const bool only = WordAt(*tokens, amount) == "only" && PlaceAt(*tokens, amount + 1);
  if (end == amount && placed.denied && number.tokens > 0) end = amount + number.tokens;
  if (end == amount && !(only && placed.denied)) return;
  if (has ? !IsPauseAt(*tokens, end) : !only && !PlaceAt(*tokens, end)) return;
  const Token beside = (*tokens)[amount];
  // "a lot", "lots of them": of it
  const std::string_view last = WordAt(*tokens, end - 1);
  const bool of_them = end > amount + 1 && WordAt(*tokens, end - 2) == "of";
  if (!only && of_them) EraseTokens(tokens, end - 1, 1);
  std::vector<Token> said;
  if (!only && !of_them && IsOneOf(last, {"lot", "lots", "bit", "plenty", "couple", "handful"}))
    said.push_back(WordLike("of", beside));
  for (const Token& token : TokensBetween(*tokens, placed.begin, placed.end))
    said.push_back(WordLike(token.text, beside));
  InsertTokens(tokens, only ? amount : end - (of_them ? 1 : 0), said);
  std::size_t begin = at;
  while (begin > 0 && (IsMark(*tokens, begin - 1) ||
                       IsOneOf(WordAt(*tokens, begin - 1), {"but", "and", "while", "yet"}))) {
    --begin;
  }
  EraseTokens(tokens, begin, at - begin);
  if (begin > 0 && !IsStopAt(*tokens, begin - 1)) InsertTokens(tokens, begin, {StopLike(beside)});
}

// "The edges are covered with them": with what was named.
void TurnCoveredWithThem(std::vector<Token>* tokens, std::size_t at) {
  if (at < 3 || !IsOneOf(WordAt(*tokens, at), {"them", "it"}) || !IsPauseAt(*tokens, at + 1) ||
      !IsOneOf(WordAt(*tokens, at - 1), {"with", "of", "by", "in"}) ||
      !IsOneOf(WordAt(*tokens, at - 2), {"covered", "full", "filled"})) {
    return;
  }
  // What is covered does not count: "a lake, and the forest is full of them".
  const std::size_t being = BeingBegin(*tokens, at - 2);
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  std::size_t thing = 0;
  while (thing < named.size() &&
         (named[thing].end == being || OnlySaysWhere(*tokens, named[thing]))) {
    ++thing;
  }
  if (thing == named.size()) return;
  const std::string name = JoinWords(*tokens, named[thing].begin, named[thing].end);
  ReplaceTokens(tokens, at, 1, {name});
  const std::vector<Token> words = SaidLike(name, (*tokens)[at]);
  EraseTokens(tokens, at, 1);
  InsertTokens(tokens, at, words);
  std::size_t comma = at;
  while (comma > 0 && !IsPauseAt(*tokens, comma)) --comma;
  if (comma > 0 && IsMark(*tokens, comma)) (*tokens)[comma] = StopLike((*tokens)[comma]);
}

// "Not many houses", "not too much water", "there should not be much water": one to five houses,
// a bit of water. "Only little water": a bit of it, which is not all there is.
void TurnNotMany(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"only", "just", "really"})) {
    std::size_t little = at + 1;
    if (IsOneOf(WordAt(*tokens, little), {"a", "very"})) ++little;
    const bool bit = WordAt(*tokens, little) == "bit" && WordAt(*tokens, little + 1) == "of";
    if ((bit || IsOneOf(WordAt(*tokens, little), {"little", "some"})) &&
        NamesThing(*tokens, little + 1)) {
      EraseTokens(tokens, at, 1);
    }
  }
  // "Little forest": a bit of it.
  const ClassWordMatch land = MatchClassWord(*tokens, at + 1);
  const bool mass_next = land.word != nullptr &&
                         (land.word->shape == WordShape::kMass || land.word->phrase == "water");
  if (WordAt(*tokens, at) == "little" && mass_next &&
      (at == 0 || IsPauseAt(*tokens, at - 1) ||
       IsOneOf(WordAt(*tokens, at - 1),
               {"is", "are", "be", "and", "but", "very", "with", "has"}))) {
    const bool very = at > 0 && WordAt(*tokens, at - 1) == "very";
    if (!very) ReplaceTokens(tokens, at, 1, {"a", "bit", "of"});
    return;
  }
  if (WordAt(*tokens, at) != "not") return;
  std::size_t much = at + 1;
  const bool be = WordAt(*tokens, much) == "be";
  if (be) ++much;
  if (IsOneOf(WordAt(*tokens, much), {"too", "very", "so", "that", "all"})) ++much;
  const bool many = WordAt(*tokens, much) == "many";
  if ((!many && WordAt(*tokens, much) != "much") || !NamesThing(*tokens, much + 1)) return;
  // "not many more houses than"
  if (IsOneOf(WordAt(*tokens, much + 1), {"more", "less", "fewer", "of"})) return;
  const bool mass = MatchClassWord(*tokens, much + 1).word != nullptr && !many;
  if (!mass && !many) return;
  if (many)
    ReplaceTokens(tokens, at, much + 1 - at, {"one", "to", "five"});
  else
    ReplaceTokens(tokens, at, much + 1 - at, {"a", "bit", "of"});
  if (be) InsertTokens(tokens, at, {WordLike("be", (*tokens)[at])});
}

// "No large lake, only small ponds": small ponds.
void TurnNoneOfSize(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "no" || !IsSize(WordAt(*tokens, at + 1))) return;
  const ClassWordMatch large = MatchClassWord(*tokens, at + 2);
  std::size_t only = at + 2 + large.tokens;
  if (large.word == nullptr) return;
  while (IsMark(*tokens, only) || WordAt(*tokens, only) == "but") ++only;
  if (only == at + 2 + large.tokens) return;
  const std::size_t small =
      only + (IsOneOf(WordAt(*tokens, only), {"only", "just", "rather"}) ? 1 : 0);
  std::size_t noun = small;
  while (IsSize(WordAt(*tokens, noun)) ||
         IsOneOf(WordAt(*tokens, noun), {"a", "some", "few", "several", "one"})) {
    ++noun;
  }
  const ClassWordMatch other = MatchClassWord(*tokens, noun);
  if (other.word == nullptr || noun == small || other.word->suburb != large.word->suburb ||
      other.word->wild != large.word->wild) {
    return;
  }
  EraseTokens(tokens, at, small - at);
}

// "Apart from a small pond there is no water", "besides one farm there are no houses": a small
// pond. "Except for a lake there are no trees": a lake. No trees.
void TurnNoneBesides(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  std::size_t thing = at;
  if (IsOneOf(WordAt(*tokens, at), {"apart", "aside"}) && WordAt(*tokens, at + 1) == "from")
    thing = at + 2;
  if (WordAt(*tokens, at) == "other" && WordAt(*tokens, at + 1) == "than") thing = at + 2;
  if (IsOneOf(WordAt(*tokens, at), {"besides", "except", "save"}))
    thing = at + 1 + (WordAt(*tokens, at + 1) == "for" ? 1 : 0);
  if (thing == at || !IsOneOf(WordAt(*tokens, thing), {"a", "an", "one", "the", "two", "some"}))
    return;
  std::size_t there = thing;
  while (!IsStopAt(*tokens, there) && WordAt(*tokens, there) != "there") ++there;
  if (IsStopAt(*tokens, there) || !IsOneOf(WordAt(*tokens, there + 1), {"is", "are"}) ||
      WordAt(*tokens, there + 2) != "no") {
    return;
  }
  const std::size_t no = there + 2, named = no + 1 + (WordAt(*tokens, no + 1) == "other" ? 1 : 0);
  const ClassWordMatch none = MatchClassWord(*tokens, named);
  const std::vector<NamedThing> left = NamedBefore(*tokens, there);
  if (none.word == nullptr || left.empty() || left[0].begin < thing) return;
  const ClassWordMatch match = MatchClassWord(*tokens, left[0].begin);
  const bool same = match.word->suburb == none.word->suburb && match.word->wild == none.word->wild;
  std::size_t end = no;
  if (same) {
    end = named + none.tokens;
    while (IsOneOf(WordAt(*tokens, end), {"at", "all", "anywhere"})) ++end;
  }
  std::size_t said = there;
  if (said > 0 && IsMark(*tokens, said - 1)) --said;
  EraseTokens(tokens, said, end - said);
  if (!same) InsertTokens(tokens, said, {StopLike((*tokens)[at])});
  EraseTokens(tokens, at, thing - at);
}

// "The north is partly water and partly grass": in the north there is water and grass.
void TurnPartly(std::vector<Token>* tokens, std::size_t at) {
  const bool is = IsOneOf(WordAt(*tokens, at), {"is", "are"});
  const std::size_t partly = at + (is ? 1 : 0);
  if (!IsOneOf(WordAt(*tokens, partly), {"partly", "partially"}) ||
      MatchClassWord(*tokens, partly + 1).tokens == 0) {
    return;
  }
  EraseTokens(tokens, partly, 1);
  if (!is) return;
  std::size_t begin = at;
  while (begin > 0 && !IsPauseAt(*tokens, begin - 1) && WordAt(*tokens, begin - 1) != "and")
    --begin;
  if (WordAt(*tokens, begin) != "the") return;
  PlaceCursor cursor(*tokens, begin + 1);
  if (!TakeDirection(&cursor).found) return;
  InsertTokens(tokens, at, {WordLike("there", (*tokens)[at])});
  InsertTokens(tokens, begin, {WordLike("in", (*tokens)[begin])});
}

// "In the top left there are trees, in the top right too": there are trees.
void TurnThereToo(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !(IsMark(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and") ||
      !PlaceAt(*tokens, at)) {
    return;
  }
  const std::size_t end = PauseAfter(*tokens, at);
  const bool well = WordAt(*tokens, end - 1) == "well" && WordAt(*tokens, end - 2) == "as";
  if (!well && !IsOneOf(WordAt(*tokens, end - 1), {"too", "also"})) return;
  std::size_t begin = at;
  while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.empty() || named[0].begin < begin || !PlaceAt(*tokens, begin) ||
      NamesThing(*tokens, at + 1)) {
    return;
  }
  // "In the north there are trees along the river, in the south too": the trees.
  std::size_t thing = 0;
  while (thing + 1 < named.size() && named[thing + 1].begin >= begin &&
         OnlySaysWhere(*tokens, named[thing])) {
    ++thing;
  }
  const std::string name = JoinWords(*tokens, named[thing].begin, named[thing].end);
  const std::vector<Token> said = SaidLike("there is " + name, (*tokens)[at]);
  const std::size_t too = end - (well ? 2 : 1);
  EraseTokens(tokens, too, end - too);
  InsertTokens(tokens, too, said);
}

}  // namespace

void TurnEllipses(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnNotMany(tokens, at);
    TurnNoneOfSize(tokens, at);
    TurnNoneBesides(tokens, at);
    TurnCoveredWithThem(tokens, at);
    TurnPartly(tokens, at);
    TurnThereToo(tokens, at);
    TurnSomeElsewhere(tokens, at);
  }
}

}  // namespace latticeworld
