#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/lexeme.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// What links things, and what the land turns into.
namespace latticeworld {
namespace {

// The nouns of different things in tokens [begin, end) that are no lines.
std::vector<std::vector<Token>> ThingsIn(const std::vector<Token>& tokens, std::size_t begin,
                                         std::size_t end) {
  std::vector<std::vector<Token>> things;
  std::vector<const ClassWord*> known;
  for (std::size_t at = begin; at < end; ++at) {
    const ClassWordMatch match = MatchClassWord(tokens, at);
    if (match.word == nullptr) continue;
    if (!match.is_line() && std::find(known.begin(), known.end(), match.word) == known.end()) {
      known.push_back(match.word);
      things.push_back(TokensBetween(tokens, at, at + match.tokens));
    }
    at += match.tokens - 1;
  }
  return things;
}

// "A village in each corner and a lake in the middle, connected by roads": roads connect the
// village and the lake.
void TurnLinks(std::vector<Token>* tokens) {
  for (std::size_t at = 2; at + 2 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"connected", "joined", "linked"})) continue;
    // "connected to each other by"
    std::size_t next = at + 1;
    while (IsOneOf(WordAt(*tokens, next),
                   {"up", "together", "to", "each", "other", "one", "another", "with"})) {
      ++next;
    }
    if (WordAt(*tokens, next) != "by") continue;
    ++next;
    // A kind of line must end the sentence.
    std::size_t noun = next;
    while (noun < next + 4 && !IsPauseAt(*tokens, noun) &&
           MatchClassWord(*tokens, noun).word == nullptr) {
      ++noun;
    }
    const ClassWordMatch line = MatchClassWord(*tokens, noun);
    if (!line.is_line()) continue;
    const std::size_t end = noun + line.tokens;
    if (!IsStopAt(*tokens, end)) continue;
    // The sentence must name two things or more before.
    std::size_t first = at;
    while (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"all", "and", "both"})) --first;
    if (first == 0 || !IsMark(*tokens, first - 1)) continue;
    --first;
    std::size_t begin = first;
    while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
    const std::vector<std::vector<Token>> things = ThingsIn(*tokens, begin, first);
    if (things.size() < 2) continue;
    // A sentence says that the lines connect them.
    const Token beside = (*tokens)[at];
    const std::vector<Token> links = TokensBetween(*tokens, next, next + end - next);
    std::vector<Token> turned = {{TokenKind::kStop, ".", beside.begin, beside.begin}};
    turned.insert(turned.end(), links.begin(), links.end());
    turned.push_back(WordLike(line.plural ? "connect" : "connects", beside));
    for (std::size_t i = 0; i < things.size(); ++i) {
      if (i > 0) turned.push_back(WordLike("and", beside));
      turned.push_back(WordLike("the", beside));
      for (const Token& token : things[i]) turned.push_back(WordLike(token.text, beside));
    }
    EraseTokens(tokens, first, end - first);
    InsertTokens(tokens, first, turned);
    at = first + turned.size();
  }
}

// The land that a comparative tells: "sandier" is sand; "": none known.
std::string_view LandOf(std::string_view word) {
  if (IsOneOf(word, {"sandier", "dustier"})) return "sand";
  if (IsOneOf(word, {"snowier", "icier"})) return "snow";
  if (IsOneOf(word, {"rockier", "stonier"})) return "rocks";
  if (IsOneOf(word, {"grassier"})) return "grass";
  if (IsOneOf(word, {"woodier", "leafier"})) return "woods";
  return {};
}

