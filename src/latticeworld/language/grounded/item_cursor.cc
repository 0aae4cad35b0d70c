#include "latticeworld/language/grounded/item_cursor.h"

namespace latticeworld {
namespace {

// Words that may stand between others and the noun that they belong to.
bool MayPrecedeNoun(LayoutWord word) {
  switch (word) {
    case LayoutWord::kFunction:
    case LayoutWord::kMostly:
    case LayoutWord::kCovers:
    case LayoutWord::kMore:
    case LayoutWord::kLess:
    case LayoutWord::kFew:
    case LayoutWord::kMany:
    case LayoutWord::kSeveral:
    case LayoutWord::kScattered:
    case LayoutWord::kClustered:
    case LayoutWord::kWinding:
    case LayoutWord::kStraight:
    case LayoutWord::kHeights:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool ItemCursor::KindIsNext(LayoutItemKind kind) const {
  std::size_t i = at_ + 1;
  while (IsWord(i, LayoutWord::kFunction)) ++i;
  return IsKind(i, kind);
}

bool ItemCursor::NounAhead() const {
  for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
    const LayoutItem& item = items_[i];
    if (item.kind == LayoutItemKind::kNoun) return true;
    if (item.kind == LayoutItemKind::kNumber || item.kind == LayoutItemKind::kUnknown) continue;
    if (item.kind != LayoutItemKind::kWord || !MayPrecedeNoun(item.word)) return false;
  }
  return false;
}

bool ItemCursor::RestNounAhead() const {
  for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
    const LayoutItem& item = items_[i];
    if (item.kind == LayoutItemKind::kNoun) return true;
    if (item.kind == LayoutItemKind::kStop || item.kind == LayoutItemKind::kPlace ||
        IsWord(i, LayoutWord::kAnd) ||
        (IsWord(i, LayoutWord::kBreak) && FirstWord(item) != "with")) {
      return false;
    }
  }
  return false;
}

bool ItemCursor::NounFollowsPlace(bool sentence_has_noun, bool has_owner) const {
  for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
    const LayoutItem& item = items_[i];
    if (item.kind == LayoutItemKind::kNoun) return true;
    if (item.kind == LayoutItemKind::kStop) return false;
    if (item.kind == LayoutItemKind::kComma) {
      // "in the north, a forest" leads; "forest in the north, farmland ..." has had its noun.
      if (has_owner && sentence_has_noun) return false;
      continue;
    }
    if (item.kind == LayoutItemKind::kPlace && !IsWord(i - 1, LayoutWord::kAnd)) return false;
    if (IsWord(i, LayoutWord::kAnd) && sentence_has_noun) return false;
  }
  return false;
}

bool ItemCursor::ThanAhead() const {
  for (std::size_t i = at_ + 1; i < items_.size(); ++i) {
    if (items_[i].kind == LayoutItemKind::kStop) return false;
    if (FirstWord(items_[i]) == "than") return true;
  }
  return false;
}

bool ItemCursor::SpreadOver() const {
  const LayoutItem& item = items_[at_];
  for (const std::size_t i : {item.last - 1, item.last}) {
    if (i >= tokens_.size()) continue;
    for (const std::string_view word : {"across", "over", "around", "about", "in", "on", "along",
                                        "among", "throughout", "through", "within"}) {
      if (tokens_[i].text == word) return true;
    }
  }
  return false;
}

bool ItemCursor::ListGoesOn() const {
  return NextIsNoun() &&
         (IsWord(at_ + 2, LayoutWord::kAnd) || IsKind(at_ + 2, LayoutItemKind::kComma));
}

}  // namespace latticeworld
