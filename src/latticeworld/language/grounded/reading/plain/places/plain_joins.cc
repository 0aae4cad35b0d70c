#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// This file rewrites how texts tell where lines meet, and tell of lines that are drawn like
// letters.
namespace latticeworld {
namespace {

bool IsMeeting(std::string_view word) {
  return IsOneOf(word,
                 {"meet", "meets", "cross", "crosses", "intersect", "intersects", "join", "joins"});
}

// A line with or without an article: the tokens of its noun; 0: none. `noun` is where they begin.
std::size_t LineAt(const std::vector<Token>& tokens, std::size_t at, std::size_t* noun) {
  *noun = at + (IsOneOf(WordAt(tokens, at), {"the", "a", "this", "that"}) ? 1 : 0);
  const ClassWordMatch match = MatchClassWord(tokens, *noun);
  return match.word != nullptr && match.word->shape == WordShape::kLine ? match.tokens : 0;
}

// "next to the river and next to the road"
std::vector<Token> NextToBoth(const std::vector<Token>& first, const std::vector<Token>& second,
                              const Token& beside) {
  std::vector<Token> turned;
  for (const std::vector<Token>* line : {&first, &second}) {
    if (!turned.empty()) turned.push_back(WordLike("and", beside));
    for (const std::string_view word : {"next", "to", "the"}) {
      turned.push_back(WordLike(word, beside));
    }
    for (const Token& token : *line) turned.push_back(WordLike(token.text, beside));
  }
  return turned;
}

// "A mill stands where the brook flows into the lake", "right where the sand meets the grass": next
// to both.
void TurnMouth(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 4 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "where" || IsPauseAt(*tokens, at - 1)) continue;
    std::size_t line = 0;
    std::size_t count = LineAt(*tokens, at + 1, &line);
    const bool area = count == 0;
    if (area) count = MatchClassWord(*tokens, line).tokens;
    std::size_t next = line + count;
    const bool meets = IsOneOf(WordAt(*tokens, next), {"meets", "meet", "touches", "joins"});
    const bool flows =
        !area && IsOneOf(WordAt(*tokens, next),
                         {"flows", "runs", "empties", "enters", "reaches", "drains", "leaves"});
    if (count == 0 || (!meets && !flows)) continue;
    if (area && IsOneOf(WordAt(*tokens, at - 1), {"right", "just", "exactly"})) {
      EraseTokens(tokens, --at, 1);
      --line;
      --next;
    }
    ++next;
    if (IsOneOf(WordAt(*tokens, next), {"into", "in"})) ++next;
    if (IsOneOf(WordAt(*tokens, next), {"the", "a"})) ++next;
    const ClassWordMatch lake = MatchClassWord(*tokens, next);
    if (lake.word == nullptr || lake.word->shape == WordShape::kLine) continue;
    const std::size_t end = next + lake.tokens;
    if (!IsPauseAt(*tokens, end)) continue;
    const Token beside = (*tokens)[at];
    std::vector<Token> turned =
        NextToBoth(TokensBetween(*tokens, line, line + count),
                   TokensBetween(*tokens, next, next + lake.tokens), beside);
    turned.push_back({TokenKind::kStop, ".", beside.begin, beside.begin});
    const std::vector<Token> said = TokensBetween(*tokens, at + 1, at + 1 + end - at - 1);
    turned.insert(turned.end(), said.begin(), said.end());
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, turned);
    at += turned.size();
  }
}

