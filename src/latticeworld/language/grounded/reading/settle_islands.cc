#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/discourse.h"

// This file settles where islands lie.
namespace latticeworld {

// Water of which no words speak, four times as much as the island; -1: there is no room for it.
int Discourse::SupposeWaterAround(int island) {
  if (things_.size() >= kMaxFeatures) return -1;
  PlannedFeature water;
  water.letter = 'W';
  water.supposed = true;
  water.form = FeatureForm::kPatch;
  water.zones = feature(island).zones;
  water.cells = 4 * feature(island).cells * std::max(1, feature(island).pieces);
  plan_.features.push_back(std::move(water));
  things_.emplace_back();
  return size() - 1;
}

// "a river with an island in it": a pool that it runs through.
bool Discourse::WidenRiverAround(int island) {
  const int river = Latest('W', FeatureForm::kLine);
  const int pool = river < 0 ? -1 : SupposeWaterAround(island);
  if (pool < 0) return false;
  Waypoint through;
  through.feature = pool;
  through.said = false;
  feature(river).via.push_back(std::move(through));
  for (PlannedRelation& relation : plan_.relations)
    if (relation.subject == island && relation.object == river) relation.object = pool;
  return true;
}

// An island needs water to lie in: where none is named, a river's, else a sea of its own.
void Discourse::SettleIslands() {
  bool water = false;
  for (int i = 0; i < size(); ++i) {
    water = water || (!thing(i).dropped && feature(i).letter == 'W' &&
                      feature(i).form != FeatureForm::kLine);
  }
  for (int i = 0; i < size() && !water; ++i) {
    if (thing(i).dropped || !thing(i).is_island) continue;
    const bool denied = std::any_of(plan_.absences.begin(), plan_.absences.end(),
                                    [](const PlannedAbsence& each) { return each.letter == 'W'; });
    water = WidenRiverAround(i) || (!denied && SupposeWaterAround(i) >= 0);
    if (water) break;
    plan_.warnings.push_back("there is no lake or sea for " +
                             Quote(Words(thing(i).begin, thing(i).end)) + " to lie in");
    Drop(i);
  }
  // "A lake. An island.": in the first water there is.
  for (int i = 0; i < size() && water; ++i) {
    if (thing(i).dropped || !thing(i).is_island) continue;
    const bool placed = std::any_of(
        plan_.relations.begin(), plan_.relations.end(), [&](const PlannedRelation& relation) {
          return relation.kind == RelationKind::kWithin && relation.subject == i;
        });
    for (int j = 0; j < size() && !placed; ++j) {
      if (thing(j).dropped || feature(j).letter != 'W' || feature(j).form == FeatureForm::kLine) {
        continue;
      }
      PlannedRelation relation;
      relation.kind = RelationKind::kWithin;
      relation.subject = i;
      relation.object = j;
      Relate(std::move(relation));
      break;
    }
  }
  // "an island with a house on it, in a lake": only the island lies in the water.
  const auto lies_in = [&](int inner, int outer) {
    return std::any_of(plan_.relations.begin(), plan_.relations.end(),
                       [&](const PlannedRelation& relation) {
                         return relation.kind == RelationKind::kWithin &&
                                relation.subject == inner && relation.object == outer;
                       });
  };
  const auto needless = [&](const PlannedRelation& relation) {
    if (relation.kind != RelationKind::kWithin) return false;
    for (int i = 0; i < size(); ++i)
      if (thing(i).is_island && lies_in(relation.subject, i) && lies_in(i, relation.object))
        return true;
    return false;
  };
  std::vector<PlannedRelation> relations;
  for (const PlannedRelation& relation : plan_.relations)
    if (!needless(relation)) relations.push_back(relation);
  plan_.relations = std::move(relations);
}

}  // namespace latticeworld
