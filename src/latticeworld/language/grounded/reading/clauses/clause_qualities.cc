#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// Numbers, shares, shapes and the like that stand apart from the noun: "the lakes are small".
namespace latticeworld {

void ClauseReader::ReadQualities(const Chunk& chunk) {
  const Qualities& said = chunk.qualities;
  if (IsMereNumber(chunk) || CorrectQualities(said) || ReadNone(chunk) || ReadGap(chunk)) return;
  const std::size_t next = at_ + 1;
  // "Lots of trees, please! At least half.": of what was spoken of.
  if (at_ == sentence_start_ && subjects_.empty() && lead_.empty() && EndsAt(next)) {
    for (const int index : d_.Antecedent({}, /*many=*/false)) d_.Describe(said, index);
    return;
  }
  // "40 % with woods, 20 % with water"
  const bool of_next = said.share.has_value() && IsSense(next, Sense::kWith) && IsThing(next + 1) &&
                       at_ > 0 &&
                       (IsKind(at_ - 1, ChunkKind::kComma) || IsSense(at_ - 1, Sense::kAnd));
  if (of_next && !subjects_.empty()) BeginClause();
  if (KeepForNext(said)) return;
  const std::vector<int> about = QualityOwners(said);
  if (not_next_) {
    not_next_ = false;
    return;
  }
  const bool mostly_place = (said.mostly || (said.share && said.share->mostly)) &&
                            (IsKind(next, ChunkKind::kPlace) || IsSense(next, Sense::kIn));
  if (mostly_place) return;  // "mostly in the north" says no more than "in the north"
  for (const int index : about) {
    d_.Describe(said, index);
    d_.Extend(index, chunk.end);
  }
  if (said.parallel && !about.empty() && LineOf(about) >= 0) {
    Frame frame;
    frame.sense = Sense::kParallelEach;
    frame.subjects = about;
    AssertEachOther(frame, &d_);
  }
}

// Whether a number counts nothing.
bool ClauseReader::IsMereNumber(const Chunk& chunk) const {
  const Qualities& said = chunk.qualities;
  if (!said.count.has_value()) return false;
  // "1. a lake", "2) a village": numbers of a list.
  if (at_ == sentence_start_ && !said.share &&
      (IsKind(at_ + 1, ChunkKind::kComma) || EndsAt(at_ + 1))) {
    return true;
  }
  // "two bridges"
  if (IsSense(at_ + 1, Sense::kBridge)) return true;
  // "two lakes: one big, one small"
  const int several = subjects_.empty() ? d_.LastMentioned() : subjects_.back();
  return said.count->least == 1 && said.count->most == 1 && several >= 0 &&
         ToLowerAscii(d_.Words(chunk.begin, chunk.end)).substr(0, 4) == "one " &&
         d_.feature(several).pieces_least >= 2;
}

// "six huts, scratch that, four"
bool ClauseReader::CorrectQualities(const Qualities& said) {
  if (!correcting_ || !said.count.has_value()) return false;
  correcting_ = false;
  int last = !subjects_.empty() ? subjects_.back() : d_.size() - 1;
  while (last > 0 && d_.feature(last).pieces == 0 && subjects_.empty()) --last;
  if (last >= 0) d_.Describe(said, last);
  return true;
}

// "trees: none"
bool ClauseReader::ReadNone(const Chunk& chunk) {
  if (!chunk.qualities.none) return false;
  std::vector<int> gone = subjects_;
  if (at_ > 0 && IsThing(at_ - 1) && d_.LastMentioned() >= 0) gone = {d_.LastMentioned()};
  std::size_t place = at_ + 1;
  if (IsSense(place, Sense::kIn)) ++place;
  if (IsKind(place, ChunkKind::kPlace)) {
    // "snow: none in the lower half": there is some elsewhere.
    not_next_ = true;
    return true;
  }
  for (const int index : gone) {
    if (d_.thing(index).sentence != d_.sentence()) continue;
    Chunk about = chunk;
    about.begin = d_.thing(index).begin;
    Deny(d_.feature(index).letter, d_.feature(index).zones, about);
    d_.Drop(index);
  }
  subjects_.clear();
  open_list_ = false;
  return true;
}

// "at least five cells from the water"
bool ClauseReader::ReadGap(const Chunk& chunk) {
  const std::size_t next = at_ + 1;
  const bool gap = chunk.qualities.count.has_value() && !subjects_.empty() &&
                   (IsSense(next, Sense::kFrom) || IsSense(next, Sense::kAway) ||
                    IsSense(next, Sense::kApartEach));
  if (!gap) return false;
  const std::string unit = ToLowerAscii(d_.Words(chunk.end, chunks_[next].begin));
  for (const std::string_view word : {"cells", "tiles", "steps", "squares"}) {
    if (unit.find(word) != std::string::npos) gap_ = chunk.qualities.count->least;
  }
  return gap_ > 0;
}

// Whether the qualities are of what is to come; what was counted before may be spoken of again.
bool ClauseReader::KeepForNext(const Qualities& said) {
  const std::size_t next = at_ + 1;
  if (!subjects_.empty() && !IsSense(next, Sense::kCoveredBy) &&
      !IsSense(next, Sense::kDominatedBy)) {
    return false;
  }
  if (said.share.has_value() && said.share->mostly && !said.share->fraction) {
    mostly_next_ = true;
  } else if (said.share.has_value()) {
    map_share_ = said.share;
    share_of_map_ = false;
  }
  if (said.mostly) mostly_next_ = true;
  // "all three in the eastern half"
  const bool refers = subjects_.empty() && said.count.has_value() &&
                      (IsKind(next, ChunkKind::kPlace) || IsSense(next, Sense::kIn));
  if (refers) subjects_ = d_.Antecedent({}, /*many=*/true);
  return subjects_.empty() || refers;
}

// Those that the qualities are said of.
std::vector<int> ClauseReader::QualityOwners(const Qualities& said) {
  std::vector<int> about = subjects_;
  if (frame_.has_value() && !frame_->fronted && !frame_->objects.empty() && IsPhrase(at_ - 1)) {
    about = {frame_->objects.back()};
  } else if (about.size() > 1 && !list_has_and_ && !verb_said_) {
    about = {about.back()};
  }
  // "heath peppered with small ponds, ten or more": the ponds are.
  if (said.count.has_value() && !said.share.has_value() && d_.LastMentioned() >= 0) {
    const int last = d_.LastMentioned();
    const bool countable = d_.feature(last).form == FeatureForm::kPatch && d_.thing(last).plural &&
                           d_.thing(last).sentence == d_.sentence() &&
                           d_.feature(last).pieces_least == 0;
    const bool about_mass =
        about.size() == 1 && about[0] != last && d_.feature(about[0]).form == FeatureForm::kSpread;
    if (countable && about_mass) about = {last};
  }
  // "grass and a road bending to the left": the road does.
  const bool of_line = said.shape == ClaimShape::kWinding || said.shape == ClaimShape::kStraight;
  if (of_line && LineOf(about) >= 0) about = {LineOf(about)};
  // "sand, grass and trees, each taking a third of the map"
  const bool each = IsSense(at_ - 1, Sense::kAll) ||
                    (IsSense(at_ - 1, Sense::kCovers) && at_ > 1 && IsSense(at_ - 2, Sense::kAll));
  if (each && said.share.has_value() && at_ > 0) {
    about = ordering_ ? order_ : subjects_;
    open_list_ = false;
  } else if (said.mostly && about.size() > 1 && IsThing(at_ - 1)) {
    about = {about.back()};
  }
  // "fields cover a third of the map"
  if (frame_.has_value() && frame_->expecting && frame_->objects.empty() &&
      (frame_->sense == Sense::kCovers || frame_->sense == Sense::kDominates)) {
    about = frame_->subjects;
    frame_.reset();
  }
  return about;
}

}  // namespace latticeworld
