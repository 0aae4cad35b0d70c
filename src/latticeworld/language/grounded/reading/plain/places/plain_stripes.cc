#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/band_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/stripe_items.h"
#include "latticeworld/language/grounded/reading/stripes.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// A map that is cut into numbered or listed parts: each part is named by its band.
namespace latticeworld {
namespace {

bool IsNone(Heading heading) { return heading.east == 0 && heading.south == 0; }
bool IsSame(Heading a, Heading b) { return a.east == b.east && a.south == b.south; }
Heading Opposite(Heading heading) { return {-heading.east, -heading.south}; }

bool HasClass(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (MatchClassWord(tokens, i).word != nullptr) return true;
  }
  return false;
}

bool MayBeginItem(const std::vector<Token>& tokens, std::size_t at) {
  return at == 0 || IsPauseAt(tokens, at - 1) ||
         IsOneOf(WordAt(tokens, at - 1), {"and", "then", "while", "which", "where", "with"});
}

// The numbered parts in the order of the words, each one on from the one before.
std::vector<StripeItem> FindItems(const std::vector<Token>& tokens, const Stripes& stripes) {
  std::vector<StripeItem> items;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (!MayBeginItem(tokens, at)) continue;
    const StripeItem* before = items.empty() ? nullptr : &items.back();
    StripeItem item;
    if (!TakeStripeItem(tokens, at, before, stripes.said, &item)) continue;
    const int known = before == nullptr ? 0 : before->nth;
    if (item.nth == StripeItem::kNext) {
      if (before == nullptr || known < 0) continue;
      item.nth = known > 0 ? known + 1 : static_cast<int>(items.size()) + 1;
    }
    const bool on = item.nth <= 0 || item.nth == static_cast<int>(items.size()) + 1;
    if (!on) {
      if (item.nth != 1) continue;
      items.clear();
    }
    items.push_back(item);
    at = item.body;
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    StripeItem& item = items[i];
    item.end = i + 1 < items.size() ? items[i + 1].begin : StopAfter(tokens, item.body);
    // The signs and words that only part it from the next.
    while (item.end > item.body + 1 &&
           (IsPauseAt(tokens, item.end - 1) ||
            IsOneOf(WordAt(tokens, item.end - 1), {"and", "then", "while", "which", "with"}))) {
      --item.end;
    }
  }
  return items;
}

// "desert at the top": told by its side and not by its turn.
void TakePlaceBehind(const std::vector<Token>& tokens, StripeItem* item) {
  for (std::size_t at = item->body + 1; at < item->end; ++at) {
    if (!IsOneOf(WordAt(tokens, at), {"at", "in", "on", "to"})) continue;
    PlaceCursor cursor(tokens, at + (WordAt(tokens, at + 1) == "the" ? 2 : 1));
    const Direction side = TakeDirection(&cursor);
    if (!side.found || cursor.at() != item->end) continue;
    item->nth = 0;
    item->sided = true;
    item->side = side.heading;
    item->end = at;
    return;
  }
}

// A list right behind the noun: "four columns: snow, rock, grass, forest".
std::vector<StripeItem> FindList(const std::vector<Token>& tokens, const Stripes& stripes,
                                 std::size_t after) {
  constexpr std::size_t kReach = 9;  // words between the noun and the list
  std::size_t at = after;
  while (at < after + kReach && !IsStopAt(tokens, at) && !ClassSoon(tokens, at, 1)) ++at;
  std::size_t first = at;
  while (first > after && !IsPauseAt(tokens, first - 1) && WordAt(tokens, first - 1) != "of") {
    --first;
  }
  if (first == after || !ClassSoon(tokens, first, 4)) return {};
  const bool colon = first > 0 && tokens[first - 1].text == ":";
  std::vector<StripeItem> items;
  while (first < tokens.size()) {
    StripeItem item;
    item.begin = item.body = first;
    std::size_t end = first;
    while (!IsPauseAt(tokens, end) && WordAt(tokens, end) != "and") ++end;
    if (!ClassSoon(tokens, first, 5)) break;
    item.nth = static_cast<int>(items.size()) + 1;
    item.end = end;
    TakePlaceBehind(tokens, &item);
    items.push_back(item);
    if (IsStopAt(tokens, end)) break;
    first = end + 1;
    if (IsOneOf(WordAt(tokens, first), {"and", "then", "finally"})) ++first;
  }
  const int listed = static_cast<int>(items.size());
  const bool whole =
      stripes.count > 0 ? listed == stripes.count : (colon || stripes.equal) && listed >= 3;
  if (!whole) return {};
  return items;
}

