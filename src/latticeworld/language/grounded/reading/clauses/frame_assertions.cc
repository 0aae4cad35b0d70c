#include <algorithm>
#include <string_view>
#include <utility>

#include "latticeworld/language/grounded/reading/clauses/frame.h"

namespace latticeworld {
namespace {

constexpr double kTouchingSteps = 2.0;
constexpr double kNearSteps = 4.0;
constexpr double kApartSteps = 3.0;

class Asserter {
 public:
  Asserter(const Frame& frame, int subject, Discourse* discourse)
      : frame_(frame), subject_(subject), object_(frame.objects.back()), d_(*discourse) {}

  void Assert() {
    if (subject_ == object_ && !WantsTwo(frame_.sense)) return;
    if (frame_.negated && IsCourse(frame_.sense)) {
      // "a road that does not cross the river": it only says what the road does not do.
    } else if (frame_.negated) {
      Relate(RelationKind::kApart, subject_, object_, kTouchingSteps);
    } else if (frame_.is_direction) {
      AssertDirection(frame_.heading);
    } else {
      AssertSense();
    }
  }

 private:
  const PlannedFeature& subject() const { return d_.feature(subject_); }
  const PlannedFeature& object() const { return d_.feature(object_); }
  static bool IsLine(const PlannedFeature& feature) { return feature.form == FeatureForm::kLine; }
  static bool IsSpread(const PlannedFeature& feature) {
    return feature.form == FeatureForm::kSpread;
  }

  void Relate(RelationKind kind, int subject, int object, double steps = 0.0) {
    PlannedRelation relation;
    relation.kind = kind;
    relation.subject = subject;
    relation.object = object;
    relation.steps = steps;
    d_.Relate(std::move(relation));
  }

  void AssertDirection(Heading heading) {
    if (frame_.use == DirectionUse::kInside) {
      AssertWithin(subject_, object_);
      return;
    }
    // "fields to its north and to its south": some here, some there.
    for (const PlannedRelation& known : d_.plan().relations) {
      const bool opposite = known.kind == RelationKind::kDirection && known.subject == subject_ &&
                            known.object == object_ && known.heading.east == -heading.east &&
                            known.heading.south == -heading.south;
      if (opposite && !IsLine(subject())) {
        if (IsLine(object())) Relate(RelationKind::kNear, subject_, object_, kNearSteps);
        subject_ = d_.Twin(subject_);
        if (IsLine(object())) Relate(RelationKind::kNear, subject_, object_, kNearSteps);
        break;
      }
    }
    PlannedRelation relation;
    relation.kind = RelationKind::kDirection;
    relation.subject = subject_;
    relation.object = object_;
    relation.heading = {heading.east, heading.south};
    d_.Relate(std::move(relation));
    if (frame_.along && IsLine(subject())) Relate(RelationKind::kAlong, subject_, object_);
    if (frame_.touching || (frame_.use == DirectionUse::kAtSide && !IsLine(object()))) {
      Relate(RelationKind::kAdjacent, subject_, object_,
             frame_.use == DirectionUse::kAtSide ? kTouchingSteps : kNearSteps);
    }
  }

  void AssertSense() {
    if (AssertNearness() || AssertJoining()) return;
    AssertOrder();
  }

  // How two things lie beside, around or in each other. False: the sense is none of these.
  bool AssertNearness() {
    // Each sense is a relation, one way round or the other.
    switch (frame_.sense) {
      case Sense::kNextTo:
        Relate(RelationKind::kAdjacent, subject_, object_,
               frame_.steps > 0.0 ? frame_.steps : kTouchingSteps);
        break;
      case Sense::kBorderedBy:
        Relate(RelationKind::kAdjacent, object_, subject_, kTouchingSteps);
        break;
      case Sense::kGivesWay:
        AssertGivesWay();
        break;
      case Sense::kNear:
      case Sense::kPast:
      case Sense::kOneSide:
        Relate(RelationKind::kNear, subject_, object_, kNearSteps);
        break;
      case Sense::kAway:
        Relate(RelationKind::kApart, subject_, object_,
               frame_.steps > 0.0 ? frame_.steps : kApartSteps);
        break;
      case Sense::kSurrounds:
        AssertSurrounds(subject_, object_);
        break;
      case Sense::kSurroundedBy:
        AssertSurrounds(object_, subject_);
        break;
      case Sense::kIn:
        AssertIn();
        break;
      case Sense::kWithin:
      case Sense::kWithinIt:
        AssertWithin(subject_, object_);
        break;
      case Sense::kContains:
      case Sense::kWith:
      case Sense::kHas:
        AssertHas();
        break;
      case Sense::kBothSides:
        AssertBothSides();
        break;
      case Sense::kFlankedBy:
        Relate(RelationKind::kBothSides, object_, subject_);
        break;
      default:
        return false;
    }
    return true;
  }

