#include "latticeworld/language/reading/sentence_places.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

Zone Named(std::string_view name) {
  const std::optional<Zone> zone = FindZone(name);
  LW_CHECK(zone.has_value(), "every side and exact place of the small language is a zone");
  return *zone;
}

// A side of the small language and what it stands for.
struct Side {
  std::string_view name;
  std::string_view area;  // where a thing lies
  std::string_view end;   // where a line ends
};
constexpr Side kSides[] = {
    {"north", "northern third", "northern edge"},
    {"south", "southern third", "southern edge"},
    {"east", "eastern third", "eastern edge"},
    {"west", "western third", "western edge"},
    {"north-east", "upper right", "north-east corner"},
    {"north-west", "upper left", "north-west corner"},
    {"south-east", "lower right", "south-east corner"},
    {"south-west", "lower left", "south-west corner"},
    {"center", "center", "center"},
};

const Side* FindSide(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kSides), std::end(kSides),
                                         [&](const Side& side) { return side.name == name; });
  return found == std::end(kSides) ? nullptr : found;
}

// The zones of an exact place: all but a few have the name that zones have.
std::vector<Zone> ExactZones(std::string_view name) {
  if (name == "corners") {
    return {Named("north-west corner"), Named("north-east corner"), Named("south-west corner"),
            Named("south-east corner")};
  }
  if (name == "upper middle") return {Named("upper")};
  if (name == "lower middle") return {Named("lower")};
  return {Named(name)};
}

}  // namespace

Heading HeadingOfName(std::string_view name) {
  Heading heading;
  if (StartsWith(name, "north")) heading.south = -1;
  if (StartsWith(name, "south")) heading.south = 1;
  if (EndsWith(name, "east")) heading.east = 1;
  if (EndsWith(name, "west")) heading.east = -1;
  return heading;
}

std::vector<Zone> ZonesOf(const Phrase& phrase) {
  std::vector<Zone> zones;
  for (const Phrase* side : phrase.FindAll("side"))
    zones.push_back(Named(FindSide(side->text)->area));
  for (const Phrase* exact : phrase.FindAll("exact")) {
    for (Zone& zone : ExactZones(exact->text)) zones.push_back(std::move(zone));
  }
  return zones;
}

Zone EndZoneOf(const Phrase& phrase) {
  if (const Phrase* side = phrase.Find("side"); side != nullptr) {
    return Named(FindSide(side->text)->end);
  }
  const Phrase* exact = phrase.Find("exact");
  LW_CHECK(exact != nullptr, "a place is a side or exact");
  return ExactZones(exact->text).front();
}

}  // namespace latticeworld