// "A village where two roads meet", "a town at the crossing of two roads": next to the road, and
// two roads cross each other.
void TurnPairMeeting(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    std::size_t two = at + 1;
    const bool where = WordAt(*tokens, at) == "where";
    if (!where) {
      if (WordAt(*tokens, at) != "at" || WordAt(*tokens, at + 1) != "the" ||
          !IsOneOf(WordAt(*tokens, at + 2), {"crossing", "junction", "intersection"}) ||
          WordAt(*tokens, at + 3) != "of") {
        continue;
      }
      two = at + 4;
    }
    if (WordAt(*tokens, two) == "the") ++two;
    if (WordAt(*tokens, two) != "two") continue;
    const ClassWordMatch line = MatchClassWord(*tokens, two + 1);
    std::size_t end = two + 1 + line.tokens;
    if (line.word == nullptr || line.word->shape != WordShape::kLine || !line.plural) continue;
    if (where && !IsMeeting(WordAt(*tokens, end))) continue;
    if (where) ++end;
    if (!IsPauseAt(*tokens, end)) continue;
    std::size_t begin = at;
    if (IsOneOf(WordAt(*tokens, begin - 1), {"exactly", "right", "just"})) --begin;
    const Token beside = (*tokens)[at];
    const std::vector<Token> lines = TokensBetween(*tokens, two + 1, two + 1 + line.tokens);
    std::vector<Token> said;
    for (const std::string_view word : {"next", "to", "the"})
      said.push_back(WordLike(word, beside));
    said.insert(said.end(), lines.begin(), lines.end());
    said.push_back({TokenKind::kStop, ".", beside.begin, beside.begin});
    said.push_back(WordLike("two", beside));
    said.insert(said.end(), lines.begin(), lines.end());
    for (const std::string_view word : {"cross", "each", "other"})
      said.push_back(WordLike(word, beside));
    EraseTokens(tokens, begin, end - begin);
    InsertTokens(tokens, begin, said);
    at = begin + said.size();
  }
}

// "A road from north to south and one from east to west": and another.
void TurnOneMore(std::vector<Token>* tokens) {
  bool line = false;
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) line = false;
    const ClassWordMatch match = MatchClassWord(*tokens, at);
    if (match.word != nullptr) {
      line = match.word->shape == WordShape::kLine && !match.plural && at > 0 &&
             IsOneOf(WordAt(*tokens, at - 1), {"a", "straight", "long", "wide", "winding"});
      at += match.tokens - 1;
      continue;
    }
    const bool another = line && at > 0 && WordAt(*tokens, at) == "one" &&
                         WordAt(*tokens, at - 1) == "and" &&
                         IsOneOf(WordAt(*tokens, at + 1), {"from", "running", "going"});
    if (another) (*tokens)[at].text = "another";
  }
}

// "A mill stands where the river and the road cross": next to both, and the one crosses the other.
void TurnNamedMeeting(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 4 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "where") continue;
    std::size_t first = 0;
    const std::size_t first_count = LineAt(*tokens, at + 1, &first);
    if (first_count == 0) continue;
    const std::size_t join = first + first_count;
    const bool both = WordAt(*tokens, join) == "and";
    if (!both && !IsMeeting(WordAt(*tokens, join))) continue;
    std::size_t second = 0;
    const std::size_t second_count = LineAt(*tokens, join + 1, &second);
    if (second_count == 0) continue;
    std::size_t end = second + second_count;
    if (both) {
      if (!IsMeeting(WordAt(*tokens, end))) continue;
      ++end;
    }
    // A place of its own says what stands there; "where X meets Y there is" is read as it is.
    if (!IsPauseAt(*tokens, end) || IsPauseAt(*tokens, at - 1)) continue;
    const Token beside = (*tokens)[at];
    const std::vector<Token> a = TokensBetween(*tokens, first, first + first_count);
    const std::vector<Token> b = TokensBetween(*tokens, second, second + second_count);
    std::vector<Token> turned = NextToBoth(a, b, beside);
    turned.push_back({TokenKind::kStop, ".", beside.begin, beside.begin});
    turned.push_back(WordLike("the", beside));
    turned.insert(turned.end(), a.begin(), a.end());
    turned.push_back(WordLike("crosses", beside));
    turned.push_back(WordLike("the", beside));
    turned.insert(turned.end(), b.begin(), b.end());
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, turned);
    at += turned.size();
  }
}

