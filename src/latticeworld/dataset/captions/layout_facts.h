#ifndef LATTICEWORLD_DATASET_CAPTIONS_LAYOUT_FACTS_H_
#define LATTICEWORLD_DATASET_CAPTIONS_LAYOUT_FACTS_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/random.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// How a class lies in a layout, which decides what it is called.
enum class ClassForm : std::uint8_t {
  kSpread,  // land: "forest", "farmland"
  kOne,     // one compact piece: "a lake", "a village"
  kMany,    // pieces: "lakes", "houses"
  kLine,    // one that runs: "a river", "a road"
  kLines,   // "roads"
};

constexpr std::array<EnumName<ClassForm>, 5> EnumNames(ClassForm) {
  return {{{ClassForm::kSpread, "spread"},
           {ClassForm::kOne, "one"},
           {ClassForm::kMany, "many"},
           {ClassForm::kLine, "line"},
           {ClassForm::kLines, "lines"}}};
}

struct ClassInLayout {
  char letter = '?';
  int cells = 0;
  int pieces = 0;       // without stray cells; across a line that cuts a line
  int least_piece = 0;  // cells of the smallest of them
  ClassForm form = ClassForm::kSpread;
  bool nameable = false;  // large enough that words may speak of it
  double share() const { return static_cast<double>(cells) / (kLayoutSize * kLayoutSize); }
};

// The classes that a layout has, largest first (ties: by letter).
std::vector<ClassInLayout> ClassesIn(const LayoutMasks& layout);

// What a fact is about. A caption has a few of each.
enum class FactTopic : std::uint8_t {
  kExtent,    // what dominates, shares, more of this than of that
  kLine,      // where rivers and roads run
  kNumber,    // how many pieces, scattered or together
  kPlace,     // what lies where
  kRelation,  // how two or three classes lie to each other
  kOrder,     // what follows what
  kAbsence,   // what is not there
  kRest,      // what fills what nothing else takes
};
inline constexpr int kFactTopics = 8;

// Something that is true of a layout, and the key of the phrases that say it.
struct LayoutFact {
  FactTopic topic = FactTopic::kExtent;
  std::string phrase;  // "extent.dominant", "place.fills", ...
  char subject = '?';
  char object = '\0';
  char second = '\0';
  Zone zone;  // of the subject; where a course begins
  Zone to;    // where a course ends
  Claim::Heading heading;
  int count = 0;
  std::string amount;         // "about a third"
  std::string sequence;       // letters
  std::vector<Claim> claims;  // all that the words say; every one satisfied
};

// Chooses about `wanted` facts (fewer if the layout has no more to say), salient ones rather than
// others, never two that say the same. The layout satisfies every claim by DistanceOf. Takes a
// fraction of a millisecond.
std::vector<LayoutFact> ChooseFacts(const LayoutMasks& layout,
                                    const std::vector<ClassInLayout>& classes, int wanted,
                                    RandomStream* random);

namespace internal {

// What could be said, not yet measured; later ones are less worth saying. For the .cc files.
struct FactSource {
  const LayoutMasks& layout;
  const std::vector<ClassInLayout>& classes;
  RandomStream* random;

  const ClassInLayout* Find(char letter) const;
  bool IsLine(char letter) const;
};
std::vector<LayoutFact> ExtentFacts(const FactSource& source);
std::vector<LayoutFact> LineFacts(const FactSource& source);
std::vector<LayoutFact> PlaceFacts(const FactSource& source);
std::vector<LayoutFact> NumberFacts(const FactSource& source);
std::vector<LayoutFact> RelationFacts(const FactSource& source);
std::vector<LayoutFact> OrderFacts(const FactSource& source);
std::vector<LayoutFact> AbsenceFacts(const FactSource& source);

Claim ClaimOf(ClaimKind kind, char subject, char object = '\0');

}  // namespace internal

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_LAYOUT_FACTS_H_
