#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

namespace latticeworld {
namespace {

constexpr double kCoveringShare = 0.5;  // "forest covers the northern half": at least
constexpr double kWholeShare = 0.75;    // "the whole northern half"
constexpr int kCityCells = 60;          // what is so large may lie everywhere

}  // namespace

bool ClauseReader::IsMany(const std::vector<Zone>& zones) {
  return zones.size() > 1 || zones[0].name == "corners" || zones[0].name == "edges";
}

void ClauseReader::ReadPlace(const Chunk& chunk) {
  std::vector<Zone> zones = ZonesOf(chunk.lexeme.places);
  const std::string words = d_.Words(chunk.begin, chunk.end);
  if (at_ > 0 && IsPhrase(at_ - 1) && chunks_[at_ - 1].phrase.head == Head::kOther &&
      chunks_[at_ - 1].phrase.noun == nullptr && IsMany(zones)) {
    zones = OtherZones(std::move(zones), ToLowerAscii(words));
  }
  OppositePlace(ToLowerAscii(words), &zones);
  const bool extent =
      chunk.lexeme.whole || SaysExtent(words) || (zones.size() == 1 && IsExtent(zones.front()));
  if (SaysAnywhere(chunk.lexeme.places)) {
    // "forest everywhere", "no water anywhere", "houses all over"
    const bool frames = frame_.has_value() && frame_->sense == Sense::kSurrounds &&
                        frame_->objects.empty() && !frame_->fronted;
    for (const int index : subjects_) {
      PlannedFeature& feature = d_.feature(index);
      if (IsLine(index)) continue;
      if (frames) {  // "trees frame the whole map"
        d_.AddZones(index, {*FindZone("edges")});
        continue;
      }
      if (feature.form == FeatureForm::kSpread && feature.texture == Texture::kUnsaid) {
        feature.dominant = true;
      } else if (feature.form == FeatureForm::kPatch && feature.pieces == 0 &&
                 !d_.thing(index).plural &&
                 (feature.letter == 'G' || feature.cells >= kCityCells)) {
        feature.form = FeatureForm::kSpread;  // "lawn everywhere", "city everywhere"
        feature.dominant = true;
      } else if (feature.form == FeatureForm::kPatch) {
        feature.texture = Texture::kScattered;
      }
      d_.Extend(index, chunk.end);
    }
    if (subjects_.empty() && absences_.empty() && ThingFollows(at_ + 1, true)) mostly_next_ = true;
    if (frame_.has_value() && frame_->objects.empty() && !frame_->fronted) frame_.reset();
    return;
  }
  last_zones_ = zones;
  zones_before_ = zones;
  if (zones.size() == 1 && IsExtent(zones.front())) halves_.push_back(zones.front());
  // "the settlement (west)": of what stands right before it.
  if (chunk.begin > 0 && d_.instruction()[chunk.begin - 1] == '(' && at_ >= 2 && IsThing(at_ - 2) &&
      d_.size() > 0) {
    const int last = d_.LastMentioned();
    if (last >= 0) {
      d_.AddZones(last, zones);
      d_.Extend(last, chunk.end);
    }
    return;
  }
  if (excepting_ && !ThingFollows(at_ + 1, false) && !subjects_.empty()) {
    // "forest everywhere except in the south"
    for (const int index : subjects_) Deny(d_.feature(index).letter, zones, chunk);
    Lead_(zones, chunk);
    return;
  }
  if (not_next_) {
    not_next_ = false;
    // "the lake and the forest are not in the north"
    const bool all = list_has_and_ && verb_said_;
    for (const int index : subjects_)
      if (all || index == subjects_.back()) Deny(d_.feature(index).letter, zones, chunk);
    absences_.clear();
    if (frame_.has_value() && frame_->objects.empty()) frame_.reset();
    return;
  }
  if (correcting_ && !ThingFollows(at_ + 1, false)) {
    correcting_ = false;
    const int last = !subjects_.empty() ? subjects_.back() : d_.size() - 1;
    if (last >= 0) {
      d_.feature(last).zones.clear();
      d_.thing(last).zones_from_lead = false;
      d_.AddZones(last, zones);
      return;
    }
  }
  // "going north: fields, then woods", "advance east through ..."
  const Heading to = HeadingOf(RegionOf(zones.front()));
  // "Snow in the west, then going east rocks, then bushes"
  if (traveling_ && at_ > 0 && IsSense(at_ - 1, Sense::kTravel) && then_after_ >= 0 &&
      zones.size() == 1 && !to.IsDiagonal() && (to.east != 0 || to.south != 0) && !ordering_ &&
      !SaysExtent(words)) {
    const int first = std::exchange(then_after_, -1);
    BeginClause();
    BeginOrder(to);
    order_ = {first};
    return;
  }
  if (traveling_ && at_ > 0 && IsSense(at_ - 1, Sense::kTravel) && subjects_.empty() &&
      zones.size() == 1 && (to.east != 0 || to.south != 0) && !from_.has_value() &&
      !frame_.has_value() && !SaysExtent(words)) {
    BeginOrder(to);
    return;
  }
  there_.clear();
  if (TakeContrast(zones) || TakeEndZone(zones)) return;
  there_ = zones;
  // "From the lake in the north-east flows a stream": the lake is there.
  const bool of_object =
      frame_.has_value() && frame_->fronted && !frame_->objects.empty() && at_ > 0 &&
      (IsPhrase(at_ - 1) || (IsSense(at_ - 1, Sense::kIn) && at_ > 1 && IsPhrase(at_ - 2)));
  if (of_object) {
    const int object = frame_->objects.back();
    if (d_.feature(object).zones.empty() && !IsLine(object)) d_.AddZones(object, zones);
    d_.Extend(object, chunk.end);
    return;
  }
  // "behind the hotels, further to the east, runs a road"
  const Heading side = HeadingOf(RegionOf(zones.front()));
  if (frame_.has_value() && frame_->fronted && !frame_->objects.empty() &&
      (frame_->sense == Sense::kBehind || frame_->sense == Sense::kBeyond) &&
      (side.east != 0 || side.south != 0)) {
    frame_->is_direction = true;
    frame_->heading = side;
    return;
  }
  if (frame_.has_value() && frame_->expecting && frame_->objects.empty() && !frame_->fronted) {
    const Sense sense = frame_->sense;
    const bool covers = sense == Sense::kCovers || sense == Sense::kDominates;
    const bool away = sense == Sense::kAway || frame_->negated;
    for (const int index : frame_->subjects) {
      if (covers && !IsLine(index)) {
        d_.feature(index).dominant = true;
        if (extent && d_.feature(index).form != FeatureForm::kLine) {
          const std::string lower = ToLowerAscii(words);
          const bool whole = chunk.lexeme.whole || lower.find("whole") != std::string::npos ||
                             lower.find("entire") != std::string::npos;
          d_.feature(index).share_least = std::max(d_.feature(index).share_least.value_or(0.0),
                                                   whole ? kWholeShare : kCoveringShare);
        }
      }
      if (away) Deny(d_.feature(index).letter, zones, chunk);
    }
    if (away) {
      frame_.reset();
      absences_.clear();
      return;
    }
    if (covers) covered_ = d_.sentence();
    if (covers || !IsCourse(sense)) frame_.reset();
    if (frame_.has_value()) frame_.reset();
    Attach(zones, extent, chunk);
    return;
  }
  // "bordered by forest on the north and by fields on the south": of what is bordered.
  const bool borders =
      frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
      !frame_->subjects.empty() && zones.size() == 1 &&
      (frame_->sense == Sense::kSurroundedBy || frame_->sense == Sense::kBorderedBy ||
       frame_->sense == Sense::kFlankedBy) &&
      (side.east != 0 || side.south != 0) && zones.front() == ZoneOf(side) &&
      (IsSense(at_ - 1, Sense::kIn) || IsSense(at_ - 1, Sense::kTo) ||
       IsSense(at_ - 1, Sense::kAnd) || IsKind(at_ - 1, ChunkKind::kComma));
  if (borders) {
    const bool list = IsKind(at_ + 1, ChunkKind::kComma) || IsSense(at_ + 1, Sense::kAnd) ||
                      !IsSense(at_ - 1, Sense::kIn);
    if (frame_->sense == Sense::kSurroundedBy && list) return;
    Frame there;
    there.is_direction = true;
    there.heading = side;
    there.objects = {frame_->subjects.back()};
    Assert(there, frame_->objects.back(), &d_);
    d_.Extend(frame_->objects.back(), chunk.end);
    return;
  }
  // "the road touches the forest on the east side": on the forest's.
  const bool of_forest = frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
                         frame_->sense == Sense::kNextTo && zones.size() == 1 &&
                         (side.east != 0 || side.south != 0) &&
                         EndsWithWord(ToLowerAscii(words), "side") && at_ > 1 &&
                         IsSense(at_ - 1, Sense::kIn) && IsPhrase(at_ - 2);
  if (of_forest) {
    Frame there;
    there.is_direction = true;
    there.heading = side;
    there.objects = {frame_->objects.back()};
    for (const int index : frame_->subjects) Assert(there, index, &d_);
    return;
  }
  const bool nothing_yet = subjects_.empty() && absences_.empty();
  const bool after_break =
      at_ > 0 && (IsKind(at_ - 1, ChunkKind::kComma) || IsSense(at_ - 1, Sense::kAnd) ||
                  IsSense(at_ - 1, Sense::kThen) ||
                  (IsSense(at_ - 1, Sense::kIn) && at_ > 1 &&
                   (IsKind(at_ - 2, ChunkKind::kComma) || IsSense(at_ - 2, Sense::kAnd) ||
                    IsSense(at_ - 2, Sense::kThen))));
  // "..., the upper left corner and the lower left corner have trees"
  std::size_t verb = at_ + 1;
  while (IsSense(verb, Sense::kAnd) && IsKind(verb + 1, ChunkKind::kPlace)) verb += 2;
  const bool list_has = verb > at_ + 1 && at_ > 0 && !IsSense(at_ - 1, Sense::kIn) &&
                        (IsSense(verb, Sense::kHas) || IsSense(verb, Sense::kBe)) &&
                        ThingFollows(verb, false);
  const bool is_subject =
      list_has || ((IsSense(at_ + 1, Sense::kBe) || IsSense(at_ + 1, Sense::kCoveredBy) ||
                    IsSense(at_ + 1, Sense::kDominatedBy)) &&
                   at_ > 0 && !IsSense(at_ - 1, Sense::kIn));
  const bool leads = nothing_yet || (after_break && (is_subject || ThingFollows(at_ + 1, false)));
  if (leads) {
    const bool joins =
        nothing_yet && !lead_.empty() && !lead_.used && at_ > 0 &&
        (IsSense(at_ - 1, Sense::kAnd) || (at_ > 1 && IsSense(at_ - 2, Sense::kAnd)));
    if (joins) {
      for (const Zone& zone : zones) lead_.zones.push_back(zone);
      return;
    }
    if (!nothing_yet) BeginClause();
    if (frame_.has_value() && frame_->fronted && frame_->objects.empty()) frame_.reset();
    Lead_(zones, chunk);
    return;
  }
  // "Forest covers the north, fields the south.": covers it too.
  if (covered_ == d_.sentence() && at_ > 0 && IsPhrase(at_ - 1) && subjects_.size() == 1 &&
      !IsLine(subjects_[0]) && !frame_.has_value() && !verb_said_) {
    d_.feature(subjects_[0]).dominant = true;
    if (extent) d_.feature(subjects_[0]).share_least = kCoveringShare;
  }
  Attach(zones, extent, chunk);
}

void ClauseReader::Lead_(const std::vector<Zone>& zones, const Chunk& chunk) {
  lead_ = Lead();
  lead_.zones = zones;
  lead_.is_subject = at_ == 0 || !chunks_[at_ - 1].Is(Sense::kIn);
  lead_.band = chunk.lexeme.band;
  lead_.extent = chunk.lexeme.whole || SaysExtent(d_.Words(chunk.begin, chunk.end)) ||
                 (zones.size() == 1 && IsExtent(zones.front()));
  lead_.along = at_ > 0 && chunks_[at_ - 1].Is(Sense::kAlong);
  lead_.begin = chunk.begin;
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

void ClauseReader::Attach(const std::vector<Zone>& zones, bool extent, const Chunk& chunk) {
  if (subjects_.empty()) {
    // "no houses in the east"
    if (!absences_.empty()) {
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
      return;
    }
    Lead_(zones, chunk);
    return;
  }
  std::vector<int> owners = subjects_;
  // "town, grid streets, centre": the streets are the town's.
  const bool streets = owners.size() == 2 && IsKind(at_ - 1, ChunkKind::kComma) &&
                       d_.feature(owners[0]).letter == 'B' &&
                       d_.feature(owners[1]).shape == ClaimShape::kGridded;
  // "a forest and a lake in the north" share the place; "a lake, a village in the center" do not.
  if (owners.size() > 1 && !list_has_and_ && !streets) owners = {owners.back()};
  // "a village next to a lake in the east": the lake is there, and so is the village by it.
  const std::size_t before = at_ > 0 && IsSense(at_ - 1, Sense::kIn) ? at_ - 1 : at_;
  const bool of_pronoun =
      before > 0 && IsPhrase(before - 1) && chunks_[before - 1].phrase.noun == nullptr;
  const bool by_object = frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
                         !IsKind(at_ - 1, ChunkKind::kComma) && !IsCourse(frame_->sense) &&
                         !of_pronoun;
  if (by_object) {
    const int object = frame_->objects.back();
    const bool fresh = d_.feature(object).zones.empty() && !IsLine(object);
    const bool together = !WantsTwo(frame_->sense) && LineOf(owners) < 0;
    if (!together && !IsLine(object)) {
      if (fresh) d_.AddZones(object, zones);
      d_.Extend(object, chunk.end);
      return;
    }
    if (fresh) owners.push_back(object);
    owners.erase(std::remove_if(owners.begin(), owners.end(),
                                [&](int index) {
                                  return index != object && !d_.feature(index).zones.empty();
                                }),
                 owners.end());
  } else if (frame_.has_value() && !frame_->objects.empty() && IsCourse(frame_->sense) &&
             !IsKind(at_ - 1, ChunkKind::kComma)) {
    // "leads to the town in the upper right", "cutting through a forest in the centre"
    const int object = frame_->objects.back();
    if (!IsLine(object)) {
      if (d_.feature(object).zones.empty()) d_.AddZones(object, zones);
      d_.Extend(object, chunk.end);
      return;
    }
  }
  // The rest has no place of its own beside what has one.
  if (owners.size() > 1) {
    owners.erase(std::remove_if(owners.begin(), owners.end(),
                                [&](int index) { return d_.feature(index).fills_rest; }),
                 owners.end());
  }
  // "mostly grass and a single building in the middle", "40 % forest and one lake in the middle":
  // the building, the lake is there.
  if (owners.size() > 1) {
    const int placed = owners.back();
    const bool counted = d_.feature(placed).form == FeatureForm::kPatch &&
                         (d_.feature(placed).pieces_least > 0 || !d_.thing(placed).plural);
    owners.erase(std::remove_if(owners.begin(), owners.end(),
                                [&](int index) {
                                  const PlannedFeature& other = d_.feature(index);
                                  const bool land =
                                      other.form == FeatureForm::kSpread &&
                                      (other.dominant || other.texture == Texture::kScattered);
                                  const bool grid = other.shape == ClaimShape::kGridded;
                                  const bool covers =
                                      other.zones.empty() && other.share.value_or(0.0) >= 0.2;
                                  return counted && index != placed && (land || grid || covers);
                                }),
                 owners.end());
  }
  // "roads reaching every side of the map"
  const bool all_sides = zones.size() == 4 || (zones.size() == 1 && zones.front().name == "edges");
  if (all_sides && owners.size() == 1 && IsLine(owners[0]) && SaysReach()) {
    ReachAllSides(owners[0]);
    d_.Extend(owners[0], chunk.end);
    return;
  }
  for (const int index : owners) {
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
    // "one arm leaves in the west, the other in the east"
    if (IsLine(index) && feature.from.has_value() && feature.from->feature >= 0 &&
        IsLine(feature.from->feature) && !feature.to.has_value() && zones.size() == 1) {
      Waypoint to;
      to.zone = EndZoneOf(zones.front(), d_.Words(chunk.begin, chunk.end));
      feature.to = to;
      d_.Extend(index, chunk.end);
      continue;
    }
    // "a river down the middle", "a road across the middle"
    const bool down = zones.size() == 1 && zones.front().name == "middle columns";
    const bool across = zones.size() == 1 && zones.front().name == "middle rows";
    if (IsLine(index) && (down || across) && !feature.from.has_value() && !feature.to.has_value() &&
        feature.pieces <= 1) {
      Waypoint from;
      from.zone = RimZoneOf(down ? Heading{0, -1} : Heading{-1, 0});
      Waypoint via;
      via.zone = *FindZone("center");
      Waypoint to;
      to.zone = RimZoneOf(down ? Heading{0, 1} : Heading{1, 0});
      feature.from = from;
      feature.via = {via};
      feature.to = to;
      d_.Extend(index, chunk.end);
      continue;
    }
    const bool line_with_course =
        IsLine(index) && (feature.from.has_value() || feature.to.has_value());
    if (IsLine(index) && TurnsAt(zones, &feature)) {
      d_.Extend(index, chunk.end);
      continue;
    }
    if (line_with_course) {
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
    const bool fills =
        extent && feature.pieces_least == 0 && feature.texture == Texture::kUnsaid &&
        !feature.share.has_value() && owners.size() == 1 && !confining_ &&
        (feature.form == FeatureForm::kSpread || feature.letter == 'A' || IsUncounted(index));
    if (fills) {
      // "vineyards on the left half": as many as fill it.
      feature.dominant = true;
      feature.form = FeatureForm::kSpread;
      feature.pieces = 0;
    }
    d_.Extend(index, chunk.end);
  }
  confining_ = false;
  open_list_ = false;
}

}  // namespace latticeworld
