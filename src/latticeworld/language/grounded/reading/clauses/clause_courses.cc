#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

namespace latticeworld {
// "between the forest and the bottom edge": toward the edge from the forest.
bool ClauseReader::TakeOtherEnd(const std::vector<Zone>& zones) {
  const bool second = frame_.has_value() && frame_->sense == Sense::kBetween &&
                      frame_->objects.size() == 1 && at_ > 0 && IsSense(at_ - 1, Sense::kAnd);
  if (!second) return false;
  const Heading side = HeadingOf(RegionOf(zones.front()));
  if (side.east == 0 && side.south == 0) return false;
  frame_->sense = Sense::kNone;
  frame_->is_direction = true;
  frame_->heading = side;
  frame_->expecting = false;
  if (!frame_->fronted) {
    for (const int subject : frame_->subjects) Assert(*frame_, subject, &d_);
  }
  return true;
}

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

// "to the north edge, the south edge and the eastern edge": a line to each of them.
void ClauseReader::TakeMoreEnds(int line) {
  const auto is_edge = [&](std::size_t at) {
    if (!IsKind(at, ChunkKind::kPlace) || chunks_[at].lexeme.places.size() != 1) return false;
    const std::string words = ToLowerAscii(d_.Words(chunks_[at].begin, chunks_[at].end));
    const std::string& name = chunks_[at].lexeme.places.front().zone.name;
    return EndsWithWord(name, "edge") || EndsWithWord(name, "corner") ||
           EndsWithWord(words, "edge") || EndsWithWord(words, "border") ||
           EndsWithWord(words, "side") || EndsWithWord(words, "corner");
  };
  if (!is_edge(at_)) return;
  std::vector<std::size_t> more;
  for (std::size_t at = at_ + 1; more.size() < 3;) {
    std::size_t next = at;
    if (IsKind(next, ChunkKind::kComma)) ++next;
    if (IsSense(next, Sense::kAnd)) ++next;
    if (next == at || !is_edge(next)) break;
    more.push_back(next);
    at = next + 1;
  }
  if (more.empty() || !(EndsAt(more.back() + 1) || IsKind(more.back() + 1, ChunkKind::kComma) ||
                        IsSense(more.back() + 1, Sense::kAnd))) {
    return;
  }
  if (d_.feature(line).pieces > 1) return;
  for (const std::size_t at : more) {
    const int twin = d_.Twin(line);
    if (twin == line) return;
    Waypoint to;
    to.zone = EndZoneOf(chunks_[at].lexeme.places.front().zone,
                        d_.Words(chunks_[at].begin, chunks_[at].end));
    d_.feature(twin).to = to;
    at_ = at;
  }
}

// Ends and turning points of a line.
bool ClauseReader::TakeEndZone(const std::vector<Zone>& zones) {
  if (TakeOtherEnd(zones) || TakeHeading(zones)) return true;
  if (!frame_.has_value() || !frame_->expecting || !frame_->objects.empty()) return false;
  // "between the northern edge and the village": north of the village.
  const Heading before = HeadingOf(RegionOf(zones.front()));
  if (frame_->sense == Sense::kBetween && IsSense(at_ + 1, Sense::kAnd) && IsThing(at_ + 2) &&
      (before.east != 0 || before.south != 0)) {
    frame_->sense = Sense::kNone;
    frame_->is_direction = true;
    frame_->heading = before;
    ++at_;
    return true;
  }
  const Sense sense = frame_->sense;
  const Chunk& chunk = chunks_[at_];
  const std::string words = d_.Words(chunk.begin, chunk.end);
  const bool end = sense == Sense::kFrom || sense == Sense::kTo || sense == Sense::kConnects;
  if (sense == Sense::kTo && SplitsMap(zones, words)) return true;
  const bool between = sense == Sense::kThrough || sense == Sense::kCrosses ||
                       sense == Sense::kPast || sense == Sense::kAlong || sense == Sense::kIn;
  // "a road hugging the southern edge"
  const bool hugs = sense == Sense::kNextTo && EndsWithWord(zones.front().name, "edge") &&
                    zones.size() == 1 && LineOf(frame_->subjects) >= 0 && !frame_->negated;
  if (hugs) {
    const int index = LineOf(frame_->subjects);
    d_.feature(index).along = zones.front();
    d_.Extend(index, chunk.end);
    frame_.reset();
    return true;
  }
  if (!end && !between) return false;
  Waypoint waypoint;
  waypoint.zone = end ? EndZoneOf(zones.front(), words) : zones.front();
  const int line = LineOf(frame_->subjects);
  if (end && line >= 0) {
    if (DealOut(line, zones, words, sense == Sense::kFrom)) {
      frame_.reset();
      return true;
    }
    if (zones.size() == 4 || zones.front().name == "edges") {
      // "roads to every side of the map"; the arms of a crossroads go there anyway.
      const std::string_view noun = d_.thing(line).noun->phrase;
      const bool crossing = noun.find("cross") != std::string_view::npos ||
                            noun == "intersection" || noun == "junction";
      const bool all = crossing || zones.size() == 4;
      if (all && !d_.feature(line).from.has_value() && !d_.feature(line).to.has_value()) {
        if (!crossing) ReachAllSides(line);
        d_.Extend(line, chunk.end);
        frame_.reset();
        return true;
      }
    }
    // "making a big loop to the right": there it passes, on its way.
    const bool bends = sense == Sense::kTo && at_ >= 2 && IsKind(at_ - 2, ChunkKind::kQualities) &&
                       (chunks_[at_ - 2].qualities.shape == ClaimShape::kBent ||
                        chunks_[at_ - 2].qualities.shape == ClaimShape::kWinding);
    if (bends) {
      Waypoint via;
      via.zone = ZoneOf(HeadingOf(RegionOf(zones.front())));
      d_.feature(line).via.push_back(std::move(via));
      d_.Extend(line, chunk.end);
      frame_.reset();
      return true;
    }
    for (const int index : frame_->subjects) {
      if (!IsLine(index)) continue;
      PlannedFeature& feature = d_.feature(index);
      const bool first =
          sense == Sense::kFrom || (sense == Sense::kConnects && !feature.from.has_value());
      // "heads north to the edge of the map": the northern one.
      const bool any_edge = waypoint.zone.name == "edges" && !first && feature.to.has_value() &&
                            feature.to->feature < 0;
      if (any_edge) continue;
      // "from the town to the north edge and to the south edge": another line from there.
      const bool again = !first && feature.to.has_value() && feature.to->feature < 0 &&
                         sense == Sense::kTo && feature.from.has_value() && at_ >= 2 &&
                         (IsSense(at_ - 2, Sense::kAnd) || IsKind(at_ - 2, ChunkKind::kComma));
      if (again && feature.pieces <= 1 &&
          EndsWithWord(EndZoneOf(zones.front(), words).name, "edge")) {
        const int twin = d_.Twin(index);
        if (twin != index) {
          d_.feature(twin).to = waypoint;
          d_.feature(twin).via.clear();
          continue;
        }
      }
      (first ? d_.feature(index).from : d_.feature(index).to) = waypoint;
      d_.Extend(index, chunk.end);
      if (!first) TakeMoreEnds(index);
    }
    if (sense == Sense::kConnects && !d_.feature(line).to.has_value()) return true;
    frame_.reset();
    return true;
  }
  // "From the lake we walked east, through forest ...": the lake is the first of them.
  if (sense == Sense::kTo && traveling_ && !ordering_ && from_.has_value() && from_->feature >= 0 &&
      frame_->subjects.empty()) {
    const Heading way = HeadingOf(RegionOf(zones.front()));
    const int first = from_->feature;
    from_.reset();
    frame_.reset();
    BeginOrder(way);
    order_ = {first};
    return true;
  }
  if (end && (frame_->fronted || frame_->subjects.empty())) {
    // "To the north-east there is a shop": a place.
    std::size_t stands = SkipVerbs(at_ + 1);
    if (IsKind(stands, ChunkKind::kComma)) stands = SkipVerbs(stands + 1);
    const bool place = sense == Sense::kTo && !from_.has_value() && !traveling_ && !ordering_ &&
                       IsThing(stands) && chunks_[stands].phrase.noun->shape != WordShape::kLine;
    if (place) {
      // "To the north of it, snow; to the south, forest."
      frame_->is_direction = true;
      frame_->heading = HeadingOf(RegionOf(zones.front()));
      const int same = SameObject();
      if (same >= 0) {
        frame_->objects = {same};
        frame_->expecting = false;
        return true;
      }
      frame_.reset();
      Lead_(zones, chunk);
      return true;
    }
    (sense == Sense::kFrom ? from_ : to_) = waypoint;
    frame_.reset();
    // "From north to south: snow, rock, forest."
    if (from_.has_value() && to_.has_value()) {
      const Heading a = HeadingOf(RegionOf(from_->zone));
      const Heading b = HeadingOf(RegionOf(to_->zone));
      std::size_t next = SkipVerbs(at_ + 1);
      if (IsKind(next, ChunkKind::kComma)) next = SkipVerbs(next + 1);
      const bool line_next = IsThing(next) && chunks_[next].phrase.noun->shape == WordShape::kLine;
      if (IsOppositeHeading(a, b) && (traveling_ || !line_next)) {
        from_.reset();
        to_.reset();
        BeginOrder(b);
      }
    } else if (traveling_ && sense == Sense::kFrom && !IsSense(at_ + 1, Sense::kTo)) {
      const Heading a = HeadingOf(RegionOf(from_->zone));
      from_.reset();
      BeginOrder({-a.east, -a.south});
    } else if (traveling_ && sense == Sense::kTo && !from_.has_value()) {
      const Heading b = HeadingOf(RegionOf(to_->zone));
      to_.reset();
      BeginOrder(b);
    }
    return true;
  }
  if (end) {
    // A belt that runs: "a strip of forest from the north to the south".
    const int index = frame_->subjects.empty() ? -1 : frame_->subjects.back();
    if (index < 0) return false;
    PlannedFeature& feature = d_.feature(index);
    const bool pair = sense == Sense::kFrom && IsSense(at_ + 1, Sense::kTo);
    const bool second = sense == Sense::kTo && feature.from.has_value();
    // "an inlet cuts in from the north and ends in the middle"
    Thing& thing = d_.thing(index);
    if (sense == Sense::kTo && thing.start.has_value() && feature.letter == 'W') {
      feature.from = *std::exchange(thing.start, std::nullopt);
      feature.to = waypoint;
      feature.form = FeatureForm::kLine;
      feature.wide = true;
      feature.zones.clear();
      d_.Extend(index, chunk.end);
      frame_.reset();
      return true;
    }
    if (!pair && !second) {
      if (sense == Sense::kFrom) thing.start = waypoint;
      frame_.reset();
      Attach(zones, false, chunk);
      return true;
    }
    if (frame_->subjects.size() > 1 && !verb_said_) {
      // "snow, rock and forest from north to south"
      if (pair) {
        from_ = waypoint;
        frame_.reset();
        return true;
      }
    }
    (pair ? feature.from : feature.to) = waypoint;
    if (second && feature.form != FeatureForm::kLine) {
      feature.form = FeatureForm::kLine;
      feature.wide = true;
    }
    d_.Extend(index, chunk.end);
    frame_.reset();
    return true;
  }
  if (line < 0) return false;
  PlannedFeature& feature = d_.feature(line);
  if (sense == Sense::kAlong) {
    feature.along = AlongZone(zones.front());
  } else if (sense == Sense::kIn || (sense == Sense::kCrosses && !feature.from.has_value())) {
    return false;
  } else {
    for (const Zone& zone : zones) {
      Waypoint via;
      via.zone = zone;
      feature.via.push_back(std::move(via));
    }
  }
  d_.Extend(line, chunk.end);
  frame_.reset();
  return true;
}

// "a river runs diagonally": from corner to corner.
void ClauseReader::RunDiagonally() {
  const int line = LineOf(subjects_);
  if (line < 0 || d_.feature(line).from.has_value()) return;
  Waypoint from;
  from.zone = RimZoneOf({-1, -1});
  from.said = false;
  Waypoint to;
  to.zone = RimZoneOf({1, 1});
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
  Waypoint from;
  from.zone = RimZoneOf(axis.from);
  Waypoint to;
  to.zone = RimZoneOf(axis.to);
  if (frame_.has_value() && frame_->objects.empty()) {
    if (frame_->fronted) {
      frame_.reset();
    } else {
      CloseFrame();
    }
  }
  const int line = LineOf(subjects_);
  if (line >= 0) {
    // "stream north to south, road east to west": the road does.
    const std::vector<int> lines = list_has_and_ || verb_said_ ? subjects_ : std::vector<int>{line};
    open_list_ = false;
    for (int index : lines) {
      if (!IsLine(index)) continue;
      // "two roads, north-south and east-west"
      if (d_.feature(index).from.has_value() && d_.feature(index).pieces > 1) {
        index = d_.SplitOff(index);
        subjects_.push_back(index);
      }
      d_.feature(index).from = from;
      d_.feature(index).to = to;
      d_.Extend(index, chunk.end);
    }
    return;
  }
  // "three ponds in a row from west to east"
  if (subjects_.size() == 1 && d_.feature(subjects_[0]).pieces > 1) {
    // "two strips of forest run from north to south": each of them does.
    if (IsStrip(subjects_[0])) {
      d_.feature(subjects_[0]).from = from;
      d_.feature(subjects_[0]).to = to;
      d_.feature(subjects_[0]).form = FeatureForm::kLine;
      d_.feature(subjects_[0]).wide = true;
      d_.Extend(subjects_[0], chunk.end);
      const std::string words =
          ToLowerAscii(d_.Words(d_.thing(subjects_[0]).begin, d_.thing(subjects_[0]).end));
      if (words.find("parallel") != std::string::npos) {
        Frame frame;
        frame.sense = Sense::kParallelEach;
        frame.subjects = subjects_;
        AssertEachOther(frame, &d_);
      }
      return;
    }
    if (d_.feature(subjects_[0]).zones.empty() && (axis.to.east == 0 || axis.to.south == 0)) {
      d_.AddZones(subjects_[0], {*FindZone(axis.to.east != 0 ? "middle rows" : "middle columns")});
    }
    d_.Extend(subjects_[0], chunk.end);
    return;
  }
  if (subjects_.size() >= 2 && !verb_said_) {
    order_ = subjects_;
    order_begin_ = d_.thing(subjects_.front()).begin;
    ordering_ = true;
    order_heading_ = axis.to;
    return;
  }
  const bool after_phrase =
      at_ > 0 &&
      (IsPhrase(at_ - 1) || (at_ > 1 && IsPhrase(at_ - 2) && IsSense(at_ - 1, Sense::kFrom)));
  const bool of_one = subjects_.size() == 1 && after_phrase &&
                      (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma)) &&
                      (EndsAt(at_ + 1) || d_.instruction()[chunks_[at_ + 1].begin] == ',');
  const bool ridge = subjects_.size() == 1 && at_ > 1 &&
                     (IsThing(at_ - 1) || (IsSense(at_ - 1, Sense::kFrom) && IsThing(at_ - 2))) &&
                     !IsKind(at_ + 1, ChunkKind::kComma) && !traveling_;
  if (!subjects_.empty() && (verb_said_ || of_one || ridge)) {
    const int index = subjects_.back();
    d_.feature(index).from = from;
    d_.feature(index).to = to;
    // "a long lake stretches from north to south": as a wide river does.
    const bool lake = d_.feature(index).letter == 'W' && !d_.thing(index).plural &&
                      d_.feature(index).pieces <= 1 && !d_.feature(index).share.has_value() &&
                      !d_.feature(index).share_least.has_value();
    // "Exactly one ridge of rock. A ridge of rock runs from west to east."
    const bool ridge_counted =
        d_.thing(index).counted == 1 && d_.thing(index).noun->shape == WordShape::kMass;
    if (d_.feature(index).form == FeatureForm::kSpread || lake || ridge_counted) {
      d_.feature(index).form = FeatureForm::kLine;
      d_.feature(index).wide = true;
      // "A long narrow lake. The lake runs from west to east.": both were said.
      if (d_.feature(index).shape == ClaimShape::kElongated &&
          d_.thing(index).sentence == d_.sentence()) {
        d_.feature(index).shape.reset();
      }
    }
    return;
  }
  std::size_t next = SkipVerbs(at_ + 1);
  if (IsKind(next, ChunkKind::kComma)) next = SkipVerbs(next + 1);
  const bool line_next = IsThing(next) && chunks_[next].phrase.noun->shape == WordShape::kLine;
  // "on the right, from top to bottom, lies the lake"
  const bool long_next = IsThing(next) && next > at_ + 2 && IsSense(next - 1, Sense::kStands) &&
                         chunks_[next].phrase.noun->shape == WordShape::kThing &&
                         ListLength(next) == 1;
  if ((line_next || long_next) && !traveling_) {
    from_ = from;
    to_ = to;
  } else {
    BeginOrder(axis.to);
  }
}

