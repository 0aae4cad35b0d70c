#include "latticeworld/language/grounded/place_reader.h"

#include <algorithm>

namespace latticeworld {

void PlaceReader::Read(const LayoutItem& item) {
  if (!state_.clause_has_noun &&
      state_.cursor.NounFollowsPlace(state_.sentence_has_noun, state_.last >= 0)) {
    Lead(item);
  } else {
    Attach(item);
  }
}

void PlaceReader::Lead(const LayoutItem& item) {
  const bool more =
      state_.cursor.PreviousIsWord(LayoutWord::kAnd) && !state_.lead.empty() && !state_.lead_used;
  if (!more) {
    state_.lead.clear();
    state_.lead_begin = state_.cursor.BeginOf(item);
  }
  state_.lead.insert(state_.lead.end(), item.places.begin(), item.places.end());
  state_.lead_used = false;
  state_.group.clear();
}

void PlaceReader::ApplyLead(Mention* added) const {
  if (state_.lead.empty()) return;
  added->places = state_.lead;
  added->place_from_lead = true;
  added->begin = std::min(added->begin, state_.lead_begin);
}

std::vector<int> PlaceReader::Owners() const {
  if (state_.last >= 0 && (!state_.lead.empty() || state_.group.empty())) return {state_.last};
  // "a forest and a lake in the north" shares the place; "a lake, a village in the center" not.
  if (state_.group_has_and || state_.group.empty()) return state_.group;
  return {state_.group.back()};
}

void PlaceReader::Attach(const LayoutItem& item) {
  const std::vector<int> owners = Owners();
  if (owners.empty()) {
    state_.AddUnknown(item);
    state_.unknown.Close();
    return;
  }
  for (const int owner : owners) {
    Mention* placed = state_.mention(owner);
    if (placed->is_line() && placed->has_course()) {
      for (const Place& place : item.places) placed->through.push_back(place.main);
    } else {
      if (placed->place_from_lead) placed->places.clear();
      placed->place_from_lead = false;
      placed->places.insert(placed->places.end(), item.places.begin(), item.places.end());
    }
    placed->end = std::max(placed->end, state_.cursor.EndOf(item));
  }
  state_.group.clear();
  state_.group_has_and = false;
}

}  // namespace latticeworld
