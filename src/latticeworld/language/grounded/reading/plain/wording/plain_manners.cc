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
#include "latticeworld/layout/symbolic_layout.h"

// How people say it who are in a hurry, or whose first language is another.
namespace latticeworld {
namespace {

// "Is going", "are lying": goes, lie.
void TurnProgressive(std::vector<Token>* tokens, std::size_t at) {
  const bool one = WordAt(*tokens, at) == "is";
  if (!one && WordAt(*tokens, at) != "are") return;
  struct Verb {
    std::string_view doing, does, they;
  };
  constexpr Verb kVerbs[] = {
      {"going", "goes", "go"},
      {"coming", "comes", "come"},
      {"running", "runs", "run"},
      {"flowing", "flows", "flow"},
      {"passing", "passes", "pass"},
      {"leading", "leads", "lead"},
      {"crossing", "crosses", "cross"},
      {"winding", "winds", "wind"},
      {"entering", "enters", "enter"},
      {"leaving", "leaves", "leave"},
      {"standing", "stands", "stand"},
      {"lying", "lies", "lie"},
      {"sitting", "sits", "sit"},
      {"surrounding", "surrounds", "surround"},
      {"covering", "covers", "cover"},
      {"filling", "fills", "fill"},
      {"following", "follows", "follow"},
      {"connecting", "connects", "connect"},
  };
  const std::size_t doing = at + (IsOneOf(WordAt(*tokens, at + 1), {"always", "also"}) ? 2 : 1);
  for (const Verb& verb : kVerbs) {
    if (WordAt(*tokens, doing) != verb.doing) continue;
    // "is going to be", "the river is winding"
    if (IsPauseAt(*tokens, doing + 1) || WordAt(*tokens, doing + 1) == "and" ||
        (WordAt(*tokens, doing + 1) == "to" &&
         IsOneOf(WordAt(*tokens, doing + 2), {"be", "have", "need", "use", "test", "drive"}))) {
      return;
    }
    const std::string said(one ? verb.does : verb.they);
    ReplaceTokens(tokens, at, doing + 1 - at, {said});
    return;
  }
}

// "At north from the lake", "in the south from it", "at the left from the road": north of it.
void TurnSideFrom(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"at", "in", "on"})) return;
  const std::size_t side = at + (WordAt(*tokens, at + 1) == "the" ? 2 : 1);
  Heading heading;
  const std::size_t from = TakeHeading(*tokens, side, &heading);
  if (from == 0 || WordAt(*tokens, from) != "from") return;
  // "in the north, from the lake to the edge"
  const std::size_t end = PastThing(*tokens, from + 1) > 0    ? PastThing(*tokens, from + 1)
                          : WordAt(*tokens, from + 1) == "it" ? from + 2
                                                              : 0;
  if (end == 0 || WordAt(*tokens, end) == "to") return;
  (*tokens)[from].text = "of";
  const bool picture = IsOneOf(WordAt(*tokens, from - 1), {"left", "right", "top", "bottom"});
  if (picture) {
    ReplaceTokens(tokens, at, side - at, {"to", "the"});
  } else {
    EraseTokens(tokens, at, side - at);
  }
}

// "Everything that I haven't mentioned": everything else.
void TurnUnmentioned(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"everything", "anything", "all"})) return;
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"that", "which"})) ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"i", "we", "was", "is", "has"})) return;
  while (IsOneOf(WordAt(*tokens, next), {"i", "we", "was", "is", "has", "have", "did", "been"}))
    ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"not", "never"})) return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"been", "yet", "already"})) ++next;
  if (!IsOneOf(WordAt(*tokens, next),
               {"mentioned", "mention", "named", "name", "said", "say", "described", "describe",
                "listed", "specified", "specify"})) {
    return;
  }
  ReplaceTokens(tokens, at, next + 1 - at, {"everything", "else"});
}

