#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Lists of short sentences: what is everywhere, what there is most of, and what every one has.
namespace latticeworld {
namespace {

// The token after "the whole map"; `at`: it is not named there.
std::size_t PastMap(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t next = at;
  while (IsOneOf(WordAt(tokens, next), {"the", "whole", "entire", "of"})) ++next;
  return IsMapWord(WordAt(tokens, next)) ? next + 1 : at;
}

// "Houses are scattered all over the map", "trees, sprinkled across the whole map": scattered.
void TurnScatteredOver(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at),
               {"scattered", "dotted", "sprinkled", "strewn", "dispersed", "distributed"})) {
    return;
  }
  std::size_t over = at + 1;
  while (IsOneOf(WordAt(*tokens, over), {"evenly", "about", "around", "out", "all"})) ++over;
  if (!IsOneOf(WordAt(*tokens, over), {"over", "across", "throughout"})) return;
  const std::size_t end = PastMap(*tokens, over + 1);
  if (end == over + 1 || !IsPauseAt(*tokens, end)) return;
  EraseTokens(tokens, at + 1, end - at - 1);
  (*tokens)[at].text = "scattered";
}

// The token after "than any other land", "than anything else"; 0: something else stands there.
std::size_t PastAnyOther(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) != "than") return 0;
  if (WordAt(tokens, at + 1) == "anything" && WordAt(tokens, at + 2) == "else") return at + 3;
  if (WordAt(tokens, at + 1) != "any" || WordAt(tokens, at + 2) != "other") return 0;
  std::size_t end = at + 3;
  while (IsOneOf(WordAt(tokens, end), {"kind", "type", "sort", "of", "single", "land", "ground",
                                       "terrain", "surface", "cover", "area", "class", "thing",
                                       "landscape", "element", "feature", "use", "one"})) {
    ++end;
  }
  return end;
}

// "More farmland than any other land", "forest covers more of the map than anything else": mostly.
void TurnMoreThanOther(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "more") return;
  std::size_t than = at + 1;
  const std::size_t noun = MatchClassWord(*tokens, than).tokens;
  std::size_t begin = at;
  if (noun > 0) {
    than += noun;
  } else {
    // "forest covers more of the map"
    if (WordAt(*tokens, than) == "of") than = PastMap(*tokens, than);
    if (IsOneOf(WordAt(*tokens, than), {"land", "area", "space", "ground"})) ++than;
    std::size_t verb = at;
    if (verb > 0 && WordAt(*tokens, verb - 1) == "up") --verb;
    if (verb == 0 || !IsOneOf(WordAt(*tokens, verb - 1), {"covers", "cover", "takes", "take",
                                                          "occupies", "occupy", "fills", "fill"})) {
      return;
    }
    begin = SentenceBegin(*tokens, at);
    const std::size_t name = begin + (WordAt(*tokens, begin) == "the" ? 1 : 0);
    const std::size_t length = MatchClassWord(*tokens, name).tokens;
    // "forest covers" might be the plural of "forest cover"
    if (length == 0 || (name + length != verb - 1 && name + length != verb)) return;
  }
  const std::size_t end = PastAnyOther(*tokens, than);
  if (end == 0 || !IsPauseAt(*tokens, end)) return;
  if (noun > 0) {
    EraseTokens(tokens, than, end - than);
    (*tokens)[at].text = "mostly";
    return;
  }
  std::size_t verb = at - 1;
  while (WordAt(*tokens, verb) == "up") --verb;
  EraseTokens(tokens, verb, end - verb);
  if (WordAt(*tokens, begin) == "the") EraseTokens(tokens, begin, 1);
  InsertTokens(tokens, begin, {WordLike("mostly", (*tokens)[begin])});
}

// What was counted before: its number, "four", "at least three", and its noun, "meadows".
struct Counted {
  std::vector<Token> number, noun;
};

Counted CountOf(const std::vector<Token>& tokens, std::size_t before, const ClassWord* word) {
  Counted found;
  for (std::size_t i = 0; i < before; ++i) {
    const CountMatch count = MatchCount(tokens, i);
    if (count.tokens == 0 || count.least < 2) continue;
    std::size_t noun = i + count.tokens;
    for (int more = 0; more < 2 && MatchClassWord(tokens, noun).word == nullptr; ++more) ++noun;
    const ClassWordMatch match = MatchClassWord(tokens, noun);
    // "meadows" is a word of its own
    const bool same =
        match.word != nullptr &&
        (match.plural ? match.word == word
                      : match.word != word && Singular(match.word->phrase) == word->phrase);
    if (!same) continue;
    // "at most five ponds" after "at least four ponds": no one number.
    if (!found.number.empty()) return {};
    std::size_t first = i;
    if (IsOneOf(WordAt(tokens, i), {"exactly", "precisely", "only", "just"})) ++first;
    found.number = TokensBetween(tokens, first, i + count.tokens);
    found.noun = TokensBetween(tokens, noun, noun + match.tokens);
    i = noun + match.tokens - 1;
  }
  return found;
}

