#include "latticeworld/language/reading/things/laid_as_houses.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld {

std::string_view NearestThingFile(std::string_view file_name);  // data, compiled in

namespace {

// The nearest kind of a noun in the singular.
std::map<std::string, std::string, std::less<>> ReadNearest() {
  std::map<std::string, std::string, std::less<>> nearest;
  for (const std::string& line : Split(NearestThingFile("nearest_things.txt"), '\n')) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> fields = Split(line, '\t');
    LW_CHECK(fields.size() == 2 && FindThingKind(fields[0]) != nullptr,
             "a line of nearest things has a kind and nouns");
    for (std::string& noun : Split(fields[1], ',')) {
      nearest.emplace(noun.substr(noun.find_first_not_of(' ')), fields[0]);
    }
  }
  return nearest;
}

}  // namespace

const ThingKind* KindOfBuilding(std::string_view noun) {
  static const std::map<std::string, std::string, std::less<>> nearest = ReadNearest();
  const ThingKind* kind = FindThingKind(noun);
  if (kind != nullptr) return kind->name == "house" ? nullptr : kind;
  const auto found = nearest.find(noun);
  return found == nearest.end() ? nullptr : FindThingKind(found->second);
}

std::vector<std::string> WarningsOfHouses(const LayoutPlan& plan) {
  std::vector<std::string> warnings;
  for (const PlannedFeature& feature : plan.features) {
    const bool one = !feature.plural && feature.pieces <= 1 && !feature.supposed;
    if (!IsBuilding(plan.vocabulary, feature.letter) || !one) continue;
    const ThingKind* kind = KindOfBuilding(feature.noun);
    if (kind == nullptr) continue;
    const bool known = FindThingKind(feature.noun) != nullptr;
    std::string warning = Quote(feature.words) + ": a " + feature.noun + " is laid as houses";
    if (!known) warning += ", for there is no such kind of thing; the nearest is a " + kind->name;
    warnings.push_back(warning + "; \"a lone " + kind->name + "\" stands there as one thing");
  }
  const auto feature_at = [&plan](int index) -> const PlannedFeature* {
    return index < 0 ? nullptr : &plan.features[static_cast<std::size_t>(index)];
  };
  for (const PlannedRelation& relation : plan.relations) {
    const PlannedFeature* house = feature_at(relation.subject);
    const PlannedFeature* water = feature_at(relation.object);
    const bool in_water = relation.kind == RelationKind::kWithin && house != nullptr &&
                          water != nullptr && IsBuilding(plan.vocabulary, house->letter) &&
                          water->letter == class_letter::kWater;
    if (!in_water) continue;
    warnings.push_back(Quote(relation.words.empty() ? house->words : relation.words) +
                       ": no house stands in water; an island is laid for it");
  }
  return warnings;
}

}  // namespace latticeworld
