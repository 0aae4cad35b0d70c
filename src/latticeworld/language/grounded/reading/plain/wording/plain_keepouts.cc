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

// What things keep away from.
namespace latticeworld {
namespace {

// "Ends before it reaches the forest", "stops before the lake": stops short of it.
void TurnEndsBefore(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"ends", "end", "stops", "stop", "ending", "stopping"})) return;
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"just", "shortly", "right", "well"})) ++next;
  if (WordAt(*tokens, next) != "before") return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"it", "they"}) &&
      IsOneOf(WordAt(*tokens, next + 1), {"reaches", "reach", "meets", "touches", "enters"})) {
    next += 2;
  } else if (IsOneOf(WordAt(*tokens, next), {"reaching", "entering", "touching", "meeting"})) {
    ++next;
  }
  const std::size_t end = PastThing(*tokens, next);
  if (end == 0 || IsOneOf(WordAt(*tokens, end), {"bends", "turns", "begins", "starts"})) return;
  ReplaceTokens(tokens, at, next - at, {"stops", "short", "of"});
}

// "The road and the river never meet", "lakes that do not touch each other": do not touch.
void TurnNeverMeet(std::vector<Token>* tokens, std::size_t at) {
  const bool never = WordAt(*tokens, at) == "never";
  if (!never && WordAt(*tokens, at) != "not") return;
  const std::string_view helper = at > 0 ? WordAt(*tokens, at - 1) : std::string_view();
  const bool helped = IsOneOf(helper, {"do", "must", "should", "may", "shall", "can", "will"});
  if ((!never && !helped) || !IsOneOf(WordAt(*tokens, at + 1), {"meet", "touch", "join"})) return;
  const std::size_t begin = at - (helped ? 1 : 0);
  std::size_t end = at + 2;
  if (IsOneOf(WordAt(*tokens, end), {"each", "one"}) &&
      IsOneOf(WordAt(*tokens, end + 1), {"other", "another"})) {
    end += 2;
  }
  if (WordAt(*tokens, end) == "anywhere") ++end;
  if (!IsPauseAt(*tokens, end) && WordAt(*tokens, end) != "and") return;
  ReplaceTokens(tokens, begin, end - begin, {"do", "not", "touch"});
}

// The river or lake that a bank belongs to: the last one named, else a river.
std::string OwnerOfBank(const std::vector<Token>& tokens, std::size_t at) {
  for (std::size_t i = at; i-- > 0;) {
    const ClassWordMatch match = MatchClassWord(tokens, i);
    if (match.word != nullptr && match.word->wild == 'W' && i + match.tokens <= at &&
        !match.plural) {
      return JoinWords(tokens, i, i + match.tokens);
    }
  }
  return "river";
}

// "A river with no buildings on its west bank": on the west bank of the river.
void TurnBareBank(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"no", "without"})) return;
  const std::size_t on = PastThing(*tokens, at + 1);
  if (on == 0 || !IsOneOf(WordAt(*tokens, on), {"on", "along", "at"}) ||
      !IsOneOf(WordAt(*tokens, on + 1), {"its", "the", "their"})) {
    return;
  }
  Heading heading;
  const std::size_t side = TakeHeading(*tokens, on + 1, &heading);
  const bool own = WordAt(*tokens, on + 1) == "its";
  const bool bank = side > 0 && IsOneOf(WordAt(*tokens, side), {"bank", "shore"});
  if (side == 0 || (!bank && !(own && WordAt(*tokens, side) == "side")) ||
      !IsPauseAt(*tokens, side + 1)) {
    return;
  }
  std::string owner;
  if (bank) {
    owner = OwnerOfBank(*tokens, at);
  } else {
    for (std::size_t i = SentenceBegin(*tokens, at); i < at && owner.empty(); ++i) {
      const std::size_t length = MatchClassWord(*tokens, i).tokens;
      if (length > 0) owner = JoinWords(*tokens, i, i + length);
    }
  }
  if (owner.empty()) return;
  InsertTokens(tokens, side + 1, SaidLike("of the " + owner, (*tokens)[side]));
  (*tokens)[on + 1].text = "the";
}