  // What lies between, joins, parts, follows or crosses. False: the sense is none of these.
  bool AssertJoining() {
    switch (frame_.sense) {
      case Sense::kBetween:
        AssertTwo(RelationKind::kBetween, subject_, frame_.objects);
        // "a motorway between the two towns", "a road between the lake and the village": joins
        // them.
        if (IsLine(subject()) && subject().letter == 'R' && AreSpots(frame_.objects)) {
          AssertTwo(RelationKind::kConnects, subject_, frame_.objects);
        }
        break;
      case Sense::kConnects:
        // "a hedge runs between the fields"
        AssertTwo(IsLine(subject()) ? RelationKind::kConnects : RelationKind::kBetween, subject_,
                  frame_.objects);
        break;
      case Sense::kSeparatedBy:
        AssertTwo(RelationKind::kBetween, object_, frame_.subjects);
        break;
      case Sense::kConnectedBy:
        if (IsLine(subject()) && !IsLine(object())) {
          Relate(RelationKind::kAdjacent, subject_, object_, kTouchingSteps);
        } else {
          AssertTwo(RelationKind::kConnects, object_, frame_.subjects);
        }
        break;
      case Sense::kAlong:
        AssertAlong(subject_, object_);
        break;
      case Sense::kLinedWith:
        AssertAlong(object_, subject_);
        break;
      case Sense::kThrough:
      case Sense::kCrosses:
        AssertThrough(subject_, object_);
        break;
      case Sense::kCutBy:
        AssertThrough(object_, subject_);
        break;
      case Sense::kParallel:
        if (IsLine(subject()) && IsLine(object())) {
          Relate(RelationKind::kParallel, subject_, object_);
        } else {
          AssertAlong(subject_, object_);
        }
        break;
      default:
        return false;
    }
    return true;
  }

  // Ends of lines, what is strewn, which way from something, and how much of it.
  void AssertOrder() {
    switch (frame_.sense) {
      case Sense::kFrom:
        AssertEnd(/*from=*/true);
        break;
      case Sense::kTo:
        AssertEnd(/*from=*/false);
        break;
      case Sense::kDottedWith:
        AssertSprinkled(object_, subject_);
        break;
      case Sense::kScatteredOver:
        AssertSprinkled(subject_, object_);
        break;
      case Sense::kAbove:
      case Sense::kBehind:
        AssertDirection({0, -1});
        // "the pond behind our house"
        if (frame_.sense == Sense::kBehind && object().letter == 'B' &&
            subject().form == FeatureForm::kPatch) {
          Relate(RelationKind::kNear, subject_, object_, kNearSteps);
        }
        break;
      case Sense::kBelow:
      case Sense::kInFront:
        AssertDirection({0, 1});
        break;
      case Sense::kBeyond:
        AssertBeyond();
        break;
      case Sense::kOutside:
        break;
      case Sense::kOutweighs:
      case Sense::kThan:
        Relate(RelationKind::kMoreThan, subject_, object_);
        break;
      case Sense::kSmallerThan:
        Relate(RelationKind::kMoreThan, object_, subject_);
        break;
      default:
        break;
    }
  }

  // "the southern edge is beach, then come houses": on from there.
  void AssertGivesWay() {
    const std::vector<Zone>& zones = subject().zones;
    const Heading there = zones.size() == 1 ? HeadingOf(RegionOf(zones.front())) : Heading{0, 0};
    if ((there.east != 0) != (there.south != 0) && object().zones.empty() && !IsLine(subject())) {
      PlannedRelation relation;
      relation.kind = RelationKind::kDirection;
      relation.subject = object_;
      relation.object = subject_;
      relation.heading = {-there.east, -there.south};
      d_.Relate(std::move(relation));
    }
    Relate(RelationKind::kAdjacent, object_, subject_, kTouchingSteps);
  }

  bool AreSpots(const std::vector<int>& indices) const {
    return d_.plan().vocabulary == Vocabulary::kSuburb &&
           std::any_of(indices.begin(), indices.end(),
                       [&](int index) { return d_.feature(index).letter == 'B'; }) &&
           std::all_of(indices.begin(), indices.end(), [&](int index) {
             const PlannedFeature& feature = d_.feature(index);
             return !IsLine(feature) &&
                    (feature.letter == 'B' || feature.form == FeatureForm::kPatch);
           });
  }

