#include "latticeworld/language/grounded/reading/thing_words.h"

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {

bool NamesThing(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::size_t kReach = 5;  // "a narrow strip of fields"
  for (std::size_t i = at; i < at + kReach && !IsPauseAt(tokens, i); ++i)
    if (MatchClassWord(tokens, i).tokens > 0) return true;
  return false;
}

bool IsSize(std::string_view word) {
  return IsOneOf(word, {"small", "smaller", "little", "tiny", "big", "bigger", "large", "larger",
                        "huge", "long", "short", "wide", "narrow"});
}

std::size_t PastArticle(const std::vector<Token>& tokens, std::size_t at) {
  while (IsOneOf(WordAt(tokens, at), {"the", "a", "an", "any", "its", "their"}) ||
         IsSize(WordAt(tokens, at))) {
    ++at;
  }
  return at;
}

std::size_t PastThing(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t noun = PastArticle(tokens, at);
  const std::size_t length = MatchClassWord(tokens, noun).tokens;
  return length > 0 ? noun + length : 0;
}

std::vector<Token> SaidLike(std::string_view words, const Token& beside) {
  std::vector<Token> said = Tokenize(words);
  for (Token& token : said) {
    token.begin = beside.begin;
    token.end = beside.end;
  }
  return said;
}

std::vector<NamedThing> NamedBefore(const std::vector<Token>& tokens, std::size_t at) {
  std::vector<NamedThing> named;
  int stops = 0;
  for (std::size_t i = at; i-- > 0 && stops < 2;) {
    if (IsStopAt(tokens, i)) ++stops;
    const std::size_t end = i + MatchClassWord(tokens, i).tokens;
    if (end == i || end > at) continue;
    // "corn field": the longest.
    if (!named.empty() && named.back().begin < end) {
      if (named.back().end <= end) named.back().begin = i;
      continue;
    }
    named.push_back({i, end});
  }
  return named;
}

NounSpan TakeNounSpan(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::size_t kReach = 5;
  NounSpan span;
  for (std::size_t i = at; i < at + kReach && !IsPauseAt(tokens, i); ++i) {
    const ClassWordMatch match = MatchClassWord(tokens, i);
    if (match.tokens > 0) {
      span = {at, i, i + match.tokens, match.plural};
      break;
    }
    if (IsOneOf(WordAt(tokens, i),
                {"of",      "and",   "or",     "nor",   "but",   "with",    "without", "in",
                 "on",      "at",    "to",     "from",  "by",    "near",    "next",    "beside",
                 "around",  "above", "below",  "under", "over",  "through", "across",  "between",
                 "along",   "is",    "are",    "be",    "lies",  "lie",     "has",     "have",
                 "which",   "that",  "who",    "where", "it",    "them",    "they",    "there",
                 "neither", "both",  "not",    "no",    "other", "one",     "another", "only",
                 "except",  "than",  "behind", "while", "then",  "also",    "towards", "into"})) {
      break;
    }
  }
  return span;
}

std::string_view LandOfAdjective(std::string_view adjective) {
  constexpr std::pair<std::string_view, std::string_view> kLands[] = {{"forested", "forest"},
                                                                      {"wooded", "forest"},
                                                                      {"grassy", "grass"},
                                                                      {"open", "grass"},
                                                                      {"green", "grass"},
                                                                      {"rocky", "rocks"},
                                                                      {"snowy", "snow"},
                                                                      {"sandy", "sand"},
                                                                      {"cultivated", "farmland"},
                                                                      {"farmed", "farmland"},
                                                                      {"agricultural", "farmland"},
                                                                      {"urban", "houses"},
                                                                      {"built", "houses"},
                                                                      {"residential", "houses"},
                                                                      {"flooded", "water"},
                                                                      {"barren", "barren land"}};
  for (const auto& [said, land] : kLands)
    if (said == adjective) return land;
  return "";
}

namespace {

bool IsArticle(std::string_view word) {
  return IsOneOf(word, {"the", "a", "an", "some", "this", "that", "its", "their", "these", "those",
                        "two", "three", "four", "several", "many", "one", "both", "another"});
}

// "patch" of "a patch of forest".
bool IsPatch(std::string_view word) {
  return IsOneOf(word,
                 {"patch", "patches", "strip",   "strips",   "belt",  "belts",  "band", "bands",
                  "row",   "rows",    "line",    "ring",     "group", "groups", "wall", "area",
                  "areas", "stretch", "cluster", "clusters", "piece", "pieces", "bit",  "clump"});
}

// What stands in no noun phrase.
bool IsJoint(std::string_view word) {
  return IsOneOf(word,
                 {"in",    "on",   "at",    "by",   "to",   "and",     "or",    "with", "from",
                  "which", "who",  "no",    "not",  "but",  "between", "into",  "than", "as",
                  "has",   "only", "where", "near", "next", "whose",   "along", "runs", "it",
                  "off",   "so",   "then",  "per",  "all",  "every",   "each",  "other"});
}

bool IsBeing(std::string_view word) {
  return IsOneOf(
      word, {"is",    "are",    "be",   "lies",  "lie",  "stands",  "stand",  "sits",     "sit",
             "there", "should", "must", "shall", "will", "located", "placed", "situated", "find",
             "you",   "built",  "put",  "comes", "have", "i",       "want",   "we"});
}

}  // namespace

std::size_t PhraseEnd(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"it", "them"})) return at + 1;
  std::size_t next = at;
  while (next < at + 2 && IsArticle(WordAt(tokens, next))) ++next;
  constexpr std::size_t kLongest = 4;  // "a narrow belt of trees"
  for (std::size_t i = next; i < next + kLongest && !IsPauseAt(tokens, i); ++i) {
    const std::size_t length = MatchClassWord(tokens, i).tokens;
    if (length > 0) return i + length;
    const std::string_view word = WordAt(tokens, i);
    if (word == "of" && !IsPatch(i > 0 ? WordAt(tokens, i - 1) : "")) return at;
    if (IsArticle(word) || IsBeing(word) || IsJoint(word)) return at;
  }
  return at;
}