// "None of them holding most of the houses": of sizes, not of what there is.
void TurnHoldingMost(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"none", "no"}) || at == 0 || !IsPauseAt(*tokens, at - 1))
    return;
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"one", "group", "piece", "single"})) ++next;
  if (WordAt(*tokens, next) == "of" &&
      IsOneOf(WordAt(*tokens, next + 1), {"them", "which", "these"}))
    next += 2;
  if (!IsOneOf(WordAt(*tokens, next), {"holding", "holds", "containing", "contains", "having",
                                       "has", "with", "making", "dominating"})) {
    return;
  }
  const bool most = WordAt(*tokens, next + 1) == "most" ||
                    (WordAt(*tokens, next + 1) == "more" && WordAt(*tokens, next + 2) == "than") ||
                    WordAt(*tokens, next + 1) == "the";
  if (!most) return;
  const std::size_t end = PauseAfter(*tokens, next);
  EraseTokens(tokens, at - 1, end - (at - 1));
}

// "Roads should not exist in this world": no roads.
void TurnNotExisting(std::vector<Token>* tokens, std::size_t at) {
  const std::size_t exist = at + 2;
  if (!IsOneOf(WordAt(*tokens, at),
               {"should", "must", "shall", "may", "can", "do", "does", "will"}) ||
      WordAt(*tokens, at + 1) != "not" ||
      !IsOneOf(WordAt(*tokens, exist), {"exist", "occur", "appear"})) {
    return;
  }
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.empty() || named.front().end != at) return;
  std::size_t end = exist + 1;
  if (IsOneOf(WordAt(*tokens, end), {"in", "on"})) {
    std::size_t map = end + 1;
    while (IsOneOf(WordAt(*tokens, map), {"this", "the", "our", "my", "whole", "entire"})) ++map;
    const std::string_view word = WordAt(*tokens, map);
    if (!IsMapWord(word) && !IsOneOf(word, {"world", "game", "level", "place"})) return;
    end = map + 1;
  }
  if (WordAt(*tokens, end) == "at" && WordAt(*tokens, end + 1) == "all") end += 2;
  if (!IsPauseAt(*tokens, end)) return;
  std::size_t begin = named.front().begin;
  const Token beside = (*tokens)[begin];
  EraseTokens(tokens, at, end - at);
  if (begin > 0 && WordAt(*tokens, begin - 1) == "the") EraseTokens(tokens, --begin, 1);
  InsertTokens(tokens, begin, {WordLike("no", beside)});
}

// "With a distance of at least five cells between them", "at least a distance of five cells must be
// there", "five or more cells from each other": at least five cells apart.
void TurnDistance(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"at", "least", "most", "than"})) return;
  std::size_t next = at;
  if (IsOneOf(WordAt(*tokens, next), {"with", "keep", "keeping", "leave", "leaving", "having"}))
    ++next;
  const auto take_least = [&] {
    const bool least = WordAt(*tokens, next) == "at" && WordAt(*tokens, next + 1) == "least";
    if (least) next += 2;
    return least;
  };
  take_least();
  const bool distance = IsOneOf(WordAt(*tokens, next), {"a", "one", "some"}) &&
                        IsOneOf(WordAt(*tokens, next + 1), {"distance", "gap", "space"}) &&
                        WordAt(*tokens, next + 2) == "of";
  if (distance) next += 3;
  take_least();
  const std::size_t count = next;
  const NumberMatch number = MatchNumber(*tokens, next);
  if (number.tokens == 0 || number.value > kLayoutSize) return;
  next += number.tokens;
  const auto take_more = [&] {
    if (WordAt(*tokens, next) == "or" && WordAt(*tokens, next + 1) == "more") next += 2;
  };
  take_more();
  if (!IsOneOf(WordAt(*tokens, next), {"cells", "squares", "tiles", "steps"})) return;
  const std::size_t unit = next++;
  take_more();
  if (WordAt(*tokens, next) == "between" && WordAt(*tokens, next + 1) == "them") {
    next += 2;
  } else if (WordAt(*tokens, next) == "apart") {
    ++next;
  } else if (IsOneOf(WordAt(*tokens, next), {"from", "away"}) ||
             (WordAt(*tokens, next) == "between" && WordAt(*tokens, next + 1) != "the")) {
    if (WordAt(*tokens, next) != "between") {
      next += WordAt(*tokens, next) == "away" ? 2 : 1;
    } else {
      ++next;
    }
    const bool each = WordAt(*tokens, next) == "each" && WordAt(*tokens, next + 1) == "other";
    const bool one = WordAt(*tokens, next) == "one" && WordAt(*tokens, next + 1) == "another";
    if (!each && !one) return;
    next += 2;
  } else if (distance && IsOneOf(WordAt(*tokens, next), {"must", "should", "has", "is"})) {
    next = PauseAfter(*tokens, next);
  } else if (!distance) {
    return;
  }
  if (!IsPauseAt(*tokens, next) && WordAt(*tokens, next) != "and") return;
  // Said so already.
  if (WordAt(*tokens, at) == "at" && count == at + 2 && next == unit + 2) return;
  // Number and unit keep their places in the instruction: it is by them that a gap is known.
  std::vector<Token> said = {WordLike("at", (*tokens)[count]), WordLike("least", (*tokens)[count])};
  for (std::size_t i = count; i < count + number.tokens; ++i) said.push_back((*tokens)[i]);
  said.push_back((*tokens)[unit]);
  Token apart = WordLike("apart", (*tokens)[next - 1]);
  apart.begin = apart.end;
  said.push_back(apart);
  EraseTokens(tokens, at, next - at);
  InsertTokens(tokens, at, said);
}

