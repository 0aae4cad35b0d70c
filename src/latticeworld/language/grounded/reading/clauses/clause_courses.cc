#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// How lines run, and what is long: "from west to east", "diagonally".
namespace latticeworld {
namespace {

Waypoint AtRim(Heading heading) {
  Waypoint waypoint;
  waypoint.zone = RimZoneOf(heading);
  return waypoint;
}

}  // namespace

// "leaves the town heading east"
bool ClauseReader::TakeHeading(const std::vector<Zone>& zones) {
  const int line = LineOf(subjects_);
  if (line < 0 || at_ == 0 || zones.size() != 1) return false;
  const Chunk& chunk = chunks_[at_];
  const std::string before = ToLowerAscii(d_.instruction().substr(0, chunk.begin));
  const bool goes = EndsWith(before, " goes ") || EndsWith(before, " go ");
  if (!goes && !IsSense(at_ - 1, Sense::kRuns)) return false;
  const std::string words = d_.Words(chunk.begin, chunk.end);
  const bool bare = words.find(' ') == std::string::npos;  // "east", not "the western edge"
  const Heading side = HeadingOf(RegionOf(zones.front()));
  PlannedFeature& feature = d_.feature(line);
  if (!bare || (side.east == 0 && side.south == 0)) return false;
  // "runs to the middle and then turns north"
  const bool turns = feature.to.has_value() && feature.to->feature < 0 &&
                     RegionOf(feature.to->zone) == Region::kCenter;
  if (feature.to.has_value() && !turns) return false;
  if (turns) feature.via.push_back(*feature.to);
  Waypoint to;
  to.zone = EndZoneOf(zones.front(), words);
  feature.to = to;
  d_.Extend(line, chunk.end);
  return true;
}

// "splits the map into an eastern and a western half": the line runs between them.
bool ClauseReader::SplitsMap(const std::vector<Zone>& zones, const std::string& words) {
  const int line = LineOf(frame_->subjects);
  const bool two = IsSense(at_ + 1, Sense::kAnd) && IsKind(at_ + 2, ChunkKind::kPlace);
  const std::string last = two ? d_.Words(chunks_[at_ + 2].begin, chunks_[at_ + 2].end) : words;
  if (line < 0 || !SaysExtent(last) || at_ < 2) return false;
  const Chunk& before = chunks_[at_ - 2];
  const bool whole = before.kind == ChunkKind::kNounPhrase && before.phrase.head == Head::kMap;
  const Heading side = HeadingOf(RegionOf(zones.front()));
  if (!whole || (side.east == 0) == (side.south == 0)) return false;
  Waypoint from;
  from.zone = RimZoneOf(side.east != 0 ? Heading{0, -1} : Heading{-1, 0});
  Waypoint to;
  to.zone = RimZoneOf(side.east != 0 ? Heading{0, 1} : Heading{1, 0});
  d_.feature(line).from = from;
  d_.feature(line).to = to;
  frame_.reset();
  while (IsSense(at_ + 1, Sense::kAnd) && IsKind(at_ + 2, ChunkKind::kPlace)) at_ += 2;
  return true;
}

// "a river runs diagonally": from corner to corner.
void ClauseReader::RunDiagonally() {
  const int line = LineOf(subjects_);
  if (line < 0 || d_.feature(line).from.has_value()) return;
  Waypoint from = AtRim({-1, -1});
  from.said = false;
  Waypoint to = AtRim({1, 1});
  to.said = false;
  d_.feature(line).from = from;
  d_.feature(line).to = to;
}

// "a road from there": from what was spoken of.
void ClauseReader::RunFromThere() {
  const int line = LineOf(subjects_);
  if (line < 0) return;
  Frame frame;
  frame.sense = Sense::kFrom;
  frame.subjects = {line};
  frame.objects = d_.Antecedent(subjects_, false);
  if (!frame.objects.empty()) Assert(frame, line, &d_);
}

// "two strips of forest", "three parallel belts of rock"
bool ClauseReader::IsStrip(int index) const {
  const std::string words = ToLowerAscii(d_.Words(d_.thing(index).begin, d_.thing(index).end));
  for (const std::string_view strip : {"strips of ", "belts of ", "bands of ", "stripes of "}) {
    if (words.find(strip) != std::string::npos) return true;
  }
  return false;
}

void ClauseReader::ReadAxis(const Chunk& chunk) {
  const AxisMatch& axis = chunk.lexeme.axis;
  if (frame_.has_value() && frame_->objects.empty()) {
    if (frame_->fronted) {
      frame_.reset();
    } else {
      CloseFrame();
    }
  }
  if (LineOf(subjects_) >= 0) {
    RunLinesAlong(axis, chunk);
    return;
  }
  if (subjects_.size() == 1 && d_.feature(subjects_[0]).pieces > 1) {
    RunPiecesAlong(axis, chunk);
    return;
  }
  if (subjects_.size() >= 2 && !verb_said_) {
    order_ = subjects_;
    order_begin_ = d_.thing(subjects_.front()).begin;
    ordering_ = true;
    order_heading_ = axis.to;
    return;
  }
  if (!subjects_.empty() && (verb_said_ || EndsThingAtAxis())) {
    StretchAlong(axis, subjects_.back());
    return;
  }
  RunWhatComes(axis);
}

// "stream north to south, road east to west": the road does.
void ClauseReader::RunLinesAlong(const AxisMatch& axis, const Chunk& chunk) {
  const std::vector<int> lines =
      list_has_and_ || verb_said_ ? subjects_ : std::vector<int>{LineOf(subjects_)};
  open_list_ = false;
  for (int index : lines) {
    if (!IsLine(index)) continue;
    // "two roads, north-south and east-west"
    if (d_.feature(index).from.has_value() && d_.feature(index).pieces > 1) {
      index = d_.SplitOff(index);
      subjects_.push_back(index);
    }
    d_.feature(index).from = AtRim(axis.from);
    d_.feature(index).to = AtRim(axis.to);
    d_.Extend(index, chunk.end);
  }
}

// "three ponds in a row from west to east"
void ClauseReader::RunPiecesAlong(const AxisMatch& axis, const Chunk& chunk) {
  const int index = subjects_[0];
  PlannedFeature& feature = d_.feature(index);
  // "two strips of forest run from north to south": each of them does.
  if (IsStrip(index)) {
    feature.from = AtRim(axis.from);
    feature.to = AtRim(axis.to);
    feature.form = FeatureForm::kLine;
    feature.wide = true;
    d_.Extend(index, chunk.end);
    const std::string words = ToLowerAscii(d_.Words(d_.thing(index).begin, d_.thing(index).end));
    if (words.find("parallel") != std::string::npos) {
      Frame frame;
      frame.sense = Sense::kParallelEach;
      frame.subjects = subjects_;
      AssertEachOther(frame, &d_);
    }
    return;
  }
  if (feature.zones.empty() && (axis.to.east == 0 || axis.to.south == 0)) {
    d_.AddZones(index, {*FindZone(axis.to.east != 0 ? "middle rows" : "middle columns")});
  }
  d_.Extend(index, chunk.end);
}

// Whether the axis belongs to the thing right before it: "a ridge of rock from west to east".
bool ClauseReader::EndsThingAtAxis() const {
  const bool after_phrase =
      at_ > 0 &&
      (IsPhrase(at_ - 1) || (at_ > 1 && IsPhrase(at_ - 2) && IsSense(at_ - 1, Sense::kFrom)));
  const bool of_one = subjects_.size() == 1 && after_phrase &&
                      (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma)) &&
                      (EndsAt(at_ + 1) || d_.instruction()[chunks_[at_ + 1].begin] == ',');
  const bool ridge = subjects_.size() == 1 && at_ > 1 &&
                     (IsThing(at_ - 1) || (IsSense(at_ - 1, Sense::kFrom) && IsThing(at_ - 2))) &&
                     !IsKind(at_ + 1, ChunkKind::kComma) && !traveling_;
  return of_one || ridge;
}