// "it gets sandier towards the north": there is sand in the north. What a word like "greener" makes
// of the land is not known; it says nothing of what "it" is.
void TurnMoods(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 4 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"gets", "becomes", "grows", "turns", "get", "getting",
                                       "becoming", "growing", "turning"})) {
      continue;
    }
    // "it gets", "the land is becoming", "more"
    std::size_t first = at;
    if (first > 0 && WordAt(*tokens, first - 1) == "is") --first;
    const std::string_view before = first > 0 ? WordAt(*tokens, first - 1) : std::string_view();
    std::size_t word = at + 1;
    const bool more = IsOneOf(WordAt(*tokens, word),
                              {"more", "less", "ever", "gradually", "slowly", "increasingly", "a"});
    if (more) ++word;
    if (before == "it" || IsMapWord(before) || IsOneOf(before, {"land", "country", "everything"})) {
      --first;
      if (first > 0 && WordAt(*tokens, first - 1) == "the") --first;
    } else if (first == 0 || !IsPauseAt(*tokens, first - 1)) {
      continue;
    }
    // "towards the north"
    if (!IsOneOf(WordAt(*tokens, word + 1), {"towards", "toward", "to", "in"})) continue;
    Heading heading;
    std::size_t end = TakeHeading(*tokens, word + 2, &heading);
    if (end == 0) continue;
    if (IsFlank(WordAt(*tokens, end)) || IsOneOf(WordAt(*tokens, end), {"edge", "corner"})) ++end;
    // A word that is known for its land becomes that land.
    const std::string_view said = WordAt(*tokens, word);
    const Token beside = (*tokens)[word];
    const std::string_view land = LandOf(said);
    if (!land.empty() && !more) {
      ReplaceTokens(tokens, first, word + 2 - first, {"there", "is", land, "in"});
      continue;
    }
    if (said.empty() || MatchClassWord(*tokens, word).word != nullptr ||
        MatchSense(*tokens, word).tokens > 0 || MatchSize(*tokens, word).tokens > 0) {
      continue;
    }
    // Any other word is left alone between stops: it says nothing that is known.
    const Token stop{TokenKind::kStop, ".", beside.begin, beside.begin};
    EraseTokens(tokens, first, end - first);
    if (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"and", "but"})) {
      --first;
      EraseTokens(tokens, first, 1);
    }
    InsertTokens(tokens, first, {stop, beside, stop});
    at = first + 2;
  }
}

// Two words for the sides of things that stand apart: "Forest to the left, fields to the right".
int SidesIn(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
  int sides = 0;
  for (std::size_t at = begin; at < end; ++at) {
    if (!IsOneOf(WordAt(tokens, at), {"in", "to", "on", "at"})) continue;
    Heading heading;
    const std::size_t after = TakeHeading(tokens, at + 1, &heading);
    if (after > 0 && after <= end && WordAt(tokens, after) != "of") ++sides;
  }
  return sides;
}

// "Forest to the left, fields to the right, and a road between them": between the forest and the
// fields.
void TurnThem(std::vector<Token>* tokens) {
  for (std::size_t at = 3; at + 1 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "between") continue;
    std::size_t end = at + 1;
    if (IsOneOf(WordAt(*tokens, end), {"them", "these"})) {
      ++end;
    } else if (WordAt(*tokens, end) == "the" && WordAt(*tokens, end + 1) == "two" &&
               (IsPauseAt(*tokens, end + 2) ||
                IsOneOf(WordAt(*tokens, end + 2), {"there", "is", "a", "runs", "lies"}))) {
      end += 2;
    } else {
      continue;
    }
    // Behind its subject, the noun right before is what lies there.
    std::size_t last = at;
    const bool fronted = IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
    if (!fronted) {
      while (last > 0 && !IsPauseAt(*tokens, last - 1) && WordAt(*tokens, last - 1) != "and" &&
             WordAt(*tokens, last - 1) != "with") {
        --last;
      }
    }
    std::size_t begin = last;
    while (begin > 0 && IsPauseAt(*tokens, begin - 1)) --begin;
    while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
    const std::vector<std::vector<Token>> things = ThingsIn(*tokens, begin, last);
    if (things.size() != 2 || SidesIn(*tokens, begin, last) != 2) continue;
    const Token beside = (*tokens)[at + 1];
    std::vector<Token> turned;
    for (std::size_t i = 0; i < 2; ++i) {
      if (i > 0) turned.push_back(WordLike("and", beside));
      turned.push_back(WordLike("the", beside));
      for (const Token& token : things[i]) turned.push_back(WordLike(token.text, beside));
    }
    if (fronted && !IsPauseAt(*tokens, end) && IsOneOf(WordAt(*tokens, end), {"a", "an", "the"})) {
      turned.push_back(WordLike("there", beside));
      turned.push_back(WordLike("is", beside));
    }
    EraseTokens(tokens, at + 1, end - at - 1);
    InsertTokens(tokens, at + 1, turned);
    at += turned.size();
  }
}