// "Keep the river bank free of buildings", "the banks of the river clear of trees": the buildings
// not next to the river.
void TurnKeptBank(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"keep", "leave"})) return;
  std::size_t next = at + 1;
  while (IsOneOf(WordAt(*tokens, next), {"the", "both", "all"})) ++next;
  const auto is_bank = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i),
                   {"bank", "banks", "shore", "shores", "shoreline", "riverbank", "riverbanks"});
  };
  std::string owner;
  std::size_t length = MatchClassWord(*tokens, next).tokens;
  if (length > 0 && is_bank(next + length)) {
    owner = JoinWords(*tokens, next, next + length);
    next += length + 1;
  } else if (is_bank(next)) {
    owner = WordAt(*tokens, next).substr(0, 5) == "river" ? "river" : OwnerOfBank(*tokens, at);
    ++next;
    if (WordAt(*tokens, next) == "of" && WordAt(*tokens, next + 1) == "the") {
      length = MatchClassWord(*tokens, next + 2).tokens;
      if (length == 0) return;
      owner = JoinWords(*tokens, next + 2, next + 2 + length);
      next += 2 + length;
    }
  } else {
    return;
  }
  if (!IsOneOf(WordAt(*tokens, next), {"free", "clear"}) ||
      !IsOneOf(WordAt(*tokens, next + 1), {"of", "from"})) {
    return;
  }
  std::size_t end = next + 1;
  std::string said;
  // "free of houses, trees and roads"
  for (std::size_t thing = next + 2; PastThing(*tokens, thing) > 0;) {
    const std::size_t noun = PastArticle(*tokens, thing);
    end = PastThing(*tokens, thing);
    said += (said.empty() ? "the " : " . the ") + JoinWords(*tokens, noun, end) +
            " not next to the " + owner;
    thing = end + (IsMark(*tokens, end) ? 1 : 0);
    if (IsOneOf(WordAt(*tokens, thing), {"and", "or"})) ++thing;
    const std::size_t after = PastThing(*tokens, thing);
    const bool listed =
        after > 0 && (IsPauseAt(*tokens, after) || WordAt(*tokens, after) == "and" ||
                      WordAt(*tokens, after) == "or");
    if (thing == end || !listed) break;
  }
  if (said.empty()) return;
  const Token beside = (*tokens)[at];
  // "..., and put a village in the north": a sentence of its own
  std::size_t next_clause = end + (IsMark(*tokens, end) ? 1 : 0);
  if (WordAt(*tokens, next_clause) == "and") ++next_clause;
  if (next_clause > end) {
    said += " .";
    end = next_clause;
  }
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, SaidLike(said, beside));
}

bool SameClass(const ClassWord* one, const ClassWord* other) {
  return one != nullptr && other != nullptr && one->suburb == other->suburb &&
         one->wild == other->wild;
}

// The thing that "it" or "them" stands for behind what ends before `at`: right before "with", else
// the last that no preposition leads in. "a lake near a wood. No houses near it": the lake.
NamedThing OwnerBefore(const std::vector<Token>& tokens, std::size_t at, const ClassWord* denied) {
  NamedThing owner = {0, 0};
  for (const NamedThing& named : NamedBefore(tokens, at)) {
    if (SameClass(MatchClassWord(tokens, named.begin).word, denied)) continue;
    const std::size_t first = PhraseBegin(tokens, named.end);
    const bool led = first > 0 && IsOneOf(WordAt(tokens, first - 1),
                                          {"near", "along", "by", "around", "of", "to", "beside",
                                           "in", "from", "with", "no", "through", "behind"});
    if (owner.end == 0) owner = named;
    if (!led || named.end == at) return named;
  }
  return owner;
}

// "near it", "around them", "close by", "nearby": the token after them; 0: no such words.
std::size_t NearItEnd(const std::vector<Token>& tokens, std::size_t at) {
  while (IsOneOf(WordAt(tokens, at), {"directly", "right", "immediately", "anywhere"})) ++at;
  const std::string_view word = WordAt(tokens, at), next = WordAt(tokens, at + 1);
  if (word == "nearby") return at + 1;
  std::size_t it = 0;
  if (IsOneOf(word, {"near", "around", "round", "beside", "by", "touching"})) it = at + 1;
  if (IsOneOf(word, {"next", "close", "adjacent"}) && next == "to") it = at + 2;
  if (word == "all" && next == "around") it = at + 2;
  if (word == "close" && next == "by") return at + 2;
  return it > 0 && IsOneOf(WordAt(tokens, it), {"it", "them"}) ? it + 1 : 0;
}

