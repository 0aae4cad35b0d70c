#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

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

void ClauseReader::ReadDirection(const Chunk& chunk) {
  Frame frame;
  frame.is_direction = true;
  frame.heading = chunk.lexeme.heading;
  frame.use = chunk.lexeme.use;
  frame.of_it = chunk.lexeme.of_it;
  // "Its eastern end touches a village", "a town whose western edge borders on a lake"
  const bool meets = IsSense(at_ + 1, Sense::kNextTo) || IsSense(at_ + 1, Sense::kNear) ||
                     IsSense(at_ + 1, Sense::kBorderedBy) || IsSense(at_ + 1, Sense::kTo);
  if (frame.of_it && frame.use == DirectionUse::kAtSide && meets && IsPhrase(at_ + 2)) {
    const bool after_owner = IsPhrase(at_ - 1) && d_.LastMentioned() >= 0;
    frame.objects = after_owner ? std::vector<int>{d_.LastMentioned()} : Own(frame, {});
    if (!frame.objects.empty()) {
      BeginClause();
      frame.fronted = true;
      frame.expecting = false;
      frame_ = std::move(frame);
      ++at_;
      return;
    }
  }
  frame.touching = SaysClose(chunk);
  frame.along = at_ > 0 && chunks_[at_ - 1].Is(Sense::kAlong);
  Open(std::move(frame));
}

// "on the northern bank", "just north of it", but not "north of it".
bool ClauseReader::SaysClose(const Chunk& chunk) const {
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  if (words.find("bank") != std::string::npos || words.find("shore") != std::string::npos) {
    return true;
  }
  const std::string before = ToLowerAscii(d_.instruction().substr(0, chunk.begin));
  for (const std::string_view close :
       {"just to the ", "right to the ", "just ", "right ", "directly ", "immediately "}) {
    if (before.size() >= close.size() &&
        before.compare(before.size() - close.size(), close.size(), close) == 0) {
      return true;
    }
  }
  return false;
}

void ClauseReader::OpenSense(Sense sense, bool of_it) {
  // "Through the city, from west to east, flows a river": the axis tells.
  if (sense == Sense::kFrom && IsKind(at_ + 1, ChunkKind::kAxis) && frame_.has_value() &&
      frame_->fronted && !frame_->objects.empty()) {
    return;
  }
  if (sense == Sense::kBothSides && ReadFartherSides()) return;
  if (sense == Sense::kTo && (ReadSideToCome() || ReadSideOfHost())) return;
  // "trees grow only near the river": all along it
  const bool only_near = (sense == Sense::kNear || sense == Sense::kNextTo) && at_ > 0 &&
                         (IsSense(at_ - 1, Sense::kNothingElse) || IsSense(at_ - 1, Sense::kOnly));
  if (only_near && !of_it) {
    sense = Sense::kAlong;
    confining_ = false;
  }
  if (sense == Sense::kBetween && ReadInBetween()) return;
  if (sense == Sense::kConnects && RunsBetween()) sense = Sense::kBetween;
  Frame frame;
  frame.sense = sense;
  frame.of_it = of_it || sense == Sense::kWithinIt;
  if (sense == Sense::kBothSides) frame.heading = chunks_[at_].lexeme.heading;
  const std::string said = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  frame.at_end =
      sense == Sense::kNextTo && (EndsWithWord(said, "end of") || EndsWithWord(said, "head of") ||
                                  EndsWithWord(said, "tip of"));
  frame.partly = sense == Sense::kSurrounds && SaysThreeSides();
  frame.inside =
      sense == Sense::kIn && ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end)) == "in";
  Open(std::move(frame));
}

// "on three sides of", "surrounds the town on three sides"
bool ClauseReader::SaysThreeSides() const {
  std::size_t last = at_;
  while (last + 1 < chunks_.size() && !EndsAt(last + 1) && !IsKind(last + 1, ChunkKind::kComma))
    ++last;
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[last].end));
  return words.find("three sides") != std::string::npos;
}

// "A river runs between the village and the wood", "a road runs between two lakes": lies there.
// Only roads lead from one place where people live to another.
bool ClauseReader::RunsBetween() const {
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  if (words.substr(0, 3) != "run" || !IsThing(at_ + 1)) return false;
  const int line = LineOf(subjects_);
  if (line < 0) return false;
  const char to = chunks_[at_ + 1].phrase.noun->LetterIn(d_.plan().vocabulary);
  return d_.feature(line).letter != 'R' || (to != 'B' && to != 'A');
}

