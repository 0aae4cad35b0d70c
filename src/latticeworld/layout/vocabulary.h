#ifndef LATTICEWORLD_LAYOUT_VOCABULARY_H_
#define LATTICEWORLD_LAYOUT_VOCABULARY_H_

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/rgb.h"

namespace latticeworld {

// The two symbol sets of the method: suburb (the classes of LoveDA) and wild.
enum class Vocabulary : std::uint8_t { kSuburb, kWild };

constexpr std::array<EnumName<Vocabulary>, 2> EnumNames(Vocabulary) {
  return {{{Vocabulary::kSuburb, "suburb"}, {Vocabulary::kWild, "wild"}}};
}

struct LayoutClass {
  char letter;
  std::string_view name;     // "forest"
  std::string_view meaning;  // for prompts: "forest: woodland, dense trees"
  Rgb color;
};

// The classes of a vocabulary in alphabetical order of their letters.
const std::vector<LayoutClass>& ClassesOf(Vocabulary vocabulary);
// nullptr when the vocabulary has no such letter.
const LayoutClass* FindClass(Vocabulary vocabulary, char letter);
// "A, B, D, F, G, R, W": for messages.
std::string_view LegalLetters(Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_VOCABULARY_H_
