#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// "but", "then", "where", "which": how a clause goes on from what was said before.
namespace latticeworld {

// "..., but in the north there is ...", "while the south ...": a clause of its own.
void ClauseReader::ReadBreak() {
  negating_ = false;
  const bool begins = IsPhrase(at_ + 1) || IsKind(at_ + 1, ChunkKind::kPlace) ||
                      IsSense(at_ + 1, Sense::kIn) || IsSense(at_ + 1, Sense::kExists) ||
                      IsKind(at_ + 1, ChunkKind::kDirection) ||
                      (IsSense(at_ + 1, Sense::kTo) && IsKind(at_ + 2, ChunkKind::kDirection));
  if (!begins || (IsSense(at_ + 1, Sense::kIn) && !ThingFollows(at_ + 3, false))) return;
  BeginClause();
  if (!(IsPhrase(at_ + 1) && chunks_[at_ + 1].phrase.negated)) lead_ = Lead();
}

// "then a belt of trees", "then nothing but rock"
void ClauseReader::ReadThen() {
  negating_ = false;
  then_after_ = LastSubject();
  if (!ordering_ && !subjects_.empty() &&
      (IsPhrase(at_ + 1) || (IsSense(at_ + 1, Sense::kNothingElse) && IsThing(at_ + 2)))) {
    ReadNext();
  }
}

// "where", "in which"
void ClauseReader::ReadInWhich(const Chunk& chunk) {
  if (ReadWhere()) return;
  // "a forest in which there are two clearings"
  if (at_ > 0 && IsThing(at_ - 1) && d_.LastMentioned() >= 0 && !IsLine(d_.LastMentioned()) &&
      (IsSense(at_ + 1, Sense::kExists) ||
       (ThingFollows(at_ + 1, false) &&
        ToLowerAscii(d_.Words(chunk.begin, chunk.end)).find("which") != std::string::npos))) {
    const int host = d_.LastMentioned();
    BeginClause();
    d_.SetTopic({host});
    Frame frame;
    frame.sense = Sense::kIn;
    frame.inside = true;
    frame.objects = {host};
    frame.fronted = true;
    frame.expecting = false;
    frame_ = std::move(frame);
    if (IsSense(at_ + 1, Sense::kExists)) ++at_;
    return;
  }
  // "in the north, where ..."
  if (!last_zones_.empty() && IsKind(at_ - 1, ChunkKind::kComma) && at_ >= 2 &&
      IsKind(at_ - 2, ChunkKind::kPlace)) {
    BeginClause();
    lead_ = Lead();
    lead_.zones = last_zones_;
    lead_.begin = chunk.begin;
  }
}

// "a lake, which ...": what was named last is what is spoken of.
void ClauseReader::ReadWhich() {
  if (frame_.has_value() && !frame_->objects.empty()) {
    const int nearest = frame_->objects.back();
    if (WantsTwo(frame_->sense) && frame_->objects.size() < 2) {
      paused_ = std::move(frame_);
      frame_.reset();
    }
    CloseFrame();
    d_.SetTopic(subjects_);
    subjects_ = {nearest};
    open_list_ = false;
  } else if (subjects_.size() > 1) {
    d_.SetTopic(subjects_);
    subjects_ = {subjects_.back()};
  }
  if (excepting_ && !lead_.empty()) {
    subjects_.clear();
    lead_.is_subject = true;
    lead_.extent = true;
  }
}

}  // namespace latticeworld
