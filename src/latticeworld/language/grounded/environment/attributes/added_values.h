#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_ADDED_VALUES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_ADDED_VALUES_H_

#include <optional>
#include <set>
#include <string>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/language/grounded/environment/word_tables.h"

namespace latticeworld {

// The words of the values that a catalogue has beyond BuiltIn().
struct AddedValueWords {
  std::optional<EnvironmentWords> words;  // the tables with these too; nullopt: nothing is added
  std::set<std::string> known;            // single words, which are no slips of the pen
};

// A value is known by its name. Seasonal variants are known together by what follows the season in
// their names, and by the name of an added model that wears them: "larch" stands for "spring larch"
// and "autumn larch", and for "golden larch" where that is worn by a model "larch". All of it in
// singular and plural. A single word that the tables know already counts only together with a noun
// of the asset type. A name of one or two letters is not heard at all.
AddedValueWords AddedValueWordsOf(const Catalogue& catalogue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_ADDED_VALUES_H_
