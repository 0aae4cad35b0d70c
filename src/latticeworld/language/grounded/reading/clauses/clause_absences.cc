#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// What shall not be, and what is excepted.
namespace latticeworld {

void ClauseReader::ReadAbsence(const Chunk& chunk) {
  const char letter = chunk.phrase.noun->LetterIn(d_.plan().vocabulary);
  if (letter == '\0') return;
  d_.SetTopic(subjects_);
  subjects_.clear();
  open_list_ = false;
  if (!negating_) absences_.clear();
  negating_ = true;
  std::vector<Zone> zones = ZonesOf(chunk.phrase.places);
  if (zones.empty() && !lead_.empty()) zones = lead_.zones;
  // "above it there is not one tree"
  if (zones.empty() && frame_.has_value() && frame_->fronted) {
    const Heading side = HeadingOfFrame(*frame_);
    if (side.east != 0 || side.south != 0) zones = {ZoneOf(side)};
  }
  if (frame_.has_value() && !frame_->objects.empty()) CloseFrame();
  // "ponds in the south; no trees there"
  const std::string after = ToLowerAscii(d_.Words(chunk.end, d_.instruction().size())).substr(0, 6);
  if (zones.empty() && after == " there") zones = zones_before_;
  if (zones.empty() && DeniesAnother(*chunk.phrase.noun)) return;
  Deny(letter, zones, chunk);
}

// "A river but no lake", "no junctions": other water, other roads than those that were spoken of.
bool ClauseReader::DeniesAnother(const ClassWord& noun) const {
  // "no ponds in the south": there, at least.
  const bool placed = IsKind(at_ + 1, ChunkKind::kPlace) ||
                      (IsSense(at_ + 1, Sense::kIn) && IsKind(at_ + 2, ChunkKind::kPlace));
  if (correcting_ || placed) return false;
  const Vocabulary vocabulary = d_.plan().vocabulary;
  const char letter = noun.LetterIn(vocabulary);
  const bool road = letter == 'R' && vocabulary == Vocabulary::kSuburb;
  for (const std::string_view crossing : {"junction", "intersection", "crossing", "crossroad"}) {
    if (road && noun.phrase.find(crossing) != std::string_view::npos) return true;
  }
  if (!road && letter != 'W') return false;
  // What names all of the class.
  for (const std::string_view all :
       {"water", "road", "street", "body of water", "water body", "open water", "waterway"}) {
    if (noun.phrase == all) return false;
  }
  bool another = false;
  for (int i = 0; i < d_.size(); ++i) {
    if (d_.thing(i).dropped || d_.feature(i).letter != letter) continue;
    // "two ponds. no duck ponds", "a lake, a pond and no lakes"
    const ClassWord& other = *d_.thing(i).noun;
    // "an ocean ... just kidding, no sea": the same in other words.
    const bool alike = !road && other.shape == noun.shape && other.cells < 2 * noun.cells &&
                       noun.cells < 2 * other.cells;
    if (other.phrase == noun.phrase || alike) return false;
    another = true;
  }
  return another;
}

void ClauseReader::Deny(char letter, const std::vector<Zone>& zones, const Chunk& chunk) {
  const auto add = [&](const Zone& zone) {
    PlannedAbsence absence;
    absence.letter = letter;
    absence.zone = zone;
    absence.words = d_.Words(chunk.begin, chunk.end);
    absences_.push_back(d_.plan().absences.size());
    d_.Deny(std::move(absence));
  };
  if (d_.plan().absences.size() > 64) return;
  if (zones.empty()) add(Zone());
  for (const Zone& zone : zones) add(zone);
}

// What the sentence before asked for is not to be.
void ClauseReader::DropQuestion(const Chunk& chunk) {
  for (int i = 0; i < d_.size(); ++i) {
    if (d_.thing(i).dropped || d_.thing(i).sentence + 1 != d_.sentence()) continue;
    Chunk about = chunk;
    about.begin = d_.thing(i).begin;
    d_.Drop(i);
    Deny(d_.feature(i).letter, {}, about);
  }
  absences_.clear();
}

// "its western side is wooded, its eastern side is not": none of it there.
bool ClauseReader::ReadSideWithout(const Chunk& chunk) {
  const bool sided = frame_.has_value() && frame_->fronted && frame_->is_direction &&
                     axis_.subject >= 0 && axis_.sentence == d_.sentence() &&
                     (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma));
  if (!sided) return false;
  Deny(d_.feature(axis_.subject).letter, {RimZoneOf(frame_->heading)}, chunk);
  absences_.clear();
  frame_.reset();
  return true;
}

bool ClauseReader::AfterAll() const {
  if (at_ == 0) return false;
  const Chunk& before = chunks_[at_ - 1];
  return before.Is(Sense::kEntirely) ||
         (before.kind == ChunkKind::kNounPhrase && before.phrase.head == Head::kMap) ||
         (before.kind == ChunkKind::kPlace && SaysAnywhere(before.lexeme.places));
}

