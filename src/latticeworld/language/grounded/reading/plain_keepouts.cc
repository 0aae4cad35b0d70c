#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain_turns.h"
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
  const std::size_t end = PastThing(*tokens, next + 2);
  if (end == 0) return;
  const std::size_t noun = PastArticle(*tokens, next + 2);
  const std::string said = "the " + JoinWords(*tokens, noun, end) + " not next to the " + owner;
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, SaidLike(said, beside));
}

// "No houses should be near it", "do not put any water near it": the houses not near it.
void TurnNoneNearIt(std::vector<Token>* tokens, std::size_t at) {
  std::size_t begin = at, noun = at + 1;
  if (WordAt(*tokens, at) == "not") {
    if (at == 0 || WordAt(*tokens, at - 1) != "do" ||
        !IsOneOf(WordAt(*tokens, at + 1), {"put", "place", "build", "add", "draw", "plant"})) {
      return;
    }
    --begin;
    noun = at + 2;
    if (WordAt(*tokens, noun) == "any") ++noun;
  } else if (WordAt(*tokens, at) != "no") {
    return;
  }
  const std::size_t length = MatchClassWord(*tokens, noun).tokens;
  std::size_t near = noun + length;
  while (IsOneOf(WordAt(*tokens, near), {"should", "may", "must", "can", "be", "stand", "lie",
                                         "built", "are", "is", "placed"})) {
    ++near;
  }
  const bool close =
      WordAt(*tokens, near) == "near" || WordAt(*tokens, near) == "beside" ||
      (IsOneOf(WordAt(*tokens, near), {"next", "close"}) && WordAt(*tokens, near + 1) == "to");
  const std::size_t it = near + (WordAt(*tokens, near + 1) == "to" ? 2 : 1);
  if (length == 0 || !close || !IsOneOf(WordAt(*tokens, it), {"it", "them"}) ||
      !IsPauseAt(*tokens, it + 1) || NamedBefore(*tokens, begin).empty()) {
    return;
  }
  if (begin > 1 && IsOneOf(WordAt(*tokens, begin - 1), {"is", "are"}) &&
      WordAt(*tokens, begin - 2) == "there") {
    begin -= 2;
  }
  const bool with = begin > 0 && WordAt(*tokens, begin - 1) == "with";
  if (with) --begin;
  const bool stop = begin == 0 || IsPauseAt(*tokens, begin - 1);
  ReplaceTokens(tokens, near, it - near, {"not", "close", "to"});
  EraseTokens(tokens, noun + length, near - noun - length);
  const Token beside = (*tokens)[begin];
  const bool linked = begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"and", "but"});
  if (linked) --begin;
  EraseTokens(tokens, begin, noun - begin);
  InsertTokens(tokens, begin, SaidLike("the", beside));
  if (linked || !stop) InsertTokens(tokens, begin, {StopLike(beside)});
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