// "a long lake stretches from north to south": as a wide river does.
void ClauseReader::StretchAlong(const AxisMatch& axis, int index) {
  PlannedFeature& feature = d_.feature(index);
  feature.from = AtRim(axis.from);
  feature.to = AtRim(axis.to);
  const bool lake = feature.letter == 'W' && !d_.thing(index).plural && feature.pieces <= 1 &&
                    !feature.share.has_value() && !feature.share_least.has_value();
  // "Exactly one ridge of rock. A ridge of rock runs from west to east."
  const bool ridge_counted =
      d_.thing(index).counted == 1 && d_.thing(index).noun->shape == WordShape::kMass;
  if (feature.form == FeatureForm::kSpread || lake || ridge_counted) {
    feature.form = FeatureForm::kLine;
    feature.wide = true;
    // "A long narrow lake. The lake runs from west to east.": both were said.
    if (feature.shape == ClaimShape::kElongated && d_.thing(index).sentence == d_.sentence()) {
      feature.shape.reset();
    }
  }
}

// "from west to east runs a river", "from north to south: snow, rock, forest"
void ClauseReader::RunWhatComes(const AxisMatch& axis) {
  std::size_t next = SkipVerbs(at_ + 1);
  if (IsKind(next, ChunkKind::kComma)) next = SkipVerbs(next + 1);
  const bool line_next = IsThing(next) && chunks_[next].phrase.noun->shape == WordShape::kLine;
  // "on the right, from top to bottom, lies the lake"
  const bool long_next = IsThing(next) && next > at_ + 2 && IsSense(next - 1, Sense::kStands) &&
                         chunks_[next].phrase.noun->shape == WordShape::kThing &&
                         ListLength(next) == 1;
  if ((line_next || long_next) && !traveling_) {
    from_ = AtRim(axis.from);
    to_ = AtRim(axis.to);
  } else {
    BeginOrder(axis.to);
  }
}

}  // namespace latticeworld
