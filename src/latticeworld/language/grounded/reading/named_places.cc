#include "latticeworld/language/grounded/reading/named_places.h"

#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsPlaceNoun(std::string_view word) {
  return IsOneOf(word, {"quarter", "corner", "half", "quadrant", "side", "edge", "third"});
}

// "houses only in that quarter": in the one that was named last.
void NameThatPlace(std::vector<Token>* tokens) {
  std::string noun;
  std::vector<std::string> named;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    PlaceCursor cursor(*tokens, at);
    const Direction direction = TakeDirection(&cursor);
    if (direction.found && IsPlaceNoun(WordAt(*tokens, cursor.at()))) {
      noun = WordAt(*tokens, cursor.at());
      named.clear();
      for (std::size_t i = at; i < cursor.at(); ++i) named.push_back((*tokens)[i].text);
      at = cursor.at();
      continue;
    }
    if (named.empty()) continue;
    std::size_t next = at;
    if (IsOneOf(WordAt(*tokens, at), {"that", "this"})) {
      ++next;
    } else if (WordAt(*tokens, at) == "the" && WordAt(*tokens, at + 1) == "same") {
      next += 2;
    } else {
      continue;
    }
    const bool after = at > 0 && IsOneOf(WordAt(*tokens, at - 1),
                                         {"in", "on", "to", "within", "at", "inside", "into"});
    if (!after || WordAt(*tokens, next) != noun) continue;
    std::vector<std::string_view> words = {"the"};
    for (const std::string& word : named) words.push_back(word);
    ReplaceTokens(tokens, at, next - at, words);
    at += words.size();
  }
}

// Items of a numbered list by their numbers: "between 1 and 2".
void NameItems(std::vector<Token>* tokens) {
  std::map<int, std::string> items;
  int item = 0;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const Token& token = (*tokens)[at];
    if (token.kind == TokenKind::kStop && std::atoi(token.text.c_str()) > 0) {
      item = std::atoi(token.text.c_str());
      continue;
    }
    if (item > 0 && items.count(item) == 0) {
      const ClassWordMatch match = MatchClassWord(*tokens, at);
      if (match.word != nullptr) items[item] = JoinWords(*tokens, at, at + match.tokens);
    }
  }
  if (items.size() < 2) return;
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const Token& token = (*tokens)[at];
    if (token.kind != TokenKind::kNumber) continue;
    const auto named = items.find(std::atoi(token.text.c_str()));
    const bool after = IsOneOf(WordAt(*tokens, at - 1), {"between", "and", "from", "to", "of",
                                                         "near", "number", "no", "item", "with"});
    const bool alone = IsPauseAt(*tokens, at + 1) ||
                       IsOneOf(WordAt(*tokens, at + 1), {"and", "to", "with", "by", "in"});
    if (named == items.end() || !after || !alone) continue;
    std::vector<std::string_view> words = {"the"};
    const std::vector<Token> name = Tokenize(named->second);
    for (const Token& word : name) words.push_back(word.text);
    ReplaceTokens(tokens, at, 1, words);
  }
}

// "on your left": on the left. "In front we see fields": in the foreground. "where it starts is the
// left side": it starts there. "in the middle of everything": of the map.
void NameSides(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const std::string_view word = WordAt(*tokens, at);
    if (IsOneOf(word, {"your", "my", "our"}) &&
        IsOneOf(WordAt(*tokens, at + 1), {"left", "right"})) {
      (*tokens)[at].text = "the";
    }
    const bool begins = IsPauseAt(*tokens, at - 1) || at == 0;
    const bool we = IsOneOf(WordAt(*tokens, at + 2),
                            {"we", "you", "i", "there", "lie", "lies", "are", "is", "a", "the"});
    if (begins && word == "in" && WordAt(*tokens, at + 1) == "front" && we) {
      ReplaceTokens(tokens, at, 2, {"in", "the", "foreground"});
    }
    if (word == "where" && WordAt(*tokens, at + 1) == "it") {
      const std::string_view verb = WordAt(*tokens, at + 2);
      const bool starts = IsOneOf(verb, {"starts", "begins", "comes"});
      const bool ends = IsOneOf(verb, {"ends", "stops", "finishes"});
      if ((starts || ends) && IsOneOf(WordAt(*tokens, at + 3), {"is", "should"})) {
        const std::size_t count = WordAt(*tokens, at + 4) == "be" ? 5 : 4;
        ReplaceTokens(tokens, at, count, {"it", starts ? "starts" : "ends", "at"});
      }
    }
    if (IsOneOf(word, {"middle", "center", "centre", "heart"}) && WordAt(*tokens, at + 1) == "of" &&
        IsOneOf(WordAt(*tokens, at + 2), {"everything", "all"}) &&
        MatchClassWord(*tokens, at + 3).word == nullptr && WordAt(*tokens, at + 3) != "the" &&
        WordAt(*tokens, at + 3) != "of") {
      ReplaceTokens(tokens, at + 2, 1, {"the", "map"});
    }
  }
}