// "leaves the town": from it.
bool ClauseReader::SaysLeaving() const {
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  return words == "leaves" || words == "leaving" || words == "exits" || words == "exiting";
}

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
  // "separates the town from the fields", "connects the lake with the village"
  const bool second = (sense == Sense::kFrom || sense == Sense::kTo || sense == Sense::kWith) &&
                      frame_.has_value() && WantsTwo(frame_->sense) &&
                      frame_->objects.size() == 1 && IsPhrase(at_ + 1);
  if (second) {
    frame_->expecting = true;
    return;
  }
  // "linked with the lake by a road"
  const bool by_line = sense == Sense::kNear && frame_.has_value() && IsThing(at_ + 1) &&
                       frame_->sense == Sense::kConnectedBy && frame_->objects.size() == 1 &&
                       chunks_[at_ + 1].phrase.noun->shape == WordShape::kLine;
  if (by_line) return;
  // "connects the village to the northern edge"
  const bool from_object = (sense == Sense::kTo || sense == Sense::kWith) && frame_.has_value() &&
                           frame_->sense == Sense::kConnects && frame_->objects.size() == 1 &&
                           !frame_->fronted && IsKind(at_ + 1, ChunkKind::kPlace);
  if (from_object) {
    Frame start = *frame_;
    start.sense = Sense::kFrom;
    frame_.reset();
    for (const int subject : start.subjects) Assert(start, subject, &d_);
  }
  // "the woods must not reach the lake"
  if (not_next_ && sense == Sense::kTo && LineOf(subjects_) < 0) frame.sense = Sense::kNextTo;
  frame.negated = not_next_;
  not_next_ = false;
  // "Link them by a footpath": what does it comes last.
  if (sense == Sense::kNear && frame_.has_value() && frame_->fronted && WantsTwo(frame_->sense) &&
      !frame_->objects.empty()) {
    frame_->expecting = false;
    return;
  }
  // "a river that ends in a lake near the southern edge": the lake is there.
  if (sense == Sense::kNear && frame_.has_value() && IsCourse(frame_->sense) &&
      !frame_->objects.empty() && at_ > 0 && IsThing(at_ - 1) &&
      IsKind(at_ + 1, ChunkKind::kPlace) && !frame.negated) {
    return;
  }
  // "between a lake to its west and a wood to its east, the village": of what is to come.
  if (frame.is_direction && frame.of_it && frame_.has_value() && frame_->fronted &&
      frame_->sense == Sense::kBetween && !frame_->objects.empty() && at_ > 1 &&
      (IsPhrase(at_ - 1) || (IsSense(at_ - 1, Sense::kTo) && IsPhrase(at_ - 2)))) {
    sides_to_come_.push_back({frame_->objects.back(), frame.heading});
    return;
  }
  // "which turns into grass toward the middle and finally into forest"
  if (sense == Sense::kTo && frame_.has_value() && frame_->sense == Sense::kGivesWay &&
      !frame_->objects.empty() && !frame_->fronted) {
    const int last = frame_->objects.back();
    if (IsKind(at_ + 1, ChunkKind::kPlace) && !IsLine(last)) {
      d_.SetTopic(subjects_);
      subjects_ = {last};
      frame_.reset();
      return;
    }
    if (IsThing(at_ + 1) && words.substr(0, 4) == "into") {
      d_.SetTopic(subjects_);
      subjects_ = {last};
      frame_.reset();
      frame.sense = Sense::kGivesWay;
    }
  } else if (sense == Sense::kTo && gave_way_ == d_.sentence() && words.substr(0, 4) == "into" &&
             IsThing(at_ + 1) && LineOf(subjects_) < 0) {
    frame.sense = Sense::kGivesWay;
  }
  if (frame.sense == Sense::kGivesWay) gave_way_ = d_.sentence();
  const bool was_fronted = frame_.has_value() && frame_->fronted;
  // "flows past the town on its western side": the town's
  const int owner = frame.is_direction && frame.of_it && frame_.has_value() && !was_fronted &&
                            !frame_->objects.empty() && IsCourse(frame_->sense)
                        ? frame_->objects.back()
                        : -1;
  const bool after_object =
      at_ > 1 &&
      (IsPhrase(at_ - 1) || (IsKind(at_ - 1, ChunkKind::kQualities) && IsPhrase(at_ - 2)));
  const std::vector<int> nearest =
      frame_.has_value() && !was_fronted && !frame_->objects.empty() && after_object
          ? std::vector<int>{frame_->objects.back()}
          : std::vector<int>();
  // "a lake inside a forest inside a desert": the forest is inside the desert.
  const auto encloses = [](Sense one) { return one == Sense::kIn || one == Sense::kWithin; };
  const bool nested = !nearest.empty() && encloses(frame_->sense) && encloses(sense) &&
                      IsThing(at_ + 1) && !IsLine(nearest.front());
  if (frame_.has_value() && WantsTwo(frame_->sense) && frame_->objects.size() == 1 &&
      !was_fronted) {
    paused_ = std::move(frame_);
    frame_.reset();
  } else {
    CloseFrame();
  }
  const bool after_break =
      at_ == sentence_start_ || IsKind(at_ - 1, ChunkKind::kComma) ||
      IsSense(at_ - 1, Sense::kAnd) || IsSense(at_ - 1, Sense::kThen) ||
      IsSense(at_ - 1, Sense::kBut) || IsSense(at_ - 1, Sense::kBreak) ||
      ((IsSense(at_ - 1, Sense::kIn) || IsSense(at_ - 1, Sense::kTo)) && at_ > 1 &&
       (IsKind(at_ - 2, ChunkKind::kComma) || IsSense(at_ - 2, Sense::kAnd) ||
        at_ - 1 == sentence_start_));
  const bool leads = Fronts(at_);
  // "..., and separate the two with a belt of trees", "Surround the town with fields."
  const bool imperative = after_break && IsPhrase(at_ + 1) && IsBareVerb(words);
  // "To the right of it, in this order: ..."
  const bool list_follows = frame.is_direction && at_ <= sentence_start_ + 1 && IsPhrase(at_ + 1) &&
                            IsKind(at_ + 2, ChunkKind::kComma);
  const bool may_lead = imperative || list_follows || leads || frame.of_it || IsCourse(sense) ||
                        sense == Sense::kBetween || !IsPhrase(at_ + 1);
  if (subjects_.empty() && !may_lead) {
    if (frame.is_direction) PlaceDenials(frame);
    absences_.clear();
    return;  // "the player starts in a field": the field is what is spoken of
  }
  // "Line the southern edge with trees."
  if (after_break && IsKind(at_ + 1, ChunkKind::kPlace) && IsSense(at_ + 2, Sense::kWith) &&
      IsThing(at_ + 3) && IsBareVerb(words)) {
    BeginClause();
    Lead_(ZonesOf(chunks_[at_ + 1].lexeme.places), chunks_[at_ + 1]);
    at_ += 2;
    return;
  }
  const bool fronted = subjects_.empty() || (after_break && leads) || imperative;
  if (fronted) {
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
    return;
  }
  frame.subjects = subjects_;
  if (words.substr(0, 5) == "touch") frame.steps = 1.0;
  if (sense == Sense::kAway && frame.steps == 0.0 && SaysFar(words)) frame.steps = kFarSteps;
  if (IsCourse(sense) || sense == Sense::kBetween) {
    const int near_line = LineOf(nearest);
    const int line = LineOf(subjects_);
    if (IsCourse(sense) && line < 0 && near_line >= 0) {
      d_.SetTopic(subjects_);
      subjects_ = nearest;
      frame.subjects = nearest;
    } else if (sense == Sense::kAlong && subjects_.size() > 1 && !IsLine(subjects_.back()) &&
               IsThing(at_ - 1) && !verb_said_) {
      // "winding roads, houses along all of them"
      const std::vector<int> last = {subjects_.back()};
      subjects_.pop_back();
      d_.SetTopic(subjects_);
      subjects_ = last;
      frame.subjects = last;
    } else if (line >= 0 && (list_has_and_ ? false : subjects_.size() > 1)) {
      frame.subjects = {line};
    }
  } else if (IsParticiple(sense) && !nearest.empty()) {
    d_.SetTopic(subjects_);
    frame.subjects = nearest;
    subjects_ = nearest;
  } else if (nested) {
    frame.subjects = nearest;
  } else if (words.find(" in turn") != std::string::npos && d_.LastMentioned() >= 0) {
    frame.subjects = {d_.LastMentioned()};
  } else if (!verb_said_ && subjects_.size() > 1 && !IsParticiple(sense) &&
             sense != Sense::kConnectedBy && sense != Sense::kSeparatedBy) {
    frame.subjects = {subjects_.back()};
  }
  open_list_ = false;
  if (frame.of_it) {
    frame.objects = owner >= 0 ? std::vector<int>{owner} : Own(frame, frame.subjects);
    frame.expecting = false;
    // "With a lake to its west, the village ..."
    const bool first = frame.objects.empty() && d_.size() == sentence_first_feature_ + 1;
    if (frame.is_direction && (first || !sides_to_come_.empty())) {
      sides_to_come_.push_back({frame.subjects.back(), frame.heading});
      return;
    }
    if (!frame.objects.empty()) {
      for (const int subject : frame.subjects) Assert(frame, subject, &d_);
      if (!frame.subjects.empty()) NoteAxis(frame, frame.subjects.back());
      if (frame.is_direction) AssertMoreSides(frame);
    }
  }
  frame_ = std::move(frame);
}