// "from the depot to the shop along a road": the road joins them.
void ClauseReader::JoinEnds(int line) {
  PlannedFeature& feature = d_.feature(line);
  const bool joins =
      from_.has_value() && to_.has_value() && !feature.from.has_value() && !feature.to.has_value();
  if (!joins) return;
  feature.from = from_;
  feature.to = to_;
  if (from_->feature >= 0 && to_->feature >= 0) {
    PlannedRelation relation;
    relation.kind = RelationKind::kConnects;
    relation.subject = line;
    relation.object = from_->feature;
    relation.second_object = to_->feature;
    d_.Relate(std::move(relation));
  }
  from_.reset();
  to_.reset();
}

// "four roads, one to each edge": each of them to one.
bool ClauseReader::DealOut(int line, const std::vector<Zone>& zones, const std::string& words,
                           bool from) {
  if (zones.size() < 2 || d_.feature(line).pieces != static_cast<int>(zones.size())) return false;
  std::vector<int> lines;
  for (std::size_t i = 0; i + 1 < zones.size(); ++i) lines.push_back(d_.SplitOff(line));
  lines.push_back(line);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    Waypoint end;
    end.zone = EndZoneOf(zones[i], words);
    (from ? d_.feature(lines[i]).from : d_.feature(lines[i]).to) = end;
  }
  return true;
}

}  // namespace latticeworld
