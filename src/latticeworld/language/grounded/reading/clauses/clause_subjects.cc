#include <algorithm>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// What noun phrases are in their clause: its objects, or its subjects and all that holds of these.
namespace latticeworld {
namespace {

constexpr double kCoveringShare = 0.5;  // "the northern half is forest": at least
constexpr double kOnlyShare = 0.85;     // "nothing but forest": at least

// What is only there beside a thing says nothing of the whole map.
bool TiesObject(const Frame& frame) {
  switch (frame.sense) {
    case Sense::kBetween:
    case Sense::kNextTo:
    case Sense::kNear:
    case Sense::kAlong:
    case Sense::kSurrounds:
    case Sense::kBothSides:
    case Sense::kBehind:
    case Sense::kInFront:
    case Sense::kBeyond:
    case Sense::kIn:
    case Sense::kWithin:
      return !frame.objects.empty();
    default:
      return false;
  }
}

}  // namespace

// "nothing but trees along the river"
bool ClauseReader::TiesSubject(std::size_t at) const {
  // "Only grassland lies south of the lake."
  const bool verb = IsSense(at, Sense::kBe) || IsSense(at, Sense::kStands);
  if (verb && IsKind(at + 1, ChunkKind::kDirection)) ++at;
  if (!IsThing(at + 1)) return false;
  if (IsKind(at, ChunkKind::kDirection)) return true;
  for (const Sense sense : {Sense::kBetween, Sense::kNextTo, Sense::kNear, Sense::kAlong,
                            Sense::kBothSides, Sense::kBehind, Sense::kBeyond}) {
    if (IsSense(at, sense)) return true;
  }
  return false;
}

// "beyond the roofs", of a town that was spoken of in another sentence: all around it.
bool ClauseReader::IsBeyondKnown(int index) const {
  const PlannedFeature& feature = d_.feature(index);
  if (frame_->sense != Sense::kBeyond || frame_->objects.empty() ||
      feature.form != FeatureForm::kSpread || !feature.zones.empty()) {
    return false;
  }
  const char letter = d_.feature(frame_->objects.back()).letter;
  for (int i = 0; i < sentence_first_feature_; ++i)
    if (!d_.thing(i).dropped && d_.feature(i).letter == letter) return true;
  return false;
}

void ClauseReader::TakeObjects(const std::vector<int>& found) {
  Frame& frame = *frame_;
  // "the forest hugs its whole shoreline"
  const Chunk& chunk = chunks_[at_];
  if (frame.sense == Sense::kAlong && found.size() == 1 && IsLine(found[0])) JoinEnds(found[0]);
  const bool whole_shore = chunk.phrase.head == Head::kShore &&
                           (frame.sense == Sense::kNextTo || frame.sense == Sense::kAlong);
  if (whole_shore) {
    const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
    for (const std::string_view all : {"whole", "entire", "all "}) {
      if (words.find(all) != std::string::npos) frame.sense = Sense::kSurrounds;
    }
  }
  // "snow nowhere but on one peak in the corner": the peak's is all there is.
  if (confining_ && frame.sense == Sense::kIn && found.size() == 1 && !frame.fronted &&
      frame.subjects.size() == 1 && frame.subjects[0] != found[0] &&
      d_.feature(frame.subjects[0]).letter == d_.feature(found[0]).letter) {
    d_.Drop(frame.subjects[0]);
    d_.feature(found[0]).confined = true;
    confining_ = false;
    frame_.reset();
    subjects_ = found;
    return;
  }
  for (const int index : found) {
    frame.objects.push_back(index);
    ResolveBehind(&frame);
    if (frame.fronted) continue;
    if (WantsTwo(frame.sense) && frame.objects.size() < 2 && found.size() == 1) continue;
    if (frame.sense == Sense::kSeparatedBy || frame.sense == Sense::kConnectedBy) {
      if (!frame.subjects.empty()) Assert(frame, frame.subjects.back(), &d_);
      continue;
    }
    if (WantsTwo(frame.sense) && index != found.back()) continue;
    for (const int subject : frame.subjects) Assert(frame, subject, &d_);
  }
  // "the town lies at the inner end of the fjord": on from there.
  const Heading way = frame.at_end && found.size() == 1 ? WayOf(found[0]) : Heading{0, 0};
  if ((way.east != 0) != (way.south != 0) && !frame.fronted) {
    Frame end;
    end.is_direction = true;
    end.heading = way;
    end.objects = found;
    for (const int subject : frame.subjects) Assert(end, subject, &d_);
  }
  if (!frame.fronted && !frame.subjects.empty()) NoteAxis(frame, frame.subjects.back());
  if (frame.sense == Sense::kOutside) {
    for (const int subject : frame.subjects) d_.AddZones(subject, {*FindZone("edges")});
  }
  const bool wants_more = WantsTwo(frame.sense) && frame.objects.size() < 2 &&
                          ((IsSense(at_ + 1, Sense::kAnd) && !IsSense(at_ + 2, Sense::kTo) &&
                            !IsSense(at_ + 2, Sense::kRuns)) ||
                           IsSense(at_ + 1, Sense::kFrom) || IsSense(at_ + 1, Sense::kTo) ||
                           IsSense(at_ + 1, Sense::kWith) || IsKind(at_ + 1, ChunkKind::kPlace) ||
                           IsSense(at_ + 1, Sense::kIn));
  // "between the two lakes": one phrase, two pieces.
  if (WantsTwo(frame.sense) && frame.objects.size() == 1 && !wants_more && !frame.fronted &&
      (!IsSense(at_ + 1, Sense::kWhich) && !IsKind(at_ + 1, ChunkKind::kComma))) {
    for (const int subject : frame.subjects) Assert(frame, subject, &d_);
  }
  frame.expecting = false;
  for (const int index : frame.subjects) {
    if (index < d_.size() && at_ < chunks_.size()) d_.Extend(index, chunks_[at_].end);
  }
}

// "With a lake to its west and a wood to its east, the village ...": of the village.
void ClauseReader::TakeSides(const std::vector<int>& found) {
  const bool after_comma = at_ > 0 && IsKind(at_ - 1, ChunkKind::kComma);
  if (sides_to_come_.empty() || !after_comma || found.size() != 1) return;
  for (const auto& [thing, heading] : sides_to_come_) {
    Frame frame;
    frame.is_direction = true;
    frame.heading = heading;
    frame.objects = found;
    if (thing != found[0]) Assert(frame, thing, &d_);
  }
  sides_to_come_.clear();
}

void ClauseReader::TakeSubjects(const std::vector<int>& found, bool is_new, const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (ordering_) {
    for (const int index : found) {
      const bool passed = !IsLine(index) || (host_ < 0 && !frame_.has_value());
      if (passed && std::find(order_.begin(), order_.end(), index) == order_.end()) {
        order_.push_back(index);
      }
    }
  }
  const bool fronted = frame_.has_value() && frame_->fronted;
  if (joining_ && !fronted) {
    for (const int index : found) {
      if (std::find(subjects_.begin(), subjects_.end(), index) == subjects_.end()) {
        subjects_.push_back(index);
      }
    }
  } else {
    if (!fronted) {
      if (!subjects_.empty()) BeginClause();
    } else {
      d_.SetTopic(subjects_);
    }
    subjects_ = found;
    // "they are in the west", "both run from top to bottom": all that these are
    list_has_and_ = found.size() > 1 && phrase.noun == nullptr && !fronted &&
                    (phrase.head == Head::kThey || phrase.head == Head::kBoth) &&
                    (IsSense(at_ + 1, Sense::kBe) || IsSense(at_ + 1, Sense::kStands) ||
                     IsSense(at_ + 1, Sense::kRuns));
  }
  joining_ = false;
  open_list_ = true;
  absences_.clear();
  negating_ = false;
  for (const int index : found) {
    PlannedFeature& feature = d_.feature(index);
    if (rest_next_) feature.fills_rest = true;
    if (only_next_ && IsLine(index) && ListLength(at_) > 1 && lead_.empty()) d_.AllIsSaid();
    if (only_next_ && !IsLine(index)) {
      const Heading side = fronted ? HeadingOfFrame(*frame_) : Heading{0, 0};
      if (fronted && IsBeyondKnown(index)) {
        feature.dominant = feature.fills_rest = true;
      } else if ((fronted && TiesObject(*frame_)) || (!fronted && TiesSubject(at_ + 1))) {
        // "in between there is only rock", "nothing but trees along the river"
        const bool between = fronted && frame_->sense == Sense::kBetween;
        if (between) feature.form = FeatureForm::kSpread;
      } else if (side.east == 0 && side.south == 0) {
        OnlyThis(index, is_new);
      } else if (feature.zones.empty() && feature.form == FeatureForm::kSpread) {
        // "below it nothing but trees"
        d_.AddZones(index, {ZoneOf(side)});
        feature.dominant = true;
        feature.share_least = std::max(feature.share_least.value_or(0.0), kOnlyShare);
      }
    }
    // "all snow and three lakes"
    const bool all = is_new && phrase.each && !phrase.definite && lead_.empty() &&
                     feature.form == FeatureForm::kSpread &&
                     (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma) ||
                      IsSense(at_ + 1, Sense::kAnd) || IsSense(at_ + 1, Sense::kWith));
    if (all) feature.fills_rest = true;
    // "the left side is all rock, the right side all forest"
    if (is_new && phrase.each && !lead_.empty() && lead_.is_subject && !IsLine(index)) {
      feature.dominant = true;
    }
    if (mostly_next_) feature.dominant = true;
    const bool named = is_new || phrase.noun != nullptr;
    const bool spoken_of = !is_new && d_.thing(index).sentence == d_.sentence() &&
                           d_.thing(index).begin < lead_.begin && IsSense(at_ + 1, Sense::kNextTo);
    if (!lead_.empty() && !excepting_ && named && !spoken_of) {
      if (is_new || feature.zones.empty()) {
        if (feature.zones.empty()) {
          d_.AddZones(index, lead_.zones);
          d_.thing(index).zones_from_lead = true;
        }
        if (is_new && d_.thing(index).sentence == d_.sentence()) {
          d_.thing(index).begin = std::min(d_.thing(index).begin, lead_.begin);
        }
      }
      lead_.used = true;
    } else if (!lead_.empty() && excepting_) {
      d_.AddZones(index, lead_.zones);
    }
    if (lead_.band && named && !excepting_) FillBand(index);
    const bool bare_extent = !lead_.empty() && lead_.is_subject && lead_.extent && is_new;
    if ((cover_next_ && named) || bare_extent) Cover(index, chunk);
    // "at most a tenth of the map should be roads"
    if (map_share_.has_value() && (!IsLine(index) || (map_share_->fraction && share_of_map_))) {
      Qualities said;
      said.share = map_share_;
      said.any = true;
      d_.Describe(said, index);
    }
    if (is_new && named && !excepting_) ShareOfLead(index, chunk);
    if (IsLine(index) && lead_.along && !lead_.empty() && is_new) {
      feature.along = AlongZone(lead_.zones.front());
      feature.zones.clear();
    }
    const bool runs = from_.has_value() && to_.has_value() && found.size() == 1 &&
                      feature.form == FeatureForm::kPatch && feature.letter == 'W';
    if (runs) {  // "from top to bottom lies the lake"
      feature.form = FeatureForm::kLine;
      feature.wide = true;
    }
    if (IsLine(index)) {
      if (from_.has_value()) d_.feature(index).from = from_;
      if (to_.has_value()) d_.feature(index).to = to_;
    }
    if (host_ >= 0 && hosted_ < 0) {
      hosted_ = index;
      host_relations_ = d_.plan().relations.size();
    }
  }
  if (LineOf(found) >= 0) {
    from_.reset();
    to_.reset();
  }
  rest_next_ = mostly_next_ = only_next_ = false;
  if (sharing_ > 0) --sharing_;
  if (sharing_ == 0) map_share_.reset();
  if (is_new && (!fronted || frame_->sense == Sense::kNextTo)) Follow(found.back());
  then_after_ = -1;
  if (fronted) {
    ResolveBehind(&*frame_);
    NoteAxis(*frame_, found.back());
    frame_->subjects = found;
    const bool two_at_once = WantsTwo(frame_->sense);
    Frame each = *frame_;
    for (const int subject : found) {
      if (two_at_once) {
        Assert(*frame_, subject, &d_);
        continue;
      }
      for (const int object : frame_->objects) {
        each.objects = {object};
        Assert(each, subject, &d_);
      }
    }
    frame_.reset();
  }
  excepting_ = false;
  if (phrase.qualities.parallel && found.size() == 1 && IsLine(found[0])) {
    Frame frame;
    frame.sense = Sense::kParallelEach;
    frame.subjects = found;
    const int pieces = d_.feature(found[0]).pieces;
    if (pieces == 0) d_.feature(found[0]).pieces = 2;
    const int before = d_.size();
    AssertEachOther(frame, &d_);
    if (d_.size() > before) subjects_.push_back(d_.size() - 1);
    list_has_and_ = true;
  }
  if (phrase.qualities.more || phrase.qualities.less) {
    comparing_less_ = phrase.qualities.less;
    std::size_t next = at_ + 1;
    if (IsSense(next, Sense::kBe)) ++next;
    comparing_ = IsSense(next, Sense::kThan);
  }
}

