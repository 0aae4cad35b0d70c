#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_INFLECTION_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_INFLECTION_H_

#include <string>
#include <string_view>
#include <vector>

namespace latticeworld {

// The regular plural of an English noun phrase: "goblin archer" -> "goblin archers", "pony" ->
// "ponies".
std::string PluralOf(std::string_view noun);

// The forms of an English verb phrase by the regular rules and the common exceptions among verbs of
// movement and rest: "keep watch" -> "keep watch", "keeps watch", "keeping watch", "kept watch".
std::vector<std::string> FormsOf(std::string_view verb);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_INFLECTION_H_
