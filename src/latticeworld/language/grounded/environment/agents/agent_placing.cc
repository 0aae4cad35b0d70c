// Reading about agents: puts them at the places that were read.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {
namespace {

// The places within those of `by`; as they are where nothing is in both.
std::vector<Place> Narrowed(const std::vector<Place>& places, const std::vector<Place>& by) {
  std::vector<Place> narrowed = places;
  for (Place& place : narrowed) {
    std::vector<Region> common;
    for (const Region region : place.regions) {
      const bool led = std::any_of(by.begin(), by.end(), [&](const Place& other) {
        return std::find(other.regions.begin(), other.regions.end(), region) != other.regions.end();
      });
      if (led) common.push_back(region);
    }
    if (common.empty()) continue;
    place.regions = common;
    if (std::find(common.begin(), common.end(), place.main) == common.end()) {
      place.main = common[common.size() / 2];
    }
  }
  return narrowed;
}

}  // namespace

bool AgentDiscourse::Narrows(const FeaturePlace& feature,
                             const std::optional<FeaturePlace>& land) const {
  return land.has_value() && !land->near && !land->on.has_value() && feature.near &&
         feature.way == FeaturePlace::Way::kNone && feature.name != land->name;
}

void AgentReader::SetPlace(const std::vector<Place>& places,
                           const std::optional<FeaturePlace>& feature, bool each,
                           const std::vector<std::size_t>& owners, std::size_t end) {
  if (owners.empty()) {
    // "on the sand, in the corner, ten knights" adds to what the clause began with.
    const std::size_t last = at_ > 0 && noted_.IsPause(at_ - 1) ? at_ - 1 : at_;
    if (clause_open_ && lead_.end != last) {
      lead_ = {};
      subject_.clear();
    }
    if (feature.has_value() && lead_.end == at_ && Narrows(*feature, lead_.feature)) {
      lead_.feature->beside.push_back(*feature);
      lead_.end = end;
      return;
    }
    const std::vector<Place> narrowed = NarrowedByLead(places);
    if (lead_.end == last && clause_open_ && !places.empty()) lead_.places.clear();
    lead_.places.insert(lead_.places.end(), narrowed.begin(), narrowed.end());
    if (feature.has_value()) lead_.feature = feature;
    lead_.each = lead_.each || each;
    lead_.set = true;
    lead_.end = end;
    return;
  }
  // "in the north, south and east"
  const bool listed = at_ > 1 && tokens_[at_ - 1].kind == TokenKind::kComma &&
                      noted_.notes[at_ - 2].place && IsPlaceList(end);
  const bool also = listed || (at_ > 0 && noted_.IsAnyWord(at_ - 1, {"and", "or"}));
  for (const std::size_t index : owners) {
    AgentWish& wish = groups_[index].wish;
    // "Five knights on the bridge. Ten sheep. All of them in the south."
    const bool placed = wish.IsPlaced();
    if (everybody_ && placed && groups_[index].sentence != sentence_) continue;
    // "wherever you like" takes no place away.
    const bool anywhere =
        !feature.has_value() && !places.empty() && places.front().main == Region::kAnywhere;
    if (anywhere && (placed || groups_[index].with != kNone)) continue;
    const bool fresh = placed_sentence_ != sentence_ + 1 || placed_ != index;
    if (corrected_ || (fresh && groups_[index].sentence != sentence_)) {
      wish.ForgetPlace();
    }
    if (groups_[index].inherited) wish.ForgetPlace();
    groups_[index].inherited = false;
    const bool led_here = lead_.set && fresh && !places.empty() && !wish.places.empty() &&
                          wish.places.size() == lead_.places.size() &&
                          wish.places.front().main == lead_.places.front().main;
    const bool goes_on =
        placed_sentence_ == sentence_ + 1 && !also && at_ > 0 && noted_.notes[at_ - 1].place;
    const bool narrows = feature.has_value() && goes_on && Narrows(*feature, wish.feature);
    if (led_here) {
      wish.places = NarrowedByLead(places);
    } else if (goes_on && !wish.places.empty() && !feature.has_value() &&
               !wish.feature.has_value()) {
      // "on the lower slopes on the right"
      wish.places = Narrowed(wish.places, places);
    } else if ((wish.places.empty() || also) && !narrows) {
      wish.places.insert(wish.places.end(), places.begin(), places.end());
    }
    // What is said at the agents themselves counts over what the clause began with.
    const bool led = lead_.feature.has_value() && wish.feature.has_value() &&
                     wish.feature->name == lead_.feature->name;
    if (narrows) {
      wish.feature->beside.push_back(*feature);
    } else if (feature.has_value() && (led || !wish.feature.has_value())) {
      wish.feature = feature;
    } else if (feature.has_value() && also && feature->name != wish.feature->name) {
      wish.more_land.push_back(*feature);
    }
    wish.each = wish.each || each;
    Extend(index, tokens_[end - 1].end);
    placed_ = index;
  }
  placed_sentence_ = sentence_ + 1;
  joined_ = false;
}

std::vector<Place> AgentDiscourse::NarrowedByLead(const std::vector<Place>& places) const {
  return Narrowed(places, lead_.places);
}

}  // namespace internal

}  // namespace latticeworld
