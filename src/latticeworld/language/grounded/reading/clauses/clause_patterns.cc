#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// Turns of phrase that are read as a whole, several chunks at once.
namespace latticeworld {

// "Where the road meets the river stands an inn": near both; false, and nothing read, where no
// thing follows.
bool ClauseReader::ReadWhere() {
  constexpr std::size_t kReach = 8;  // chunks
  std::size_t verb = at_ + 1;
  std::vector<std::size_t> phrases;
  bool crosses = false;
  for (; verb < std::min(chunks_.size(), at_ + kReach); ++verb) {
    if (IsSense(verb, Sense::kStands) || IsSense(verb, Sense::kExists) || EndsAt(verb)) break;
    if (IsSense(verb, Sense::kBe) && IsThing(verb + 1)) break;
    if (IsKind(verb, ChunkKind::kComma)) break;
    if (IsPhrase(verb)) phrases.push_back(verb);
    crosses = crosses || IsSense(verb, Sense::kCrosses);
  }
  // "Where the tongue ends, there is a lake."
  const std::string said = ToLowerAscii(d_.Words(
      chunks_[at_].begin, chunks_[verb < chunks_.size() ? verb : chunks_.size() - 1].begin));
  if (phrases.size() <= 1 &&
      (said.find(" ends") != std::string::npos || said.find(" stops") != std::string::npos) &&
      ThingFollows(verb, true)) {
    for (int i = d_.size() - 1; i >= 0; --i) {
      const Heading way = d_.thing(i).dropped ? Heading{0, 0} : WayOf(i);
      if ((way.east != 0) == (way.south != 0)) continue;
      BeginClause();
      Frame end;
      end.is_direction = true;
      end.heading = way;
      end.touching = true;
      end.objects = {i};
      end.fronted = true;
      end.expecting = false;
      frame_ = std::move(end);
      at_ = verb - 1;
      return true;
    }
  }
  const bool told = !phrases.empty() && phrases.size() <= 2 && phrases.front() == at_ + 1 &&
                    !EndsAt(verb) && ThingFollows(verb, true);
  if (!told) return false;
  BeginClause();
  Frame frame;
  frame.sense = Sense::kNear;
  frame.fronted = true;
  frame.expecting = false;
  const std::size_t where = at_;
  for (const std::size_t at : phrases) {
    at_ = at;
    for (const int index : Refer(chunks_[at])) frame.objects.push_back(index);
  }
  at_ = where;
  if (frame.objects.empty()) return false;
  if (frame.objects.size() == 2 && (crosses || LineOf(frame.objects) >= 0)) {
    Frame meeting;
    meeting.sense = crosses ? Sense::kCrosses : Sense::kNextTo;
    meeting.objects = {frame.objects[1]};
    Assert(meeting, frame.objects[0], &d_);
  }
  frame_ = std::move(frame);
  at_ = verb - 1;
  return true;
}

// "a river splits the map into a northern and a southern part": it runs between them.
bool ClauseReader::ReadHalves() {
  const int line = LineOf(subjects_);
  const bool of_map = at_ > 0 && IsPhrase(at_ - 1) && chunks_[at_ - 1].phrase.head == Head::kMap;
  const bool two = IsKind(at_ + 1, ChunkKind::kPlace) && IsSense(at_ + 2, Sense::kAnd) &&
                   IsKind(at_ + 3, ChunkKind::kPlace);
  const bool one = IsKind(at_ + 1, ChunkKind::kPlace) && chunks_[at_ + 1].lexeme.places.size() == 2;
  if (line < 0 || !of_map || !(two || one) || d_.feature(line).from.has_value()) return false;
  const Heading side = HeadingOf(RegionOf(chunks_[at_ + 1].lexeme.places.front().zone));
  if ((side.east == 0) == (side.south == 0)) return false;
  Waypoint from;
  from.zone = RimZoneOf({side.south != 0 ? -1 : 0, side.east != 0 ? -1 : 0});
  Waypoint to;
  to.zone = RimZoneOf({side.south != 0 ? 1 : 0, side.east != 0 ? 1 : 0});
  d_.feature(line).from = from;
  d_.feature(line).to = to;
  frame_.reset();
  at_ += two ? 3 : 1;
  d_.Extend(line, chunks_[at_].end);
  return true;
}

// "possible to have", "ought to be", "to surround the lake": no way leads there.
bool ClauseReader::IsInfinitive(std::size_t at) const {
  if (d_.Words(chunks_[at].begin, chunks_[at].end).size() > 2) return false;
  for (const Sense verb :
       {Sense::kHas, Sense::kBe, Sense::kStands, Sense::kRuns, Sense::kWinds, Sense::kCovers,
        Sense::kSurrounds, Sense::kConnects, Sense::kCrosses, Sense::kDominates}) {
    if (IsSense(at + 1, verb)) return true;
  }
  return false;
}

// A bridge takes a road over the river that was spoken of, or that comes.
void ClauseReader::ReadBridge(const Chunk& chunk) {
  if (d_.plan().vocabulary == Vocabulary::kWild) return;
  int road = d_.Latest('R', FeatureForm::kLine);
  const int river = d_.Latest('W', FeatureForm::kLine);
  const bool road_comes = IsThing(at_ + 1) && chunks_[at_ + 1].phrase.noun->suburb == 'R';
  if (road < 0 && !road_comes) {
    const std::vector<Token> word = Tokenize("road");
    NounPhrase phrase;
    phrase.noun = MatchClassWord(word, 0).word;
    // "two bridges": as many roads
    if (at_ > 0 && IsKind(at_ - 1, ChunkKind::kQualities)) {
      phrase.qualities.count = chunks_[at_ - 1].qualities.count;
    }
    if (phrase.noun != nullptr) road = d_.Create(phrase, chunk.begin, chunk.end);
  }
  if (road < 0) return;
  CloseFrame();
  if (subjects_.empty()) subjects_ = {road};
  if (river < 0) return;
  PlannedRelation relation;
  relation.kind = RelationKind::kCrosses;
  relation.subject = road;
  relation.object = river;
  d_.Relate(std::move(relation));
}

// "villas with one drive leading in": to the villas.
void ClauseReader::ReadToThere() {
  verb_said_ = true;
  const int line = LineOf(subjects_);
  int place = line < 0 ? -1 : d_.Latest('B', FeatureForm::kPatch);
  if (line >= 0 && place < 0) {
    const std::vector<int> found = d_.Antecedent(subjects_, false);
    if (!found.empty()) place = found.back();
  }
  if (place < 0 || place == line) return;
  Frame frame;
  frame.sense = Sense::kTo;
  frame.subjects = {line};
  frame.objects = {place};
  Assert(frame, line, &d_);
}

// "Six ponds. All but one lie in the forest; the odd one out ...": one is told from the others.
void ClauseReader::ReadAllButOne() {
  for (int i = d_.size() - 1; i >= 0; --i) {
    if (d_.thing(i).dropped || d_.feature(i).pieces < 2) continue;
    BeginClause();
    split_ = d_.SplitOff(i);
    subjects_ = {i};
    return;
  }
}

// "Two rivers, one from the west, one from the east, flow together and leave through the south":
// what follows is said of both.
void ClauseReader::ReadMeeting() {
  const int line = LineOf(subjects_);
  if (line < 0) return;
  CloseFrame();
  std::vector<int> lines;
  for (int i = 0; i < d_.size(); ++i) {
    const bool alike = IsLine(i) && !d_.thing(i).dropped &&
                       d_.feature(i).letter == d_.feature(line).letter &&
                       d_.sentence() <= d_.thing(i).sentence + 1;
    if (alike) lines.push_back(i);
  }
  subjects_ = lines;
  list_has_and_ = true;
  verb_said_ = true;
}

// "The forest is a crescent; inside the crescent there is a village": close by it.
void ClauseReader::ReadInsideBend() {
  for (int i = d_.size() - 1; i >= 0; --i) {
    const bool bent = d_.feature(i).shape == ClaimShape::kBent || IsLine(i);
    if (d_.thing(i).dropped || !bent) continue;
    Frame frame;
    frame.sense = Sense::kNear;
    frame.objects = {i};
    frame.expecting = false;
    if (ThingFollows(at_ + 1, true)) {
      if (!subjects_.empty()) BeginClause();
      frame.fronted = true;
      frame_ = std::move(frame);
    } else {
      for (const int subject : subjects_) Assert(frame, subject, &d_);
    }
    // If it is known where the bend bulges to, what is inside it lies on the other side.
    const PlannedFeature& line = d_.feature(i);
    const Heading bulge = line.via.empty() ? Heading{0, 0} : HeadingOf(RegionOf(line.via[0].zone));
    if (IsLine(i) && (bulge.east != 0) != (bulge.south != 0) && !frame_.has_value()) {
      Frame side;
      side.is_direction = true;
      side.heading = {-bulge.east, -bulge.south};
      side.objects = {i};
      for (const int subject : subjects_) Assert(side, subject, &d_);
    }
    return;
  }
}

// "islands covered with trees": of that class.
bool ClauseReader::ClotheIsland(int host) {
  const bool land = host >= 0 && d_.thing(host).is_island && IsThing(at_ + 1) &&
                    chunks_[at_ + 1].phrase.noun->shape == WordShape::kMass;
  const char letter = land ? chunks_[at_ + 1].phrase.noun->LetterIn(d_.plan().vocabulary) : '\0';
  if (letter == '\0' || letter == 'W') return false;
  d_.feature(host).letter = letter;
  d_.Extend(host, chunks_[at_ + 1].end);
  ++at_;
  return true;
}

// The way along a line, or what is long; (0, 0): not known.
Heading ClauseReader::WayOf(int index) const {
  const PlannedFeature& line = d_.feature(index);
  if (!line.from.has_value() || !line.to.has_value() || line.from->feature >= 0 ||
      line.to->feature >= 0) {
    return {0, 0};
  }
  const Heading from = HeadingOf(RegionOf(line.from->zone));
  const Heading to = HeadingOf(RegionOf(line.to->zone));
  const int east = to.east - from.east;
  const int south = to.south - from.south;
  return {(east > 0) - (east < 0), (south > 0) - (south < 0)};
}

// "woods at both its ends": in the directions that it runs.
void ClauseReader::ReadBothEnds(bool of_it) {
  std::vector<int> objects;
  for (int i = d_.size() - 1; i >= 0 && objects.empty(); --i) {
    const bool about = std::find(subjects_.begin(), subjects_.end(), i) != subjects_.end();
    const Heading way = WayOf(i);
    if (!d_.thing(i).dropped && !about && (way.east != 0 || way.south != 0)) objects = {i};
  }
  if (objects.empty() || subjects_.empty()) {
    OpenSense(Sense::kNear, of_it);
    return;
  }
  Frame frame;
  frame.is_direction = true;
  frame.both = true;
  frame.heading = WayOf(objects[0]);
  frame.objects = objects;
  const std::vector<int> subjects = subjects_;
  CloseFrame();
  for (const int subject : subjects) Assert(frame, subject, &d_);
  if (IsPhrase(at_ + 1)) ++at_;  // "at both ends of the lake"
}

// "behind the houses on both sides fields": on both sides of the road that the houses line.
bool ClauseReader::ReadFartherSides() {
  const bool beyond =
      frame_.has_value() && (frame_->sense == Sense::kBehind || frame_->sense == Sense::kBeyond ||
                             frame_->sense == Sense::kOutside);
  if (!beyond || !ThingFollows(at_ + 1, false)) return false;
  const int object = frame_->objects.empty() ? -1 : frame_->objects.back();
  int line = object >= 0 && IsLine(object) ? object : -1;
  for (const PlannedRelation& relation : d_.plan().relations) {
    const bool beside =
        (relation.subject == object || (object < 0 && relation.kind == RelationKind::kBothSides)) &&
        IsLine(relation.object);
    if (beside) line = relation.object;
  }
  if (line < 0) return false;
  const Heading way = WayOf(line);
  if ((way.east != 0) == (way.south != 0)) return false;
  Frame frame;
  frame.is_direction = true;
  frame.both = true;
  frame.heading = {way.south, way.east};
  frame.objects = {line};
  frame_.reset();
  if (!subjects_.empty()) BeginClause();
  frame.fronted = true;
  frame.expecting = false;
  frame_ = std::move(frame);
  return true;
}

// "In between a strip of bushes": between what was named before.
bool ClauseReader::ReadInBetween() {
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end));
  const bool alone = words == "in between" && at_ == sentence_start_ && IsThing(at_ + 1) &&
                     chunks_[at_ + 1].phrase.indefinite && !IsSense(at_ + 2, Sense::kAnd);
  if (!alone) return false;
  const std::vector<int> two = d_.LastTwo({});
  if (two.size() < 2) return false;
  Frame frame;
  frame.sense = Sense::kBetween;
  frame.objects = two;
  frame.fronted = true;
  frame.expecting = false;
  frame_ = std::move(frame);
  return true;
}

}  // namespace latticeworld
