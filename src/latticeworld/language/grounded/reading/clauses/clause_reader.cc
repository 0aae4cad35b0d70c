#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

#include <string>
#include <string_view>

#include "latticeworld/common/text.h"

namespace latticeworld {
void ClauseReader::Read() {
  sentence_start_ = 0;
  for (at_ = 0; at_ < chunks_.size(); ++at_) ReadChunk(chunks_[at_]);
  EndSentence();
}

void ClauseReader::ReadChunk(const Chunk& chunk) {
  switch (chunk.kind) {
    case ChunkKind::kNounPhrase:
      ReadNounPhrase(chunk);
      break;
    case ChunkKind::kPlace:
      ReadPlace(chunk);
      break;
    case ChunkKind::kDirection:
      ReadDirection(chunk);
      break;
    case ChunkKind::kAxis:
      ReadAxis(chunk);
      break;
    case ChunkKind::kQualities:
      ReadQualities(chunk);
      break;
    case ChunkKind::kSense:
      ReadSense(chunk);
      break;
    case ChunkKind::kComma:
      ReadComma();
      break;
    case ChunkKind::kStop:
      if (OrderGoesOn()) break;
      EndSentence();
      sentence_start_ = at_ + 1;
      break;
    case ChunkKind::kUnknown:
      break;
  }
}

// What was spoken of is the topic; something new may come.
void ClauseReader::BeginClause() {
  CloseFrame();
  EndHost();
  if (!subjects_.empty()) cover_next_ = false;
  d_.SetTopic(subjects_);
  subjects_.clear();
  open_list_ = false;
  list_has_and_ = false;
  joining_ = false;
  verb_said_ = false;
  absences_.clear();
  comparing_ = false;
}

void ClauseReader::EndSentence() {
  const int host = host_;
  BeginClause();
  // "A desert with grass around it. Its northern side ...": the desert's.
  if (host >= 0) d_.SetTopic({host});
  FinishOrder();
  paused_.reset();
  lead_ = Lead();
  map_is_subject_ = false;
  map_share_.reset();
  sharing_ = 0;
  cover_next_ = mostly_next_ = only_next_ = rest_next_ = skip_next_ = not_next_ = false;
  negating_ = excepting_ = confining_ = correcting_ = traveling_ = false;
  from_.reset();
  to_.reset();
  then_after_ = -1;
  last_zones_.clear();
  for (const auto& [thing, side] : sides_to_come_) {
    if (!IsLine(thing) && d_.feature(thing).zones.empty()) d_.AddZones(thing, {ZoneOf(side)});
  }
  sides_to_come_.clear();
  verbs_said_ = 0;
  side_of_ = -1;
  d_.NextSentence();
  sentence_first_feature_ = d_.size();
}

// "a forest with a lake": nothing more was said of the lake than that the forest has it.
void ClauseReader::EndHost() {
  if (host_ >= 0 && hosted_ >= 0 && d_.plan().relations.size() == host_relations_ &&
      (d_.feature(hosted_).zones.empty() || d_.thing(hosted_).zones_from_lead || IsSpot(host_) ||
       d_.feature(host_).letter == d_.feature(hosted_).letter)) {
    Frame frame;
    frame.sense = Sense::kHas;
    frame.objects = {hosted_};
    // "peaks with snow": one thing
    const bool same = d_.feature(host_).letter == d_.feature(hosted_).letter;
    if (same && d_.feature(hosted_).form == FeatureForm::kSpread) {
      // "a farm with its fields in the south": all of it is there
      if (d_.feature(host_).zones.empty()) d_.AddZones(host_, d_.feature(hosted_).zones);
      d_.Drop(hosted_);
    }
    Assert(frame, host_, &d_);
  }
  host_ = hosted_ = -1;
}

// "a clearing with a pond in the middle of the map": where the pond is, there is the clearing.
bool ClauseReader::IsSpot(int index) const {
  const PlannedFeature& feature = d_.feature(index);
  const bool building = feature.letter == 'B' && d_.plan().vocabulary == Vocabulary::kSuburb;
  return feature.form == FeatureForm::kPatch && !building && feature.zones.empty() &&
         feature.pieces <= 1 && !d_.thing(index).plural;
}

void ClauseReader::ReadComma() {
  // Brackets around a place part nothing.
  if (IsSense(at_ + 1, Sense::kWhich)) return;
  const char mark = d_.instruction()[chunks_[at_].begin];
  if (mark == '(' && IsKind(at_ + 1, ChunkKind::kPlace)) return;
  if (mark == '(' && InBrackets()) return;
  // "a forest (40 % of the map) by the lake"
  if (mark == '(' && IsPhrase(at_ + 1) && chunks_[at_ + 1].phrase.head == Head::kMap &&
      chunks_[at_ + 1].phrase.qualities.share.has_value()) {
    return;
  }
  if (mark == ')' && at_ >= 2 && IsKind(at_ - 1, ChunkKind::kPlace) &&
      IsKind(at_ - 2, ChunkKind::kComma) && !IsPhrase(at_ + 1)) {
    return;
  }
  negating_ = negating_ && IsThing(at_ + 1) && ListLength(at_ + 1) >= 1 &&
              (IsBareList(at_ + 1) || EndsAt(at_ + 2)) && !IsSaidAnew(at_ + 1);
  not_next_ = skip_next_ = false;
  if (ordering_ || negating_) return;
  const bool unfinished = frame_.has_value() && frame_->expecting && frame_->objects.empty();
  if (unfinished && mark == ':' && frame_->fronted) frame_.reset();
  // "streets that form a cross, trees along them": no object comes after the comma.
  if (unfinished && mark == ',' && at_ > 0 && frame_.has_value() && !frame_->fronted &&
      ((IsCourse(frame_->sense) && IsSense(at_ - 1, frame_->sense)) || FrameLacksObject())) {
    CloseFrame();
  }
  // "bare soil in the middle, about a quarter of the map"
  const bool of_map = IsPhrase(at_ + 1) && chunks_[at_ + 1].phrase.head == Head::kMap &&
                      chunks_[at_ + 1].phrase.qualities.share.has_value() && !subjects_.empty();
  if (of_map && (EndsAt(at_ + 2) || IsKind(at_ + 2, ChunkKind::kComma))) return;
  if (IsPhrase(at_ + 1)) {
    const bool list = frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
                      TakesList(frame_->sense) && IsBareList(at_ + 1);
    if (list) {
      frame_->expecting = true;
      return;
    }
    // "fields all round, trees along the north side"
    if (frame_.has_value() && frame_->expecting && frame_->objects.empty() && !frame_->fronted &&
        MayLackObject(frame_->sense) && !frame_->subjects.empty()) {
      BeginClause();
      return;
    }
    if (frame_.has_value() && frame_->expecting && frame_->objects.empty()) return;
    if (frame_.has_value() && frame_->fronted) {
      frame_->expecting = false;
      return;
    }
    if (open_list_ && !verb_said_ && !frame_.has_value() && IsThing(at_ + 1) &&
        !BeginsImperative(at_ + 1)) {
      joining_ = true;
      return;
    }
    if (subjects_.empty() && absences_.empty()) return;
    BeginClause();
    return;
  }
  // "enclosed by fields on the west, north and east"
  const bool more_sides =
      frame_.has_value() && IsKind(at_ + 1, ChunkKind::kPlace) &&
      (frame_->sense == Sense::kSurroundedBy || frame_->sense == Sense::kBorderedBy) && at_ > 0 &&
      IsKind(at_ - 1, ChunkKind::kPlace);
  if (more_sides) return;
  if (frame_.has_value() && !frame_->objects.empty() && !frame_->fronted &&
      !(WantsTwo(frame_->sense) && frame_->objects.size() < 2)) {
    CloseFrame();
  }
}

// "sand dominates, and ...", "trees in between, no rocks": nothing more comes.
bool ClauseReader::FrameLacksObject() const {
  if (!frame_.has_value() || !frame_->expecting || !frame_->objects.empty() || frame_->fronted) {
    return false;
  }
  return frame_->sense == Sense::kDominates ||
         (MayLackObject(frame_->sense) && at_ > 0 && IsSense(at_ - 1, frame_->sense));
}

// "cabins among the trees and one small lake": what is known and what is new are no one list.
bool ClauseReader::StartsAnew(std::size_t next) const {
  const NounPhrase& phrase = chunks_[next].phrase;
  const bool fresh = phrase.indefinite || phrase.qualities.count.has_value();
  if (!fresh || !IsPhrase(at_ - 1) || TakesList(frame_->sense) || IsCourse(frame_->sense)) {
    return false;
  }
  const NounPhrase& known = chunks_[at_ - 1].phrase;
  return known.definite || known.noun == nullptr;
}

void ClauseReader::ReadAnd(bool is_or) {
  const std::size_t next = at_ + 1;
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  for (const std::string_view on : {"then", "followed by", "next", "finally", "last"}) {
    if (words.find(on) != std::string::npos) then_after_ = LastSubject();
  }
  if (negating_) {
    const bool bare = IsThing(next) && !chunks_[next].phrase.definite && !IsSaidAnew(next);
    negating_ = is_or || bare;
    if (negating_) return;
  }
  if (ordering_) return;
  if (comparing_) return;
  if (FrameLacksObject()) CloseFrame();
  if (then_after_ >= 0 && ReadNextRing()) return;
  if (IsThing(next) && BeginsImperative(next) && !subjects_.empty()) {
    BeginClause();
    lead_ = Lead();
    return;
  }
  // "bordered by forest on the north and by fields on the south"
  const bool by_more =
      IsThing(next) && frame_.has_value() && !frame_->objects.empty() && !frame_->fronted &&
      (frame_->sense == Sense::kBorderedBy || frame_->sense == Sense::kSurroundedBy ||
       frame_->sense == Sense::kFlankedBy) &&
      ToLowerAscii(d_.Words(chunks_[at_].end, chunks_[next].end)).substr(0, 4) == " by ";
  if (by_more) {
    frame_->expecting = true;
    return;
  }
  if (IsPhrase(next)) {
    if (frame_.has_value() && frame_->expecting && frame_->objects.empty()) return;
    if (paused_.has_value()) {
      CloseFrame();
      frame_ = std::move(paused_);
      paused_.reset();
      frame_->expecting = true;
      return;
    }
    if (frame_.has_value() && !frame_->objects.empty()) {
      if (WantsTwo(frame_->sense) && frame_->objects.size() < 2) {
        frame_->expecting = true;
        return;
      }
      const bool goes_on =
          EndsAt(next + 1) || IsKind(next + 1, ChunkKind::kComma) || IsSense(next + 1, Sense::kAnd);
      if (frame_->fronted || (goes_on && !StartsAnew(next))) {
        frame_->expecting = true;
        return;
      }
      BeginClause();
      return;
    }
    // "forest, and a lake at the southern edge": the lake alone.
    const bool afterthought =
        at_ > 0 && IsKind(at_ - 1, ChunkKind::kComma) && subjects_.size() == 1;
    if (open_list_ && IsThing(next) && !afterthought) {
      joining_ = true;
      list_has_and_ = true;
      return;
    }
    if (IsPhrase(next) && !subjects_.empty()) BeginClause();
    return;
  }
  // "a lake in the north and in the south a village"
  if (IsKind(next, ChunkKind::kPlace) || IsSense(next, Sense::kIn)) return;
  if (frame_.has_value() && !frame_->objects.empty() &&
      !(WantsTwo(frame_->sense) && frame_->objects.size() < 2)) {
    CloseFrame();
  }
}

// "the mountains in the north (bare ground)": the same in other words; they are skipped.
bool ClauseReader::InBrackets() {
  const bool alone = IsThing(at_ + 1) && IsKind(at_ + 2, ChunkKind::kComma) &&
                     d_.instruction()[chunks_[at_ + 2].begin] == ')';
  const int last = d_.LastMentioned();
  if (!alone || last < 0 || d_.thing(last).sentence != d_.sentence()) return false;
  const NounPhrase& phrase = chunks_[at_ + 1].phrase;
  if (phrase.noun->LetterIn(d_.plan().vocabulary) != d_.feature(last).letter ||
      phrase.qualities.count.has_value() || phrase.indefinite || phrase.negated ||
      (phrase.noun->shape == WordShape::kLine) != IsLine(last)) {
    return false;
  }
  at_ += 2;
  return true;
}

// "..., and put a pond in the middle": a wish of its own.
bool ClauseReader::BeginsImperative(std::size_t next) const {
  const std::string words =
      ToLowerAscii(d_.Words(chunks_[next].begin, chunks_[next].end)).substr(0, 8);
  for (const std::string_view verb :
       {"put ", "place ", "add ", "draw ", "build ", "set ", "let "}) {
    if (words.substr(0, verb.size()) == verb) return true;
  }
  return false;
}

}  // namespace latticeworld
