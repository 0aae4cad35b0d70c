#include "latticeworld/language/grounded/reading/slants.h"

#include <algorithm>

#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {
namespace {

constexpr std::string_view kPrefix = "slant#";

bool IsStep(char digit) { return digit >= '0' && digit <= '2'; }

// Left of the line, seen on the map with the south below.
bool IsLeft(const Slant& slant, double east, double south) {
  const double along_east = slant.to.east - slant.from.east;
  const double along_south = slant.to.south - slant.from.south;
  return along_east * (south - slant.from.south) - along_south * (east - slant.from.east) < 0.0;
}

// Names the side for people: "north-east of a line".
std::string NameOf(const Slant& slant) {
  const int sign = slant.left ? 1 : -1;
  const int east = sign * (slant.to.south - slant.from.south);
  const int south = -sign * (slant.to.east - slant.from.east);
  std::string name;
  if (south != 0) name += south < 0 ? "north" : "south";
  if (south != 0 && east != 0) name += "-";
  if (east != 0) name += east < 0 ? "west" : "east";
  return name + " of a line";
}

}  // namespace

std::optional<Slant> SlantToward(RimPoint from, RimPoint to, Heading heading) {
  Slant slant{from, to, true};
  const int cross = (to.east - from.east) * heading.south - (to.south - from.south) * heading.east;
  if (cross == 0) return std::nullopt;
  slant.left = cross < 0;
  return slant;
}

std::string WordOf(const Slant& slant) {
  std::string word(kPrefix);
  for (const int step : {slant.from.east, slant.from.south, slant.to.east, slant.to.south}) {
    word += static_cast<char>('0' + step);
  }
  return word + (slant.left ? '+' : '-');
}

std::optional<Slant> SlantNamed(std::string_view word) {
  if (word.size() != kPrefix.size() + 5 || word.substr(0, kPrefix.size()) != kPrefix) {
    return std::nullopt;
  }
  const std::string_view steps = word.substr(kPrefix.size(), 4);
  if (!std::all_of(steps.begin(), steps.end(), IsStep)) return std::nullopt;
  return Slant{
      {steps[0] - '0', steps[1] - '0'}, {steps[2] - '0', steps[3] - '0'}, word.back() == '+'};
}

Zone ZoneOfSlant(const Slant& slant) {
  Zone zone;
  zone.name = NameOf(slant);
  for (int row = 0; row < kLayoutSize; ++row) {
    int first = kLayoutSize;
    int last = -1;
    for (int col = 0; col < kLayoutSize; ++col) {
      const double scale = 2.0 / kLayoutSize;
      if (IsLeft(slant, (col + 0.5) * scale, (row + 0.5) * scale) != slant.left) continue;
      first = std::min(first, col);
      last = std::max(last, col);
    }
    if (last < first) continue;
    UnitBox box;
    box.u_min = static_cast<double>(first) / kLayoutSize;
    box.u_max = static_cast<double>(last + 1) / kLayoutSize;
    box.v_min = static_cast<double>(row) / kLayoutSize;
    box.v_max = static_cast<double>(row + 1) / kLayoutSize;
    zone.boxes.push_back(box);
  }
  return zone;
}

}  // namespace latticeworld