// "The north is half forest", "in the west there is 30 % water": half of the north, for none said
// that it is of the map.
void ClauseReader::ShareOfLead(int index, const Chunk& chunk) {
  const bool share = chunk.phrase.qualities.share.has_value()
                         ? chunk.phrase.qualities.share->fraction
                         : map_share_.has_value() && map_share_->fraction && !share_of_map_;
  PlannedFeature& feature = d_.feature(index);
  if (!share || lead_.empty() || lead_.zones.size() != 1 || feature.zones != lead_.zones) return;
  feature.share_of_zones = true;
}

// "nothing but trees", after all else that there is: these are the rest. "only snow and rocks":
// nothing but these.
void ClauseReader::OnlyThis(int index, bool is_new) {
  PlannedFeature& feature = d_.feature(index);
  if (ListLength(at_) > 1 && !rest_next_) {
    if (lead_.empty()) d_.AllIsSaid();
    return;
  }
  const bool after_others = d_.size() > (is_new ? 1 : 2);
  feature.dominant = true;
  if (after_others && lead_.empty() && !frame_.has_value() &&
      feature.form == FeatureForm::kSpread && feature.zones.empty() &&
      (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma))) {
    feature.fills_rest = true;
    return;
  }
  feature.share_least = std::max(feature.share_least.value_or(0.0), kOnlyShare);
}

