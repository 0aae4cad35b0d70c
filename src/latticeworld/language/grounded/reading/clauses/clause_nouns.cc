#include <string>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// What noun phrases do in a clause: name, count, deny, correct, compare.
namespace latticeworld {
namespace {

// "no forest", "zero houses"
bool SaysNone(const NounPhrase& phrase) {
  return phrase.negated ||
         (phrase.qualities.count.has_value() && phrase.qualities.count->most == 0);
}

}  // namespace

void ClauseReader::ReadNounPhrase(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  JoinByLine(phrase);
  if (skip_next_ && phrase.noun != nullptr) {
    skip_next_ = false;
    return;
  }
  // Phrases that name no thing of their own are read first.
  if (ReadMapOrRest(chunk) || CountThem(chunk) || ReadLeftOut(chunk) || ReadPartOf(chunk) ||
      DenyThing(chunk) || CorrectCountOf(phrase) || IsOtherWord(chunk) || SaysMore(chunk)) {
    return;
  }
  if (phrase.head == Head::kOther && phrase.noun == nullptr && IsKind(at_ + 1, ChunkKind::kPlace) &&
      IsMany(ZonesOf(chunks_[at_ + 1].lexeme.places))) {
    if (!subjects_.empty()) BeginClause();
    return;  // "the other corners"
  }
  // Any other phrase names things that are new or known.
  const int before = d_.size();
  const std::vector<int> found = Refer(chunk);
  const bool is_new = d_.size() > before;
  if (found.empty()) {
    if (frame_.has_value() && frame_->expecting) frame_->expecting = false;
    return;
  }
  for (const int index : found) d_.Extend(index, chunk.end);
  // They are what something is compared with, what lies on a shore, or another name of the subject
  // ...
  if (comparing_) {
    CompareWith(found.back());
    return;
  }
  if (LayOnShore(found)) return;
  if (IsSameThing(found, is_new)) {
    Merge(subjects_[0], found[0]);
    subjects_ = found;
    return;
  }
  // ... or else objects of the frame that waits for them, or new subjects.
  if (frame_.has_value() && frame_->expecting) {
    TakeObjects(found);
  } else {
    TakeSides(found);
    TakeSubjects(found, is_new, chunk);
  }
  if (correcting_) correcting_ = false;
}

// "linked with the lake by a straight road": the road joins them.
void ClauseReader::JoinByLine(const NounPhrase& phrase) {
  const bool joins = frame_.has_value() && frame_->sense == Sense::kConnectedBy &&
                     frame_->objects.size() == 1 && !frame_->subjects.empty() &&
                     !IsLine(frame_->objects[0]) && !IsLine(frame_->subjects.back()) &&
                     phrase.noun != nullptr && phrase.noun->shape == WordShape::kLine;
  if (!joins) return;
  frame_->sense = Sense::kConnects;
  frame_->objects.insert(frame_->objects.begin(), frame_->subjects.back());
  frame_->fronted = true;
  frame_->expecting = false;
}

// "the map", "the rest", "half of it"
bool ClauseReader::ReadMapOrRest(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (phrase.head == Head::kMap) {
    ReadMap(chunk);
    return true;
  }
  if (phrase.head == Head::kRest) {
    ReadRest(chunk);
    return true;
  }
  const bool most_there =
      (phrase.head == Head::kIt || phrase.head == Head::kThey) &&
      phrase.qualities.share.has_value() && phrase.qualities.share->mostly && !subjects_.empty() &&
      (IsKind(at_ + 1, ChunkKind::kPlace) || IsKind(at_ + 2, ChunkKind::kPlace));
  if (most_there) return true;  // "woods, most of it in the north"
  // "half of it is forest": of the map.
  if (phrase.head == Head::kIt && phrase.qualities.share.has_value()) {
    ReadMap(chunk);
    return true;
  }
  return false;
}

// "none of them touching the border", "copses: four of them"
bool ClauseReader::CountThem(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (phrase.head != Head::kThey) return false;
  if (SaysNone(phrase) || phrase.qualities.none) {
    BeginClause();
    subjects_ = d_.Antecedent({}, /*many=*/true);
    not_next_ = true;
    return true;
  }
  if (!phrase.qualities.count.has_value()) return false;
  std::vector<int> about = subjects_;
  if (about.empty()) about = d_.Antecedent({}, true);
  if (about.size() != 1 || SomeOf(phrase, about[0])) return false;
  d_.Describe(phrase.qualities, about[0]);
  d_.Extend(about[0], chunk.end);
  if (subjects_.empty()) subjects_ = about;
  return true;
}

// "no lake", "not a lake", "no forest and houses"
bool ClauseReader::DenyThing(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  const bool none = SaysNone(phrase);
  if (phrase.noun == nullptr || !(none || negating_ || not_next_)) return false;
  not_next_ = false;
  // "not a lake but a river"
  if (!none && !negating_ && IsSense(at_ + 1, Sense::kBut)) return true;
  // "no large lakes": there may be small ones.
  const bool zero = phrase.qualities.count.has_value() && phrase.qualities.count->most == 0;
  const bool of_size = phrase.negated && phrase.qualities.size > 1.0 &&
                       phrase.noun->shape != WordShape::kLine && !zero;
  if (of_size) {
    BeginClause();
  } else {
    ReadAbsence(chunk);
  }
  return true;
}

// "six huts, no, four huts"
bool ClauseReader::CorrectCountOf(const NounPhrase& phrase) {
  if (!correcting_ || phrase.noun == nullptr) return false;
  const int last = !subjects_.empty() ? subjects_.back() : d_.size() - 1;
  if (last < 0 || !phrase.qualities.count.has_value() ||
      phrase.noun->LetterIn(d_.plan().vocabulary) != d_.feature(last).letter) {
    return false;
  }
  correcting_ = false;
  d_.Describe(phrase.qualities, last);
  return true;
}

// Whether the phrase only goes on about what the clause is about.
bool ClauseReader::SaysMore(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (phrase.noun == nullptr) return false;
  // "the river comes in as one stream"
  const std::string own = ToLowerAscii(d_.Words(chunk.begin, chunk.end)).substr(0, 7);
  const bool as_one = own == "as one " || own == "as a si";
  if (as_one && LastSubject() >= 0 &&
      phrase.noun->LetterIn(d_.plan().vocabulary) == d_.feature(LastSubject()).letter) {
    d_.Extend(LastSubject(), chunk.end);
    return true;
  }
  // "three clearings, grassy ones"
  const std::string after = ToLowerAscii(d_.Words(chunk.end, d_.instruction().size())).substr(0, 5);
  if (after == " ones" && !subjects_.empty() && at_ > 0 && IsKind(at_ - 1, ChunkKind::kComma)) {
    d_.Extend(subjects_.back(), chunk.end);
    return true;
  }
  return false;
}

// "more forest than water"
void ClauseReader::CompareWith(int other) {
  Frame frame;
  frame.sense = comparing_less_ ? Sense::kSmallerThan : Sense::kOutweighs;
  frame.objects = {other};
  if (!subjects_.empty()) Assert(frame, subjects_.back(), &d_);
  comparing_ = false;
}

// "The shore of the lake is sand all the way round."
bool ClauseReader::LayOnShore(const std::vector<int>& found) {
  const bool of_shore = at_ >= 2 && IsSense(at_ - 1, Sense::kBe) && IsThing(at_ - 2) &&
                        chunks_[at_ - 2].phrase.shore && subjects_.size() == 1 &&
                        !frame_.has_value();
  if (!of_shore) return false;
  Frame frame;
  frame.sense = SaysAround(at_ + 1) ? Sense::kSurrounds : Sense::kNextTo;
  frame.objects = subjects_;
  for (const int index : found) Assert(frame, index, &d_);
  subjects_ = found;
  return true;
}

// "Half of the forest lies in the west", "most of the houses are in the north": so much of it is
// there, and how much there is nobody says.
bool ClauseReader::ReadPartOf(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (phrase.noun == nullptr || !phrase.qualities.share.has_value() || phrase.negated ||
      negating_ || frame_.has_value() || !lead_.empty()) {
    return false;
  }
  const ShareMatch& share = *phrase.qualities.share;
  const bool part = share.fraction ? share.of && phrase.definite : share.least >= 0.45;
  std::size_t place = at_ + 1;
  while (IsSense(place, Sense::kBe) || IsSense(place, Sense::kStands)) ++place;
  if (!part || place == at_ + 1) return false;
  if (IsSense(place, Sense::kIn)) ++place;
  if (!IsKind(place, ChunkKind::kPlace)) return false;
  const std::vector<Zone> zones = ZonesOf(chunks_[place].lexeme.places);
  if (zones.size() != 1 || zones.front().is_anywhere()) return false;
  Chunk whole = chunk;
  whole.phrase.qualities.share.reset();
  whole.phrase.qualities.mostly = false;
  const double least = share.mostly ? 0.5 : share.least;
  ReadNounPhrase(whole);
  if (subjects_.size() != 1) return true;
  d_.feature(subjects_[0]).located_in = zones.front();
  d_.feature(subjects_[0]).located_least = least;
  return true;
}

// "all the way round", "all around" right after a thing
bool ClauseReader::SaysAround(std::size_t at) const {
  if (EndsAt(at)) return false;
  const std::string words =
      ToLowerAscii(d_.Words(chunks_[at - 1].end, d_.instruction().size())).substr(0, 24);
  return words.find("round") != std::string::npos;
}

// "The only water is one small reservoir": one thing, said twice.
bool ClauseReader::IsSameThing(const std::vector<int>& found, bool is_new) const {
  if (!is_new || found.size() != 1 || subjects_.size() != 1 || frame_.has_value() || at_ == 0 ||
      !IsSense(at_ - 1, Sense::kBe)) {
    return false;
  }
  const int known = subjects_[0];
  return known != found[0] && d_.thing(known).sentence == d_.sentence() &&
         d_.feature(known).letter == d_.feature(found[0]).letter &&
         IsLine(known) == IsLine(found[0]);
}

// What was said of the one is said of the other, which stays.
void ClauseReader::Merge(int known, int other) {
  PlannedFeature& from = d_.feature(known);
  PlannedFeature& to = d_.feature(other);
  if (to.zones.empty()) to.zones = from.zones;
  if (to.pieces_least == 0) {
    to.pieces = from.pieces;
    to.pieces_least = from.pieces_least;
    to.pieces_most = from.pieces_most;
  }
  if (!to.share.has_value()) to.share = from.share;
  to.dominant = to.dominant || from.dominant;
  to.fills_rest = to.fills_rest || from.fills_rest;
  d_.thing(other).begin = d_.thing(known).begin;
  d_.Drop(known);
}

// "six trees or tree groups": the same things in other words.
bool ClauseReader::IsOtherWord(const Chunk& chunk) const {
  const NounPhrase& phrase = chunk.phrase;
  const int last = LastSubject();
  return at_ > 0 && IsSense(at_ - 1, Sense::kOr) && phrase.noun != nullptr && last >= 0 &&
         !phrase.definite && !phrase.qualities.count.has_value() && !frame_.has_value() &&
         phrase.noun->LetterIn(d_.plan().vocabulary) == d_.feature(last).letter &&
         (phrase.noun->shape == WordShape::kLine) == IsLine(last);
}

}  // namespace latticeworld
