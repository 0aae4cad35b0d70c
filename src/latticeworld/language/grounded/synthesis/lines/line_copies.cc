#include "latticeworld/language/grounded/synthesis/lines/line_copies.h"

#include <algorithm>
#include <vector>

namespace latticeworld {
namespace {

constexpr int kMostLines = 6;  // of one feature: more would leave no land

// The lines among each other as the relation has them; the others share only with the first what it
// has with other features.
void AddTies(const PlannedRelation& relation, int feature, const std::vector<int>& copies,
             LayoutPlan* plan) {
  const bool own = relation.object == feature || relation.object < 0;
  switch (relation.kind) {
    case RelationKind::kParallel:
    case RelationKind::kCrosses: {
      if (relation.subject != feature) return;
      for (const int copy : copies) {
        PlannedRelation tie = relation;
        tie.subject = copy;
        tie.object = own ? feature : relation.object;
        plan->relations.push_back(tie);
      }
      return;
    }
    case RelationKind::kApart:
    case RelationKind::kThrough:
    case RelationKind::kAlong:
    case RelationKind::kConnects: {
      if (relation.subject != feature || own) return;
      for (const int copy : copies) {
        PlannedRelation tie = relation;
        tie.subject = copy;
        plan->relations.push_back(tie);
      }
      return;
    }
    default:
      return;
  }
}

}  // namespace

LayoutPlan WithLineCopies(const LayoutPlan& plan) {
  LayoutPlan result = plan;
  for (std::size_t i = 0; i < plan.features.size(); ++i) {
    const PlannedFeature& feature = plan.features[i];
    if (feature.form != FeatureForm::kLine || feature.pieces < 2) continue;
    const int index = static_cast<int>(i);
    std::vector<int> copies;
    for (int copy = 1; copy < std::min(feature.pieces, kMostLines); ++copy) {
      copies.push_back(static_cast<int>(result.features.size()));
      result.features.push_back(feature);
      result.features.back().pieces = 0;
    }
    result.features[i].pieces = 0;
    for (const PlannedRelation& relation : plan.relations)
      AddTies(relation, index, copies, &result);
    for (PlannedRelation& relation : result.relations) {
      const bool among = relation.object == index &&
                         (relation.second_object == index || relation.second_object < 0);
      if (relation.kind == RelationKind::kBetween && among) relation.second_object = copies.front();
    }
  }
  // A line has no such thing with itself.
  result.relations.erase(std::remove_if(result.relations.begin(), result.relations.end(),
                                        [](const PlannedRelation& relation) {
                                          return relation.subject == relation.object &&
                                                 relation.subject >= 0 &&
                                                 relation.kind != RelationKind::kApart;
                                        }),
                         result.relations.end());
  return result;
}

}  // namespace latticeworld
