#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Places told by others: the remaining corners, the other side, the opposite edge.
namespace latticeworld {

// "the other two corners": those that nothing was laid in so far.
std::vector<Zone> ClauseReader::OtherZones(std::vector<Zone> zones, std::string_view words) const {
  const bool corners = words.find("corners") != std::string_view::npos;
  if (corners || words.find("edges") != std::string_view::npos) {
    const int step = corners ? 2 : 1;
    std::vector<Zone> rim;
    for (int east = -1; east <= 1; ++east) {
      for (int south = -1; south <= 1; ++south) {
        if (std::abs(east) + std::abs(south) == step) rim.push_back(RimZoneOf({east, south}));
      }
    }
    zones = std::move(rim);
  }
  std::vector<Zone> left = zones;
  for (int i = 0; i < d_.size(); ++i) {
    if (d_.thing(i).dropped) continue;
    for (const Zone& taken : d_.feature(i).zones) {
      left.erase(
          std::remove_if(left.begin(), left.end(),
                         [&](const Zone& zone) { return RegionOf(zone) == RegionOf(taken); }),
          left.end());
    }
  }
  return left.empty() ? zones : left;
}

// "houses on its west bank, on the other bank fields": away from the houses.
bool ClauseReader::ReadOppositeOf() {
  const std::vector<PlannedRelation>& relations = d_.plan().relations;
  for (std::size_t r = relations.size(); r-- > 0;) {
    const PlannedRelation& known = relations[r];
    if (known.kind != RelationKind::kDirection || !IsLine(known.object)) continue;
    if (!d_.feature(known.subject).zones.empty()) continue;
    Frame frame;
    frame.is_direction = true;
    frame.heading = {-known.heading.east, -known.heading.south};
    frame.objects = {known.object};
    frame.expecting = false;
    if (ThingFollows(at_ + 1, true)) {
      if (!subjects_.empty()) BeginClause();
      frame.fronted = true;
      frame_ = std::move(frame);
    } else {
      for (const int subject : subjects_) Assert(frame, subject, &d_);
    }
    return true;
  }
  return false;
}

// "a lake on the left and on the other side a village"
void ClauseReader::ReadOtherSide(const Chunk& chunk) {
  if (ReadOppositeOf()) return;
  for (int i = d_.size() - 1; i >= 0; --i) {
    if (d_.thing(i).dropped || d_.feature(i).zones.size() != 1) continue;
    const Heading there = HeadingOf(RegionOf(d_.feature(i).zones.front()));
    if (there.east == 0 && there.south == 0) continue;
    Chunk place = chunk;
    place.kind = ChunkKind::kPlace;
    Place opposite = PlaceOf(RegionOf(Heading{-there.east, -there.south}));
    opposite.zone = ZoneOf(Heading{-there.east, -there.south});
    place.lexeme.places = {std::move(opposite)};
    ReadPlace(place);
    return;
  }
}

// "The left half mirrors the right: a lake in each."
void ClauseReader::PlaceInEach() {
  if (halves_.size() < 2) return;
  for (const int index : subjects_) {
    PlannedFeature& feature = d_.feature(index);
    if (IsLine(index)) continue;
    feature.zones = {halves_[halves_.size() - 2], halves_.back()};
    d_.thing(index).zones_from_lead = false;
    if (feature.form == FeatureForm::kPatch && feature.pieces < 2) feature.pieces = 2;
  }
}

// "a quarry in the opposite corner": opposite what was named last at a corner or a side.
bool ClauseReader::OppositePlace(const std::string& words, std::vector<Zone>* zones) const {
  if (words.find("opposite") == std::string::npos) return false;
  const bool corner =
      EndsWithWord(words, "corner") || words.find("corner diagonally") != std::string::npos;
  const bool edge = EndsWithWord(words, "edge");
  if (!corner && !edge && !EndsWithWord(words, "side") && !EndsWithWord(words, "end")) return false;
  for (int i = d_.size() - 1; i >= 0; --i) {
    if (d_.thing(i).dropped || d_.feature(i).zones.size() != 1) continue;
    const Heading at = HeadingOf(RegionOf(d_.feature(i).zones.front()));
    if ((at.east == 0 && at.south == 0) || corner != at.IsDiagonal()) continue;
    const Heading opposite{-at.east, -at.south};
    *zones = {corner || edge ? RimZoneOf(opposite) : ZoneOf(opposite)};
    return true;
  }
  return false;
}

}  // namespace latticeworld
