#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// What is said of a thing between its noun and its verb.
namespace latticeworld {
namespace {

bool IsMainVerb(std::string_view word) {
  return IsOneOf(word,
                 {"is",      "are",    "lies",    "lie",     "runs",     "run",      "leads",
                  "lead",    "goes",   "comes",   "flows",   "winds",    "crosses",  "enters",
                  "leaves",  "passes", "follows", "sits",    "stands",   "occupies", "fills",
                  "covers",  "cuts",   "divides", "splits",  "connects", "should",   "stretches",
                  "extends", "links",  "borders", "touches", "bends",    "surrounds"});
}

bool IsShore(std::string_view word) {
  return IsOneOf(word, {"shore", "shores", "bank", "banks", "edge", "edges", "side", "sides",
                        "shoreline", "coast", "coasts", "rim"});
}

// Tokens [begin, end) go away, and a sentence follows the one that they stood in.
void SayAfter(std::vector<Token>* tokens, std::size_t begin, std::size_t end,
              const std::vector<Token>& sentence) {
  std::vector<Token> said = {StopLike(sentence.front())};
  said.insert(said.end(), sentence.begin(), sentence.end());
  InsertTokens(tokens, StopAfter(*tokens, end), said);
  EraseTokens(tokens, begin, end - begin);
}

// "the lake": the noun that ends before `end`, after "the".
std::vector<Token> TheThing(const std::vector<Token>& tokens, std::size_t end) {
  const std::vector<NamedThing> named = NamedBefore(tokens, end);
  std::vector<Token> said = {WordLike("the", tokens[end - 1])};
  for (std::size_t i = named.front().begin; i < named.front().end; ++i) said.push_back(tokens[i]);
  return said;
}

// "The lake whose southern shore is lined with houses lies in the middle": the lake lies in the
// middle. Houses on the southern shore of the lake. "A river whose banks are wooded": with forest
// on both banks.
void TurnWhose(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "whose" || at == 0) return;
  const std::size_t owner = at - (IsMark(*tokens, at - 1) ? 1 : 0);
  const ClassWord* noun = NounBefore(*tokens, owner);
  if (noun == nullptr) return;
  Heading heading;
  const std::size_t sided = TakeHeading(*tokens, at + 1, &heading);
  const std::size_t shore = sided > 0 ? sided : at + 1;
  if (!IsShore(WordAt(*tokens, shore)) || !IsOneOf(WordAt(*tokens, shore + 1), {"is", "are"}))
    return;
  // What lies there.
  std::size_t next = shore + 2;
  while (IsOneOf(WordAt(*tokens, next), {"all", "densely", "thickly", "entirely", "mostly"}))
    ++next;
  const Token beside = (*tokens)[at];
  std::vector<Token> land;
  std::size_t end = next + 1;
  if (const std::string_view told = LandOfAdjective(WordAt(*tokens, next)); !told.empty()) {
    land = SaidLike(told, beside);
    if (WordAt(*tokens, end) == "up") ++end;
  } else {
    if (IsOneOf(WordAt(*tokens, next), {"lined", "fringed", "covered", "bordered", "edged",
                                        "planted", "occupied", "dotted"}) &&
        IsOneOf(WordAt(*tokens, next + 1), {"with", "by", "in"})) {
      next += 2;
    }
    end = PhraseEnd(*tokens, next);
    if (end == next) return;
    land = TokensBetween(*tokens, next, end);
  }
  const bool rest = !IsStopAt(*tokens, end);
  // "its northern shore is wooded" is plain enough.
  if (!rest && sided > 0 && land.size() == 1 && end == shore + 3) return;
  const std::size_t main = end + (IsMark(*tokens, end) ? 1 : 0);
  if (rest && !IsMainVerb(WordAt(*tokens, main))) return;
  std::vector<Token> where;
  if (sided > 0) {
    where = SaidLike("on the", beside);
    where.push_back(WordLike(NameOf(heading), beside));
    where.push_back(WordLike("shore", beside));
  } else {
    const bool line = noun->shape == WordShape::kLine;
    where = SaidLike(line ? "on both sides" : "on the shore", beside);
  }
  where.push_back(WordLike("of", beside));
  std::vector<Token> said = land;
  said.insert(said.end(), where.begin(), where.end());
  for (const Token& token : TheThing(*tokens, owner)) said.push_back(token);
  SayAfter(tokens, owner, rest ? main : end, said);
}

// "Everything except the village, which is in the middle, is forest", "the lake, which has houses
// on its shore, is in the west": the village is in the middle, in a sentence of its own.
void TurnInserted(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || !IsOneOf(WordAt(*tokens, at + 1), {"which", "that"}) || at == 0)
    return;
  const std::size_t end = PauseAfter(*tokens, at + 1);
  const bool verb = IsMainVerb(WordAt(*tokens, end + 1)) || WordAt(*tokens, end + 1) == "there";
  if (!IsMark(*tokens, end) || !verb || NounBefore(*tokens, at) == nullptr) {
    return;
  }
  const std::size_t begin = SentenceBegin(*tokens, at);
  const std::size_t thing = PhraseBegin(*tokens, at);
  bool apart = false;  // the noun is not what the verb after the comma is about
  for (std::size_t i = begin; i < thing; ++i) {
    apart = apart || (IsOneOf(WordAt(*tokens, i), {"everything", "all", "of", "behind", "beyond",
                                                   "beside", "around", "next", "inside"}) &&
                      NamedBefore(*tokens, i + 1).size() == NamedBefore(*tokens, begin).size());
  }
  const bool has = thing == begin && IsOneOf(WordAt(*tokens, at + 2), {"has", "have"}) &&
                   NamesThing(*tokens, at + 3);
  if (!apart && !has) return;
  std::vector<Token> said = TheThing(*tokens, at);
  for (const Token& token : TokensBetween(*tokens, at + 2, end)) said.push_back(token);
  SayAfter(tokens, at, end + 1, said);
}

