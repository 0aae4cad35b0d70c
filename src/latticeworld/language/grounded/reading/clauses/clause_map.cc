#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// What is said of the whole map, and of the rest of it.
namespace latticeworld {

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
  const bool over =
      frame_.has_value() && frame_->sense == Sense::kCrosses && LineOf(frame_->subjects) < 0;
  if (frame_.has_value() && (frame_->sense == Sense::kIn || over) && frame_->objects.empty() &&
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
    if (!IsCourse(frame_->sense)) {
      frame_.reset();
    } else if (frame_->sense == Sense::kCrosses) {
      frame_->sense = Sense::kThrough;  // "two roads cross the map": not each other
    }
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
  share_of_map_ = true;
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

}  // namespace latticeworld
