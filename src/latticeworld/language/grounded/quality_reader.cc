#include "latticeworld/language/grounded/quality_reader.h"

namespace latticeworld {

Modifiers* QualityReader::Modify() {
  if (modifiers_.first_item < 0) modifiers_.first_item = state_.cursor.Index();
  return &modifiers_;
}

void QualityReader::SetAmount(Amount amount) {
  const bool of_a_place =
      amount == Amount::kMost && state_.cursor.KindIsNext(LayoutItemKind::kPlace);
  if (state_.cursor.NounAhead()) {
    Modify()->amount = amount;
  } else if (state_.last >= 0 && !of_a_place) {
    state_.mention(state_.last)->amount = amount;
    state_.Extend(state_.last);
  }
}

void QualityReader::SetTexture(Texture texture) {
  if (state_.cursor.NounAhead() && !(state_.clause_has_noun && state_.cursor.SpreadOver())) {
    Modify()->texture = texture;
  } else if (state_.last >= 0) {
    state_.mention(state_.last)->texture = texture;
    state_.Extend(state_.last);
  }
}

void QualityReader::SetMeander(double meander) {
  if (state_.cursor.NounAhead() || state_.line < 0) {
    Modify()->meander = meander;
  } else {
    state_.mention(state_.line)->meander = meander;
  }
}

// "forest covers the north", "the north is covered with forest"; of a map without a place this
// says no more than that it is there.
void QualityReader::ReadCovers() {
  if (state_.last >= 0 && state_.clause_has_noun &&
      state_.cursor.KindIsNext(LayoutItemKind::kPlace)) {
    state_.mention(state_.last)->amount = Amount::kMost;
  } else if (!state_.lead.empty() && !state_.lead_used && state_.cursor.NounAhead()) {
    Modify()->amount = Amount::kMost;
  }
}

void QualityReader::ReadEverywhere() {
  // Of a course it says no more than that it crosses the map.
  if (state_.last < 0 || state_.mention(state_.last)->is_line()) return;
  Mention* said = state_.mention(state_.last);
  if (said->negated) return;
  if (said->texture == Texture::kUnsaid && said->noun->shape == WordShape::kMass) {
    said->amount = Amount::kMost;
  } else if (said->noun->shape == WordShape::kThing) {
    said->texture = Texture::kScattered;
  }
  state_.Extend(state_.last);
}

void QualityReader::ReadRest() {
  if (state_.cursor.RestNounAhead()) {
    Modify()->is_rest = true;
  } else if (state_.last >= 0) {
    state_.mention(state_.last)->is_rest = true;
    state_.Extend(state_.last);
  }
}

}  // namespace latticeworld