// "the second stripe is houses", "... a river": a stripe of houses, a river from end to end.
void ClauseReader::FillBand(int index) {
  PlannedFeature& feature = d_.feature(index);
  if (feature.zones != lead_.zones) return;
  if (IsLine(index)) {
    const UnitBox& box = lead_.zones.front().boxes.front();
    order_heading_ = box.v_max - box.v_min < 1.0 ? Heading{0, 1} : Heading{1, 0};
    LayInBand(index, lead_.zones.front());
    if (feature.from.has_value()) feature.zones.clear();
  } else if (feature.form == FeatureForm::kPatch && feature.pieces_least == 0) {
    feature.form = FeatureForm::kSpread;
    feature.pieces = 0;
  }
}

// "the northern half is forest": it has more than anything else there, and half of it at least
// where it is all that is named.
void ClauseReader::Cover(int index, const Chunk& chunk) {
  PlannedFeature& feature = d_.feature(index);
  const bool counted = chunk.phrase.qualities.count.has_value() || feature.pieces > 1;
  if (IsLine(index) || counted || host_ >= 0) return;
  const bool verb_before =
      at_ > 0 && (IsSense(at_ - 1, Sense::kBe) || IsSense(at_ - 1, Sense::kCoveredBy));
  const bool extent = !lead_.empty() && lead_.extent && verb_before && host_ < 0;
  if (feature.form != FeatureForm::kSpread && chunk.phrase.indefinite && !extent) return;
  if (feature.share.has_value() || map_share_.has_value()) return;
  if (ListLength(at_) > 1 || (list_has_and_ && subjects_.size() > 1)) return;
  feature.dominant = true;
  if (!lead_.empty() && lead_.extent) {
    feature.share_least = std::max(feature.share_least.value_or(0.0), kCoveringShare);
  }
}

}  // namespace latticeworld
