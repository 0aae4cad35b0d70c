#ifndef LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_SYNTHESIS_PLAN_WRITER_H_
#define LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_SYNTHESIS_PLAN_WRITER_H_

#include <string>
#include <utility>
#include <vector>

#include "language/grounded/synthesis/synthesis_plans.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "layout/claim_making.h"

namespace latticeworld {

// Claims as a reader of instructions would make them, beside those of claim_making.h; zones by
// their names (FindZone).
Claim Says(ClaimKind kind, char subject, const std::string& zone = "anywhere",
           double least = Claim::kUnsaid, double most = Claim::kUnsaid);
Claim Gap(ClaimKind kind, char subject, char object, double least, double most);
Claim Toward(char subject, char object, int east, int south);
Claim Order(const std::string& sequence, int east, int south);
Claim Rest(char subject, const std::string& others);

Zone ZoneNamed(const std::string& name);

// Writes a plan down piece by piece; what a call says is of the feature added last.
class PlanWriter {
 public:
  explicit PlanWriter(char background, Vocabulary vocabulary = Vocabulary::kSuburb) {
    plan_.vocabulary = vocabulary;
    plan_.background = background;
  }

  PlanWriter& Feature(char letter, FeatureForm form, std::vector<std::string> zones = {}) {
    PlannedFeature feature;
    feature.letter = letter;
    feature.form = form;
    for (const std::string& zone : zones) feature.zones.push_back(ZoneNamed(zone));
    if (letter == 'B' && form == FeatureForm::kPatch) feature.cells = 14;
    plan_.features.push_back(std::move(feature));
    return *this;
  }
  PlanWriter& Spread(char letter, std::vector<std::string> zones = {}) {
    return Feature(letter, FeatureForm::kSpread, std::move(zones));
  }
  PlanWriter& Patch(char letter, std::vector<std::string> zones = {}) {
    return Feature(letter, FeatureForm::kPatch, std::move(zones));
  }
  PlanWriter& Line(char letter, const std::string& from = "", const std::string& to = "") {
    Feature(letter, FeatureForm::kLine);
    if (!from.empty()) Last().from = Waypoint{ZoneNamed(from), -1};
    if (!to.empty()) Last().to = Waypoint{ZoneNamed(to), -1};
    return *this;
  }
  PlanWriter& In(const std::string& zone) {
    Last().zones.push_back(ZoneNamed(zone));
    return *this;
  }
  PlanWriter& Pieces(int pieces, int cells) {
    Last().pieces = pieces;
    Last().cells = cells;
    return *this;
  }
  PlanWriter& Cells(int cells) {
    Last().cells = cells;
    return *this;
  }
  PlanWriter& Share(double share) {
    Last().share = share;
    return *this;
  }
  PlanWriter& Dominant() {
    Last().dominant = true;
    return *this;
  }
  PlanWriter& FillsRest() {
    Last().fills_rest = true;
    return *this;
  }
  PlanWriter& Scattered() {
    Last().texture = Texture::kScattered;
    return *this;
  }
  PlanWriter& Shape(ClaimShape shape) {
    Last().shape = shape;
    return *this;
  }
  PlanWriter& Meander(double meander) {
    Last().meander = meander;
    return *this;
  }
  PlanWriter& Wide() {
    Last().wide = true;
    return *this;
  }
  PlanWriter& ToFeature(int feature) {
    Last().to = Waypoint{Zone(), feature};
    return *this;
  }
  PlanWriter& FromFeature(int feature) {
    Last().from = Waypoint{Zone(), feature};
    return *this;
  }
  PlanWriter& Relate(RelationKind kind, int subject, int object, int second = -1) {
    PlannedRelation relation;
    relation.kind = kind;
    relation.subject = subject;
    relation.object = object;
    relation.second_object = second;
    plan_.relations.push_back(relation);
    return *this;
  }
  PlanWriter& Head(int subject, int object, int east, int south) {
    Relate(RelationKind::kDirection, subject, object);
    plan_.relations.back().heading = {east, south};
    return *this;
  }
  PlanWriter& Without(char letter, const std::string& zone = "anywhere") {
    plan_.absences.push_back({letter, ZoneNamed(zone), ""});
    plan_.claims.push_back(Says(ClaimKind::kAbsent, letter, zone));
    return *this;
  }
  PlanWriter& Claims(std::vector<Claim> claims) {
    for (Claim& claim : claims) plan_.claims.push_back(std::move(claim));
    return *this;
  }
  NamedPlan As(const std::string& name) { return {name, plan_}; }

 private:
  PlannedFeature& Last() { return plan_.features.back(); }
  LayoutPlan plan_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_SYNTHESIS_PLAN_WRITER_H_
