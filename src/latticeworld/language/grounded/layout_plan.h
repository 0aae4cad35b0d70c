#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_PLAN_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_PLAN_H_

#include <string>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/places.h"
#include "latticeworld/layout/claims.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

enum class Amount { kUnsaid, kMost, kMuch, kLittle };
enum class Texture { kUnsaid, kScattered, kClustered };

// Something that covers cells: "a dense forest in the upper left", "three small ponds".
struct AreaWish {
  char letter = '?';
  WordShape shape = WordShape::kMass;
  std::vector<Place> places;  // empty: anywhere
  Amount amount = Amount::kUnsaid;
  Texture texture = Texture::kUnsaid;
  int pieces = 0;                 // 0: not said
  int cells = 40;                 // usual size of one piece
  bool laid_by_relation = false;  // "surrounded by forest": the ring is all of it
};

// Something that runs: "a winding river from the north to the lower right".
struct CourseWish {
  char letter = '?';
  Region from = Region::kAnywhere;  // kAnywhere: not said
  Region to = Region::kAnywhere;
  std::vector<Region> through;
  double meander = 1.0;  // 0 straight, 1 gentle, 2 winding
  bool wide = false;
  bool hugs_edge = false;  // "along the southern edge"
};

// What ties two wishes together.
struct RelationWish {
  ClaimKind kind = ClaimKind::kAdjacent;  // kAdjacent or kSurrounds
  char subject = '?';
  char object = '?';
  int subject_area = -1;  // index into areas; -1: a course
  int object_area = -1;
};

// Land within the largest water.
struct IslandWish {
  char letter = '?';
  int pieces = 1;
  int cells = 6;
};

// What an instruction asks for, ready to be laid out.
struct LayoutPlan {
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::vector<AreaWish> areas;
  std::vector<CourseWish> courses;
  std::vector<RelationWish> relations;
  std::vector<IslandWish> islands;
  char background = '\0';  // '\0': not said
  std::vector<Claim> claims;
  std::vector<std::string> warnings;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_PLAN_H_
