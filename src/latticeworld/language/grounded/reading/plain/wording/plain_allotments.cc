#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Shares of a part of the map, which the reader counts in the whole of it.
namespace latticeworld {
namespace {

// "The eastern half", "the left third": what part of the map that is, and where its words end.
struct PartOfMap {
  double share = 0.0;
  std::size_t end = 0;  // 0: no such part
};

PartOfMap TakePart(const std::vector<Token>& tokens, std::size_t at) {
  PartOfMap part;
  if (WordAt(tokens, at) != "the") return part;
  PlaceCursor cursor(tokens, at + 1);
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found || direction.center || direction.heading.IsDiagonal()) return part;
  const std::string_view noun = WordAt(tokens, cursor.at());
  if (noun == "half") part.share = 0.5;
  if (noun == "third") part.share = 1.0 / 3.0;
  if (noun == "quarter") part.share = 0.25;
  if (part.share > 0.0) part.end = cursor.at() + 1;
  return part;
}

// A share that is a number, "60 percent of", "a third"; 0: none starts here.
double TakeNumber(const std::vector<Token>& tokens, std::size_t at, std::size_t* end) {
  const ShareMatch share = MatchShare(tokens, at);
  if (share.tokens == 0 || !share.fraction) return 0.0;
  *end = at + share.tokens;
  return share.value;
}

std::string PercentOf(double share) { return std::to_string(std::lround(share * 100.0)); }

bool IsBeing(std::string_view word) {
  return IsOneOf(word, {"is", "are", "be", "should", "must", "shall", "will", "consists", "of"});
}

struct Allotted {
  std::size_t begin, end;  // of its noun and what stands before it
  double share;
  std::string bound = {};  // "at least ", "at most "
};

// The bound that stands at `at`, where a share does.
std::string BoundAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) == "at" && IsOneOf(WordAt(tokens, at + 1), {"least", "most"}))
    return JoinWords(tokens, at, at + 2) + " ";
  if (IsOneOf(WordAt(tokens, at), {"more", "less"}) && WordAt(tokens, at + 1) == "than")
    return WordAt(tokens, at) == "more" ? "at least " : "at most ";
  return "";
}

// "A third forest, a third grass and a third houses" from `at` to a stop; nothing: no such list.
std::vector<Allotted> TakeShareList(const std::vector<Token>& tokens, std::size_t at,
                                    std::size_t* end) {
  std::vector<Allotted> list;
  while (!IsStopAt(tokens, at)) {
    std::size_t noun = 0;
    const double share = TakeNumber(tokens, at, &noun);
    if (share == 0.0) break;
    while (IsBeing(WordAt(tokens, noun))) ++noun;
    const std::size_t noun_end = noun + MatchClassWord(tokens, noun).tokens;
    if (noun_end == noun) break;
    list.push_back({noun, noun_end, share, BoundAt(tokens, at)});
    *end = at = noun_end;
    if (IsMark(tokens, at)) ++at;
    if (WordAt(tokens, at) == "and") ++at;
    if (at == noun_end) break;
  }
  return list;
}

// "Farmland, grass and houses": no shares.
std::vector<Allotted> TakeNouns(const std::vector<Token>& tokens, std::size_t at,
                                std::size_t* end) {
  std::vector<Allotted> list;
  while (!IsStopAt(tokens, at)) {
    const std::size_t noun_end = at + MatchClassWord(tokens, at).tokens;
    if (noun_end == at) break;
    list.push_back({at, noun_end, 0.0, ""});
    *end = at = noun_end;
    if (IsMark(tokens, at)) ++at;
    if (WordAt(tokens, at) == "and") ++at;
    if (at == noun_end) break;
  }
  return list;
}

// "Farmland, grass and houses, roughly a third each", "forest and field in equal parts": the share
// of each.
std::vector<Allotted> TakeEqualList(const std::vector<Token>& tokens, std::size_t at,
                                    std::size_t* end) {
  std::vector<Allotted> list = TakeNouns(tokens, at, &at);
  if (list.size() < 2) return {};
  if (IsMark(tokens, at)) ++at;
  bool equal = false;
  std::size_t last = at;
  for (; !IsPauseAt(tokens, last); ++last)
    equal = equal || IsOneOf(WordAt(tokens, last), {"each", "equal", "equally"});
  if (!equal) return {};
  for (Allotted& allotted : list) allotted.share = 1.0 / static_cast<double>(list.size());
  *end = last;
  return list;
}