// "Exactly four meadows ... A house inside every meadow": four houses inside the meadows.
void TurnInsideEvery(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"every", "each"}) || at < 3) return;
  // "A house inside every meadow" is a whole sentence.
  const ClassWordMatch match = MatchClassWord(*tokens, at + 1);
  const std::size_t end = at + 1 + match.tokens;
  const std::size_t begin = SentenceBegin(*tokens, at);
  if (match.word == nullptr || match.plural || match.is_line() || !IsStopAt(*tokens, end) ||
      !IsOneOf(WordAt(*tokens, begin), {"a", "an", "one"})) {
    return;
  }
  // One thing that can be counted stands first.
  std::size_t noun = begin + 1;
  for (int more = 0; more < 2 && MatchClassWord(*tokens, noun).word == nullptr; ++more) ++noun;
  const ClassWordMatch one = MatchClassWord(*tokens, noun);
  std::size_t in = noun + one.tokens;
  if (one.word == nullptr || one.plural || one.word == match.word ||
      one.word->shape == WordShape::kMass || one.is_line()) {
    return;
  }
  // It lies in, near or by each of the others.
  if (IsOneOf(WordAt(*tokens, in), {"is", "lies", "stands"})) {
    (*tokens)[in].text = WordAt(*tokens, in) == "is" ? "are" : "lie";
    ++in;
  }
  const bool next_to = WordAt(*tokens, in) == "next" && WordAt(*tokens, in + 1) == "to";
  if (!IsOneOf(WordAt(*tokens, in), {"inside", "in", "within", "near", "beside", "by"}) && !next_to)
    return;
  if (in + (next_to ? 2 : 1) != at) return;
  // Those must have been counted; there are as many things as they are.
  const Counted counted = CountOf(*tokens, begin, match.word);
  if (counted.number.empty()) return;
  const auto like = [](const std::vector<Token>& words, const Token& beside) {
    std::vector<Token> said;
    for (const Token& word : words)
      said.push_back({word.kind, word.text, beside.begin, beside.end});
    return said;
  };
  const std::vector<Token> number = like(counted.number, (*tokens)[begin]);
  const std::vector<Token> name = like(counted.noun, (*tokens)[at + 1]);
  EraseTokens(tokens, at + 1, match.tokens);
  InsertTokens(tokens, at + 1, name);
  (*tokens)[at].text = "the";
  (*tokens)[noun + one.tokens - 1].text += "s";
  EraseTokens(tokens, begin, 1);
  InsertTokens(tokens, begin, number);
}

// "No village holds more than half of the buildings": there are villages, and how they share the
// buildings no claim tells.
void TurnNoneHolds(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  std::size_t noun = at + 1;
  if (WordAt(*tokens, at) == "none" && WordAt(*tokens, noun) == "of") {
    noun += WordAt(*tokens, noun + 1) == "the" ? 2 : 1;
  } else if (WordAt(*tokens, at) != "no") {
    return;
  }
  if (IsOneOf(WordAt(*tokens, noun), {"single", "one"})) ++noun;
  std::size_t verb = noun + MatchClassWord(*tokens, noun).tokens;
  if (verb == noun && IsOneOf(WordAt(*tokens, noun), {"group", "cluster", "piece", "patch"}))
    ++verb;
  if (verb == noun || !IsOneOf(WordAt(*tokens, verb), {"holds", "hold", "has", "have", "contains",
                                                       "contain", "makes", "make", "covers"})) {
    return;
  }
  std::size_t half = verb + 1 + (WordAt(*tokens, verb + 1) == "up" ? 1 : 0);
  if (WordAt(*tokens, half) != "more" || WordAt(*tokens, half + 1) != "than") return;
  half += 2;
  if (WordAt(*tokens, half) != "half") return;
  std::size_t all = half + 1;
  while (IsOneOf(WordAt(*tokens, all), {"of", "all", "the"})) ++all;
  const std::size_t end = all + MatchClassWord(*tokens, all).tokens;
  if (end == all || !IsStopAt(*tokens, end)) return;
  EraseTokens(tokens, at, end - at);
}

// "The ponds do not touch each other", "none of the ponds touch": are not connected.
void TurnNotEachOther(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  const bool none = WordAt(*tokens, at) == "none" && WordAt(*tokens, at + 1) == "of";
  const std::size_t the = at + (none ? 2 : 0);
  const std::size_t noun = the + (WordAt(*tokens, the) == "the" ? 1 : 0);
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  if (noun == the || match.word == nullptr || !match.plural || match.is_line()) return;
  std::size_t verb = noun + match.tokens;
  if (!none) {
    if (!IsOneOf(WordAt(*tokens, verb),
                 {"do", "must", "should", "may", "shall", "can", "will", "never"})) {
      return;
    }
    const bool never = WordAt(*tokens, verb) == "never";
    if (!never && WordAt(*tokens, ++verb) != "not") return;
    ++verb;
  }
  if (!IsOneOf(WordAt(*tokens, verb), {"touch", "touches", "meet", "join"})) return;
  std::size_t end = verb + 1;
  if (IsOneOf(WordAt(*tokens, end), {"each", "one", "any"}) &&
      IsOneOf(WordAt(*tokens, end + 1), {"other", "another"})) {
    end += 2;
  }
  if (!IsStopAt(*tokens, end)) return;
  const std::size_t first = noun + match.tokens;
  const Token beside = (*tokens)[verb];
  EraseTokens(tokens, first, end - first);
  InsertTokens(tokens, first,
               {WordLike("are", beside), WordLike("not", beside), WordLike("connected", beside)});
  if (none) EraseTokens(tokens, at, 2);
}

}  // namespace

void TurnListed(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnScatteredOver(tokens, at);
    TurnMoreThanOther(tokens, at);
    TurnInsideEvery(tokens, at);
    TurnNoneHolds(tokens, at);
    TurnNotEachOther(tokens, at);
  }
}

}  // namespace latticeworld