  // "fields north and south of the village": the sides are named.
  void AssertBothSides() {
    const Heading heading = frame_.heading;
    const bool named = heading.east != 0 || heading.south != 0;
    if (!named || IsLine(subject()) || IsLine(object())) {
      PlannedRelation relation;
      relation.kind = RelationKind::kBothSides;
      relation.subject = subject_;
      relation.object = object_;
      relation.heading = {heading.east, heading.south};
      d_.Relate(std::move(relation));
      return;
    }
    const int whole = subject_;
    for (const int sign : {1, -1}) {
      subject_ = whole;
      AssertDirection({sign * heading.east, sign * heading.south});
    }
  }

  // Nothing can lie all around a line that runs on.
  void AssertSurrounds(int outer, int inner) {
    PlannedFeature& around = d_.feature(outer);
    if (IsLine(d_.feature(inner))) {
      Relate(RelationKind::kAdjacent, outer, inner, kTouchingSteps);
    } else if (IsLine(around) && around.from.has_value()) {
      // "a river enters in the west, makes a bend around the town and leaves in the south"
      around.shape = ClaimShape::kBent;
      Relate(RelationKind::kNear, outer, inner, kNearSteps);
    } else {
      if (IsLine(d_.feature(outer)) && !frame_.partly) d_.feature(outer).shape = ClaimShape::kRing;
      Relate(RelationKind::kSurrounds, outer, inner);
    }
  }

  void AssertWithin(int inner, int outer) {
    if (d_.feature(inner).letter == d_.feature(outer).letter) return;
    // "a canyon from north to south, water in it": the water runs there.
    PlannedFeature& canyon = d_.feature(outer);
    PlannedFeature& water = d_.feature(inner);
    if (IsLine(canyon) && canyon.wide && water.letter == 'W' && canyon.from.has_value() &&
        canyon.to.has_value()) {
      water.form = FeatureForm::kLine;
      water.from = canyon.from;
      water.to = canyon.to;
      canyon.form = FeatureForm::kSpread;
      canyon.from.reset();
      canyon.to.reset();
      Relate(RelationKind::kBothSides, outer, inner);
      return;
    }
    if (IsLine(d_.feature(inner))) {
      AssertThrough(inner, outer);
    } else if (d_.feature(outer).shape == ClaimShape::kRing) {
      Relate(RelationKind::kSurrounds, outer, inner);
    } else if (IsLine(d_.feature(outer))) {
      Relate(RelationKind::kAdjacent, inner, outer, kTouchingSteps);
    } else {
      Relate(RelationKind::kWithin, inner, outer);
    }
  }

  // "a village on the lake" lies beside it, an island within it.
  void AssertIn() {
    const bool inside = frame_.inside && !IsLine(object()) && subject().letter == 'B' &&
                        d_.plan().vocabulary == Vocabulary::kSuburb;
    const bool beside = object().letter == 'W' && !d_.thing(subject_).is_island && !inside;
    // "a pond in a clearing"
    const bool area = frame_.inside && !IsLine(object()) && object().letter != 'B' &&
                      object().letter != 'W' && subject().letter != object().letter;
    // "a town inside the ring road"
    const bool ringed = frame_.inside && object().shape == ClaimShape::kRing;
    if (area || ringed) {
      AssertWithin(subject_, object_);
      return;
    }
    if (inside && object().letter == 'W') {
      AssertWithin(subject_, object_);
      return;
    }
    if (beside) {
      Relate(RelationKind::kAdjacent, subject_, object_, kTouchingSteps);
    } else if (IsSpread(object()) || d_.thing(subject_).is_island || d_.thing(object_).is_island) {
      AssertWithin(subject_, object_);
    } else {
      Relate(RelationKind::kNear, subject_, object_, kTouchingSteps);
    }
  }

  void AssertHas() {
    const PlannedFeature& host = subject();
    const PlannedFeature& held = object();
    if (host.letter == held.letter) return;
    if (d_.thing(object_).is_island || (IsSpread(host) && !IsSpread(held))) {
      if (!host.dominant || d_.thing(object_).is_island) AssertWithin(object_, subject_);
    } else if (IsSpread(host) && IsSpread(held)) {
      return;
    } else {
      Relate(RelationKind::kNear, object_, subject_, kNearSteps);
    }
  }