// Numbers for the items that have none, and how many stripes there are; false: they do not fit.
bool Resolve(std::vector<StripeItem>* items, Stripes* stripes) {
  int count = stripes->count;
  for (std::size_t i = 0; i < items->size(); ++i) {
    StripeItem& item = (*items)[i];
    if (count == 0) count = item.parts;
    if (!item.sided || IsNone(item.side) || !IsNone(stripes->way)) continue;
    if (item.nth == 1 || (item.nth == 0 && i == 0)) stripes->way = Opposite(item.side);
    if (item.nth == StripeItem::kLast || (item.nth == 0 && i + 1 == items->size())) {
      stripes->way = item.side;
    }
  }
  if (IsNone(stripes->way)) stripes->way = stripes->usual;
  if (IsNone(stripes->way)) stripes->way = {1, 0};
  count = std::max(count, static_cast<int>(items->size()));
  for (const StripeItem& item : *items) count = std::max(count, item.nth);
  if (count < 2 || count > Band::kMost) return false;
  int before = 0;
  for (StripeItem& item : *items) {
    if (item.nth == StripeItem::kLast) item.nth = count;
    if (item.nth == 0) {
      if (IsNone(item.side)) {
        item.nth = (count + 1) / 2;
      } else if (IsSame(item.side, stripes->way)) {
        item.nth = count;
      } else if (IsSame(item.side, Opposite(stripes->way))) {
        item.nth = 1;
      } else {
        return false;
      }
    }
    if (item.nth == before) return false;
    before = item.nth;
  }
  stripes->count = count;
  return true;
}

// "the second of four bands is" and what it holds, in a sentence of its own.
void AppendItem(const std::vector<Token>& tokens, const StripeItem& item, const Stripes& stripes,
                std::vector<Token>* turned) {
  const Token& beside = tokens[item.begin];
  const Band band{item.nth, stripes.count, stripes.way};
  turned->push_back(WordLike("the", beside));
  turned->push_back(WordLike(WordOf(band), beside));
  turned->push_back(WordLike("is", beside));
  bool measured = !stripes.equal;
  for (std::size_t i = item.body; i < item.end; ++i) {
    const ClassWordMatch noun = MatchClassWord(tokens, i);
    turned->push_back(tokens[i]);
    if (measured || noun.word == nullptr) continue;
    measured = true;
    for (std::size_t k = 1; k < noun.tokens; ++k) turned->push_back(tokens[++i]);
    if (noun.word->shape == WordShape::kLine) continue;
    const Token& last = tokens[i];
    turned->push_back({TokenKind::kComma, "(", last.begin, last.end});
    turned->push_back(
        {TokenKind::kNumber, std::to_string(100 / stripes.count), last.begin, last.end});
    turned->push_back(WordLike("percent", last));
    turned->push_back({TokenKind::kComma, ")", last.begin, last.end});
  }
}

// What stands before the first item: without the words for the stripes and the way.
void AppendOpening(const std::vector<Token>& tokens, const Stripes& stripes, std::size_t first,
                   std::vector<Token>* turned) {
  const std::size_t anchor = stripes.said ? stripes.noun : stripes.way_begin;
  const std::size_t begin = SentenceBegin(tokens, std::min(anchor, first));
  const std::size_t end = std::min(first, StopAfter(tokens, anchor));
  for (std::size_t i = 0; i < begin; ++i) turned->push_back(tokens[i]);
  if (HasClass(tokens, begin, end)) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool way = i >= stripes.way_begin && i < stripes.way_end;
      if (!way) turned->push_back(tokens[i]);
    }
  }
  for (std::size_t i = end; i < first; ++i) {
    const bool way = i >= stripes.way_begin && i < stripes.way_end;
    if (!way) turned->push_back(tokens[i]);
  }
}