// "..., a mill where they meet": next to the last two lines that were named.
void TurnMeeting(std::vector<Token>* tokens) {
  std::vector<Token> last;
  std::vector<Token> before;
  std::vector<std::vector<Token>> lands;  // what else was named
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const ClassWordMatch match = MatchClassWord(*tokens, at);
    if (match.word != nullptr) {
      if (match.word->shape == WordShape::kLine) {
        const std::vector<Token> line = TokensBetween(*tokens, at, at + match.tokens);
        if (last.empty() || JoinWords(line, 0, line.size()) != JoinWords(last, 0, last.size())) {
          before = last;
          last = line;
        }
      } else {
        lands.push_back(TokensBetween(*tokens, at, at + match.tokens));
      }
      at += match.tokens - 1;
      continue;
    }
    if (WordAt(*tokens, at) != "where" || at == 0 || IsPauseAt(*tokens, at - 1)) continue;
    std::size_t verb = at + 1;
    if (WordAt(*tokens, verb) == "the" && WordAt(*tokens, verb + 1) == "two") ++verb;
    if (!IsOneOf(WordAt(*tokens, verb), {"they", "these", "those", "both", "two"}) ||
        !IsMeeting(WordAt(*tokens, verb + 1)) || (last.empty() && lands.size() < 3)) {
      continue;
    }
    const std::size_t end = verb + 2;
    const bool place = IsPauseAt(*tokens, end) || IsOneOf(WordAt(*tokens, end), {"and", "but"});
    if (!place) continue;
    const Token beside = (*tokens)[at];
    std::vector<Token> turned;
    if (last.empty()) {
      // "forest and fields, and a village where they meet": between the two.
      std::string_view join = "between";
      for (const std::size_t back : {3, 2}) {
        turned.push_back(WordLike(join, beside));
        turned.push_back(WordLike("the", beside));
        for (const Token& token : lands[lands.size() - back]) {
          turned.push_back(WordLike(token.text, beside));
        }
        join = "and";
      }
    } else if (before.empty()) {
      for (const std::string_view word : {"next", "to", "the"}) {
        turned.push_back(WordLike(word, beside));
      }
      for (const Token& token : last) turned.push_back(WordLike(token.text, beside));
    } else {
      turned = NextToBoth(before, last, beside);
    }
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, turned);
    at += turned.size() - 1;
  }
}

// The strokes of a letter as courses of a line, each "from ... to ..."; empty: none of those known.
std::vector<std::string_view> StrokesOf(std::string_view letter) {
  if (letter == "t") {
    return {"from the left edge to the right edge in the northern third",
            "from the northern third to the bottom edge"};
  }
  if (letter == "x") {
    return {"from the upper left corner to the lower right corner",
            "from the upper right corner to the lower left corner"};
  }
  if (letter == "l") {
    return {"from the upper left corner through the lower left corner to the lower right corner"};
  }
  if (letter == "u") {
    return {"from the upper left corner through the bottom edge to the upper right corner"};
  }
  return {};
}

// The end of a sentence that names nothing further; 0: it does.
std::size_t EndOfDescription(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsPauseAt(tokens, at)) return 0;
  while (!IsStopAt(tokens, at)) {
    const ClassWordMatch match = MatchClassWord(tokens, at);
    if (match.word != nullptr && match.word->shape != WordShape::kLine) return 0;
    ++at;
  }
  return at;
}