// Returns where the words end that tell of a line's way ("from north to south"); `at`: there are
// none. What "in" tells is of the thing that the line runs through.
std::size_t WayEnd(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"from", "to", "towards", "toward", "into", "down", "up",
                                    "northwards", "southwards", "eastwards", "westwards"})) {
    return at;
  }
  std::size_t end = at;
  while (!IsPauseAt(tokens, end) && !IsMainVerb(WordAt(tokens, end)) &&
         !IsOneOf(WordAt(tokens, end), {"and", "but", "with", "while"})) {
    ++end;
  }
  return end;
}

// "A town through which a river flows to the south": a town, a river flows through the town to the
// south.
void TurnThroughWhich(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"through", "across"}) || WordAt(*tokens, at + 1) != "which" ||
      at == 0) {
    return;
  }
  const std::size_t owner = at - (IsMark(*tokens, at - 1) ? 1 : 0);
  if (NounBefore(*tokens, owner) == nullptr) return;
  std::size_t line = at + 2, line_end = PhraseEnd(*tokens, line), way = line_end + 1;
  const bool turned = line_end == line;  // "through which flows a river"
  const std::size_t verb = line_end;
  if (!IsOneOf(WordAt(*tokens, verb), {"flows", "flow", "runs", "run", "passes", "pass", "leads",
                                       "lead", "goes", "go", "winds", "wind", "cuts", "meanders"}))
    return;
  if (turned) {
    line = verb + 1;
    line_end = way = PhraseEnd(*tokens, line);
    if (line_end == line) return;
  }
  const std::size_t end = WayEnd(*tokens, way);
  std::vector<Token> said = TokensBetween(*tokens, line, line_end);
  const bool many = IsOneOf(WordAt(*tokens, verb), {"flow", "run", "pass", "lead", "go", "wind"});
  said.push_back(WordLike(many ? "run" : "runs", (*tokens)[at]));
  said.push_back(WordLike(WordAt(*tokens, at), (*tokens)[at]));
  for (const Token& token : TheThing(*tokens, owner)) said.push_back(token);
  for (const Token& token : TokensBetween(*tokens, way, end)) said.push_back(token);
  const bool aside = IsMark(*tokens, end) && (owner < at || IsMainVerb(WordAt(*tokens, end + 1))) &&
                     PhraseEnd(*tokens, end + 1) == end + 1 && WordAt(*tokens, end + 1) != "and";
  SayAfter(tokens, owner, end + (aside ? 1 : 0), said);
}

// "A road with houses on both sides leads from the south to the lake": it leads there. Houses on
// both sides of the road.
void TurnAccompanied(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "with" || at == 0) return;
  const std::size_t owner = at - (IsMark(*tokens, at - 1) ? 1 : 0);
  const ClassWord* noun = NounBefore(*tokens, owner);
  const std::size_t begin = SentenceBegin(*tokens, at);
  if (noun == nullptr || PhraseBegin(*tokens, owner) != begin) return;
  const std::size_t on = PhraseEnd(*tokens, at + 1);
  if (on == at + 1 || !IsOneOf(WordAt(*tokens, on), {"on", "along"}) ||
      !IsOneOf(WordAt(*tokens, on + 1), {"both", "either", "each"})) {
    return;
  }
  std::size_t end = on + 2;
  if (WordAt(*tokens, end) == "of" && WordAt(*tokens, end + 1) == "its") end += 2;
  if (!IsOneOf(WordAt(*tokens, end), {"side", "sides", "bank", "banks"})) return;
  ++end;
  const bool of_it = WordAt(*tokens, end) == "of" && WordAt(*tokens, end + 1) == "it";
  if (of_it) end += 2;
  const std::size_t main = end + (IsMark(*tokens, end) ? 1 : 0);
  if (!IsMainVerb(WordAt(*tokens, main))) return;
  std::vector<Token> said = TokensBetween(*tokens, at + 1, on);
  for (const Token& token : SaidLike("on both sides of", (*tokens)[at])) said.push_back(token);
  for (const Token& token : TheThing(*tokens, owner)) said.push_back(token);
  SayAfter(tokens, owner, main, said);
}

}  // namespace

void TurnRelatives(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnWhose(tokens, at);
    TurnInserted(tokens, at);
    TurnThroughWhich(tokens, at);
    TurnAccompanied(tokens, at);
  }
}

}  // namespace latticeworld
