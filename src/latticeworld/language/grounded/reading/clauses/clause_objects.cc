#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// Noun phrases that are the objects of a relation: "next to the lake and the wood".
namespace latticeworld {

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

}  // namespace latticeworld
