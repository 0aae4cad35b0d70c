#include "latticeworld/language/grounded/reading/place_phrases.h"

#include <algorithm>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld {

std::vector<Zone> ZonesOf(const std::vector<Place>& places) {
  std::vector<Zone> zones;
  for (const Place& place : places) zones.push_back(place.zone);
  return zones;
}

bool SaysAnywhere(const std::vector<Place>& places) {
  return !places.empty() && std::all_of(places.begin(), places.end(), [](const Place& place) {
    return place.zone.is_anywhere();
  });
}

bool SaysExtent(std::string_view words) {
  const std::string lower = ToLowerAscii(words);
  for (const std::string_view word : {"half", "halves", "third", "quarter", "whole", "entire"}) {
    if (lower.find(word) != std::string::npos) return true;
  }
  return false;
}

bool IsExtent(const Zone& zone) {
  return EndsWithWord(zone.name, "half") || EndsWithWord(zone.name, "quarter");
}

Zone EndZoneOf(const Zone& zone, std::string_view words) {
  const Region region = RegionOf(zone);
  if (region == Region::kAnywhere || region == Region::kCenter) return zone;
  const std::string lower = ToLowerAscii(words);
  if (lower.find("cent") != std::string::npos || lower.find("middle") != std::string::npos) {
    return zone;
  }
  return RimZoneOf(HeadingOf(region));
}

Zone AlongZone(const Zone& zone) {
  const Heading at = HeadingOf(RegionOf(zone));
  const bool side = (at.east == 0) != (at.south == 0);
  return side ? RimZoneOf(at) : zone;
}

Sense BesideOf(const ClassWord& noun) {
  const std::string_view phrase = noun.phrase;
  const auto holds = [&](std::string_view word) {
    return phrase.find(word) != std::string_view::npos;
  };
  if (holds("riverside") || holds("riverbank")) return Sense::kRiverside;
  for (const std::string_view word :
       {"lakeside", "seaside", "waterside", "waterfront", "harbour", "harbor", "fishing village",
        "fishing town", "port town", "coastal", "boathouse", "seaport"}) {
    if (holds(word)) return Sense::kLakeside;
  }
  return Sense::kNone;
}

bool EndsWithWord(std::string_view phrase, std::string_view word) {
  return phrase.size() > word.size() + 1 && phrase.substr(phrase.size() - word.size()) == word &&
         phrase[phrase.size() - word.size() - 1] == ' ';
}

bool IsOppositeHeading(Heading a, Heading b) { return a.east == -b.east && a.south == -b.south; }

}  // namespace latticeworld
