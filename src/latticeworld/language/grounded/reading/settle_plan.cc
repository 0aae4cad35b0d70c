#include "latticeworld/language/grounded/reading/settle_plan.h"

#include <algorithm>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

bool IsDenied(const LayoutPlan& plan, char letter) {
  return std::any_of(plan.absences.begin(), plan.absences.end(),
                     [&](const PlannedAbsence& absence) {
                       return absence.letter == letter && absence.zone.is_anywhere();
                     });
}

bool IsAsked(const LayoutPlan& plan, char letter) {
  return std::any_of(plan.features.begin(), plan.features.end(),
                     [&](const PlannedFeature& feature) { return feature.letter == letter; });
}

// What covers land without having been asked for: grass first, then whatever else is not denied
// and not asked for in some place of its own.
char OpenGround(const LayoutPlan& plan) {
  const std::string_view order = plan.vocabulary == Vocabulary::kSuburb ? "GADF" : "BFRS";
  for (const char letter : order) {
    if (!IsDenied(plan, letter)) return letter;
  }
  return order.front();
}

// "a desert with an oasis", "a river through the jungle": what holds the rest and is the only land
// that spreads.
char Host(const LayoutPlan& plan) {
  char host = '\0';
  for (const PlannedRelation& relation : plan.relations) {
    if (relation.kind != RelationKind::kWithin && relation.kind != RelationKind::kThrough) continue;
    const PlannedFeature& land = plan.features[static_cast<std::size_t>(relation.object)];
    if (land.form == FeatureForm::kSpread && land.letter != 'W' && land.zones.empty() &&
        !land.share.has_value() && land.texture == Texture::kUnsaid) {
      host = land.letter;
    }
  }
  for (const PlannedFeature& feature : plan.features) {
    if (feature.form == FeatureForm::kSpread && feature.letter != host) return '\0';
  }
  return host;
}

// "round the ice stone, and round the stone the forest": the outermost of rings.
char Outermost(const LayoutPlan& plan) {
  const auto surrounds = [&](int outer) {
    return std::find_if(
        plan.relations.begin(), plan.relations.end(), [&](const PlannedRelation& relation) {
          return relation.kind == RelationKind::kSurrounds && relation.subject == outer;
        });
  };
  for (const PlannedRelation& relation : plan.relations) {
    if (relation.kind != RelationKind::kSurrounds) continue;
    const PlannedFeature& outer = plan.features[static_cast<std::size_t>(relation.subject)];
    const bool open = outer.form == FeatureForm::kSpread && outer.zones.empty() &&
                      !outer.shape.has_value() && !outer.share.has_value() &&
                      outer.texture == Texture::kUnsaid;
    const bool chain = surrounds(relation.object) != plan.relations.end();
    const bool last = std::none_of(
        plan.relations.begin(), plan.relations.end(), [&](const PlannedRelation& other) {
          return other.kind == RelationKind::kSurrounds && other.object == relation.subject;
        });
    if (open && chain && last) return outer.letter;
  }
  return '\0';
}

// The share of the map that a feature takes at most, roughly.
double MostOf(const PlannedFeature& feature) {
  constexpr double kLine = 0.06, kCells = kLayoutSize * kLayoutSize;
  switch (feature.form) {
    case FeatureForm::kLine:
      return kLine;
    case FeatureForm::kPatch:
      return std::max({feature.pieces, feature.pieces_most, feature.pieces_least, 1}) *
             feature.cells / kCells;
    case FeatureForm::kSpread:
      break;
  }
  LayoutMask covered;
  for (const Zone& zone : feature.zones) covered = covered | MaskOf(zone);
  const double open = feature.zones.empty() ? 1.0 : covered.count() / kCells;
  return std::min(open, feature.share_most.value_or(1.0));
}

// "Grass takes up 75 % of the land", and nothing is said of what could be the rest.
bool LeavesLandOver(const LayoutPlan& plan, const PlannedFeature& feature) {
  if (feature.share_most.value_or(1.0) >= 1.0) return false;
  double others = 0.0;
  for (const PlannedFeature& other : plan.features)
    if (other.letter != feature.letter) others += MostOf(other);
  return others < 1.0 - *feature.share_most;
}

char Background(const LayoutPlan& plan) {
  for (const PlannedFeature& feature : plan.features) {
    if (feature.fills_rest && feature.form != FeatureForm::kLine) return feature.letter;
  }
  // What covers most of the whole map is what everything else lies on.
  for (const PlannedFeature& feature : plan.features) {
    if (feature.dominant && feature.zones.empty() && feature.form != FeatureForm::kLine &&
        !LeavesLandOver(plan, feature)) {
      return feature.letter;
    }
  }
  if (const char host = Host(plan); host != '\0') return host;
  if (const char ring = Outermost(plan); ring != '\0') return ring;
  const char usual = OpenGround(plan);
  for (const PlannedRelation& relation : plan.relations) {
    if (relation.kind != RelationKind::kMoreThan) continue;
    const auto at = [&](int index) -> const PlannedFeature& {
      return plan.features[static_cast<std::size_t>(index)];
    };
    if (at(relation.object).letter == usual && at(relation.subject).form != FeatureForm::kLine) {
      return at(relation.subject).letter;
    }
  }
  // What is bounded above cannot be what is left over.
  const bool bounded =
      std::any_of(plan.features.begin(), plan.features.end(), [&](const PlannedFeature& feature) {
        // "two parks" do not show on grass.
        const bool counted = feature.form == FeatureForm::kPatch && feature.pieces_least > 0;
        return feature.letter == usual &&
               (counted || feature.share_most.value_or(1.0) < 0.7 || LeavesLandOver(plan, feature));
      });
  if (!bounded) return usual;
  // "rocky desert with a few bushes": what was asked for without bounds is.
  for (const PlannedFeature& feature : plan.features) {
    const bool open = feature.form == FeatureForm::kSpread && feature.letter != usual &&
                      feature.letter != 'W' && feature.zones.empty() &&
                      feature.share_most.value_or(1.0) > 0.99 &&
                      feature.texture == Texture::kUnsaid && !feature.shape;
    if (open) return feature.letter;
  }
  // "lots of houses and one park": a town with a park.
  for (const PlannedFeature& feature : plan.features) {
    const bool many = feature.form == FeatureForm::kPatch && feature.pieces_least >= 4 &&
                      feature.pieces_most == 0 && feature.zones.empty() && feature.letter == 'B';
    if (many && plan.vocabulary == Vocabulary::kSuburb) return feature.letter;
  }
  const std::string_view order = plan.vocabulary == Vocabulary::kSuburb ? "GADF" : "BFRS";
  for (const char letter : order) {
    if (!IsDenied(plan, letter) && !IsAsked(plan, letter)) return letter;
  }
  return usual;
}

// Shares are said of the whole map and laid in a feature's zones.
void SettleShares(LayoutPlan* plan) {
  for (PlannedFeature& feature : plan->features) {
    if (!feature.share.has_value() || feature.zones.empty()) continue;
    LayoutMask covered;
    for (const Zone& zone : feature.zones) covered = covered | MaskOf(zone);
    const double area = covered.count() / static_cast<double>(kLayoutSize * kLayoutSize);
    if (area > 0.0) feature.share = std::min(1.0, *feature.share / area);
  }
}

}  // namespace

void SettlePlan(LayoutPlan* plan) {
  SettleShares(plan);
  plan->background = Background(*plan);
}

}  // namespace latticeworld
