#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Places that lines run from, to, through and along.
namespace latticeworld {
namespace {

Heading SideOf(const std::vector<Zone>& zones) { return HeadingOf(RegionOf(zones.front())); }

}  // namespace

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

bool ClauseReader::TakeEndZone(const std::vector<Zone>& zones) {
  if (TakeOtherEnd(zones) || TakeHeading(zones)) return true;
  if (!frame_.has_value() || !frame_->expecting || !frame_->objects.empty()) return false;
  if (TakeFirstEnd(zones)) return true;
  const Sense sense = frame_->sense;
  const Chunk& chunk = chunks_[at_];
  const std::string words = d_.Words(chunk.begin, chunk.end);
  if (sense == Sense::kTo && SplitsMap(zones, words)) return true;
  if (HugEdge(zones, chunk)) return true;
  const bool end = sense == Sense::kFrom || sense == Sense::kTo || sense == Sense::kConnects;
  if (!end) return TakePassage(zones, chunk);
  Waypoint waypoint;
  waypoint.zone = EndZoneOf(zones.front(), words);
  if (LineOf(frame_->subjects) >= 0) {
    EndLines(zones, waypoint, chunk);
    return true;
  }
  if (frame_->fronted || frame_->subjects.empty()) {
    if (!WalkOn(zones) && !StandThere(zones, chunk)) EndWhatComes(waypoint);
    return true;
  }
  EndBelt(zones, waypoint, chunk);
  return true;
}

// "between the northern edge and the village": north of the village.
bool ClauseReader::TakeFirstEnd(const std::vector<Zone>& zones) {
  const Heading before = SideOf(zones);
  if (frame_->sense != Sense::kBetween || !IsSense(at_ + 1, Sense::kAnd) || !IsThing(at_ + 2) ||
      (before.east == 0 && before.south == 0)) {
    return false;
  }
  frame_->sense = Sense::kNone;
  frame_->is_direction = true;
  frame_->heading = before;
  ++at_;
  return true;
}

// "a road hugging the southern edge"
bool ClauseReader::HugEdge(const std::vector<Zone>& zones, const Chunk& chunk) {
  const int line = LineOf(frame_->subjects);
  const bool hugs = frame_->sense == Sense::kNextTo && EndsWithWord(zones.front().name, "edge") &&
                    zones.size() == 1 && line >= 0 && !frame_->negated;
  if (!hugs) return false;
  d_.feature(line).along = zones.front();
  d_.Extend(line, chunk.end);
  frame_.reset();
  return true;
}

// "through the north", "along the south": a place that the line passes.
bool ClauseReader::TakePassage(const std::vector<Zone>& zones, const Chunk& chunk) {
  const Sense sense = frame_->sense;
  const int line = LineOf(frame_->subjects);
  if (line < 0) return false;
  PlannedFeature& feature = d_.feature(line);
  if (sense == Sense::kAlong) {
    feature.along = AlongZone(zones.front());
  } else if (sense == Sense::kThrough || sense == Sense::kPast ||
             (sense == Sense::kCrosses && feature.from.has_value())) {
    for (const Zone& zone : zones) {
      Waypoint via;
      via.zone = zone;
      feature.via.push_back(std::move(via));
    }
  } else {
    return false;
  }
  d_.Extend(line, chunk.end);
  frame_.reset();
  return true;
}

// "a road from the north to the south": where the lines begin and end.
void ClauseReader::EndLines(const std::vector<Zone>& zones, const Waypoint& end,
                            const Chunk& chunk) {
  const Sense sense = frame_->sense;
  const int line = LineOf(frame_->subjects);
  const std::string words = d_.Words(chunk.begin, chunk.end);
  if (DealOut(line, zones, words, sense == Sense::kFrom)) {
    frame_.reset();
    return;
  }
  if (ReachEdges(line, zones, chunk) || BendToward(line, zones, chunk)) return;
  for (const int index : frame_->subjects) {
    if (IsLine(index)) EndLine(index, end, chunk);
  }
  if (sense == Sense::kConnects && !d_.feature(line).to.has_value()) return;
  frame_.reset();
}

// "roads to every side of the map"; the arms of a crossroads go there anyway.
bool ClauseReader::ReachEdges(int line, const std::vector<Zone>& zones, const Chunk& chunk) {
  if (zones.size() != 4 && zones.front().name != "edges") return false;
  const std::string_view noun = d_.thing(line).noun->phrase;
  const bool crossing =
      noun.find("cross") != std::string_view::npos || noun == "intersection" || noun == "junction";
  const bool all = crossing || zones.size() == 4;
  if (!all || d_.feature(line).from.has_value() || d_.feature(line).to.has_value()) return false;
  if (!crossing) ReachAllSides(line);
  d_.Extend(line, chunk.end);
  frame_.reset();
  return true;
}

// "making a big loop to the right": there it passes, on its way.
bool ClauseReader::BendToward(int line, const std::vector<Zone>& zones, const Chunk& chunk) {
  const bool bends = frame_->sense == Sense::kTo && at_ >= 2 &&
                     IsKind(at_ - 2, ChunkKind::kQualities) &&
                     (chunks_[at_ - 2].qualities.shape == ClaimShape::kBent ||
                      chunks_[at_ - 2].qualities.shape == ClaimShape::kWinding);
  if (!bends) return false;
  Waypoint via;
  via.zone = ZoneOf(SideOf(zones));
  d_.feature(line).via.push_back(std::move(via));
  d_.Extend(line, chunk.end);
  frame_.reset();
  return true;
}

// One line begins or ends there; more of them where more ends follow.
void ClauseReader::EndLine(int index, const Waypoint& end, const Chunk& chunk) {
  const PlannedFeature& feature = d_.feature(index);
  const Sense sense = frame_->sense;
  const bool first =
      sense == Sense::kFrom || (sense == Sense::kConnects && !feature.from.has_value());
  // "heads north to the edge of the map": the northern one.
  const bool any_edge =
      end.zone.name == "edges" && !first && feature.to.has_value() && feature.to->feature < 0;
  if (any_edge) return;
  // "from the town to the north edge and to the south edge": another line from there.
  const bool again = !first && feature.to.has_value() && feature.to->feature < 0 &&
                     sense == Sense::kTo && feature.from.has_value() && at_ >= 2 &&
                     (IsSense(at_ - 2, Sense::kAnd) || IsKind(at_ - 2, ChunkKind::kComma));
  if (again && feature.pieces <= 1 && EndsWithWord(end.zone.name, "edge")) {
    const int twin = d_.Twin(index);
    if (twin != index) {
      d_.feature(twin).to = end;
      d_.feature(twin).via.clear();
      return;
    }
  }
  (first ? d_.feature(index).from : d_.feature(index).to) = end;
  d_.Extend(index, chunk.end);
  if (!first) TakeMoreEnds(index);
}

// "From the lake we walked east, through forest ...": the lake is the first of them.
bool ClauseReader::WalkOn(const std::vector<Zone>& zones) {
  const bool walks = frame_->sense == Sense::kTo && traveling_ && !ordering_ && from_.has_value() &&
                     from_->feature >= 0 && frame_->subjects.empty();
  if (!walks) return false;
  const int first = from_->feature;
  from_.reset();
  frame_.reset();
  BeginOrder(SideOf(zones));
  order_ = {first};
  return true;
}

// "To the north-east there is a shop": a place.
bool ClauseReader::StandThere(const std::vector<Zone>& zones, const Chunk& chunk) {
  std::size_t stands = SkipVerbs(at_ + 1);
  if (IsKind(stands, ChunkKind::kComma)) stands = SkipVerbs(stands + 1);
  const bool place = frame_->sense == Sense::kTo && !from_.has_value() && !traveling_ &&
                     !ordering_ && IsThing(stands) &&
                     chunks_[stands].phrase.noun->shape != WordShape::kLine;
  if (!place) return false;
  // "To the north of it, snow; to the south, forest."
  frame_->is_direction = true;
  frame_->heading = SideOf(zones);
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

// "From north to south: snow, rock, forest", "from west to east runs a river": of what is to come.
void ClauseReader::EndWhatComes(const Waypoint& end) {
  const Sense sense = frame_->sense;
  (sense == Sense::kFrom ? from_ : to_) = end;
  frame_.reset();
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
}

// A belt that runs: "a strip of forest from the north to the south".
void ClauseReader::EndBelt(const std::vector<Zone>& zones, const Waypoint& end,
                           const Chunk& chunk) {
  const Sense sense = frame_->sense;
  const int index = frame_->subjects.back();
  PlannedFeature& feature = d_.feature(index);
  const bool pair = sense == Sense::kFrom && IsSense(at_ + 1, Sense::kTo);
  const bool second = sense == Sense::kTo && feature.from.has_value();
  // "an inlet cuts in from the north and ends in the middle"
  Thing& thing = d_.thing(index);
  if (sense == Sense::kTo && thing.start.has_value() && feature.letter == 'W') {
    feature.from = *std::exchange(thing.start, std::nullopt);
    feature.to = end;
    feature.form = FeatureForm::kLine;
    feature.wide = true;
    feature.zones.clear();
    d_.Extend(index, chunk.end);
    frame_.reset();
    return;
  }
  if (!pair && !second) {
    if (sense == Sense::kFrom) thing.start = end;
    frame_.reset();
    Attach(zones, false, chunk);
    return;
  }
  // "snow, rock and forest from north to south"
  if (frame_->subjects.size() > 1 && !verb_said_ && pair) {
    from_ = end;
    frame_.reset();
    return;
  }
  (pair ? feature.from : feature.to) = end;
  if (second && feature.form != FeatureForm::kLine) {
    feature.form = FeatureForm::kLine;
    feature.wide = true;
  }
  d_.Extend(index, chunk.end);
  frame_.reset();
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
