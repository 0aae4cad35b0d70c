#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/discourse.h"

// What only the end of an instruction tells: the places, orders and denials that follow from all of
// it together.
namespace latticeworld {

// If a class is both asked for and denied altogether, what was said later counts.
void Discourse::SettleDenials() {
  std::vector<PlannedAbsence> kept;
  for (std::size_t a = 0; a < plan_.absences.size(); ++a) {
    PlannedAbsence& absence = plan_.absences[a];
    bool overruled = false;
    for (int i = 0; i < size() && absence.zone.is_anywhere(); ++i) {
      if (thing(i).dropped || feature(i).letter != absence.letter) continue;
      const std::string words = Quote(Words(thing(i).begin, thing(i).end));
      if (i >= named_before_denial_[a]) {
        overruled = true;
        plan_.warnings.push_back(Quote(absence.words) +
                                 " is overruled by what is said later: " + words);
        break;
      }
      plan_.warnings.push_back(words +
                               " is not laid, for it is said later: " + Quote(absence.words));
      Drop(i);
    }
    if (!overruled) kept.push_back(std::move(absence));
  }
  plan_.absences = std::move(kept);
}

// "desert at the top, farmland in the middle, sea at the bottom": what spreads between two sides
// takes all that lies between them.
void Discourse::WidenMiddles() {
  for (int i = 0; i < size(); ++i) {
    PlannedFeature& middle = feature(i);
    if (thing(i).dropped || (middle.form != FeatureForm::kSpread && !middle.dominant) ||
        middle.zones.size() != 1 ||
        !(middle.zones.front() == ZoneOf(Heading{0, 0}) ||
          middle.zones.front() == *FindZone("middle rows"))) {
      continue;
    }
    bool sides[4] = {false, false, false, false};  // north, south, west, east
    for (int j = 0; j < size(); ++j) {
      if (thing(j).dropped || thing(j).sentence != thing(i).sentence) continue;
      for (const Zone& zone : feature(j).zones) {
        const Heading at = HeadingOf(RegionOf(zone));
        sides[0] = sides[0] || (at.south == -1 && at.east == 0);
        sides[1] = sides[1] || (at.south == 1 && at.east == 0);
        sides[2] = sides[2] || (at.east == -1 && at.south == 0);
        sides[3] = sides[3] || (at.east == 1 && at.south == 0);
      }
    }
    if (sides[0] && sides[1] && !sides[2] && !sides[3]) middle.zones = {*FindZone("middle rows")};
    if (sides[2] && sides[3] && !sides[0] && !sides[1]) {
      middle.zones = {*FindZone("middle columns")};
    }
  }
}

// "NW forest, NE houses, SW fields, SE bare soil": four that share the map by its quarters.
void Discourse::WidenQuarters() {
  for (int first = 0; first < size(); ++first) {
    std::vector<int> quarters;
    for (int i = first; i < size() && thing(i).sentence == thing(first).sentence; ++i) {
      const PlannedFeature& feature = this->feature(i);
      const bool counted = feature.pieces_least > 0 || feature.form == FeatureForm::kLine;
      if (thing(i).dropped || counted || feature.zones.size() != 1) continue;
      const Heading at = HeadingOf(RegionOf(feature.zones.front()));
      const bool ninth = at.IsDiagonal() && feature.zones.front() == ZoneOf(at);
      const bool again = std::any_of(quarters.begin(), quarters.end(), [&](int other) {
        return this->feature(other).zones == feature.zones;
      });
      if (ninth && !again) quarters.push_back(i);
    }
    if (quarters.size() != 4) continue;
    const std::string words = ToLowerAscii(instruction_);
    const bool said =
        words.find("quadrant") != std::string::npos || words.find("quarter") != std::string::npos;
    const bool spread = std::all_of(quarters.begin(), quarters.end(), [&](int i) {
      return feature(i).form == FeatureForm::kSpread || thing(i).plural;
    });
    if (!said && !spread) continue;
    for (const int i : quarters) {
      PlannedFeature& feature = this->feature(i);
      const Heading at = HeadingOf(RegionOf(feature.zones.front()));
      const std::string name = std::string(at.south < 0 ? "north" : "south") +
                               (at.east < 0 ? "-western" : "-eastern") + " quarter";
      feature.zones = {*FindZone(name)};
      feature.form = FeatureForm::kSpread;
      feature.pieces = 0;
      feature.dominant = true;
      if (said) feature.share_least = std::max(feature.share_least.value_or(0.0), 0.5);
    }
  }
}

// "a river and jungle, nothing else": what spreads takes all the land, the first where it is two.
void Discourse::SettleRest() {
  if (!all_is_said_) return;
  int land = -1;
  for (int i = 0; i < size(); ++i) {
    const PlannedFeature& feature = this->feature(i);
    if (thing(i).dropped || feature.form != FeatureForm::kSpread) continue;
    if (feature.fills_rest) return;
    const bool open =
        feature.zones.empty() && !feature.share.has_value() && feature.texture == Texture::kUnsaid;
    if (open && land < 0) land = i;
  }
  if (land >= 0) feature(land).fills_rest = true;
}

// "A crossroads in the centre: one road north-south, the other east-west": two roads that cross,
// those that are spoken of, else two of its own.
void Discourse::SettleCrossroads() {
  for (int i = 0; i < size(); ++i) {
    const std::string_view noun = thing(i).noun->phrase;
    const bool crossing = noun == "crossroads" || noun == "crossroad" || noun == "intersection" ||
                          noun == "junction" || noun == "road crossing";
    if (thing(i).dropped || !crossing || feature(i).form != FeatureForm::kLine) continue;
    // The roads are the two that were spoken of, or none yet. A crossroads with a course of its
    // own, or with another number of roads, stays one line.
    std::vector<int> roads;
    for (int j = 0; j < size(); ++j) {
      const bool road = j != i && !thing(j).dropped && feature(j).letter == feature(i).letter &&
                        feature(j).form == FeatureForm::kLine;
      if (road) roads.push_back(j);
    }
    const bool tied = feature(i).from.has_value() || feature(i).to.has_value() ||
                      feature(i).along.has_value() || roads.size() == 1 || roads.size() > 2;
    if (tied) continue;
    const std::vector<Zone> zones = feature(i).zones;
    // Without any, two are made, from north to south and from west to east; else the crossroads is
    // they.
    if (roads.empty()) {
      const int second = Twin(i);
      if (second == i) continue;
      roads = {i, second};
      for (const bool down : {true, false}) {
        PlannedFeature& road = feature(roads[down ? 0 : 1]);
        Waypoint from;
        from.zone = RimZoneOf(down ? Heading{0, -1} : Heading{-1, 0});
        from.said = false;
        Waypoint to;
        to.zone = RimZoneOf(down ? Heading{0, 1} : Heading{1, 0});
        to.said = false;
        road.from = from;
        road.to = to;
        road.zones.clear();
      }
    } else {
      for (PlannedRelation& relation : plan_.relations) {
        if (relation.subject == i) relation.subject = roads[0];
        if (relation.object == i) relation.object = roads[0];
      }
      Drop(i);
    }
    // Both roads pass the place of the crossroads, and cross.
    for (const int road : roads) {
      if (zones.size() != 1 || !feature(road).via.empty()) continue;
      Waypoint via;
      via.zone = zones.front();
      feature(road).via.push_back(std::move(via));
    }
    PlannedRelation crosses;
    crosses.kind = RelationKind::kCrosses;
    crosses.subject = roads[0];
    crosses.object = roads[1];
    Relate(std::move(crosses));
  }
}

// What runs along an edge, and nothing more is said, runs all along it.
void Discourse::SettleAlong() {
  for (int i = 0; i < size(); ++i) {
    PlannedFeature& line = feature(i);
    // Its ends at the edges that it runs between are at the corners.
    const auto at_edge = [](const std::optional<Waypoint>& end) {
      return !end.has_value() || (end->feature < 0 && EndsWith(end->zone.name, " edge"));
    };
    const bool open = line.form == FeatureForm::kLine && line.along.has_value() &&
                      at_edge(line.from) && at_edge(line.to) && line.pieces <= 1 &&
                      line.from.has_value() == line.to.has_value();
    if (!open || !EndsWith(line.along->name, " edge")) continue;
    const Heading side = HeadingOf(RegionOf(*line.along));
    const Heading way = {side.south != 0 ? 1 : 0, side.east != 0 ? 1 : 0};
    const auto across = [&](const std::optional<Waypoint>& end) {
      if (!end.has_value()) return false;
      const Heading at = HeadingOf(RegionOf(end->zone));
      return at.east * way.east + at.south * way.south == 0;
    };
    if (across(line.from) || across(line.to)) continue;
    Waypoint from;
    from.zone = RimZoneOf({side.east - way.east, side.south - way.south});
    Waypoint to;
    to.zone = RimZoneOf({side.east + way.east, side.south + way.south});
    line.from = from;
    line.to = to;
  }
}

// "a road follows the river from the west to the east": so the river runs there too.
void Discourse::SettleFollowing() {
  for (const PlannedRelation& relation : plan_.relations) {
    if (relation.kind != RelationKind::kAlong && relation.kind != RelationKind::kParallel) continue;
    const auto has_no_course = [&](const PlannedFeature& line) {
      return line.form == FeatureForm::kLine && !line.from.has_value() && !line.to.has_value() &&
             !line.along.has_value() && line.pieces <= 1 && line.zones.empty();
    };
    PlannedFeature& a = feature(relation.subject);
    PlannedFeature& b = feature(relation.object);
    if (a.form != FeatureForm::kLine || b.form != FeatureForm::kLine) continue;
    const auto runs = [](const PlannedFeature& line) {
      return line.from.has_value() && line.to.has_value() && line.from->feature < 0 &&
             line.to->feature < 0;
    };
    if (has_no_course(a) && runs(b)) {
      a.from = b.from;
      a.to = b.to;
    } else if (has_no_course(b) && runs(a)) {
      b.from = a.from;
      b.to = a.to;
    }
  }
}

// "a town in the middle, a single road from the south": it leads to the town.
void Discourse::SettleApproaches() {
  int town = -1;
  int towns = 0;
  for (int i = 0; i < size(); ++i) {
    const PlannedFeature& feature = this->feature(i);
    if (thing(i).dropped || feature.letter != 'B' || feature.form == FeatureForm::kLine) continue;
    town = i;
    ++towns;
  }
  if (towns != 1 || plan_.vocabulary != Vocabulary::kSuburb || thing(town).plural ||
      feature(town).pieces > 1) {
    return;
  }
  for (int i = 0; i < size(); ++i) {
    PlannedFeature& road = feature(i);
    const bool open = !thing(i).dropped && road.letter == 'R' && road.form == FeatureForm::kLine &&
                      road.from.has_value() && !road.to.has_value() && road.via.empty() &&
                      road.from->feature < 0 && road.pieces <= 1;
    const bool tied = std::any_of(plan_.relations.begin(), plan_.relations.end(),
                                  [&](const PlannedRelation& relation) {
                                    return relation.subject == i || relation.object == i;
                                  });
    if (!open || tied) continue;
    Waypoint to;
    to.feature = town;
    road.to = to;
  }
}

// "sea, behind it a beach, behind that a town": what goes on in one direction is an order.
void Discourse::SettleChains() {
  const std::vector<PlannedRelation>& relations = plan_.relations;
  const auto next_of = [&](int object, Claim::Heading heading) {
    for (const PlannedRelation& relation : relations) {
      if (relation.kind == RelationKind::kDirection && relation.object == object &&
          relation.heading == heading && !thing(relation.subject).dropped) {
        return relation.subject;
      }
    }
    return -1;
  };
  for (const PlannedRelation& first : relations) {
    if (first.kind != RelationKind::kDirection || thing(first.object).dropped) continue;
    const bool begins =
        std::none_of(relations.begin(), relations.end(), [&](const PlannedRelation& other) {
          return other.kind == RelationKind::kDirection && other.subject == first.object &&
                 other.heading == first.heading;
        });
    if (!begins) continue;
    PlannedOrder order;
    order.heading = first.heading;
    order.words = first.words;
    for (int at = first.object; at >= 0 && order.features.size() < 8;
         at = next_of(at, first.heading)) {
      order.features.push_back(at);
    }
    const bool known =
        std::any_of(plan_.orders.begin(), plan_.orders.end(), [&](const PlannedOrder& other) {
          return other.features.front() == order.features.front();
        });
    if (order.features.size() >= 3 && !known) plan_.orders.push_back(std::move(order));
  }
}

// "All but one lie in the forest that fills the lower half": so they lie there.
void Discourse::PlaceContained() {
  for (const PlannedRelation& relation : plan_.relations) {
    if (relation.kind != RelationKind::kWithin) continue;
    PlannedFeature& inner = feature(relation.subject);
    const PlannedFeature& outer = feature(relation.object);
    const bool counted = inner.pieces_least > 0 && inner.form == FeatureForm::kPatch;
    if (counted && inner.zones.empty() && outer.zones.size() == 1 && outer.dominant) {
      inner.zones = outer.zones;
    }
  }
}

// "a wooded spit sticks out from the western edge into the lake": it lies there, and runs nowhere.
void Discourse::SettleOpenEnds() {
  for (int i = 0; i < size(); ++i) {
    PlannedFeature& feature = this->feature(i);
    if (feature.form == FeatureForm::kLine) continue;
    if (feature.from.has_value() && feature.from->feature < 0 && !feature.to.has_value()) {
      AddZones(i, {feature.from->zone});
      feature.from.reset();
    }
  }
}

LayoutPlan Discourse::Finish() {
  // What was left open is settled, in an order in which each step finds what it needs.
  SettleOpenEnds();
  SettleAlong();
  SettleFollowing();
  SettleApproaches();
  SettleCrossroads();
  SettleDenials();
  SettleIslands();
  WidenMiddles();
  WidenQuarters();
  PlaceContained();
  SettleChains();
  SettleRest();
  // Features that were dropped are left out; `moved` has the new index of the others.
  std::vector<int> moved(things_.size(), -1);
  std::vector<PlannedFeature> features;
  for (int i = 0; i < size(); ++i) {
    if (thing(i).dropped) continue;
    moved[static_cast<std::size_t>(i)] = static_cast<int>(features.size());
    feature(i).words = Words(thing(i).begin, thing(i).end);
    features.push_back(std::move(feature(i)));
  }
  const auto move = [&](int* index) {
    if (*index >= 0) *index = moved[static_cast<std::size_t>(*index)];
  };
  // What names a feature follows to its new index, or goes with it.
  for (PlannedFeature& feature : features) {
    for (std::optional<Waypoint>* end : {&feature.from, &feature.to}) {
      if (!end->has_value() || (*end)->feature < 0) continue;
      move(&(*end)->feature);
      if ((*end)->feature < 0) end->reset();
    }
    for (Waypoint& waypoint : feature.via) move(&waypoint.feature);
    feature.via.erase(std::remove_if(feature.via.begin(), feature.via.end(),
                                     [](const Waypoint& waypoint) {
                                       return waypoint.feature < 0 && waypoint.zone.is_anywhere();
                                     }),
                      feature.via.end());
  }
  std::vector<PlannedRelation> relations;
  for (PlannedRelation& relation : plan_.relations) {
    const bool two = relation.second_object >= 0;
    move(&relation.subject);
    move(&relation.object);
    move(&relation.second_object);
    if (relation.subject < 0 || relation.object < 0 || (two && relation.second_object < 0)) {
      continue;
    }
    relations.push_back(std::move(relation));
  }
  for (PlannedOrder& order : plan_.orders) {
    for (int& index : order.features) move(&index);
    order.features.erase(std::remove(order.features.begin(), order.features.end(), -1),
                         order.features.end());
  }
  plan_.features = std::move(features);
  plan_.relations = std::move(relations);
  return std::move(plan_);
}

}  // namespace latticeworld