// "..., the remainder is meadow" after such a list: what it leaves of the part.
void TakeRemainder(const std::vector<Token>& tokens, std::vector<Allotted>* list,
                   std::size_t* end) {
  std::size_t at = *end;
  if (!IsMark(tokens, at) && WordAt(tokens, at) != "and") return;
  while (IsMark(tokens, at) || IsOneOf(WordAt(tokens, at), {"and", "the"})) ++at;
  if (!IsOneOf(WordAt(tokens, at), {"rest", "remainder", "remaining"})) return;
  ++at;
  if (WordAt(tokens, at) == "of" && IsOneOf(WordAt(tokens, at + 1), {"it", "that"})) at += 2;
  while (IsBeing(WordAt(tokens, at))) ++at;
  const std::size_t noun_end = at + MatchClassWord(tokens, at).tokens;
  double left = 1.0;
  for (const Allotted& allotted : *list) left -= allotted.share;
  if (noun_end == at || !IsPauseAt(tokens, noun_end) || left <= 0.02) return;
  list->push_back({at, noun_end, left, ""});
  *end = noun_end;
}

// "In the eastern half there is 33 percent farmland and 33 percent grass".
void PutAllotted(std::vector<Token>* tokens, std::size_t begin, std::size_t end,
                 const std::vector<Token>& place, const std::vector<Allotted>& list) {
  const Token beside = (*tokens)[begin];
  std::vector<Token> said = SaidLike("in", beside);
  for (const Token& token : place) said.push_back(token);
  for (const Token& token : SaidLike("there is", beside)) said.push_back(token);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) said.push_back(CommaLike(beside));
    const std::string percent = list[i].bound + PercentOf(list[i].share) + " percent";
    for (const Token& token : SaidLike(percent, beside)) said.push_back(token);
    for (const Token& token : TokensBetween(*tokens, list[i].begin, list[i].end))
      said.push_back(token);
  }
  EraseTokens(tokens, begin, end - begin);
  InsertTokens(tokens, begin, said);
}

// "The eastern half is a third forest, a third grass and a third houses", "in the eastern half, 60
// percent is forest", "the western half should be forest and grass in equal parts": each covers its
// share of the half.
void TurnSharedPart(std::vector<Token>* tokens, std::size_t at) {
  const PartOfMap part = TakePart(*tokens, at);
  if (part.end == 0) return;
  const bool in = at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"in", "of"});
  const std::size_t begin = at - (in ? 1 : 0);
  if (begin > 0 && !IsPauseAt(*tokens, begin - 1) && WordAt(*tokens, begin - 1) != "and") return;
  std::size_t next = part.end;
  if (WordAt(*tokens, next) == "of" && WordAt(*tokens, next + 1) == "the" &&
      IsMapWord(WordAt(*tokens, next + 2))) {
    next += 3;
  }
  const std::size_t verb = next;
  if (in && IsMark(*tokens, next)) ++next;
  while (IsBeing(WordAt(*tokens, next))) ++next;
  if (!in && next == verb) return;
  std::size_t end = 0;
  std::vector<Allotted> list = TakeShareList(*tokens, next, &end);
  if (list.empty()) list = TakeEqualList(*tokens, next, &end);
  if (list.empty()) return;
  TakeRemainder(*tokens, &list, &end);
  PutAllotted(tokens, begin, end, TokensBetween(*tokens, at, part.end), list);
}

