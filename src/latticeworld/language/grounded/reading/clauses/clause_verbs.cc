#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Verbs: what there is, what has what, what covers what, what runs.
namespace latticeworld {

// "there is"
void ClauseReader::ReadExists() {
  if (IsKind(at_ + 1, ChunkKind::kQualities) && chunks_[at_ + 1].qualities.none) return;
  if (!subjects_.empty()) BeginClause();
  negating_ = false;
}

// "is", "stands"
void ClauseReader::ReadBe(Sense sense) {
  verb_said_ = true;
  ++verbs_said_;
  if (subjects_.empty() && absences_.empty() &&
      ((!lead_.empty() && lead_.is_subject && sense == Sense::kBe) ||
       (map_is_subject_ && sense == Sense::kBe))) {
    cover_next_ = true;
  }
  if (frame_.has_value() && frame_->fronted && !frame_->objects.empty()) {
    frame_->expecting = false;
  }
}

// Whether "with" or "has" belongs to the relation that is being read; it is read then.
bool ClauseReader::ReadWithOfFrame(Sense sense) {
  if (!frame_.has_value()) return false;
  if (!frame_->fronted && WantsTwo(frame_->sense) && frame_->objects.size() == 1 &&
      IsPhrase(at_ + 1)) {
    frame_->expecting = true;  // "connects the lake with the village"
    return true;
  }
  if (frame_->sense == Sense::kConnects && frame_->expecting && !frame_->subjects.empty() &&
      IsKind(at_ + 1, ChunkKind::kPlace)) {
    return true;  // "connects the north with the south"
  }
  // "connects the village with the eastern edge"
  if (sense == Sense::kWith && frame_->sense == Sense::kConnects && !frame_->fronted &&
      frame_->objects.size() == 1 && IsKind(at_ + 1, ChunkKind::kPlace)) {
    OpenSense(Sense::kTo, false);
    return true;
  }
  return false;
}

// "A village holds the middle", "has drawn a bow through the fields": no more than a verb.
bool ClauseReader::IsBareHas() const {
  if (IsKind(at_ + 1, ChunkKind::kPlace) && EndsAt(at_ + 2)) return true;
  return IsSense(at_ + 1, Sense::kStands) || IsSense(at_ + 1, Sense::kRuns) ||
         IsSense(at_ + 1, Sense::kWinds) || IsSense(at_ + 1, Sense::kBe);
}

// "a forest with a lake", "the forest has a lake": what comes next is the forest's.
void ClauseReader::ReadWith(Sense sense) {
  if (ReadWithOfFrame(sense)) return;
  if (sense == Sense::kHas && !subjects_.empty() && IsBareHas()) return;
  verb_said_ = false;
  // "Fill the map with forest."
  if (subjects_.empty() && at_ >= 2 && IsSense(at_ - 2, Sense::kCovers)) cover_next_ = true;
  int host = LastSubject();
  if (sense == Sense::kWith && frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
      IsPhrase(at_ - 1)) {
    host = frame_->objects.back();
  }
  if (frame_.has_value() && frame_->fronted && !frame_->objects.empty()) {
    frame_->expecting = false;
    return;
  }
  if (!subjects_.empty() || !absences_.empty()) BeginClause();
  d_.SetTopic(host >= 0 ? std::vector<int>{host} : std::vector<int>());
  if (host >= 0 && !IsLine(host)) host_ = host;
  if (host >= 0 && d_.feature(host).form == FeatureForm::kPatch && !d_.thing(host).is_island) {
    side_of_ = host;
  }
  lead_.used = true;
}

// "The north is covered by forest", "a hill covered with trees"
void ClauseReader::ReadCoveredBy(Sense sense) {
  verb_said_ = true;
  if (subjects_.empty()) {
    cover_next_ = true;
    if (sense == Sense::kDominatedBy) mostly_next_ = true;
    return;
  }
  const int host = LastSubject();
  if (ClotheIsland(host)) return;
  BeginClause();
  host_ = IsLine(host) ? -1 : host;
}

void ClauseReader::ReadCovers(const Chunk& chunk) {
  // "cover 40 % with woods", "fill the northern half with water"
  const bool share =
      IsKind(at_ + 1, ChunkKind::kQualities) && chunks_[at_ + 1].qualities.share.has_value();
  const bool place = IsKind(at_ + 1, ChunkKind::kPlace);
  if (subjects_.empty() && (share || place) && IsSense(at_ + 2, Sense::kWith)) {
    cover_next_ = true;
    return;
  }
  OpenSense(chunk.lexeme.sense, chunk.lexeme.of_it);
}

// "we walk", "going north"
void ClauseReader::ReadTravel(const Chunk& chunk) {
  traveling_ = true;
  // "To the right of it, in this order: beach, road, houses"
  if (frame_.has_value() && frame_->fronted && frame_->is_direction && !frame_->objects.empty() &&
      !ordering_) {
    const Heading heading = frame_->heading;
    const int first = frame_->objects.back();
    frame_.reset();
    BeginOrder(heading);
    order_ = {first};
    return;
  }
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  const bool from = EndsWithWord(words, "from") && IsKind(at_ + 1, ChunkKind::kPlace);
  if (from && subjects_.empty()) OpenSense(Sense::kFrom, false);
}

// "runs", "winds", "passes"
void ClauseReader::ReadRuns(const Chunk& chunk) {
  verb_said_ = true;
  // "passes the village"
  const std::string verb = ToLowerAscii(d_.Words(chunk.begin, chunk.end)).substr(0, 4);
  if (verb == "pass" && IsPhrase(at_ + 1) && LineOf(subjects_) >= 0) {
    OpenSense(Sense::kPast, false);
    return;
  }
  if (frame_.has_value() && frame_->fronted && !frame_->objects.empty()) {
    frame_->expecting = false;
  }
  // "a village by a river running from ...": said of the river.
  if (frame_.has_value() && !frame_->fronted && !frame_->objects.empty() && LineOf(subjects_) < 0 &&
      IsLine(frame_->objects.back())) {
    const int line = frame_->objects.back();
    CloseFrame();
    d_.SetTopic(subjects_);
    subjects_ = {line};
  }
  if (chunk.lexeme.sense == Sense::kWinds) {
    const int line = LineOf(subjects_);
    if (line >= 0) {
      d_.feature(line).meander = 2.2;
      d_.feature(line).shape = ClaimShape::kWinding;
    }
  }
}

}  // namespace latticeworld
