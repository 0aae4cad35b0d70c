#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// What a place is said of: of what a clause is about, of the object of its relation, of what is to
// come.
namespace latticeworld {
namespace {

constexpr double kCoveringShare = 0.5;  // "forest covers the northern half": at least
constexpr double kWholeShare = 0.75;    // "the whole northern half"
constexpr int kCityCells = 60;          // what is so large may lie everywhere

bool IsSide(Heading heading) { return heading.east != 0 || heading.south != 0; }

Heading SideOf(const std::vector<Zone>& zones) { return HeadingOf(RegionOf(zones.front())); }

}  // namespace

bool ClauseReader::IsMany(const std::vector<Zone>& zones) {
  return zones.size() > 1 || zones[0].name == "corners" || zones[0].name == "edges";
}

// Whether all of the place is meant: "the northern half".
bool ClauseReader::MeansAllOf(const std::vector<Zone>& zones, const Chunk& chunk) const {
  return chunk.lexeme.whole || SaysExtent(d_.Words(chunk.begin, chunk.end)) ||
         (zones.size() == 1 && IsExtent(zones.front()));
}

// The zones of a place; those of "the other corners" depend on what was laid before.
std::vector<Zone> ClauseReader::ZonesSaid(const Chunk& chunk) const {
  std::vector<Zone> zones = ZonesOf(chunk.lexeme.places);
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  if (at_ > 0 && IsPhrase(at_ - 1) && chunks_[at_ - 1].phrase.head == Head::kOther &&
      chunks_[at_ - 1].phrase.noun == nullptr && IsMany(zones)) {
    zones = OtherZones(std::move(zones), words);
  }
  OppositePlace(words, &zones);
  return zones;
}

void ClauseReader::ReadPlace(const Chunk& chunk) {
  const std::vector<Zone> zones = ZonesSaid(chunk);
  if (SaysAnywhere(chunk.lexeme.places)) {
    PlaceAnywhere(chunk);
    return;
  }
  last_zones_ = zones;
  zones_before_ = zones;
  if (zones.size() == 1 && IsExtent(zones.front())) halves_.push_back(zones.front());
  if (PlaceInBrackets(zones, chunk) || ExceptPlace(zones, chunk) || DenyPlace(zones, chunk) ||
      CorrectPlace(zones) || TravelToward(zones, chunk)) {
    return;
  }
  there_.clear();
  if (TakeContrast(zones) || TakeEndZone(zones)) return;
  there_ = zones;
  if (PlaceFrontedObject(zones, chunk) || TurnBehind(zones) || TakePlaceAsObject(zones, chunk) ||
      PlaceBorders(zones, chunk) || PlaceTouching(zones, chunk)) {
    return;
  }
  if (LeadsClause()) {
    TakeLead(zones, chunk);
    return;
  }
  const bool extent = MeansAllOf(zones, chunk);
  // "Forest covers the north, fields the south.": covers it too.
  if (covered_ == d_.sentence() && at_ > 0 && IsPhrase(at_ - 1) && subjects_.size() == 1 &&
      !IsLine(subjects_[0]) && !frame_.has_value() && !verb_said_) {
    d_.feature(subjects_[0]).dominant = true;
    if (extent) d_.feature(subjects_[0]).share_least = kCoveringShare;
  }
  Attach(zones, extent, chunk);
}

// "forest everywhere", "no water anywhere", "houses all over"
void ClauseReader::PlaceAnywhere(const Chunk& chunk) {
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
               !d_.thing(index).plural && (feature.letter == 'G' || feature.cells >= kCityCells)) {
      feature.form = FeatureForm::kSpread;  // "lawn everywhere", "city everywhere"
      feature.dominant = true;
    } else if (feature.form == FeatureForm::kPatch) {
      feature.texture = Texture::kScattered;
    }
    d_.Extend(index, chunk.end);
  }
  if (subjects_.empty() && absences_.empty() && ThingFollows(at_ + 1, true)) mostly_next_ = true;
  if (frame_.has_value() && frame_->objects.empty() && !frame_->fronted) frame_.reset();
}

// "the settlement (west)": of what stands right before it.
bool ClauseReader::PlaceInBrackets(const std::vector<Zone>& zones, const Chunk& chunk) {
  const bool in_brackets = chunk.begin > 0 && d_.instruction()[chunk.begin - 1] == '(' &&
                           at_ >= 2 && IsThing(at_ - 2) && d_.size() > 0;
  if (!in_brackets) return false;
  const int last = d_.LastMentioned();
  if (last >= 0) {
    d_.AddZones(last, zones);
    d_.Extend(last, chunk.end);
  }
  return true;
}