// "Forest covers 60 percent of the eastern half", "60 percent of the eastern half is forest": in
// the eastern half there is 60 percent forest.
void TurnShareOfPart(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !SideWord(WordAt(*tokens, at - 1)).empty()) return;
  std::size_t the = 0;
  const double share = TakeNumber(*tokens, at, &the);
  if (share == 0.0) return;
  if (WordAt(*tokens, the) == "of") ++the;
  const PartOfMap part = TakePart(*tokens, the);
  if (part.end == 0 || WordAt(*tokens, the - 1) != "of") return;
  const std::vector<Token> place = TokensBetween(*tokens, the, part.end);
  std::size_t noun = part.end;
  while (IsBeing(WordAt(*tokens, noun)) ||
         IsOneOf(WordAt(*tokens, noun), {"covered", "with", "by", "in"})) {
    ++noun;
  }
  const std::size_t noun_end = noun + MatchClassWord(*tokens, noun).tokens;
  if (noun > part.end && noun_end > noun) {
    std::vector<Allotted> list = {{noun, noun_end, share, BoundAt(*tokens, at)}};
    std::size_t end = noun_end;
    TakeRemainder(*tokens, &list, &end);
    PutAllotted(tokens, at, end, place, list);
    return;
  }
  if (noun != part.end || !IsPauseAt(*tokens, noun)) return;
  std::size_t verb = at;
  while (verb > 0 && IsOneOf(WordAt(*tokens, verb - 1),
                             {"covers", "cover", "covering", "fills", "fill", "occupies", "takes",
                              "take", "up", "should", "must", "makes", "make"})) {
    --verb;
  }
  if (verb == at) return;
  // "Forest covers" is no noun here, though "forest cover" is one.
  std::size_t subject = verb;
  for (std::size_t i = verb; i-- > 0 && i + 4 > verb;)
    if (i + MatchClassWord(*tokens, i).tokens >= verb) subject = i;
  if (subject == verb) return;
  const std::vector<Allotted> list = {{subject, verb, share, BoundAt(*tokens, at)}};
  std::size_t begin = subject;
  if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"the", "a"})) --begin;
  PutAllotted(tokens, begin, part.end, place, list);
}

// "The other fifth is half rock and half water": 10 percent of the map is rock, 10 percent water.
void TurnSharedRest(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "the" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"other", "remaining", "last", "final"})) {
    return;
  }
  constexpr std::pair<std::string_view, double> kParts[] = {
      {"third", 1.0 / 3.0}, {"quarter", 0.25}, {"fifth", 0.2}, {"tenth", 0.1}, {"half", 0.5}};
  double part = 0.0;
  for (const auto& [word, share] : kParts)
    if (WordAt(*tokens, at + 2) == word) part = share;
  std::size_t next = at + 3;
  while (IsBeing(WordAt(*tokens, next))) ++next;
  // "The remaining 30 percent"
  const ShareMatch number = MatchShare(*tokens, at + 2);
  if (part == 0.0 && number.fraction && !number.ordinal) {
    part = number.value;
    next = at + 2 + number.tokens;
    while (IsBeing(WordAt(*tokens, next))) ++next;
  }
  if (part == 0.0 || next == at + 3) return;
  std::size_t end = 0;
  std::vector<Allotted> list = TakeShareList(*tokens, next, &end);
  // "evenly split between fields and grass"
  while (IsOneOf(WordAt(*tokens, next),
                 {"evenly", "equally", "split", "divided", "shared", "between", "into"})) {
    ++next;
  }
  if (list.empty() && WordAt(*tokens, next - 1) == "between") {
    list = TakeNouns(*tokens, next, &end);
    for (Allotted& allotted : list) allotted.share = 1.0 / static_cast<double>(list.size());
  }
  if (list.size() < 2) return;
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  for (const Allotted& allotted : list) {
    if (!said.empty()) said.push_back(WordLike("and", beside));
    const std::string percent = PercentOf(part * allotted.share) + " percent of the map is";
    for (const Token& token : SaidLike(percent, beside)) said.push_back(token);
    for (const Token& token : TokensBetween(*tokens, allotted.begin, allotted.end))
      said.push_back(token);
  }
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

// "A quarter of the map is water and a tenth is houses": a tenth of the map.
void TurnBareShare(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || (WordAt(*tokens, at - 1) != "and" && !IsMark(*tokens, at - 1))) return;
  std::size_t next = 0;
  if (TakeNumber(*tokens, at, &next) == 0.0 || WordAt(*tokens, next - 1) == "of") return;
  if (!IsOneOf(WordAt(*tokens, next), {"is", "are"}) ||
      MatchClassWord(*tokens, next + 1).tokens == 0) {
    return;
  }
  bool map = false;
  for (std::size_t i = at; i-- > 0 && !IsStopAt(*tokens, i);)
    map = map || (WordAt(*tokens, i) == "of" && IsMapWord(WordAt(*tokens, i + 2)));
  if (!map) return;
  InsertTokens(tokens, next, SaidLike("of the map", (*tokens)[at]));
}

