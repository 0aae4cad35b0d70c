#include "latticeworld/language/reading/things/beside_things.h"

#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/reading/text_units.h"
#include "latticeworld/language/reading/things/laid_as_houses.h"
#include "latticeworld/language/reading/things/things_of_text.h"
#include "latticeworld/layout/thing_wishes.h"

namespace latticeworld {

Result<LayoutReading> ReadBesideThings(
    const LayoutRequest& request, ThingsTaken which,
    const std::function<Result<LayoutReading>(const LayoutRequest& rest)>& read) {
  TextThings taken = TakeThings(request.instruction, request.vocabulary);
  if (which == ThingsTaken::kWhole && !taken.whole) taken = {};
  LayoutRequest rest = request;
  if (!taken.things.empty()) rest.instruction = std::move(taken.rest);
  LW_ASSIGN_OR_RETURN(LayoutReading reading, read(rest));
  for (std::string& warning : WarningsOfHouses(reading.plan)) {
    reading.plan.warnings.push_back(std::move(warning));
  }
  if (taken.things.empty()) return reading;
  for (std::string& warning : taken.warnings) reading.plan.warnings.push_back(std::move(warning));
  const auto words =
      static_cast<int>(UnitsOf(taken.taken, SentenceKind::kLayout, request.vocabulary).size());
  reading.coverage.words += words;
  reading.coverage.carried += words;
  std::vector<ThingWish> things = std::move(taken.things);
  AppendWishes(reading.plan.things, &things);
  reading.plan.things = std::move(things);
  return reading;
}

}  // namespace latticeworld
