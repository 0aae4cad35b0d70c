#include "latticeworld/language/grounded/noun_reader.h"

#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

void ApplyVagueNumber(const Modifiers& said, Mention* added) {
  const bool mass = added->noun->shape == WordShape::kMass;
  const bool line = added->is_line();
  if (said.few) {
    if (mass) {
      added->amount = Amount::kLittle;
    } else {
      added->number = line ? 2 : 3;
    }
  }
  if (said.several && !mass) added->number = line ? 3 : 4;
  if (said.many) {
    if (mass) {
      added->amount = Amount::kMuch;
    } else {
      added->number = line ? 4 : 8;
    }
  }
  if (line) added->wide = said.amount == Amount::kMuch;
}

}  // namespace

NounReader::Found NounReader::Read(const LayoutItem& item, const Modifiers& said,
                                   bool points_back) {
  const ItemCursor& cursor = state_.cursor;
  Found found;
  found.begin = said.first_item >= 0 ? cursor.BeginOf(said.first_item) : cursor.BeginOf(item);
  found.end = cursor.EndOf(item);
  const std::string vocabulary(NameOf(state_.vocabulary));
  const char letter = item.noun->LetterIn(state_.vocabulary);
  if (letter == '\0') {
    state_.reading.warnings.push_back("the " + vocabulary + " vocabulary has nothing like " +
                                      state_.QuoteOf(found.begin, found.end) +
                                      "; it is not placed");
    return found;
  }
  found.index = said.negated ? -1 : Known(item, letter, said, points_back);
  if (found.index >= 0) {
    if (said.amount != Amount::kUnsaid) state_.mention(found.index)->amount = said.amount;
    return found;
  }
  Mention added = MentionOf(item, letter, said);
  added.begin = found.begin;
  added.end = found.end;
  if (!item.noun->IsExactIn(state_.vocabulary) && !added.negated) {
    state_.reading.warnings.push_back(state_.QuoteOf(found.begin, found.end) + " is laid as " +
                                      std::string(FindClass(state_.vocabulary, letter)->name) +
                                      ", the nearest class of the " + vocabulary + " vocabulary");
  }
  state_.reading.mentions.push_back(std::move(added));
  found.index = static_cast<int>(state_.reading.mentions.size()) - 1;
  found.is_new = true;
  return found;
}

// The mention that the noun points back to: "the forest", or the other end of a tie.
int NounReader::Known(const LayoutItem& item, char letter, const Modifiers& said,
                      bool points_back) const {
  if (!(points_back || said.definite) || said.number > 0 || said.is_rest) return -1;
  for (std::size_t i = state_.reading.mentions.size(); i-- > 0;) {
    const Mention& known = state_.reading.mentions[i];
    if (!known.negated && known.letter == letter && known.is_island() == NamesIsland(*item.noun) &&
        known.is_line() == (item.noun->shape == WordShape::kLine)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

Mention NounReader::MentionOf(const LayoutItem& item, char letter, const Modifiers& said) const {
  Mention added;
  added.letter = letter;
  added.noun = item.noun;
  added.plural = item.plural;
  added.negated = said.negated;
  added.is_rest = said.is_rest;
  added.amount = said.amount;
  added.texture = said.texture;
  added.number = said.number;
  added.meander = said.meander;
  ApplyVagueNumber(said, &added);
  return added;
}

void NounReader::AddAbsent(std::string_view phrase, const LayoutItem& item) {
  const std::vector<Token> word = Tokenize(phrase);
  const ClassWord* noun = MatchClassWord(word, 0).word;
  if (noun == nullptr || noun->LetterIn(state_.vocabulary) == '\0') return;
  Mention absent;
  absent.noun = noun;
  absent.letter = noun->LetterIn(state_.vocabulary);
  absent.negated = true;
  absent.places = state_.lead;
  absent.begin = state_.cursor.BeginOf(item);
  absent.end = state_.cursor.EndOf(item);
  state_.reading.mentions.push_back(std::move(absent));
}

}  // namespace latticeworld