// "A town with a park in its center and fields around it": around the town.
void TurnHosts(std::vector<Token>* tokens) {
  for (std::size_t at = 2; at + 2 < tokens->size(); ++at) {
    const bool core =
        WordAt(*tokens, at) == "in" &&
        ((WordAt(*tokens, at + 1) == "its" && IsCenterWord(WordAt(*tokens, at + 2))) ||
         WordAt(*tokens, at + 1) == "it");
    if (!core) continue;
    std::size_t with = at;
    while (with > 0 && !IsPauseAt(*tokens, with) && WordAt(*tokens, with) != "with") --with;
    if (WordAt(*tokens, with) != "with") continue;
    std::vector<Token> host;
    for (std::size_t i = with; i-- > 0 && !IsPauseAt(*tokens, i) && host.empty();) {
      const ClassWordMatch match = MatchClassWord(*tokens, i);
      if (match.word == nullptr || i + match.tokens != with) continue;
      host = TokensBetween(*tokens, i, i + match.tokens);
    }
    if (host.empty()) continue;
    for (std::size_t i = at + 2; !IsStopAt(*tokens, i); ++i) {
      if (!IsOneOf(WordAt(*tokens, i), {"around", "round"}) || WordAt(*tokens, i + 1) != "it" ||
          !IsPauseAt(*tokens, i + 2)) {
        continue;
      }
      const Token beside = (*tokens)[i + 1];
      EraseTokens(tokens, i + 1, 1);
      std::vector<Token> owner = {WordLike("the", beside)};
      for (const Token& token : host) owner.push_back(WordLike(token.text, beside));
      InsertTokens(tokens, i + 1, owner);
      break;
    }
  }
}

// "A wood in the west that thins out towards the east": it is not in the east.
void TurnFading(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    std::size_t next = at;
    if (IsOneOf(WordAt(*tokens, at), {"thins", "thinning", "thin", "fades", "fading", "peters",
                                      "petering", "dwindles", "dwindling"})) {
      ++next;
      if (IsOneOf(WordAt(*tokens, next), {"out", "away"})) ++next;
    } else if (IsOneOf(WordAt(*tokens, at),
                       {"gets", "getting", "becomes", "becoming", "grows", "growing"}) &&
               IsOneOf(WordAt(*tokens, at + 1), {"thinner", "sparser", "lighter", "scarcer"})) {
      next += 2;
    }
    if (next == at || !IsOneOf(WordAt(*tokens, next), {"to", "towards", "toward", "in"})) continue;
    Heading heading;
    const std::size_t end = TakeHeading(*tokens, next + 1, &heading);
    if (end == 0 || IsFlank(WordAt(*tokens, end))) continue;
    std::size_t first = at;
    while (first > 0 && IsOneOf(WordAt(*tokens, first - 1),
                                {"that", "which", "and", "it", "slowly", "gradually"})) {
      --first;
    }
    EraseTokens(tokens, first, end - first);
    at = first;
  }
}

}  // namespace

void TurnLinked(std::vector<Token>* tokens) {
  TurnLinks(tokens);
  TurnFading(tokens);
  TurnMoods(tokens);
  TurnThem(tokens);
  TurnHosts(tokens);
}

}  // namespace latticeworld