// "forest everywhere except in the south"
bool ClauseReader::ExceptPlace(const std::vector<Zone>& zones, const Chunk& chunk) {
  if (!excepting_ || ThingFollows(at_ + 1, false) || subjects_.empty()) return false;
  for (const int index : subjects_) Deny(d_.feature(index).letter, zones, chunk);
  Lead_(zones, chunk);
  return true;
}

// "the lake and the forest are not in the north"
bool ClauseReader::DenyPlace(const std::vector<Zone>& zones, const Chunk& chunk) {
  if (!not_next_) return false;
  not_next_ = false;
  const bool all = list_has_and_ && verb_said_;
  for (const int index : subjects_) {
    if (all || index == subjects_.back()) Deny(d_.feature(index).letter, zones, chunk);
  }
  absences_.clear();
  if (frame_.has_value() && frame_->objects.empty()) frame_.reset();
  return true;
}

// "a lake in the north, no, in the south"
bool ClauseReader::CorrectPlace(const std::vector<Zone>& zones) {
  if (!correcting_ || ThingFollows(at_ + 1, false)) return false;
  correcting_ = false;
  const int last = !subjects_.empty() ? subjects_.back() : d_.size() - 1;
  if (last < 0) return false;
  d_.feature(last).zones.clear();
  d_.thing(last).zones_from_lead = false;
  d_.AddZones(last, zones);
  return true;
}

// "going north: fields, then woods", "advance east through ...": an order that way.
bool ClauseReader::TravelToward(const std::vector<Zone>& zones, const Chunk& chunk) {
  const Heading to = SideOf(zones);
  const bool travels = traveling_ && at_ > 0 && IsSense(at_ - 1, Sense::kTravel) &&
                       zones.size() == 1 && IsSide(to) &&
                       !SaysExtent(d_.Words(chunk.begin, chunk.end));
  if (!travels) return false;
  // "Snow in the west, then going east rocks, then bushes"
  if (then_after_ >= 0 && !to.IsDiagonal() && !ordering_) {
    const int first = std::exchange(then_after_, -1);
    BeginClause();
    BeginOrder(to);
    order_ = {first};
    return true;
  }
  if (!subjects_.empty() || from_.has_value() || frame_.has_value()) return false;
  BeginOrder(to);
  return true;
}

// "From the lake in the north-east flows a stream": the lake is there.
bool ClauseReader::PlaceFrontedObject(const std::vector<Zone>& zones, const Chunk& chunk) {
  const bool of_object =
      frame_.has_value() && frame_->fronted && !frame_->objects.empty() && at_ > 0 &&
      (IsPhrase(at_ - 1) || (IsSense(at_ - 1, Sense::kIn) && at_ > 1 && IsPhrase(at_ - 2)));
  if (!of_object) return false;
  const int object = frame_->objects.back();
  if (d_.feature(object).zones.empty() && !IsLine(object)) d_.AddZones(object, zones);
  d_.Extend(object, chunk.end);
  return true;
}

// "behind the hotels, further to the east, runs a road"
bool ClauseReader::TurnBehind(const std::vector<Zone>& zones) {
  const Heading side = SideOf(zones);
  const bool behind = frame_.has_value() && frame_->fronted && !frame_->objects.empty() &&
                      (frame_->sense == Sense::kBehind || frame_->sense == Sense::kBeyond) &&
                      IsSide(side);
  if (!behind) return false;
  frame_->is_direction = true;
  frame_->heading = side;
  return true;
}

// "forest covers the north", "keep the houses away from the north": the relation is to a place.
bool ClauseReader::TakePlaceAsObject(const std::vector<Zone>& zones, const Chunk& chunk) {
  if (!frame_.has_value() || !frame_->expecting || !frame_->objects.empty() || frame_->fronted) {
    return false;
  }
  const Sense sense = frame_->sense;
  const bool covers = sense == Sense::kCovers || sense == Sense::kDominates;
  const bool away = sense == Sense::kAway || frame_->negated;
  const bool extent = MeansAllOf(zones, chunk);
  for (const int index : frame_->subjects) {
    if (covers && !IsLine(index)) {
      d_.feature(index).dominant = true;
      if (extent && d_.feature(index).form != FeatureForm::kLine) {
        const std::string lower = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
        const bool whole = chunk.lexeme.whole || lower.find("whole") != std::string::npos ||
                           lower.find("entire") != std::string::npos;
        d_.feature(index).share_least = std::max(d_.feature(index).share_least.value_or(0.0),
                                                 whole ? kWholeShare : kCoveringShare);
      }
    }
    if (away) Deny(d_.feature(index).letter, zones, chunk);
  }
  frame_.reset();
  if (away) {
    absences_.clear();
    return true;
  }
  if (covers) covered_ = d_.sentence();
  Attach(zones, extent, chunk);
  return true;
}

