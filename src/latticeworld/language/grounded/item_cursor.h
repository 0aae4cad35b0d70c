#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ITEM_CURSOR_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ITEM_CURSOR_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/layout_lexer.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// The items of an instruction, how far they are read, and what lies ahead of there.
class ItemCursor {
 public:
  explicit ItemCursor(std::string_view instruction)
      : tokens_(Tokenize(instruction)), items_(LexLayout(tokens_)) {}

  bool AtEnd() const { return at_ >= items_.size(); }
  const LayoutItem& Item() const { return items_[at_]; }
  int Index() const { return static_cast<int>(at_); }
  void Advance() { ++at_; }

  // The text of the item's first token.
  const std::string& FirstWord(const LayoutItem& item) const { return tokens_[item.first].text; }
  // Bytes of the instruction that an item takes: [BeginOf, EndOf).
  std::size_t BeginOf(const LayoutItem& item) const { return tokens_[item.first].begin; }
  std::size_t EndOf(const LayoutItem& item) const { return tokens_[item.last - 1].end; }
  std::size_t BeginOf(int index) const { return BeginOf(items_[static_cast<std::size_t>(index)]); }

  bool NextIsWord(LayoutWord word) const { return IsWord(at_ + 1, word); }
  bool PreviousIsWord(LayoutWord word) const { return at_ > 0 && IsWord(at_ - 1, word); }
  bool NextIsNoun() const { return IsKind(at_ + 1, LayoutItemKind::kNoun); }
  // The kind after the small words that come next.
  bool KindIsNext(LayoutItemKind kind) const;
  // A noun comes before the clause ends or anything else that could own the words here.
  bool NounAhead() const;
  // "the rest of the map is covered with grass": nothing but small words before the noun.
  bool RestNounAhead() const;
  // A place right before a noun leads its clause: "in the north lies a forest".
  bool NounFollowsPlace(bool sentence_has_noun, bool has_owner) const;
  // "more forest than": the sentence goes on to compare.
  bool ThanAhead() const;
  // "ponds scattered across a meadow": said of the ponds, not of the meadow.
  bool SpreadOver() const;
  // "without roads, buildings or water": the comma is one of a list of nouns.
  bool ListGoesOn() const;

 private:
  bool IsKind(std::size_t at, LayoutItemKind kind) const {
    return at < items_.size() && items_[at].kind == kind;
  }
  bool IsWord(std::size_t at, LayoutWord word) const {
    return IsKind(at, LayoutItemKind::kWord) && items_[at].word == word;
  }

  std::vector<Token> tokens_;
  std::vector<LayoutItem> items_;
  std::size_t at_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ITEM_CURSOR_H_