// "roads in the shape of an X", "the road forms the letter L": its strokes, where no other words
// tell them.
void TurnLetters(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const std::string letter(WordAt(*tokens, at));
    if (letter.size() != 1 || StrokesOf(letter).empty()) continue;
    const bool named = WordAt(*tokens, at - 1) == "letter";
    std::size_t begin = at - (named ? 1 : 0);
    if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"the", "a", "an", "capital"})) --begin;
    while (begin > 0 &&
           IsOneOf(WordAt(*tokens, begin - 1),
                   {"in", "the", "shape", "form", "of", "like", "as", "shaped", "forming", "forms",
                    "form", "that", "which", "make", "makes", "making", "drawn"})) {
      --begin;
    }
    bool shaped = named || begin + 2 < at;
    // The line that is drawn so stands right before, or after "with" or "of".
    std::size_t line_begin = begin;
    std::size_t line_count = 0;
    std::size_t end = at + 1;
    for (std::size_t i = begin; i-- > 0 && i + 3 >= begin;) {
      const ClassWordMatch match = MatchClassWord(*tokens, i);
      if (match.word == nullptr || match.word->shape != WordShape::kLine ||
          i + match.tokens != begin) {
        continue;
      }
      line_begin = i;
      line_count = match.tokens;
    }
    if (line_count == 0 && IsOneOf(WordAt(*tokens, at + 1), {"of", "with", "from", "out"})) {
      std::size_t thing = at + 2;
      while (IsOneOf(WordAt(*tokens, thing), {"of", "two", "the", "a", "one"})) ++thing;
      const ClassWordMatch match = MatchClassWord(*tokens, thing);
      if (match.word != nullptr && match.word->shape == WordShape::kLine) {
        line_begin = thing;
        line_count = match.tokens;
        end = thing + match.tokens;
        shaped = true;
      }
    }
    if (line_count == 0 || !shaped) continue;
    // "..., open at the top", ": down the left side, then along the bottom": what its strokes say.
    const std::size_t stop = EndOfDescription(*tokens, end);
    if (stop == 0) continue;
    end = stop;
    std::size_t first = line_begin < begin ? line_begin : begin;
    while (first > 0 &&
           IsOneOf(WordAt(*tokens, first - 1), {"the", "a", "two", "one", "some", "draw"})) {
      --first;
    }
    const std::string noun = Singular(JoinWords(*tokens, line_begin, line_begin + line_count));
    // The bar of a T is a highway to what follows, and its stem a street.
    const bool parts = letter == "t" && noun == "road";
    std::string text;
    for (const std::string_view stroke : StrokesOf(letter)) {
      const std::string_view name = !parts         ? std::string_view(noun)
                                    : text.empty() ? std::string_view("highway")
                                                   : std::string_view("street");
      text += text.empty() ? "a " : parts ? " . a " : " . another ";
      text += std::string(name) + " " + std::string(stroke);
    }
    const Token beside = (*tokens)[at];
    std::vector<Token> turned = Tokenize(text);
    for (Token& token : turned) {
      token.begin = beside.begin;
      token.end = beside.end;
    }
    EraseTokens(tokens, first, end - first);
    InsertTokens(tokens, first, turned);
    at = first + turned.size();
    for (std::size_t i = at; parts && i < tokens->size(); ++i) {
      if (WordAt(*tokens, i) == "bar") (*tokens)[i].text = "highway";
      if (WordAt(*tokens, i) == "stem") (*tokens)[i].text = "street";
    }
  }
}

// "a cross of two avenues, reaching every edge": one from side to side, one from top to bottom.
void TurnCrosses(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "cross" || !IsOneOf(WordAt(*tokens, at - 1), {"a", "the", "one"})) {
      continue;
    }
    // "a cross made of two avenues"
    std::size_t next = at + 1;
    while (IsOneOf(WordAt(*tokens, next), {"made", "out", "formed", "drawn"})) ++next;
    if (!IsOneOf(WordAt(*tokens, next), {"of", "from", "by", "with"})) continue;
    ++next;
    if (WordAt(*tokens, next) == "two") ++next;
    const ClassWordMatch match = MatchClassWord(*tokens, next);
    if (match.word == nullptr || match.word->shape != WordShape::kLine) continue;
    const std::string noun = Singular(JoinWords(*tokens, next, next + match.tokens));
    // "reaching every edge of the map"
    std::size_t end = next + match.tokens;
    std::size_t reach = end;
    if (reach < tokens->size() && (*tokens)[reach].kind == TokenKind::kComma) ++reach;
    if (WordAt(*tokens, reach) == "that") ++reach;
    if (IsOneOf(WordAt(*tokens, reach), {"reaching", "reach", "to"}) &&
        IsOneOf(WordAt(*tokens, reach + 1), {"every", "each", "all"})) {
      reach += 2;
      while (IsOneOf(WordAt(*tokens, reach), {"four", "the", "edge", "edges", "border", "borders",
                                              "side", "sides", "of", "map"})) {
        ++reach;
      }
      end = reach;
    }
    // Two lines from edge to edge take their place.
    const Token beside = (*tokens)[at];
    std::vector<Token> turned = Tokenize(noun + " from the left edge to the right edge . another " +
                                         noun + " from the top edge to the bottom edge .");
    for (Token& token : turned) {
      token.begin = beside.begin;
      token.end = beside.end;
    }
    if (IsStopAt(*tokens, end)) turned.pop_back();
    if (end < tokens->size() && (*tokens)[end].kind == TokenKind::kComma) ++end;
    if (WordAt(*tokens, end) == "and") ++end;
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, turned);
    at += turned.size();
  }
}

}  // namespace

void TurnJoins(std::vector<Token>* tokens) {
  TurnOneMore(tokens);
  TurnPairMeeting(tokens);
  TurnMouth(tokens);
  TurnNamedMeeting(tokens);
  TurnMeeting(tokens);
  TurnCrosses(tokens);
  TurnLetters(tokens);
}

}  // namespace latticeworld
