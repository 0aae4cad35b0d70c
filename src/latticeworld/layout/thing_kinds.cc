#include "latticeworld/layout/thing_kinds.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

std::string_view ThingFile(std::string_view file_name);  // embedded

namespace {

std::vector<ThingKind> ReadThings() {
  std::vector<ThingKind> kinds;
  for (const std::string& line : Split(ThingFile("things.txt"), '\n')) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> fields = Split(line, '\t');
    LW_CHECK(fields.size() >= 4, "a kind of things has a name, a source, a model and a spacing");
    const auto source = FromName<ThingSource>(fields[1]);
    LW_CHECK(source.has_value(), "the source of a kind of things is known");
    ThingKind kind = {fields[0], *source, fields[2], std::strtod(fields[3].c_str(), nullptr), {}};
    kind.words = {fields[0]};
    kind.words.insert(kind.words.end(), fields.begin() + 4, fields.end());
    kinds.push_back(std::move(kind));
  }
  return kinds;
}

// Levenshtein's distance: letters to put in, take out or change.
std::size_t EditsBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row[b.size()];
}

}  // namespace

const std::vector<ThingKind>& AllThingKinds() {
  static const std::vector<ThingKind> kinds = ReadThings();
  return kinds;
}

const ThingKind* FindThingKind(std::string_view word) {
  static const std::map<std::string, const ThingKind*, std::less<>> by_word = [] {
    std::map<std::string, const ThingKind*, std::less<>> all;
    for (const ThingKind& kind : AllThingKinds()) {
      for (const std::string& each : kind.words) all.emplace(each, &kind);
    }
    return all;
  }();
  const auto found = by_word.find(word);
  return found == by_word.end() ? nullptr : found->second;
}

std::string NearestThingKind(std::string_view word) {
  constexpr std::size_t kLongest = 64;  // of the word that is looked at
  std::string nearest;
  std::size_t least = kLongest;
  for (const ThingKind& kind : AllThingKinds()) {
    for (const std::string& each : kind.words) {
      const std::size_t edits = EditsBetween(word.substr(0, kLongest), each);
      if (nearest.empty() || edits < least) {
        least = edits;
        nearest = kind.name;
      }
    }
  }
  return nearest;
}

char GroundNamed(std::string_view noun) {
  constexpr std::string_view kHigh[] = {"hill",   "hilltop", "mountain", "peak",
                                        "summit", "ridge",   "plateau",  "mesa"};
  constexpr std::string_view kLow[] = {"valley", "gorge", "canyon", "basin", "hollow", "crater"};
  if (std::find(std::begin(kHigh), std::end(kHigh), noun) != std::end(kHigh)) return kHighGround;
  return std::find(std::begin(kLow), std::end(kLow), noun) != std::end(kLow) ? kLowGround : '\0';
}

std::string LegalThingKinds() {
  std::vector<std::string> names;
  for (const ThingKind& kind : AllThingKinds()) names.push_back(kind.name);
  return Join(names, ", ");
}

}  // namespace latticeworld