// "bordered by forest on the north and by fields on the south": of what is bordered.
bool ClauseReader::PlaceBorders(const std::vector<Zone>& zones, const Chunk& chunk) {
  const Heading side = SideOf(zones);
  const bool borders =
      frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
      !frame_->subjects.empty() && zones.size() == 1 &&
      (frame_->sense == Sense::kSurroundedBy || frame_->sense == Sense::kBorderedBy ||
       frame_->sense == Sense::kFlankedBy) &&
      IsSide(side) && zones.front() == ZoneOf(side) &&
      (IsSense(at_ - 1, Sense::kIn) || IsSense(at_ - 1, Sense::kTo) ||
       IsSense(at_ - 1, Sense::kAnd) || IsKind(at_ - 1, ChunkKind::kComma));
  if (!borders) return false;
  const bool list = IsKind(at_ + 1, ChunkKind::kComma) || IsSense(at_ + 1, Sense::kAnd) ||
                    !IsSense(at_ - 1, Sense::kIn);
  if (frame_->sense == Sense::kSurroundedBy && list) return true;
  Frame there;
  there.is_direction = true;
  there.heading = side;
  there.objects = {frame_->subjects.back()};
  Assert(there, frame_->objects.back(), &d_);
  d_.Extend(frame_->objects.back(), chunk.end);
  return true;
}

// "the road touches the forest on the east side": on the forest's.
bool ClauseReader::PlaceTouching(const std::vector<Zone>& zones, const Chunk& chunk) {
  const Heading side = SideOf(zones);
  const bool of_forest = frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
                         frame_->sense == Sense::kNextTo && zones.size() == 1 && IsSide(side) &&
                         EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "side") &&
                         at_ > 1 && IsSense(at_ - 1, Sense::kIn) && IsPhrase(at_ - 2);
  if (!of_forest) return false;
  Frame there;
  there.is_direction = true;
  there.heading = side;
  there.objects = {frame_->objects.back()};
  for (const int index : frame_->subjects) Assert(there, index, &d_);
  return true;
}

// Whether a clause begins with the place: "In the north there is ...", "..., the south is ...".
bool ClauseReader::LeadsClause() const {
  if (subjects_.empty() && absences_.empty()) return true;
  const auto breaks = [&](std::size_t at) {
    return IsKind(at, ChunkKind::kComma) || IsSense(at, Sense::kAnd) || IsSense(at, Sense::kThen);
  };
  const bool after_break =
      at_ > 0 && (breaks(at_ - 1) || (IsSense(at_ - 1, Sense::kIn) && at_ > 1 && breaks(at_ - 2)));
  if (!after_break) return false;
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
  return is_subject || ThingFollows(at_ + 1, false);
}

// What comes next in the clause is there.
void ClauseReader::TakeLead(const std::vector<Zone>& zones, const Chunk& chunk) {
  const bool nothing_yet = subjects_.empty() && absences_.empty();
  const bool joins = nothing_yet && !lead_.empty() && !lead_.used && at_ > 0 &&
                     (IsSense(at_ - 1, Sense::kAnd) || (at_ > 1 && IsSense(at_ - 2, Sense::kAnd)));
  if (joins) {
    for (const Zone& zone : zones) lead_.zones.push_back(zone);
    return;
  }
  if (!nothing_yet) BeginClause();
  if (frame_.has_value() && frame_->fronted && frame_->objects.empty()) frame_.reset();
  Lead_(zones, chunk);
}

void ClauseReader::Lead_(const std::vector<Zone>& zones, const Chunk& chunk) {
  lead_ = Lead();
  lead_.zones = zones;
  lead_.is_subject = at_ == 0 || !chunks_[at_ - 1].Is(Sense::kIn);
  lead_.band = chunk.lexeme.band;
  lead_.extent = MeansAllOf(zones, chunk);
  lead_.along = at_ > 0 && chunks_[at_ - 1].Is(Sense::kAlong);
  lead_.begin = chunk.begin;
}

}  // namespace latticeworld