// "The right half is split between a field at the top and a lake at the bottom": the upper right
// quarter is field and the lower right quarter is lake.
void TurnSplitHalf(std::vector<Token>* tokens, std::size_t at) {
  const PartOfMap part = TakePart(*tokens, at);
  if (part.end == 0 || part.share != 0.5) return;
  // "The right half is split between"
  const std::string half(SideWord(WordAt(*tokens, at + 1)));
  std::size_t next = part.end;
  while (IsBeing(WordAt(*tokens, next)) ||
         IsOneOf(WordAt(*tokens, next), {"split", "divided", "evenly", "equally", "shared"})) {
    ++next;
  }
  if (!IsOneOf(WordAt(*tokens, next), {"between", "into"}) || next == part.end) return;
  // "a field at the top and a lake at the bottom"
  struct Quarter {
    std::size_t begin, end;
    std::string side;
  };
  std::vector<Quarter> quarters;
  ++next;
  while (quarters.size() < 2) {
    if (IsOneOf(WordAt(*tokens, next), {"a", "an", "the"})) ++next;
    const std::size_t noun_end = next + MatchClassWord(*tokens, next).tokens;
    std::size_t side = noun_end;
    while (IsOneOf(WordAt(*tokens, side), {"at", "on", "in", "to", "the"})) ++side;
    const std::string word(SideWord(WordAt(*tokens, side)));
    if (noun_end == next || side == noun_end || word.empty()) return;
    quarters.push_back({next, noun_end, word});
    next = side + 1;
    if (quarters.size() == 1 && WordAt(*tokens, next++) != "and") return;
  }
  // Each becomes a quarter, if its side lies across the half.
  const bool rows = half == "north" || half == "south";
  std::vector<Token> said;
  for (const Quarter& quarter : quarters) {
    const bool across = quarter.side == "north" || quarter.side == "south";
    if (half.empty() || rows == across) return;
    const std::string corner = rows ? half + quarter.side : quarter.side + half;
    if (!said.empty()) said.push_back(WordLike("and", (*tokens)[at]));
    for (const Token& token : SaidLike("the " + corner + " quarter is", (*tokens)[at]))
      said.push_back(token);
    for (const Token& token : TokensBetween(*tokens, quarter.begin, quarter.end))
      said.push_back(token);
  }
  EraseTokens(tokens, at, next - at);
  InsertTokens(tokens, at, said);
}

// "Split the map in half vertically: left forest, right water": the left half is forest.
void TurnHalvesLabelled(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || (*tokens)[at].text != ":") return;
  const auto label = [&](std::size_t i) {
    const bool side = !SideWord(WordAt(*tokens, i)).empty();
    return side && MatchClassWord(*tokens, i + 1).tokens > 0;
  };
  std::size_t second = at + 2 + MatchClassWord(*tokens, at + 2).tokens;
  if (!label(at + 1) || !IsMark(*tokens, second) || !label(second + 1)) return;
  bool half = false;
  for (std::size_t i = at; i-- > 0 && !IsStopAt(*tokens, i);)
    half = half || IsOneOf(WordAt(*tokens, i), {"half", "two", "halves"});
  if (!half ||
      OppositeOf(SideWord(WordAt(*tokens, at + 1))) != SideWord(WordAt(*tokens, second + 1))) {
    return;
  }
  for (const std::size_t side : {second + 1, at + 1}) {
    InsertTokens(tokens, side + 1, SaidLike("half is", (*tokens)[at]));
    InsertTokens(tokens, side, SaidLike("the", (*tokens)[at]));
  }
  std::size_t begin = SentenceBegin(*tokens, at);
  EraseTokens(tokens, begin, at + 1 - begin);
}

}  // namespace

void TurnAllotments(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnSharedPart(tokens, at);
    TurnShareOfPart(tokens, at);
    TurnSharedRest(tokens, at);
    TurnBareShare(tokens, at);
    TurnSplitHalf(tokens, at);
    TurnHalvesLabelled(tokens, at);
  }
}

}  // namespace latticeworld
