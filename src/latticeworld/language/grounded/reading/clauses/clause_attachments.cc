#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Places after what they are said of: "a lake and a village in the north".
namespace latticeworld {
namespace {

template <typename Predicate>
void EraseIf(std::vector<int>* indices, Predicate goes) {
  indices->erase(std::remove_if(indices->begin(), indices->end(), goes), indices->end());
}

}  // namespace

void ClauseReader::Attach(const std::vector<Zone>& zones, bool extent, const Chunk& chunk) {
  if (subjects_.empty()) {
    if (absences_.empty()) {
      Lead_(zones, chunk);
    } else {
      NarrowDenials(zones, chunk);
    }
    return;
  }
  std::vector<int> owners = PlaceOwners();
  if (AttachToObject(zones, chunk, &owners)) return;
  LeaveOutUnplaced(&owners);
  // "roads reaching every side of the map"
  const bool all_sides = zones.size() == 4 || (zones.size() == 1 && zones.front().name == "edges");
  if (all_sides && owners.size() == 1 && IsLine(owners[0]) && SaysReach()) {
    ReachAllSides(owners[0]);
    d_.Extend(owners[0], chunk.end);
    return;
  }
  for (const int index : owners) AttachTo(index, zones, extent && owners.size() == 1, chunk);
  confining_ = false;
  open_list_ = false;
}

// "no houses in the east": there are none there.
void ClauseReader::NarrowDenials(const std::vector<Zone>& zones, const Chunk& chunk) {
  std::vector<PlannedAbsence>& absences = d_.plan().absences;
  const std::vector<std::size_t> about = absences_;
  for (const std::size_t i : about) {
    absences[i].zone = zones.front();
    absences[i].words += " " + d_.Words(chunk.begin, chunk.end);
    for (std::size_t z = 1; z < zones.size(); ++z) {
      PlannedAbsence more = absences[i];
      more.zone = zones[z];
      d_.Deny(std::move(more));
    }
  }
}

// Those of the subjects that a place after them is said of.
std::vector<int> ClauseReader::PlaceOwners() const {
  // "town, grid streets, centre": the streets are the town's.
  const bool streets = subjects_.size() == 2 && IsKind(at_ - 1, ChunkKind::kComma) &&
                       d_.feature(subjects_[0]).letter == 'B' &&
                       d_.feature(subjects_[1]).shape == ClaimShape::kGridded;
  // "a forest and a lake in the north" share the place; "a lake, a village in the center" do not.
  if (subjects_.size() > 1 && !list_has_and_ && !streets) return {subjects_.back()};
  return subjects_;
}

// Whether the place is that of the last object of the relation alone; the object is there then.
// Where both are there, the object joins the owners.
bool ClauseReader::AttachToObject(const std::vector<Zone>& zones, const Chunk& chunk,
                                  std::vector<int>* owners) {
  if (!frame_.has_value() || frame_->objects.empty()) return false;
  const int object = frame_->objects.back();
  const bool fresh = d_.feature(object).zones.empty() && !IsLine(object);
  const auto attach = [&] {
    if (fresh) d_.AddZones(object, zones);
    d_.Extend(object, chunk.end);
  };
  // "a village next to a lake in the east": the lake is there, and so is the village by it.
  const std::size_t before = at_ > 0 && IsSense(at_ - 1, Sense::kIn) ? at_ - 1 : at_;
  const bool of_pronoun =
      before > 0 && IsPhrase(before - 1) && chunks_[before - 1].phrase.noun == nullptr;
  const bool after_comma = IsKind(at_ - 1, ChunkKind::kComma);
  if (!frame_->fronted && !after_comma && !IsCourse(frame_->sense) && !of_pronoun) {
    const bool together = !WantsTwo(frame_->sense) && LineOf(*owners) < 0;
    if (!together && !IsLine(object)) {
      attach();
      return true;
    }
    if (fresh) owners->push_back(object);
    EraseIf(owners, [&](int index) { return index != object && !d_.feature(index).zones.empty(); });
  } else if (IsCourse(frame_->sense) && !after_comma && !IsLine(object)) {
    // "leads to the town in the upper right", "cutting through a forest in the centre"
    attach();
    return true;
  }
  return false;
}

// If there are several owners, removes those that have no place of their own beside one that has.
void ClauseReader::LeaveOutUnplaced(std::vector<int>* owners) const {
  // The rest has no place of its own beside what has one.
  if (owners->size() > 1) {
    EraseIf(owners, [&](int index) { return d_.feature(index).fills_rest; });
  }
  if (owners->size() <= 1) return;
  // "mostly grass and a single building in the middle", "40 % forest and one lake in the middle":
  // the building, the lake is there.
  const int placed = owners->back();
  const bool counted = d_.feature(placed).form == FeatureForm::kPatch &&
                       (d_.feature(placed).pieces_least > 0 || !d_.thing(placed).plural);
  EraseIf(owners, [&](int index) {
    const PlannedFeature& other = d_.feature(index);
    const bool land = other.form == FeatureForm::kSpread &&
                      (other.dominant || other.texture == Texture::kScattered);
    const bool grid = other.shape == ClaimShape::kGridded;
    const bool covers = other.zones.empty() && other.share.value_or(0.0) >= 0.2;
    return counted && index != placed && (land || grid || covers);
  });
}

// `fills`: all of the place is meant, of this thing alone.
void ClauseReader::AttachTo(int index, const std::vector<Zone>& zones, bool fills,
                            const Chunk& chunk) {
  PlannedFeature& feature = d_.feature(index);
  Thing& thing = d_.thing(index);
  if (thing.zones_from_lead) feature.zones.clear();
  thing.zones_from_lead = false;
  if (thing.sentence != d_.sentence() && !feature.zones.empty() && verb_said_) {
    // Said again of the same thing: the later sentence wins.
    if (!(feature.zones == zones)) {
      d_.plan().warnings.push_back(
          Quote(d_.Words(thing.begin, thing.end)) +
          " is moved by what is said later: " + Quote(d_.Words(chunk.begin, chunk.end)));
    }
    feature.zones.clear();
  }
  if (IsLine(index) && RunTo(zones, d_.Words(chunk.begin, chunk.end), &feature)) {
    d_.Extend(index, chunk.end);
    return;
  }
  if (IsLine(index) && (feature.from.has_value() || feature.to.has_value())) {
    for (const Zone& zone : zones) {
      Waypoint via;
      via.zone = zone;
      feature.via.push_back(std::move(via));
    }
  } else {
    d_.AddZones(index, zones);
    ShareOfPlace(index);
  }
  if (confining_) feature.confined = true;
  if (fills && feature.pieces_least == 0 && feature.texture == Texture::kUnsaid &&
      !feature.share.has_value() && !confining_ &&
      (feature.form == FeatureForm::kSpread || feature.letter == 'A' || IsUncounted(index))) {
    // "vineyards on the left half": as many as fill it.
    feature.dominant = true;
    feature.form = FeatureForm::kSpread;
    feature.pieces = 0;
  }
  d_.Extend(index, chunk.end);
}

// Whether the place tells the course of the line, rather than where it lies.
bool ClauseReader::RunTo(const std::vector<Zone>& zones, const std::string& words,
                         PlannedFeature* line) const {
  // "one arm leaves in the west, the other in the east"
  if (line->from.has_value() && line->from->feature >= 0 && IsLine(line->from->feature) &&
      !line->to.has_value() && zones.size() == 1) {
    Waypoint to;
    to.zone = EndZoneOf(zones.front(), words);
    line->to = to;
    return true;
  }
  // "a river down the middle", "a road across the middle"
  const bool down = zones.size() == 1 && zones.front().name == "middle columns";
  const bool across = zones.size() == 1 && zones.front().name == "middle rows";
  if ((down || across) && !line->from.has_value() && !line->to.has_value() && line->pieces <= 1) {
    Waypoint from;
    from.zone = RimZoneOf(down ? Heading{0, -1} : Heading{-1, 0});
    Waypoint via;
    via.zone = *FindZone("center");
    Waypoint to;
    to.zone = RimZoneOf(down ? Heading{0, 1} : Heading{1, 0});
    line->from = from;
    line->via = {via};
    line->to = to;
    return true;
  }
  return TurnsAt(zones, line);
}

// "along the bottom and then up the right side": the line turns at the corner.
bool ClauseReader::TurnsAt(const std::vector<Zone>& zones, PlannedFeature* line) const {
  if (!line->along.has_value() || zones.size() != 1 || line->from.has_value()) return false;
  const Heading a = HeadingOf(RegionOf(*line->along));
  const Heading b = HeadingOf(RegionOf(zones.front()));
  if (a.IsDiagonal() || b.IsDiagonal()) return false;
  if ((a.east != 0) == (b.east != 0) || (a.south != 0) == (b.south != 0)) return false;
  Waypoint from;
  from.zone = RimZoneOf({a.east - b.east, a.south - b.south});
  Waypoint via;
  via.zone = RimZoneOf({a.east + b.east, a.south + b.south});
  Waypoint to;
  to.zone = RimZoneOf({b.east - a.east, b.south - a.south});
  line->from = from;
  line->to = to;
  line->via = {via};
  line->along.reset();
  line->zones.clear();
  return true;
}

// "water across the whole foreground": no lake, but as much as there is room.
bool ClauseReader::IsUncounted(int index) const {
  const std::string_view noun = d_.thing(index).noun->phrase;
  return d_.feature(index).form == FeatureForm::kPatch && d_.feature(index).pieces == 0 &&
         (noun == "water" || noun == "open water" || noun == "sea" || noun == "ocean");
}

// "Hardly any forest in the east": hardly any of it there, of which there may be more elsewhere.
void ClauseReader::ShareOfPlace(int index) {
  PlannedFeature& feature = d_.feature(index);
  const bool hardly = feature.share_least == 0.0 && feature.share_most.value_or(1.0) <= 0.12;
  if (hardly && feature.zones.size() == 1) feature.share_of_zones = true;
}

}  // namespace latticeworld