// "A lake. No houses should be near it. A road leads to it", "a lake with no forest around it",
// "do not put any water near it": a lake. A road leads to it. The houses not close to the lake.
void TurnNoneNearIt(std::vector<Token>* tokens, std::size_t at) {
  std::size_t begin = at, noun = at + 1;
  const bool without = WordAt(*tokens, at) == "without";
  if (WordAt(*tokens, at) == "not") {
    if (at == 0 || WordAt(*tokens, at - 1) != "do" ||
        !IsOneOf(WordAt(*tokens, at + 1), {"put", "place", "build", "add", "draw", "plant"})) {
      return;
    }
    --begin;
    noun = at + 2;
  } else if (!without && WordAt(*tokens, at) != "no") {
    return;
  }
  if (WordAt(*tokens, noun) == "any") ++noun;
  const ClassWordMatch denied = MatchClassWord(*tokens, noun);
  std::size_t near = noun + denied.tokens;
  while (IsOneOf(WordAt(*tokens, near), {"should", "may", "must", "can", "be", "stand", "lie",
                                         "built", "are", "is", "placed"})) {
    ++near;
  }
  std::size_t end = NearItEnd(*tokens, near);
  if (denied.word == nullptr || end == 0) return;
  const bool with = without || (begin > 0 && WordAt(*tokens, begin - 1) == "with");
  if (with && !without) --begin;
  if (!with) begin = BeingBegin(*tokens, begin);
  // "the lake has no houses around it"
  if (!with && begin > 0 && WordAt(*tokens, begin - 1) == "has") --begin;
  // "with no houses around it lies in the south"
  const bool goes_on =
      with && near == noun + denied.tokens &&
      (SkipBeing(*tokens, end) > end || IsOneOf(WordAt(*tokens, end), {"in", "on", "at", "but"}));
  if (!IsPauseAt(*tokens, end) && !IsOneOf(WordAt(*tokens, end), {"and", "but"}) && !goes_on)
    return;
  const bool linked = begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"and", "but"});
  if (linked) --begin;
  const bool mark = begin > 0 && IsMark(*tokens, begin - 1);
  if (mark) --begin;
  const NamedThing owner = OwnerBefore(*tokens, begin, denied.word);
  if (owner.end == 0) return;
  if (WordAt(*tokens, end - 1) == "nearby") {
    for (std::size_t i = 0; i < at; ++i)
      if (SameClass(MatchClassWord(*tokens, i).word, denied.word)) return;
  }
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  if (tokens->back().kind != TokenKind::kStop) said.push_back(StopLike(beside));
  const auto say = [&](std::string_view words) {
    for (const Token& token : SaidLike(words, beside)) said.push_back(token);
  };
  const std::string kept =
      "the " + JoinWords(*tokens, noun, noun + denied.tokens) + " not close to the ";
  say(kept + JoinWords(*tokens, owner.begin, owner.end) + " .");
  // "a village and a lake. No trees near them": near either of the two
  if (WordAt(*tokens, end - 1) == "them" && !MatchClassWord(*tokens, owner.begin).plural) {
    const std::size_t second = PhraseBegin(*tokens, owner.end);
    const std::vector<NamedThing> named = NamedBefore(*tokens, second);
    if (second > 0 && WordAt(*tokens, second - 1) == "and" && !named.empty() &&
        named.front().begin >= SentenceBegin(*tokens, second)) {
      say(kept + JoinWords(*tokens, named.front().begin, named.front().end) + " .");
    }
  }
  const bool opens = begin == 0 || IsStopAt(*tokens, begin - 1);
  if (opens) {
    // A sentence of its own goes away with the stop, comma or "and" behind it.
    if (end < tokens->size()) ++end;
  } else if (IsMark(*tokens, end) && mark) {
    // If it stands between commas, one is left before the next thing.
    const bool thing = PhraseEnd(*tokens, end + 1) > end + 1 ||
                       IsOneOf(WordAt(*tokens, end + 1), {"and", "but", "with"});
    if (!thing) ++end;
  }
  InsertTokens(tokens, tokens->size(), said);
  EraseTokens(tokens, begin, end - begin);
}

}  // namespace

void TurnKeepouts(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnEndsBefore(tokens, at);
    TurnNeverMeet(tokens, at);
    TurnBareBank(tokens, at);
    TurnKeptBank(tokens, at);
    TurnNoneNearIt(tokens, at);
  }
}

}  // namespace latticeworld