// "forest except in the south", "fields except for a village"
void ClauseReader::ReadExcept() {
  excepting_ = true;
  negating_ = false;
  if (IsThing(at_ + 1)) {
    for (const int index : subjects_) {
      PlannedFeature& feature = d_.feature(index);
      const bool all = feature.form == FeatureForm::kSpread && feature.zones.empty() &&
                       !feature.share.has_value() && !feature.fills_rest;
      if (all) feature.dominant = true;
    }
    BeginClause();
    excepting_ = true;
    map_share_.reset();
    cover_next_ = false;
  }
}

// "near the houses but not near the road": no more than "not"; else what is excepted.
void ClauseReader::ReadExceptOrNot(const Chunk& chunk) {
  if (EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "not") &&
      (IsSense(at_ + 1, Sense::kNear) || IsSense(at_ + 1, Sense::kNextTo))) {
    not_next_ = true;
    return;
  }
  ReadExcept();
}

// "treeless", "without roads", where the vocabulary has a class for what is lacking.
void ClauseReader::ReadLack(const Chunk& chunk) {
  const bool wild = d_.plan().vocabulary == Vocabulary::kWild;
  char letter = '\0';
  switch (chunk.lexeme.sense) {
    case Sense::kTreeless:
      letter = 'F';
      break;
    case Sense::kWaterless:
      letter = 'W';
      break;
    case Sense::kRoadless:
      letter = wild ? '\0' : 'R';
      break;
    case Sense::kUnbuilt:
      letter = wild ? '\0' : 'B';
      break;
    case Sense::kUnfarmed:
      letter = wild ? '\0' : 'A';
      break;
    default:  // kSnowless
      letter = wild ? 'S' : '\0';
      break;
  }
  if (letter != '\0') DenyAround(letter, chunk);
}

// "a treeless plain": where the plain is, if there are trees elsewhere.
void ClauseReader::DenyAround(char letter, const Chunk& chunk) {
  std::vector<Zone> zones = lead_.zones;
  bool asked = false;
  for (int i = 0; i < d_.size(); ++i) {
    asked = asked || (!d_.thing(i).dropped && d_.feature(i).letter == letter);
  }
  if (asked && zones.empty() && !subjects_.empty()) zones = d_.feature(LastSubject()).zones;
  if (asked && zones.empty()) return;
  const std::vector<std::size_t> focus = absences_;
  Deny(letter, zones, chunk);
  absences_ = focus;
}

void ClauseReader::TakeBackDenials() {
  for (std::size_t i = absences_.size(); i-- > 0;) {
    if (absences_[i] + 1 == d_.plan().absences.size()) d_.TakeBackDenial();
  }
  absences_.clear();
  negating_ = false;
}

// "no houses on the west side of the river": none in the west.
void ClauseReader::PlaceDenials(const Frame& frame) {
  if (frame.use == DirectionUse::kInside || frame.heading.IsDiagonal()) {
    TakeBackDenials();
    return;
  }
  for (const std::size_t i : absences_) {
    PlannedAbsence& absence = d_.plan().absences[i];
    if (absence.zone.is_anywhere()) absence.zone = RimZoneOf(frame.heading);
  }
  absences_.clear();
  negating_ = false;
}

// "scratch that": what the sentence named is not to be.
void ClauseReader::ReadScratch(const Chunk& chunk) {
  // "six huts, scratch that, four": only the number changes.
  const std::size_t number = at_ + (IsKind(at_ + 1, ChunkKind::kComma) ? 2 : 1);
  if (IsKind(number, ChunkKind::kQualities) && chunks_[number].qualities.count.has_value() &&
      !subjects_.empty()) {
    correcting_ = true;
    return;
  }
  CloseFrame();
  subjects_.clear();
  // "a village square, no, forget the square"
  if (EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "the")) {
    DropNamed();
    return;
  }
  int first = sentence_first_feature_;
  if (first >= d_.size()) first = d_.size() - 1;
  for (int i = std::max(0, first); i < d_.size(); ++i) d_.Drop(i);
}

// "a pond would be nice but is not needed": what the sentence named need not be.
void ClauseReader::DropOptional() {
  for (const int index : subjects_) {
    if (d_.thing(index).sentence == d_.sentence()) d_.Drop(index);
  }
  subjects_.clear();
}

// "forget the square": what was named so, else what was named last.
void ClauseReader::DropNamed() {
  const Chunk* next = ChunkAt(at_ + 1);
  if (next == nullptr || next->kind == ChunkKind::kStop) return;
  const std::string name = ToLowerAscii(d_.Words(next->begin, next->end));
  ++at_;
  for (int i = d_.size() - 1; i >= 0; --i) {
    const std::string known(d_.thing(i).noun->phrase);
    if (d_.thing(i).dropped || (known != name && !EndsWithWord(known, name))) continue;
    d_.Drop(i);
    return;
  }
  if (next->kind != ChunkKind::kNounPhrase || next->phrase.noun == nullptr) return;
  const std::vector<int> found = d_.Find(next->phrase, {});
  for (const int index : found) d_.Drop(index);
}

}  // namespace latticeworld
