#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

namespace latticeworld {
namespace {

constexpr double kCoveringShare = 0.5;  // "the northern half is forest": at least
constexpr double kOnlyShare = 0.6;      // "nothing but forest": at least

}  // namespace

void ClauseReader::ReadNounPhrase(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  const bool zero = phrase.qualities.count.has_value() && phrase.qualities.count->most == 0;
  const bool denied = phrase.negated || zero || (negating_ && phrase.noun != nullptr) ||
                      (not_next_ && phrase.noun != nullptr);
  // "linked with the lake by a straight road": the road joins them.
  const bool joins = frame_.has_value() && frame_->sense == Sense::kConnectedBy &&
                     frame_->objects.size() == 1 && !frame_->subjects.empty() &&
                     !IsLine(frame_->objects[0]) && !IsLine(frame_->subjects.back()) &&
                     phrase.noun != nullptr && phrase.noun->shape == WordShape::kLine;
  if (joins) {
    frame_->sense = Sense::kConnects;
    frame_->objects.insert(frame_->objects.begin(), frame_->subjects.back());
    frame_->fronted = true;
    frame_->expecting = false;
  }
  if (skip_next_ && phrase.noun != nullptr) {
    skip_next_ = false;
    return;
  }
  if (phrase.head == Head::kMap) {
    ReadMap(chunk);
    return;
  }
  if (phrase.head == Head::kRest) {
    ReadRest(chunk);
    return;
  }
  // "half of it is forest": of the map.
  const bool most_there = (phrase.head == Head::kIt || phrase.head == Head::kThey) &&
                          phrase.qualities.share.has_value() && phrase.qualities.share->mostly &&
                          !subjects_.empty() &&
                          (IsKind(at_ + 1, ChunkKind::kPlace) || IsKind(at_ + 2, ChunkKind::kPlace));
  if (most_there) return;  // "woods, most of it in the north"
  if (phrase.head == Head::kIt && phrase.qualities.share.has_value()) {
    ReadMap(chunk);
    return;
  }
  // "none of them touching the border"
  const bool none_of_them =
      phrase.head == Head::kThey && (phrase.negated || zero || phrase.qualities.none);
  if (none_of_them) {
    BeginClause();
    subjects_ = d_.Antecedent({}, /*many=*/true);
    not_next_ = true;
    return;
  }
  // "copses: four of them"
  if (phrase.head == Head::kThey && phrase.qualities.count.has_value()) {
    std::vector<int> about = subjects_;
    if (about.empty()) about = d_.Antecedent({}, true);
    if (about.size() == 1) {
      d_.Describe(phrase.qualities, about[0]);
      d_.Extend(about[0], chunk.end);
      if (subjects_.empty()) subjects_ = about;
      return;
    }
  }
  if (denied && phrase.noun != nullptr) {
    not_next_ = false;
    // "not a lake but a river"
    if (!phrase.negated && !zero && !negating_ && IsSense(at_ + 1, Sense::kBut)) return;
    ReadAbsence(chunk);
    return;
  }
  if (correcting_ && phrase.noun != nullptr) {
    const int last = !subjects_.empty() ? subjects_.back() : d_.size() - 1;
    if (last >= 0 && phrase.qualities.count.has_value() &&
        phrase.noun->LetterIn(d_.plan().vocabulary) == d_.feature(last).letter) {
      correcting_ = false;
      d_.Describe(phrase.qualities, last);
      return;
    }
  }
  if (IsOtherWord(chunk)) return;
  // "three clearings, grassy ones"
  const std::string after = ToLowerAscii(d_.Words(chunk.end, d_.instruction().size())).substr(0, 5);
  if (after == " ones" && phrase.noun != nullptr && !subjects_.empty() && at_ > 0 &&
      IsKind(at_ - 1, ChunkKind::kComma)) {
    d_.Extend(subjects_.back(), chunk.end);
    return;
  }
  if (phrase.head == Head::kOther && phrase.noun == nullptr && IsKind(at_ + 1, ChunkKind::kPlace) &&
      IsMany(ZonesOf(chunks_[at_ + 1].lexeme.places))) {
    if (!subjects_.empty()) BeginClause();
    return;  // "the other corners"
  }
  const int before = d_.size();
  const std::vector<int> found = Refer(chunk);
  const bool is_new = d_.size() > before;
  if (found.empty()) {
    if (frame_.has_value() && frame_->expecting) frame_->expecting = false;
    return;
  }
  for (const int index : found) d_.Extend(index, chunk.end);
  if (comparing_) {
    const int other = found.back();
    Frame frame;
    frame.sense = comparing_less_ ? Sense::kSmallerThan : Sense::kOutweighs;
    frame.objects = {other};
    if (!subjects_.empty()) Assert(frame, subjects_.back(), &d_);
    comparing_ = false;
    return;
  }
  // "The shore of the lake is sand all the way round."
  const bool of_shore = at_ >= 2 && IsSense(at_ - 1, Sense::kBe) && IsThing(at_ - 2) &&
                        chunks_[at_ - 2].phrase.shore && subjects_.size() == 1 &&
                        !frame_.has_value();
  if (of_shore) {
    Frame frame;
    frame.sense = SaysAround(at_ + 1) ? Sense::kSurrounds : Sense::kNextTo;
    frame.objects = subjects_;
    for (const int index : found) Assert(frame, index, &d_);
    subjects_ = found;
    return;
  }
  if (IsSameThing(found, is_new)) {
    Merge(subjects_[0], found[0]);
    subjects_ = found;
    return;
  }
  if (frame_.has_value() && frame_->expecting) {
    TakeObjects(found);
  } else {
    TakeSides(found);
    TakeSubjects(found, is_new, chunk);
  }
  if (correcting_) correcting_ = false;
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

// "all the way round", "all around" right after a thing
bool ClauseReader::SaysAround(std::size_t at) const {
  if (EndsAt(at)) return false;
  const std::string words =
      ToLowerAscii(d_.Words(chunks_[at - 1].end, d_.instruction().size())).substr(0, 24);
  return words.find("round") != std::string::npos;
}

// "The only water is one small reservoir": one thing, said twice.
bool ClauseReader::IsSameThing(const std::vector<int>& found, bool is_new) const {
  if (!is_new || found.size() != 1 || subjects_.size() != 1 || frame_.has_value() || at_ == 0 ||
      !IsSense(at_ - 1, Sense::kBe)) {
    return false;
  }
  const int known = subjects_[0];
  return known != found[0] && d_.thing(known).sentence == d_.sentence() &&
         d_.feature(known).letter == d_.feature(found[0]).letter &&
         IsLine(known) == IsLine(found[0]);
}

// What was said of the one is said of the other, which stays.
void ClauseReader::Merge(int known, int other) {
  PlannedFeature& from = d_.feature(known);
  PlannedFeature& to = d_.feature(other);
  if (to.zones.empty()) to.zones = from.zones;
  if (to.pieces_least == 0) {
    to.pieces = from.pieces;
    to.pieces_least = from.pieces_least;
    to.pieces_most = from.pieces_most;
  }
  if (!to.share.has_value()) to.share = from.share;
  to.dominant = to.dominant || from.dominant;
  to.fills_rest = to.fills_rest || from.fills_rest;
  d_.thing(other).begin = d_.thing(known).begin;
  d_.Drop(known);
}

// "six trees or tree groups": the same things in other words.
bool ClauseReader::IsOtherWord(const Chunk& chunk) const {
  const NounPhrase& phrase = chunk.phrase;
  const int last = LastSubject();
  return at_ > 0 && IsSense(at_ - 1, Sense::kOr) && phrase.noun != nullptr && last >= 0 &&
         !phrase.definite && !phrase.qualities.count.has_value() && !frame_.has_value() &&
         phrase.noun->LetterIn(d_.plan().vocabulary) == d_.feature(last).letter &&
         (phrase.noun->shape == WordShape::kLine) == IsLine(last);
}

void ClauseReader::ReadMap(const Chunk& chunk) {
  const Qualities& said = chunk.phrase.qualities;
  if (comparing_ && !subjects_.empty()) {
    // "more water than land"
    PlannedFeature& feature = d_.feature(subjects_.back());
    feature.share = comparing_less_ ? 0.4 : 0.58;
    (comparing_less_ ? feature.share_most : feature.share_least) = 0.5;
    comparing_ = false;
    return;
  }
  // "lots of water, almost no land"
  if (said.share.has_value() && said.share->most < 0.2 && !subjects_.empty() &&
      EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "land")) {
    d_.feature(subjects_.back()).dominant = true;
    return;
  }
  // "forest on two fifths of the map"
  if (frame_.has_value() && frame_->sense == Sense::kIn && frame_->objects.empty() &&
      !frame_->fronted && said.share.has_value()) {
    for (const int index : frame_->subjects) d_.Describe(said, index);
    frame_.reset();
    return;
  }
  if (frame_.has_value() && frame_->expecting && frame_->objects.empty()) {
    // "forest covers half of the map", "a river crosses the map"
    for (const int index : frame_->subjects) {
      if (frame_->sense != Sense::kCovers && frame_->sense != Sense::kDominates) continue;
      if (said.any && said.share.has_value()) {
        d_.Describe(said, index);
      } else {
        d_.feature(index).dominant = true;
      }
      d_.Extend(index, chunk.end);
    }
    if (!IsCourse(frame_->sense)) frame_.reset();
    return;
  }
  // "away from it the ground is stone"
  if (frame_.has_value() && frame_->fronted && frame_->sense == Sense::kAway) {
    frame_.reset();
    rest_next_ = true;
    return;
  }
  if (frame_.has_value() && frame_->fronted) return;  // "south of it everything is forest"
  if (!subjects_.empty() && said.share.has_value()) {
    std::vector<int> about = subjects_;
    if (!list_has_and_) about = {about.back()};
    for (const int index : about) d_.Describe(said, index);
    return;
  }
  if (!subjects_.empty() && open_list_ && !verb_said_) return;
  if (!subjects_.empty()) BeginClause();
  // "Everything south of it is forest": what lies there.
  if (Fronts(at_ + 1) &&
      (IsKind(at_ + 1, ChunkKind::kDirection) || IsSense(at_ + 1, Sense::kAbove) ||
       IsSense(at_ + 1, Sense::kBelow) || IsSense(at_ + 1, Sense::kBeyond) ||
       IsSense(at_ + 1, Sense::kBehind) || IsSense(at_ + 1, Sense::kBetween))) {
    lead_ = Lead();
    return;
  }
  map_is_subject_ = true;
  map_share_ = said.share;
  mostly_next_ = mostly_next_ || said.mostly;
  // "everything forest": no verb between them.
  if (IsThing(at_ + 1) && !chunks_[at_ + 1].phrase.negated) cover_next_ = true;
}

void ClauseReader::ReadRest(const Chunk& chunk) {
  std::size_t next = SkipVerbs(at_ + 1);
  if (IsKind(next, ChunkKind::kComma)) next = SkipVerbs(next + 1);
  if (IsSense(next, Sense::kIn) || IsSense(next, Sense::kTo) || IsSense(next, Sense::kWith)) ++next;
  if (IsPhrase(next) && chunks_[next].phrase.head == Head::kMap) next = SkipVerbs(next + 1);
  if (IsSense(next, Sense::kWith) && IsThing(next + 1)) ++next;  // "the rest with grass"
  if (IsKind(next, ChunkKind::kQualities)) ++next;
  const bool is_last = !subjects_.empty() && IsKind(at_ + 1, ChunkKind::kComma);
  if (IsThing(next) && !chunks_[next].phrase.negated && !is_last) {
    BeginClause();
    lead_ = Lead();
    rest_next_ = true;
    return;
  }
  // "forest: everything else"
  const bool value = subjects_.empty() && at_ >= 2 && IsKind(at_ - 1, ChunkKind::kComma) &&
                     IsThing(at_ - 2) && d_.LastMentioned() >= 0;
  if (value) subjects_ = {d_.LastMentioned()};
  for (const int index : subjects_) {
    d_.feature(index).fills_rest = true;
    d_.Extend(index, chunk.end);
  }
  if (frame_.has_value() && frame_->objects.empty()) frame_.reset();
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
  if (!frame.fronted && !frame.subjects.empty()) NoteAxis(frame, frame.subjects.back());
  if (frame.sense == Sense::kOutside) {
    for (const int subject : frame.subjects) d_.AddZones(subject, {*FindZone("edges")});
  }
  const bool wants_more = WantsTwo(frame.sense) && frame.objects.size() < 2 &&
                          (IsSense(at_ + 1, Sense::kAnd) || IsSense(at_ + 1, Sense::kFrom) ||
                           IsSense(at_ + 1, Sense::kTo) || IsSense(at_ + 1, Sense::kWith) ||
                           IsKind(at_ + 1, ChunkKind::kPlace) || IsSense(at_ + 1, Sense::kIn));
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
    list_has_and_ = false;
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
      if (side.east == 0 && side.south == 0) {
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
    const bool bare_extent = !lead_.empty() && lead_.is_subject && lead_.extent && is_new;
    if ((cover_next_ && named) || bare_extent) Cover(index, chunk);
    if (map_share_.has_value() && !IsLine(index)) {
      Qualities said;
      said.share = map_share_;
      said.any = true;
      d_.Describe(said, index);
    }
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