std::size_t PhraseBegin(const std::vector<Token>& tokens, std::size_t end) {
  if (end > 0 && IsOneOf(WordAt(tokens, end - 1), {"it", "them"})) return end - 1;
  constexpr std::size_t kLongest = 6;
  std::size_t begin = end;
  for (std::size_t i = end; i > 0 && i + kLongest > end && !IsPauseAt(tokens, i - 1); --i) {
    if (PhraseEnd(tokens, i - 1) != end) {
      if (begin < end) break;
      continue;
    }
    // Words without an article before them may belong to what stands before.
    const bool noun = MatchClassWord(tokens, i - 1).tokens > 0;
    const bool word = IsArticle(WordAt(tokens, i - 1)) || IsSize(WordAt(tokens, i - 1)) ||
                      IsPatch(WordAt(tokens, i - 1)) ||
                      !LandOfAdjective(WordAt(tokens, i - 1)).empty();
    const bool owned = i > 1 && IsArticle(WordAt(tokens, i - 2));
    if (noun || word || owned || WordAt(tokens, i - 1) == "of") begin = i - 1;
    if (begin != i - 1) break;
  }
  return begin;
}

const ClassWord* NounBefore(const std::vector<Token>& tokens, std::size_t end) {
  constexpr std::size_t kLongest = 3;
  for (std::size_t length = kLongest; length > 0; --length) {
    if (length > end) continue;
    const ClassWordMatch noun = MatchClassWord(tokens, end - length);
    if (noun.tokens == length) return noun.word;
  }
  return nullptr;
}

std::size_t SkipBeing(const std::vector<Token>& tokens, std::size_t at) {
  while (IsBeing(WordAt(tokens, at))) ++at;
  return at;
}

std::size_t BeingBegin(const std::vector<Token>& tokens, std::size_t end) {
  while (end > 0 && IsBeing(WordAt(tokens, end - 1))) --end;
  return end;
}

}  // namespace latticeworld
