#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// How relations are named, and how they end.
namespace latticeworld {

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
