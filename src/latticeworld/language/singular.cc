#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

struct Irregular {
  std::string_view plural;
  std::string_view singular;
};

// Plurals that no rule gives, and words that only look like plurals. Sorted by plural.
constexpr Irregular kIrregular[] = {
    {"across", "across"},
    {"always", "always"},
    {"bacteria", "bacterium"},
    {"besides", "besides"},
    {"buffaloes", "buffalo"},
    {"buses", "bus"},
    {"calves", "calf"},
    {"chassis", "chassis"},
    {"chateaux", "chateau"},
    {"children", "child"},
    {"deer", "deer"},
    {"does", "does"},
    {"dwarves", "dwarf"},
    {"feet", "foot"},
    {"gas", "gas"},
    {"gases", "gas"},
    {"geese", "goose"},
    {"glacis", "glacis"},
    {"halves", "half"},
    {"has", "has"},
    {"heroes", "hero"},
    {"hooves", "hoof"},
    {"iris", "iris"},
    {"is", "is"},
    {"its", "its"},
    {"knives", "knife"},
    {"leaves", "leaf"},
    {"lens", "lens"},
    {"loaves", "loaf"},
    {"lynxes", "lynx"},
    {"mangoes", "mango"},
    {"men", "man"},
    {"mice", "mouse"},
    {"mosquitoes", "mosquito"},
    {"news", "news"},
    {"oases", "oasis"},
    {"oasis", "oasis"},
    {"oxen", "ox"},
    {"perhaps", "perhaps"},
    {"plateaux", "plateau"},
    {"potatoes", "potato"},
    {"series", "series"},
    {"sheaves", "sheaf"},
    {"shelves", "shelf"},
    {"sometimes", "sometimes"},
    {"species", "species"},
    {"teeth", "tooth"},
    {"this", "this"},
    {"thus", "thus"},
    {"tomatoes", "tomato"},
    {"tornadoes", "tornado"},
    {"towards", "towards"},
    {"turves", "turf"},
    {"volcanoes", "volcano"},
    {"was", "was"},
    {"wharves", "wharf"},
    {"wives", "wife"},
    {"wolves", "wolf"},
    {"women", "woman"},
    {"yes", "yes"},
};

}  // namespace

std::string Singular(std::string_view word) {
  const auto* irregular = std::lower_bound(
      std::begin(kIrregular), std::end(kIrregular), word,
      [](const Irregular& entry, std::string_view given) { return entry.plural < given; });
  if (irregular != std::end(kIrregular) && irregular->plural == word) {
    return std::string(irregular->singular);
  }
  const auto cut = [&](std::size_t n) { return std::string(word.substr(0, word.size() - n)); };
  // "fishermen", "horsewomen"
  if (word.size() > 5 && EndsWith(word, "men")) return cut(2) + "an";
  if (word.size() > 4 && EndsWith(word, "ies")) return cut(3) + "y";
  for (const std::string_view end : {"shes", "ches", "sses", "xes", "zzes"}) {
    if (word.size() > end.size() + 1 && EndsWith(word, end)) return cut(2);
  }
  if (word.size() > 3 && EndsWith(word, "s") && !EndsWith(word, "ss") && !EndsWith(word, "us")) {
    return cut(1);
  }
  return std::string(word);
}

}  // namespace latticeworld