// "in four steps towards the south-west corner: snow, rock, ...": an order along the diagonal.
bool TurnSlantingSteps(std::vector<Token>* tokens, std::size_t noun) {
  std::size_t at = noun + 1;
  while (IsOneOf(WordAt(*tokens, at), {"down", "towards", "toward", "to", "the"})) ++at;
  PlaceCursor cursor(*tokens, at);
  const Direction goal = TakeDirection(&cursor);
  if (!goal.found || !goal.heading.IsDiagonal()) return false;
  std::size_t end = cursor.at();
  if (IsOneOf(WordAt(*tokens, end), {"corner", "end", "side"})) ++end;
  if (end >= tokens->size() || (*tokens)[end].text != ":" || !ClassSoon(*tokens, end + 1, 4)) {
    return false;
  }
  const std::string_view start = goal.heading.south < 0 ? "south" : "north";
  const std::string_view stop = goal.heading.south < 0 ? "north" : "south";
  const std::string_view first = goal.heading.east < 0 ? "east" : "west";
  const std::string_view last = goal.heading.east < 0 ? "west" : "east";
  const std::size_t begin = SentenceBegin(*tokens, noun);
  if (HasClass(*tokens, begin, end) && WordAt(*tokens, begin) != "from") return false;
  ReplaceTokens(tokens, begin, end - begin, {"from", "the", start, first, "to", "the", stop, last});
  return true;
}

}  // namespace

void TurnStripes(std::vector<Token>* tokens) {
  Stripes stripes = FindStripes(*tokens);
  std::vector<StripeItem> items = FindItems(*tokens, stripes);
  const bool itemized = items.size() >= 2;
  if (!itemized && !stripes.said) return;
  const std::size_t first = itemized ? items.front().begin : stripes.noun;
  const std::size_t begin = SentenceBegin(*tokens, stripes.said ? stripes.noun : first);
  FindWay(*tokens, std::min(begin, SentenceBegin(*tokens, first)),
          itemized ? items.back().end : StopAfter(*tokens, stripes.noun), &stripes);
  if (!itemized) {
    if (TurnSlantingSteps(tokens, stripes.noun)) return;
    items = FindList(*tokens, stripes, stripes.noun + 1);
  }
  if (items.size() < 2) return;
  const bool named =
      std::any_of(items.begin(), items.end(), [](const StripeItem& item) { return item.noun; });
  if (!stripes.said && !named && stripes.way_end == 0) return;
  // "The upper part is snow, the lower part water": sides, which need no numbers.
  const bool sides =
      std::all_of(items.begin(), items.end(), [](const StripeItem& item) { return item.nth == 0; });
  if (!stripes.said && sides && items.size() < 3) return;
  if (stripes.said && stripes.noun > items.front().begin) return;
  if (!Resolve(&items, &stripes)) return;
  // The way may be told behind the last of them.
  StripeItem& last = items.back();
  if (stripes.way_begin > last.body && stripes.way_end <= last.end) last.end = stripes.way_begin;
  std::vector<Token> turned;
  if (stripes.said || stripes.way_end > 0) {
    AppendOpening(*tokens, stripes, items.front().begin, &turned);
  } else {
    turned.assign(tokens->begin(),
                  tokens->begin() + static_cast<std::ptrdiff_t>(items.front().begin));
  }
  for (const StripeItem& item : items) {
    const std::size_t at = (*tokens)[item.begin].begin;
    if (!turned.empty() && turned.back().kind != TokenKind::kStop) {
      turned.push_back({TokenKind::kStop, ".", at, at});
    }
    AppendItem(*tokens, item, stripes, &turned);
  }
  std::size_t rest = StopAfter(*tokens, last.end);
  if (itemized) rest = last.end;
  if (stripes.way_begin == rest) rest = std::max(rest, stripes.way_end);
  turned.insert(turned.end(), tokens->begin() + static_cast<std::ptrdiff_t>(rest), tokens->end());
  *tokens = std::move(turned);
}

}  // namespace latticeworld
