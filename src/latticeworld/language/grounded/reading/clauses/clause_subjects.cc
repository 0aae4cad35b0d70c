#include <algorithm>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Noun phrases that a clause is about, and all that holds of these.
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

void ClauseReader::TakeSubjects(const std::vector<int>& found, bool is_new, const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (ordering_) PassInOrder(found);
  const bool fronted = frame_.has_value() && frame_->fronted;
  BecomeSubjects(found, fronted, phrase);
  // What held for the subjects before ends.
  joining_ = false;
  open_list_ = true;
  absences_.clear();
  negating_ = false;
  // What was said before its noun is said of each subject.
  for (const int index : found) {
    const bool named = is_new || phrase.noun != nullptr;
    if (rest_next_) d_.feature(index).fills_rest = true;
    if (only_next_) LimitTo(index, is_new, fronted);
    FillAll(index, is_new, phrase);
    TakeLeadOf(index, is_new, named);
    if (lead_.band && named && !excepting_) FillBand(index);
    TakeShare(index, is_new, named, chunk);
    TakeCourse(index, is_new, found.size() == 1);
    if (host_ >= 0 && hosted_ < 0) {
      hosted_ = index;
      host_relations_ = d_.plan().relations.size();
    }
  }
  if (LineOf(found) >= 0) {
    from_.reset();
    to_.reset();
  }
  // It is used up by that.
  rest_next_ = mostly_next_ = only_next_ = false;
  if (sharing_ > 0) --sharing_;
  if (sharing_ == 0) map_share_.reset();
  if (is_new && (!fronted || frame_->sense == Sense::kNextTo)) Follow(found.back());
  then_after_ = -1;
  if (fronted) AssertFronted(found);
  excepting_ = false;
  if (phrase.qualities.parallel && found.size() == 1 && IsLine(found[0])) RunParallel(found);
  // "more houses than": what follows is compared with these.
  if (phrase.qualities.more || phrase.qualities.less) {
    comparing_less_ = phrase.qualities.less;
    std::size_t next = at_ + 1;
    if (IsSense(next, Sense::kBe)) ++next;
    comparing_ = IsSense(next, Sense::kThan);
  }
}

// "going north: fields, then woods": they are passed in this order.
void ClauseReader::PassInOrder(const std::vector<int>& found) {
  for (const int index : found) {
    const bool passed = !IsLine(index) || (host_ < 0 && !frame_.has_value());
    if (passed && std::find(order_.begin(), order_.end(), index) == order_.end()) {
      order_.push_back(index);
    }
  }
}

// The clause is about these, beside those of the list that they go on.
void ClauseReader::BecomeSubjects(const std::vector<int>& found, bool fronted,
                                  const NounPhrase& phrase) {
  if (joining_ && !fronted) {
    for (const int index : found) {
      if (std::find(subjects_.begin(), subjects_.end(), index) == subjects_.end()) {
        subjects_.push_back(index);
      }
    }
    return;
  }
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

// "nothing but trees": of the whole map, or of a place or a side of something alone.
void ClauseReader::LimitTo(int index, bool is_new, bool fronted) {
  if (IsLine(index)) {
    if (ListLength(at_) > 1 && lead_.empty()) d_.AllIsSaid();
    return;
  }
  PlannedFeature& feature = d_.feature(index);
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

// "all", "mostly"
void ClauseReader::FillAll(int index, bool is_new, const NounPhrase& phrase) {
  PlannedFeature& feature = d_.feature(index);
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
}

// "In the north there is a lake": there, where nothing else was said of it.
void ClauseReader::TakeLeadOf(int index, bool is_new, bool named) {
  if (lead_.empty()) return;
  if (excepting_) {
    d_.AddZones(index, lead_.zones);
    return;
  }
  PlannedFeature& feature = d_.feature(index);
  const bool spoken_of = !is_new && d_.thing(index).sentence == d_.sentence() &&
                         d_.thing(index).begin < lead_.begin && IsSense(at_ + 1, Sense::kNextTo);
  if (!named || spoken_of) return;
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
}

// How much of the map or of the clause's place it covers.
void ClauseReader::TakeShare(int index, bool is_new, bool named, const Chunk& chunk) {
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
}

// Takes where the line runs, as the words before it told; `alone`: nothing else is named with it.
void ClauseReader::TakeCourse(int index, bool is_new, bool alone) {
  PlannedFeature& feature = d_.feature(index);
  if (IsLine(index) && lead_.along && !lead_.empty() && is_new) {
    feature.along = AlongZone(lead_.zones.front());
    feature.zones.clear();
  }
  const bool runs = from_.has_value() && to_.has_value() && alone &&
                    feature.form == FeatureForm::kPatch && feature.letter == 'W';
  if (runs) {  // "from top to bottom lies the lake"
    feature.form = FeatureForm::kLine;
    feature.wide = true;
  }
  if (IsLine(index)) {
    if (from_.has_value()) feature.from = from_;
    if (to_.has_value()) feature.to = to_;
  }
}

// "Next to the lake lies a village": the relation has its subjects now.
void ClauseReader::AssertFronted(const std::vector<int>& found) {
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

// "parallel roads": two of them, where they were not counted.
void ClauseReader::RunParallel(const std::vector<int>& found) {
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