  void AssertTwo(RelationKind kind, int middle, const std::vector<int>& ends) {
    PlannedRelation relation;
    relation.kind = kind;
    relation.subject = middle;
    if (ends.size() >= 2) {
      relation.object = ends[ends.size() - 2];
      relation.second_object = ends.back();
    } else if (kind == RelationKind::kBetween && IsLine(d_.feature(ends[0])) &&
               d_.feature(ends[0]).shape == ClaimShape::kGridded) {
      Relate(RelationKind::kAdjacent, middle, ends[0], kTouchingSteps);  // between the streets
      return;
    } else if (const int other = Sibling(ends[0], IsLine(d_.feature(middle))); other >= 0) {
      relation.object = other;
      relation.second_object = ends[0];
    } else if (d_.feature(ends[0]).pieces >= 2 || d_.thing(ends[0]).plural ||
               d_.feature(ends[0]).zones.size() == 2) {
      // Two pieces of one thing.
      if (d_.feature(ends[0]).pieces == 0) d_.feature(ends[0]).pieces = 2;
      relation.object = ends[0];
      relation.second_object = ends[0];
    } else {
      // "a village, connected by a road to the northern edge"
      if (kind == RelationKind::kConnects)
        Relate(RelationKind::kAdjacent, middle, ends[0], kTouchingSteps);
      return;
    }
    if (relation.second_object == middle) return;
    // "to the left a wood, to the right a wood, a road in between": not to the right.
    if (kind == RelationKind::kBetween && d_.thing(middle).zones_from_lead) {
      d_.feature(middle).zones.clear();
      d_.thing(middle).zones_from_lead = false;
    }
    if (kind == RelationKind::kConnects) {
      PlannedFeature& line = d_.feature(middle);
      if (!IsLine(line)) return;
      if (!line.from.has_value() && !line.to.has_value() &&
          relation.object != relation.second_object) {
        Waypoint from;
        from.feature = relation.object;
        Waypoint to;
        to.feature = relation.second_object;
        line.from = from;
        line.to = to;
      }
    }
    d_.Relate(std::move(relation));
  }

  // One of a kind: counted as one, or (placed) a thing with a place of its own.
  bool IsOne(int index, bool placed) const {
    const PlannedFeature& feature = d_.feature(index);
    return feature.pieces == 1 ||
           (placed && feature.pieces == 0 && !d_.thing(index).plural && feature.zones.size() == 1);
  }

  // The other of two things that were split off each other: "two villages, one ..., one ...", or
  // that have places of their own: "a village in the east and a village in the west".
  int Sibling(int index, bool placed) const {
    if (!IsOne(index, placed)) return -1;
    int sibling = -1;
    for (int i = 0; i < d_.size(); ++i) {
      if (i == index || d_.thing(i).dropped || d_.thing(i).noun != d_.thing(index).noun) continue;
      if (!IsOne(i, placed)) continue;
      if (sibling >= 0) return -1;
      sibling = i;
    }
    return sibling;
  }

  void AssertAlong(int follower, int followed) {
    Relate(RelationKind::kAlong, follower, followed);
    if (!IsLine(d_.feature(follower))) {
      Relate(RelationKind::kAdjacent, follower, followed, kTouchingSteps);
    }
  }

  void AssertThrough(int line, int land) {
    if (!IsLine(d_.feature(line))) {
      // "ponds across a meadow"
      if (!IsLine(d_.feature(land))) AssertWithin(line, land);
      return;
    }
    if (IsLine(d_.feature(land))) {
      Relate(d_.feature(line).letter == d_.feature(land).letter && line == land
                 ? RelationKind::kNear
                 : RelationKind::kCrosses,
             line, land);
      return;
    }
    Waypoint waypoint;
    waypoint.feature = land;
    d_.feature(line).via.push_back(std::move(waypoint));
    Relate(RelationKind::kThrough, line, land);
  }

