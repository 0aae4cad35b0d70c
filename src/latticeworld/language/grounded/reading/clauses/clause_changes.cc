#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// What changes what was said before, or takes all sides at once.
namespace latticeworld {

// "A wood in the north and fields in the south. No, swap those two."
void ClauseReader::ReadSwap() {
  CloseFrame();
  std::vector<int> placed;
  for (int i = d_.size() - 1; i >= 0 && placed.size() < 2; --i) {
    if (!d_.thing(i).dropped && !d_.feature(i).zones.empty()) placed.push_back(i);
  }
  if (placed.size() == 2) {
    std::swap(d_.feature(placed[0]).zones, d_.feature(placed[1]).zones);
  } else if (!d_.plan().relations.empty()) {
    PlannedRelation& last = d_.plan().relations.back();
    if (last.kind == RelationKind::kDirection || last.kind == RelationKind::kMoreThan) {
      last.heading = {-last.heading.east, -last.heading.south};
      if (last.kind == RelationKind::kMoreThan) std::swap(last.subject, last.object);
    }
  }
  correcting_ = false;
}

// "Snow in the corners. Leave out the south-eastern one.": none of it there, and "there" is where
// that is.
bool ClauseReader::ReadLeftOut(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (!(phrase.negated || not_next_) || phrase.noun != nullptr || phrase.places.size() != 1 ||
      (phrase.head != Head::kOne && phrase.head != Head::kOther)) {
    return false;
  }
  const Region left_out = phrase.places.front().main;
  for (int i = d_.size() - 1; i >= 0; --i) {
    PlannedFeature& feature = d_.feature(i);
    if (d_.thing(i).dropped || feature.zones.size() < 2) continue;
    const auto gone = std::find_if(feature.zones.begin(), feature.zones.end(),
                                   [&](const Zone& zone) { return RegionOf(zone) == left_out; });
    if (gone == feature.zones.end()) continue;
    const Zone zone = *gone;
    feature.zones.erase(gone);
    if (feature.pieces > 1) --feature.pieces;
    if (feature.pieces_least > 1) --feature.pieces_least;
    if (feature.pieces_most > 1) --feature.pieces_most;
    Deny(feature.letter, {zone}, chunk);
    absences_.clear();
    subjects_.clear();
    negating_ = not_next_ = false;
    there_ = zones_before_ = {zone};
    return true;
  }
  return false;
}

// "across the river from the town, fields": on the side of the river where the town is not.
bool ClauseReader::ReadAcross() {
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  const bool told = EndsWithWord(words, "across") && IsThing(at_ + 1) &&
                    IsSense(at_ + 2, Sense::kFrom) && IsPhrase(at_ + 3);
  if (!told) return false;
  const std::size_t across = at_;
  const std::vector<int> subjects = subjects_;
  at_ = across + 1;
  const std::vector<int> river = Refer(chunks_[at_]);
  at_ = across + 3;
  const std::vector<int> town = Refer(chunks_[at_]);
  if (river.empty() || town.empty()) {
    at_ = across;
    return false;
  }
  Heading side{0, 0};
  for (const PlannedRelation& relation : d_.plan().relations) {
    if (relation.kind == RelationKind::kDirection && relation.subject == town.back() &&
        relation.object == river.back()) {
      side = {-relation.heading.east, -relation.heading.south};
    }
  }
  const std::vector<Zone>& there = d_.feature(town.back()).zones;
  if (side.east == 0 && side.south == 0 && there.size() == 1) {
    const Heading at = HeadingOf(RegionOf(there.front()));
    const Heading way = WayOf(river.back());
    // What runs from west to east is crossed to the north or south.
    side = {way.east != 0 && way.south == 0 ? 0 : -at.east,
            way.south != 0 && way.east == 0 ? 0 : -at.south};
  }
  Frame frame;
  if (side.east != 0 || side.south != 0) {
    frame.is_direction = true;
    frame.heading = side;
  } else {
    frame.sense = Sense::kBeyond;
  }
  frame.objects = {river.back()};
  frame.expecting = false;
  const bool leads = subjects.empty() || across == sentence_start_ ||
                     IsSense(across - 1, Sense::kAnd) || IsKind(across - 1, ChunkKind::kComma);
  if (leads) {
    if (!subjects_.empty()) BeginClause();
    frame.fronted = true;
    frame_ = std::move(frame);
    if (IsKind(at_ + 1, ChunkKind::kComma)) ++at_;
  } else {
    for (const int subject : subjects) Assert(frame, subject, &d_);
  }
  return true;
}

// "reaching", "going to", "out to": no ring along the edges is meant.
bool ClauseReader::SaysReach() const {
  const std::size_t begin = at_ >= 3 ? chunks_[at_ - 3].begin : 0;
  const std::string words = ToLowerAscii(d_.Words(begin, chunks_[at_].begin));
  for (const std::string_view verb : {"reach", "go ", "goes ", "going ", "lead", "run", " to ",
                                      "exit", "leave", "leaving", "out ", "extend"}) {
    if (words.find(verb) != std::string::npos) return true;
  }
  return false;
}

// "a road from north to south, and a river doing likewise"
void ClauseReader::RunLikewise() {
  const int line = LineOf(subjects_);
  if (line < 0 || d_.feature(line).from.has_value() || d_.feature(line).to.has_value()) return;
  for (int i = d_.size() - 1; i >= 0; --i) {
    const PlannedFeature& model = d_.feature(i);
    if (i == line || d_.thing(i).dropped || !IsLine(i) || !model.from.has_value() ||
        !model.to.has_value() || model.from->feature >= 0 || model.to->feature >= 0) {
      continue;
    }
    d_.feature(line).from = model.from;
    d_.feature(line).to = model.to;
    return;
  }
}

// "roads reaching every side of the map": one across, one down, which meet.
void ClauseReader::ReachAllSides(int line) {
  if (d_.feature(line).from.has_value() || d_.feature(line).to.has_value()) return;
  const int second = d_.Twin(line);
  if (second == line) return;
  for (const int index : {line, second}) {
    PlannedFeature& road = d_.feature(index);
    const bool down = index == second;
    Waypoint from;
    from.zone = RimZoneOf(down ? Heading{0, -1} : Heading{-1, 0});
    Waypoint to;
    to.zone = RimZoneOf(down ? Heading{0, 1} : Heading{1, 0});
    road.from = from;
    road.to = to;
    road.zones.clear();
  }
  PlannedRelation crosses;
  crosses.kind = RelationKind::kCrosses;
  crosses.subject = line;
  crosses.object = second;
  d_.Relate(std::move(crosses));
}

}  // namespace latticeworld