// The bay that "opens to the west" lies at that edge.
void NameMouths(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"opens", "opening", "open"})) continue;
    std::size_t owner = at - 1;
    if (owner > 0 && IsOneOf(WordAt(*tokens, owner), {"that", "which", "is"})) --owner;
    if (!IsOneOf(WordAt(*tokens, owner), {"bay", "fjord", "inlet", "gulf", "cove", "sound"}) ||
        !IsOneOf(WordAt(*tokens, at + 1), {"to", "toward", "towards"})) {
      continue;
    }
    const std::size_t side = at + (WordAt(*tokens, at + 2) == "the" ? 3 : 2);
    PlaceCursor cursor(*tokens, side);
    if (!TakeDirection(&cursor).found || IsPlaceNoun(WordAt(*tokens, cursor.at()))) continue;
    const std::size_t end = cursor.at();
    InsertTokens(tokens, end, {WordLike("edge", (*tokens)[end - 1])});
    ReplaceTokens(tokens, at, side - at, {"lies", "at", "the"});
  }
}

// "white in the upper left, grey below it, a blue patch": the classes that a map paints so.
void NameColors(std::vector<Token>* tokens) {
  constexpr std::pair<std::string_view, std::string_view> kColors[] = {
      {"white", "snow"}, {"blue", "water"},        {"green", "forest"}, {"grey", "rock"},
      {"gray", "rock"},  {"brown", "bare ground"}, {"yellow", "sand"}};
  int colors = 0;
  std::vector<std::pair<std::size_t, std::string_view>> found;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    for (const auto& [color, noun] : kColors) {
      if (WordAt(*tokens, at) != color) continue;
      const bool begins =
          at == 0 || IsPauseAt(*tokens, at - 1) ||
          IsOneOf(WordAt(*tokens, at - 1), {"and", "a", "some", "the", "then", "by"});
      const bool patch =
          IsOneOf(WordAt(*tokens, at + 1), {"patch", "sliver", "blob", "spot", "stripe", "band",
                                            "area", "ribbon", "dot", "line", "strip", "part"});
      const bool stands = IsPauseAt(*tokens, at + 1) ||
                          IsOneOf(WordAt(*tokens, at + 1),
                                  {"in", "at", "on", "below", "above", "to", "covering", "covers",
                                   "everywhere", "along", "around", "between", "all", "for"});
      if (!begins || !(patch || stands)) continue;
      found.push_back({at, noun});
      ++colors;
    }
  }
  if (colors < 2) return;
  for (std::size_t i = found.size(); i-- > 0;) {
    const auto [at, noun] = found[i];
    const std::vector<Token> words = Tokenize(noun);
    std::vector<std::string_view> names;
    for (const Token& word : words) names.push_back(word.text);
    ReplaceTokens(tokens, at, 1, names);
  }
}

}  // namespace

std::vector<Token> WithNamedPlaces(std::vector<Token> tokens) {
  NameItems(&tokens);
  NameSides(&tokens);
  NameMouths(&tokens);
  NameColors(&tokens);
  NameThatPlace(&tokens);
  return tokens;
}

}  // namespace latticeworld