// What "its" means; banks and shores are those of water.
std::vector<int> ClauseReader::Own(const Frame& frame, const std::vector<int>& subjects) const {
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  const bool shore =
      words.find("bank") != std::string::npos || words.find("shore") != std::string::npos;
  for (int i = d_.size() - 1; i >= 0 && frame.is_direction && shore; --i) {
    if (!d_.thing(i).dropped && d_.feature(i).letter == 'W') return {i};
  }
  return InContrast(frame, d_.Antecedent(subjects, false));
}

// A relation without an object is to what was spoken of: "with houses on both sides".
void ClauseReader::CloseFrame() {
  if (!frame_.has_value()) return;
  Frame frame = std::move(*frame_);
  frame_.reset();
  if (frame.fronted) {
    // "Next to the lake. ...": of what was spoken of before. "From the depot to the shop, along a
    // road": the road's ends.
    if (!frame.objects.empty() && (frame.sense == Sense::kFrom || frame.sense == Sense::kTo)) {
      Waypoint end;
      end.feature = frame.objects.back();
      (frame.sense == Sense::kFrom ? from_ : to_) = end;
    }
    return;
  }
  if (!frame.objects.empty()) {
    if (WantsTwo(frame.sense) && frame.objects.size() == 1) {
      for (const int subject : frame.subjects) Assert(frame, subject, &d_);
    }
    return;
  }
  if (frame.sense == Sense::kCrosses && frame.subjects.size() >= 1 && frame.expecting &&
      LineOf(frame.subjects) >= 0 &&
      (frame.subjects.size() > 1 || d_.feature(frame.subjects[0]).pieces > 1)) {
    AssertEachOther(frame, &d_);
    return;
  }
  if (frame.sense == Sense::kDominates) {
    for (const int index : frame.subjects) {
      if (!IsLine(index)) d_.feature(index).dominant = true;
    }
    return;
  }
  if (!MayLackObject(frame.sense) || frame.subjects.empty()) return;
  if (frame.sense == Sense::kBetween) {
    frame.objects = d_.LastTwo(frame.subjects);
    // "snow N, snow S, forest between"
    if (frame.objects.size() == 1 && d_.feature(frame.objects[0]).zones.size() == 2 &&
        !IsLine(frame.objects[0])) {
      for (const int subject : frame.subjects) Assert(frame, subject, &d_);
      return;
    }
    if (frame.objects.size() < 2) {
      // "grid streets in the east. Houses between."
      if (frame.objects.size() == 1 && IsLine(frame.objects[0])) {
        frame.sense = Sense::kNextTo;
        for (const int subject : frame.subjects) {
          if (d_.feature(subject).zones.empty()) {
            d_.AddZones(subject, d_.feature(frame.objects[0]).zones);
          }
          Assert(frame, subject, &d_);
        }
      }
      return;
    }
  } else {
    frame.objects = InContrast(frame, d_.Antecedent(frame.subjects, false));
    if (!frame.objects.empty()) NoteAxis(frame, frame.subjects.back());
  }
  if (frame.objects.empty()) return;
  for (const int subject : frame.subjects) {
    // "desert all around"
    PlannedFeature& feature = d_.feature(subject);
    // "it wraps around the lake on three sides": said already.
    const std::vector<PlannedRelation>& relations = d_.plan().relations;
    const bool said = frame.sense == Sense::kSurrounds && !relations.empty() &&
                      relations.back().kind == RelationKind::kSurrounds &&
                      relations.back().subject == subject;
    if (said) continue;
    if (frame.sense == Sense::kSurrounds && !frame.partly && feature.form == FeatureForm::kSpread &&
        feature.zones.empty()) {
      feature.dominant = true;
      if (IsLine(frame.objects.back())) continue;
    }
    Assert(frame, subject, &d_);
  }
}

}  // namespace latticeworld