// "Four ponds that keep their distance from one another": apart from one another.
void TurnKeepDistance(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"keep", "keeps", "keeping"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"their", "its", "some", "a"}) ||
      WordAt(*tokens, at + 2) != "distance" || WordAt(*tokens, at + 3) != "from") {
    return;
  }
  const bool each = IsOneOf(WordAt(*tokens, at + 4), {"each", "one"});
  const bool that = each && at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"that", "which"});
  const std::size_t begin = at - (that ? 1 : 0);
  ReplaceTokens(tokens, begin, at + 3 - begin, {each ? "apart" : "away"});
}

// "Each of them separate from the others": all separate.
void TurnEachSeparate(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "each") return;
  std::size_t next = at + 1;
  if (WordAt(*tokens, next) == "one") ++next;
  if (WordAt(*tokens, next) == "of" && WordAt(*tokens, next + 1) == "them") next += 2;
  if (IsOneOf(WordAt(*tokens, next), {"being", "is"})) ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"separate", "separated", "apart", "away"}) ||
      WordAt(*tokens, next + 1) != "from") {
    return;
  }
  std::size_t end = next + 2;
  if (WordAt(*tokens, end) == "the" &&
      IsOneOf(WordAt(*tokens, end + 1), {"others", "other", "rest"}))
    end += 2;
  else if (WordAt(*tokens, end) == "each" && WordAt(*tokens, end + 1) == "other")
    end += 2;
  else
    return;
  if (IsPauseAt(*tokens, end)) ReplaceTokens(tokens, at, end - at, {"all", "separate"});
}

// "Long rather than round": long.
void TurnRatherThanShape(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "rather" || WordAt(*tokens, at + 1) != "than" || at == 0) return;
  const auto is_shape = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i),
                   {"round", "long", "straight", "winding", "elongated", "bent", "curved", "square",
                    "circular", "oval", "narrow", "compact"});
  };
  if (is_shape(at - 1) && is_shape(at + 2)) EraseTokens(tokens, at, 3);
}

// "Put four ponds into the grass", "between the both lakes": in the grass, the two lakes.
void TurnSmallWords(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "the" && WordAt(*tokens, at + 1) == "both") {
    ReplaceTokens(tokens, at + 1, 1, {"two"});
    return;
  }
  if (WordAt(*tokens, at) != "into" || PastThing(*tokens, at + 1) == 0) return;
  for (std::size_t i = at; i-- > SentenceBegin(*tokens, at);) {
    if (!IsOneOf(WordAt(*tokens, i), {"put", "place", "set", "drop", "add", "insert"})) continue;
    (*tokens)[at].text = "in";
    return;
  }
}

}  // namespace

void TurnManners(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnProgressive(tokens, at);
    TurnSideFrom(tokens, at);
    TurnUnmentioned(tokens, at);
    TurnHoldingMost(tokens, at);
    TurnNotExisting(tokens, at);
    TurnDistance(tokens, at);
    TurnKeepDistance(tokens, at);
    TurnEachSeparate(tokens, at);
    TurnRatherThanShape(tokens, at);
    TurnSmallWords(tokens, at);
  }
}

}  // namespace latticeworld
