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

struct ExactName {
  std::string_view name;  // of the small language
  std::string_view zone;
};
constexpr ExactName kExactNames[] = {{"upper middle", "upper"}, {"lower middle", "lower"}};

// The zones of an exact place: all but a few have the name that zones have.
std::vector<Zone> ExactZones(std::string_view name) {
  if (name == "corners") {
    return {Named("north-west corner"), Named("north-east corner"), Named("south-west corner"),
            Named("south-east corner")};
  }
  for (const ExactName& exact : kExactNames)
    if (exact.name == name) return {Named(exact.zone)};
  return {Named(name)};
}

// The exact place that is a zone; "": none.
std::string ExactNameOf(const Zone& zone) {
  for (const ExactName& exact : kExactNames)
    if (Named(exact.zone) == zone) return std::string(exact.name);
  const std::vector<std::string>& names = SentenceWords("exact");
  const auto found = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    const std::optional<Zone> named = FindZone(name);
    return named.has_value() && *named == zone;
  });
  return found == names.end() ? std::string() : *found;
}

// "the north", where the zone is what `side_zone` of a side names; else its exact name.
std::string NameOfZone(const Zone& zone, std::string_view Side::*side_zone) {
  for (const Side& side : kSides) {
    if (Named(side.*side_zone) == zone) return "the " + std::string(side.name);
  }
  const std::string exact = ExactNameOf(zone);
  if (!exact.empty()) return "the " + exact;
  const Zone ninth = ZoneOf(RegionOf(zone));
  const auto* const side =
      std::find_if(std::begin(kSides), std::end(kSides),
                   [&](const Side& each) { return Named(each.area) == ninth; });
  if (side != std::end(kSides)) return "the " + std::string(side->name);
  const std::string about = ExactNameOf(ninth);
  return about.empty() ? "the center" : "the " + about;
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

std::string HeadingName(Claim::Heading heading) {
  const std::string south = heading.south < 0 ? "north" : heading.south > 0 ? "south" : "";
  const std::string east = heading.east < 0 ? "west" : heading.east > 0 ? "east" : "";
  return south + (south.empty() || east.empty() ? "" : "-") + east;
}

std::string PlaceName(const Zone& zone) { return NameOfZone(zone, &Side::area); }

std::string EndName(const Zone& zone) { return NameOfZone(zone, &Side::end); }

}  // namespace latticeworld
