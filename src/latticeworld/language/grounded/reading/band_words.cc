#include "latticeworld/language/grounded/reading/band_words.h"

#include <cstdlib>
#include <utility>

namespace latticeworld {
namespace {

constexpr std::string_view kPrefix = "band#";

char LetterOf(Heading way) {
  if (way.east != 0) return way.east > 0 ? 'e' : 'w';
  return way.south > 0 ? 's' : 'n';
}

}  // namespace

std::string WordOf(const Band& band) {
  return std::string(kPrefix) + std::to_string(band.nth) + "/" + std::to_string(band.of) +
         LetterOf(band.way);
}

std::optional<Band> BandNamed(std::string_view word) {
  if (word.substr(0, kPrefix.size()) != kPrefix) return std::nullopt;
  const std::string numbers(word.substr(kPrefix.size()));
  const std::size_t slash = numbers.find('/');
  if (slash == std::string::npos || numbers.size() < slash + 3) return std::nullopt;
  Band band;
  band.nth = std::atoi(numbers.c_str());
  band.of = std::atoi(numbers.c_str() + slash + 1);
  const bool legal = band.of >= 2 && band.of <= Band::kMost && band.nth >= 1 && band.nth <= band.of;
  if (!legal) return std::nullopt;
  switch (numbers.back()) {
    case 'e':
      band.way = {1, 0};
      break;
    case 'w':
      band.way = {-1, 0};
      break;
    case 's':
      band.way = {0, 1};
      break;
    default:
      band.way = {0, -1};
      break;
  }
  return band;
}

Zone BandZone(Heading way, double low, double high, const std::string& name) {
  if (way.east < 0 || way.south < 0) {
    std::swap(low, high);
    low = 1.0 - low;
    high = 1.0 - high;
  }
  UnitBox box;
  if (way.south != 0) {
    box.v_min = low;
    box.v_max = high;
  }
  if (way.east != 0) {
    box.u_min = low;
    box.u_max = high;
  }
  Zone zone;
  zone.name = name;
  zone.boxes = {box};
  return zone;
}

Zone ZoneOfBand(const Band& band) {
  const bool end = band.nth == 1 || band.nth == band.of;
  const int sign = band.nth == 1 ? -1 : 1;
  const Heading side{sign * band.way.east, sign * band.way.south};
  if (end && band.of <= 4) {
    const std::string_view name = side.south < 0   ? "northern"
                                  : side.south > 0 ? "southern"
                                  : side.east < 0  ? "western"
                                                   : "eastern";
    const std::string_view part = band.of == 2 ? " half" : band.of == 3 ? " third" : " quarter";
    return *FindZone(std::string(name) + std::string(part));
  }
  if (band.of == 3) return *FindZone(band.way.south != 0 ? "middle rows" : "middle columns");
  const double of = band.of;
  return BandZone(band.way, (band.nth - 1) / of, band.nth / of,
                  "band " + std::to_string(band.nth) + " of " + std::to_string(band.of));
}

}  // namespace latticeworld