  void AssertEnd(bool from) {
    PlannedFeature& line = d_.feature(subject_);
    // "an avenue of trees leads from the town to the lake"
    for (const std::string_view word : {"avenue", "hedge", "row of", "line of", "belt", "strip"}) {
      const bool runs = d_.thing(subject_).noun->phrase.find(word) != std::string_view::npos;
      if (runs && line.pieces_least == 0) line.form = FeatureForm::kLine;
    }
    if (!IsLine(line)) {
      // "a meadow down to the river"
      if (!from) Relate(RelationKind::kAdjacent, subject_, object_, kTouchingSteps);
      return;
    }
    Waypoint end;
    end.feature = object_;
    (from ? line.from : line.to) = end;
    const bool both = line.from.has_value() && line.to.has_value() && line.from->feature >= 0 &&
                      line.to->feature >= 0 && line.from->feature != line.to->feature;
    if (both) {
      PlannedRelation relation;
      relation.kind = RelationKind::kConnects;
      relation.subject = subject_;
      relation.object = line.from->feature;
      relation.second_object = line.to->feature;
      d_.Relate(std::move(relation));
    } else if (line.letter != object().letter) {
      Relate(RelationKind::kAdjacent, subject_, object_, kTouchingSteps);
    }
  }

  // The land holds what is scattered over it and is the larger part.
  void AssertSprinkled(int pieces, int land) {
    PlannedFeature& scattered = d_.feature(pieces);
    if (!IsLine(scattered)) {
      scattered.texture = Texture::kScattered;
      if (scattered.pieces_least == 0) scattered.pieces = std::max(scattered.pieces, 6);
    }
    if (IsLine(d_.feature(land))) {
      AssertAlong(pieces, land);
      return;
    }
    AssertWithin(pieces, land);
    PlannedFeature& around = d_.feature(land);
    const bool placed = std::any_of(
        d_.plan().relations.begin(), d_.plan().relations.end(), [&](const PlannedRelation& other) {
          return other.kind == RelationKind::kDirection && other.subject == land;
        });
    if (IsSpread(around) && around.zones.empty() && !around.share.has_value() && !placed) {
      around.dominant = true;
    }
  }

  // "behind the hotels, further to the east, runs a road; beyond the road are woods": on from
  // there.
  void AssertBeyond() {
    for (const PlannedRelation& relation : d_.plan().relations) {
      if (relation.kind == RelationKind::kDirection && relation.subject == object_) {
        AssertDirection({relation.heading.east, relation.heading.south});
        return;
      }
      // "a town north of the river, and fields on the other side of it"
      if (relation.kind == RelationKind::kDirection && relation.object == object_ &&
          relation.subject != subject_) {
        AssertDirection({-relation.heading.east, -relation.heading.south});
        return;
      }
    }
    // "a ring of trees around the town, fields beyond it"
    for (const PlannedRelation& relation : d_.plan().relations) {
      if (relation.kind == RelationKind::kSurrounds && relation.subject == object_) {
        AssertSurrounds(subject_, object_);
        return;
      }
    }
    // Beyond what lies at one side is the other.
    if (object().zones.size() == 1) {
      const Heading there = HeadingOf(RegionOf(object().zones.front()));
      if (there.east != 0 || there.south != 0) AssertDirection({-there.east, -there.south});
    }
    for (const PlannedRelation& relation : d_.plan().relations) {
      // "next to the forest is a river; on its other side is a farm"
      const bool beside =
          (relation.kind == RelationKind::kAdjacent || relation.kind == RelationKind::kNear) &&
          (relation.subject == object_ || relation.object == object_);
      const int other = relation.subject == object_ ? relation.object : relation.subject;
      if (beside && IsLine(object()) && other != subject_ && !IsLine(d_.feature(other))) {
        PlannedRelation between;
        between.kind = RelationKind::kBetween;
        between.subject = object_;
        between.object = other;
        between.second_object = subject_;
        d_.Relate(std::move(between));
        break;
      }
    }
    Relate(RelationKind::kNear, subject_, object_, kNearSteps);
  }

  const Frame& frame_;
  int subject_;
  int object_;
  Discourse& d_;
};

}  // namespace

void Assert(const Frame& frame, int subject, Discourse* discourse) {
  if (frame.objects.empty()) return;
  Asserter(frame, subject, discourse).Assert();
  if (frame.both && frame.is_direction) {
    Frame back = frame;
    back.heading = {-frame.heading.east, -frame.heading.south};
    Asserter(back, subject, discourse).Assert();
  }
}

void AssertEachOther(const Frame& frame, Discourse* discourse) {
  if (frame.subjects.empty()) return;
  int first = frame.subjects.front();
  int second = frame.subjects.back();
  if (first == second) second = discourse->SplitOff(first);
  if (first == second) return;
  PlannedRelation relation;
  relation.kind =
      frame.sense == Sense::kParallelEach ? RelationKind::kParallel : RelationKind::kCrosses;
  relation.subject = first;
  relation.object = second;
  discourse->Relate(std::move(relation));
}

}  // namespace latticeworld
