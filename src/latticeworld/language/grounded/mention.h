#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_MENTION_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_MENTION_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/places.h"

namespace latticeworld {

inline bool NamesIsland(const ClassWord& noun) {
  return noun.phrase.find("island") != std::string_view::npos || noun.phrase == "islet";
}

// A thing of the land that an instruction speaks of, with all that is said of it.
struct Mention {
  char letter = '?';
  const ClassWord* noun = nullptr;
  bool plural = false;
  bool negated = false;
  bool is_rest = false;  // "the rest is grassland"
  Amount amount = Amount::kUnsaid;
  Texture texture = Texture::kUnsaid;
  int number = 0;  // 0: not said
  std::vector<Place> places;
  bool place_from_lead = false;  // "In the north there is ...": a place of its own replaces it
  // Lines only.
  Region from = Region::kAnywhere;
  Region to = Region::kAnywhere;
  int from_mention = -1;  // "from the lake to the village"
  int to_mention = -1;
  std::vector<Region> through;
  double meander = 1.0;
  bool wide = false;
  std::size_t begin = 0;  // bytes of the instruction
  std::size_t end = 0;

  bool is_line() const { return noun->shape == WordShape::kLine; }
  // Land that belongs into water.
  bool is_island() const { return NamesIsland(*noun); }
  bool has_course() const {
    return from != Region::kAnywhere || to != Region::kAnywhere || from_mention >= 0 ||
           to_mention >= 0;
  }
};

enum class TieKind { kNextTo, kSurrounds, kHeading, kMoreThan };

// What is said of two mentions.
struct Tie {
  TieKind kind = TieKind::kNextTo;
  int subject = -1;
  int object = -1;
  Heading heading;  // kHeading: where subject lies, seen from object
  std::size_t begin = 0;
  std::size_t end = 0;
};

// What an instruction says, before it is turned into wishes and claims.
struct LayoutReading {
  std::vector<Mention> mentions;
  std::vector<Tie> ties;
  std::vector<std::string> warnings;
};

// Wishes and claims of a reading: open places are settled here ("north of the lake").
LayoutPlan PlanFromReading(LayoutReading reading, std::string_view instruction,
                           Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_MENTION_H_
