#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// What lies inside and outside of rings: loop roads, moats, belts of trees.
namespace latticeworld {

bool ClauseReader::HasRing() const {
  for (int i = 0; i < d_.size(); ++i) {
    if (!d_.thing(i).dropped && d_.feature(i).shape == ClaimShape::kRing) return true;
  }
  return false;
}

// "Inside the loop: grass": the ring that was spoken of goes round what comes.
void ClauseReader::ReadInsideRing() {
  for (int i = d_.size() - 1; i >= 0; --i) {
    const bool ring = d_.feature(i).shape == ClaimShape::kRing;
    if (d_.thing(i).dropped || !ring) continue;
    Frame frame;
    frame.sense = Sense::kSurroundedBy;
    frame.objects = {i};
    frame.expecting = false;
    if (ThingFollows(at_ + 1, true)) {
      if (!subjects_.empty()) BeginClause();
      CloseFrame();
      frame.fronted = true;
      frame_ = std::move(frame);
    } else {
      for (const int subject : subjects_) Assert(frame, subject, &d_);
    }
    return;
  }
}

// "outside the ring road fields, inside houses"; else no more than what lies in what.
void ClauseReader::ReadWithin(const Chunk& chunk) {
  if (ToLowerAscii(d_.Words(chunk.begin, chunk.end)) == "inside" && HasRing() &&
      (!IsPhrase(at_ + 1) || subjects_.empty() || IsKind(at_ - 1, ChunkKind::kComma)) &&
      !IsKind(at_ + 1, ChunkKind::kPlace)) {
    ReadInsideRing();
    return;
  }
  OpenSense(chunk.lexeme.sense, chunk.lexeme.of_it);
}

// "outside of it": the rest of the land.
void ClauseReader::ReadOutsideRing() {
  if (ThingFollows(at_ + 1, true)) {
    if (!subjects_.empty()) BeginClause();
    lead_ = Lead();
    rest_next_ = true;
    FrontRing();
    return;
  }
  // "four fields outside it" are only these.
  const std::vector<int> about =
      list_has_and_ || subjects_.empty() ? subjects_ : std::vector<int>{subjects_.back()};
  for (const int index : about) {
    const bool counted = d_.feature(index).pieces_least > 0;
    if (!IsLine(index) && !counted) d_.feature(index).fills_rest = true;
  }
}

// "Beyond the ring of trees farmland": the land there surrounds the ring.
void ClauseReader::FrontRing() {
  std::size_t next = SkipVerbs(at_ + 1);
  if (IsKind(next, ChunkKind::kComma)) next = SkipVerbs(next + 1);
  if (!IsThing(next) || chunks_[next].phrase.noun->shape != WordShape::kMass) return;
  for (int i = d_.size() - 1; i >= 0; --i) {
    if (d_.thing(i).dropped || d_.feature(i).shape != ClaimShape::kRing || IsLine(i)) continue;
    Frame frame;
    frame.sense = Sense::kSurrounds;
    frame.objects = {i};
    frame.fronted = true;
    frame.expecting = false;
    frame_ = std::move(frame);
    return;
  }
}

}  // namespace latticeworld
