#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// How relations begin: what they are said of, and whether that comes before or after them.
namespace latticeworld {
namespace {

constexpr double kFarSteps = 6.0;

// "Surround the city with a ring road."
bool IsBareVerb(const std::string& words) {
  for (const std::string_view verb :
       {"separate", "divide", "part", "surround", "encircle", "circle", "girdle", "ring", "enclose",
        "frame", "line", "border", "flank", "fringe", "buffer", "screen", "plant", "edge"}) {
    if (words == verb) return true;
  }
  return false;
}

// "far from", "nowhere near", but not "away from".
bool SaysFar(const std::string& words) {
  for (const std::string_view word : {"far", "long way", "nowhere near", "remote", "distant"}) {
    if (words.find(word) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

void ClauseReader::Open(Frame frame) {
  if (gap_ > 0) {
    frame.sense = Sense::kAway;
    frame.steps = std::exchange(gap_, 0);
  }
  if (frame.sense == Sense::kTo && IsThing(at_ + 1) && SaysLeaving()) frame.sense = Sense::kFrom;
  const Sense sense = frame.sense;
  // "Coming down from the north we left the snow, crossed scree, ...": things as they are passed.
  if (ordering_ && !IsKind(at_ + 1, ChunkKind::kPlace)) return;
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  if (sense == Sense::kFrom && subjects_.empty() && words.find(" down from") != std::string::npos) {
    traveling_ = true;
  }
  if (NamesSecondObject(sense)) return;
  if (sense == Sense::kTo || sense == Sense::kWith) StartFromObject();
  // "the woods must not reach the lake"
  if (not_next_ && sense == Sense::kTo && LineOf(subjects_) < 0) frame.sense = Sense::kNextTo;
  frame.negated = not_next_;
  not_next_ = false;
  if (StandsInFrame(frame, sense) || GiveWay(sense, words, &frame)) return;
  const Anchor anchor = AnchorOf(frame, sense);
  if (frame_.has_value() && WantsTwo(frame_->sense) && frame_->objects.size() == 1 &&
      !frame_->fronted) {
    paused_ = std::move(frame_);
    frame_.reset();
  } else {
    CloseFrame();
  }
  // "..., and separate the two with a belt of trees", "Surround the town with fields."
  const bool imperative = AfterBreak() && IsPhrase(at_ + 1) && IsBareVerb(words);
  if (subjects_.empty() && !imperative && !MayLead(frame, sense)) {
    if (frame.is_direction) PlaceDenials(frame);
    absences_.clear();
    return;  // "the player starts in a field": the field is what is spoken of
  }
  // "Line the southern edge with trees."
  if (AfterBreak() && IsKind(at_ + 1, ChunkKind::kPlace) && IsSense(at_ + 2, Sense::kWith) &&
      IsThing(at_ + 3) && IsBareVerb(words)) {
    BeginClause();
    Lead_(ZonesOf(chunks_[at_ + 1].lexeme.places), chunks_[at_ + 1]);
    at_ += 2;
    return;
  }
  if (subjects_.empty() || (AfterBreak() && Fronts(at_)) || imperative) {
    OpenFronted(std::move(frame), sense);
    return;
  }
  if (words.substr(0, 5) == "touch") frame.steps = 1.0;
  if (sense == Sense::kAway && frame.steps == 0.0 && SaysFar(words)) frame.steps = kFarSteps;
  frame.subjects = SubjectsOf(sense, words, anchor);
  open_list_ = false;
  if (frame.of_it && TakeOwnObject(anchor.owner, &frame)) return;
  frame_ = std::move(frame);
}

// Whether the words only name the other object of the relation that is being read.
bool ClauseReader::NamesSecondObject(Sense sense) {
  if (!frame_.has_value() || frame_->objects.size() != 1) return false;
  // "separates the town from the fields", "connects the lake with the village"
  if ((sense == Sense::kFrom || sense == Sense::kTo || sense == Sense::kWith) &&
      WantsTwo(frame_->sense) && IsPhrase(at_ + 1)) {
    frame_->expecting = true;
    return true;
  }
  // "linked with the lake by a road"
  return sense == Sense::kNear && IsThing(at_ + 1) && frame_->sense == Sense::kConnectedBy &&
         chunks_[at_ + 1].phrase.noun->shape == WordShape::kLine;
}

// "connects the village to the northern edge": from the village.
void ClauseReader::StartFromObject() {
  const bool from_object = frame_.has_value() && frame_->sense == Sense::kConnects &&
                           frame_->objects.size() == 1 && !frame_->fronted &&
                           IsKind(at_ + 1, ChunkKind::kPlace);
  if (!from_object) return;
  Frame start = *frame_;
  start.sense = Sense::kFrom;
  frame_.reset();
  for (const int subject : start.subjects) Assert(start, subject, &d_);
}

// Whether the words belong to the relation that is being read, which goes on.
bool ClauseReader::StandsInFrame(const Frame& frame, Sense sense) {
  if (!frame_.has_value() || frame_->objects.empty()) return false;
  // "Link them by a footpath": what does it comes last.
  if (sense == Sense::kNear && frame_->fronted && WantsTwo(frame_->sense)) {
    frame_->expecting = false;
    return true;
  }
  // "a river that ends in a lake near the southern edge": the lake is there.
  if (sense == Sense::kNear && IsCourse(frame_->sense) && at_ > 0 && IsThing(at_ - 1) &&
      IsKind(at_ + 1, ChunkKind::kPlace) && !frame.negated) {
    return true;
  }
  // "between a lake to its west and a wood to its east, the village": of what is to come.
  if (frame.is_direction && frame.of_it && frame_->fronted && frame_->sense == Sense::kBetween &&
      at_ > 1 && (IsPhrase(at_ - 1) || (IsSense(at_ - 1, Sense::kTo) && IsPhrase(at_ - 2)))) {
    sides_to_come_.push_back({frame_->objects.back(), frame.heading});
    return true;
  }
  return false;
}

// "which turns into grass toward the middle and finally into forest": the grass gives way to what
// is told in `frame`. True: the words only say where it lies.
bool ClauseReader::GiveWay(Sense sense, const std::string& words, Frame* frame) {
  const bool into = IsThing(at_ + 1) && words.substr(0, 4) == "into";
  if (sense == Sense::kTo && frame_.has_value() && frame_->sense == Sense::kGivesWay &&
      !frame_->objects.empty() && !frame_->fronted) {
    const int last = frame_->objects.back();
    const bool place = IsKind(at_ + 1, ChunkKind::kPlace) && !IsLine(last);
    if (place || into) {
      d_.SetTopic(subjects_);
      subjects_ = {last};
      frame_.reset();
    }
    if (place) return true;
    if (into) frame->sense = Sense::kGivesWay;
  } else if (sense == Sense::kTo && gave_way_ == d_.sentence() && into && LineOf(subjects_) < 0) {
    frame->sense = Sense::kGivesWay;
  }
  if (frame->sense == Sense::kGivesWay) gave_way_ = d_.sentence();
  return false;
}

ClauseReader::Anchor ClauseReader::AnchorOf(const Frame& frame, Sense sense) const {
  Anchor anchor;
  if (!frame_.has_value() || frame_->fronted || frame_->objects.empty()) return anchor;
  const int object = frame_->objects.back();
  if (frame.is_direction && frame.of_it && IsCourse(frame_->sense)) anchor.owner = object;
  const bool after_object =
      at_ > 1 &&
      (IsPhrase(at_ - 1) || (IsKind(at_ - 1, ChunkKind::kQualities) && IsPhrase(at_ - 2)));
  if (!after_object) return anchor;
  anchor.nearest = {object};
  const auto encloses = [](Sense one) { return one == Sense::kIn || one == Sense::kWithin; };
  anchor.nested = encloses(frame_->sense) && encloses(sense) && IsThing(at_ + 1) && !IsLine(object);
  return anchor;
}

// Whether a clause may begin here: at the beginning of the sentence, after a comma, "and", "then".
bool ClauseReader::AfterBreak() const {
  return at_ == sentence_start_ || IsKind(at_ - 1, ChunkKind::kComma) ||
         IsSense(at_ - 1, Sense::kAnd) || IsSense(at_ - 1, Sense::kThen) ||
         IsSense(at_ - 1, Sense::kBut) || IsSense(at_ - 1, Sense::kBreak) ||
         ((IsSense(at_ - 1, Sense::kIn) || IsSense(at_ - 1, Sense::kTo)) && at_ > 1 &&
          (IsKind(at_ - 2, ChunkKind::kComma) || IsSense(at_ - 2, Sense::kAnd) ||
           at_ - 1 == sentence_start_));
}

// Whether the relation may come before what it is said of.
bool ClauseReader::MayLead(const Frame& frame, Sense sense) const {
  // "To the right of it, in this order: ..."
  const bool list_follows = frame.is_direction && at_ <= sentence_start_ + 1 && IsPhrase(at_ + 1) &&
                            IsKind(at_ + 2, ChunkKind::kComma);
  return list_follows || Fronts(at_) || frame.of_it || IsCourse(sense) ||
         sense == Sense::kBetween || !IsPhrase(at_ + 1);
}

// "Next to the lake lies a village": what it is said of comes last.
void ClauseReader::OpenFronted(Frame frame, Sense sense) {
  if (!subjects_.empty()) BeginClause();
  if (lead_.used) lead_ = Lead();
  frame.fronted = true;
  if (sense == Sense::kBetween && !IsPhrase(at_ + 1) && !IsKind(at_ + 1, ChunkKind::kPlace)) {
    frame.objects = d_.LastTwo({});
    frame.expecting = false;
    if (frame.objects.size() < 2) return;
  }
  // "A glacier. Both flanks: rock."
  if (sense == Sense::kBothSides && !IsPhrase(at_ + 1) && !IsKind(at_ + 1, ChunkKind::kPlace)) {
    frame.objects = d_.Antecedent({}, /*many=*/false);
    frame.expecting = false;
    if (frame.objects.empty()) return;
  }
  if (frame.of_it) {
    frame.objects = Own(frame, {});
    frame.expecting = false;
    frame_ = frame;
    if (const int same = SameObject(); same >= 0) frame.objects = {same};
  }
  // "no trees near the lake": it is not that there are none.
  if (!frame.of_it) TakeBackDenials();
  frame_ = std::move(frame);
}

// Those of what the clause is about that the relation is said of; it may be about them alone then.
std::vector<int> ClauseReader::SubjectsOf(Sense sense, const std::string& words,
                                          const Anchor& anchor) {
  if (IsCourse(sense) || sense == Sense::kBetween) {
    const int near_line = LineOf(anchor.nearest);
    const int line = LineOf(subjects_);
    if (IsCourse(sense) && line < 0 && near_line >= 0) {
      d_.SetTopic(subjects_);
      subjects_ = anchor.nearest;
    } else if (sense == Sense::kAlong && subjects_.size() > 1 && !IsLine(subjects_.back()) &&
               IsThing(at_ - 1) && !verb_said_) {
      // "winding roads, houses along all of them"
      const std::vector<int> last = {subjects_.back()};
      subjects_.pop_back();
      d_.SetTopic(subjects_);
      subjects_ = last;
    } else if (line >= 0 && !list_has_and_ && subjects_.size() > 1) {
      return {line};
    }
    return subjects_;
  }
  if (IsParticiple(sense) && !anchor.nearest.empty()) {
    d_.SetTopic(subjects_);
    subjects_ = anchor.nearest;
    return subjects_;
  }
  // "a lake inside a forest inside a desert": the forest is inside the desert.
  if (anchor.nested) return anchor.nearest;
  if (words.find(" in turn") != std::string::npos && d_.LastMentioned() >= 0) {
    return {d_.LastMentioned()};
  }
  if (!verb_said_ && subjects_.size() > 1 && !IsParticiple(sense) && sense != Sense::kConnectedBy &&
      sense != Sense::kSeparatedBy) {
    return {subjects_.back()};
  }
  return subjects_;
}

// "to its west": the object is what "its" means, or the owner, where that is not -1. True where it
// is yet to be named; the side waits for it then.
bool ClauseReader::TakeOwnObject(int owner, Frame* frame) {
  frame->objects = owner >= 0 ? std::vector<int>{owner} : Own(*frame, frame->subjects);
  frame->expecting = false;
  // "With a lake to its west, the village ..."
  const bool first = frame->objects.empty() && d_.size() == sentence_first_feature_ + 1;
  if (frame->is_direction && (first || !sides_to_come_.empty())) {
    sides_to_come_.push_back({frame->subjects.back(), frame->heading});
    return true;
  }
  if (frame->objects.empty()) return false;
  for (const int subject : frame->subjects) Assert(*frame, subject, &d_);
  if (!frame->subjects.empty()) NoteAxis(*frame, frame->subjects.back());
  if (frame->is_direction) AssertMoreSides(*frame);
  return false;
}

}  // namespace latticeworld
