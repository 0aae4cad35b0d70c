#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_PLAN_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_PLAN_H_

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// How a thing lies on the land.
enum class FeatureForm {
  kSpread,  // fills what it is given: forest, farmland
  kPatch,   // compact and countable: lake, village, grove
  kLine,    // runs: river, road
};

enum class Texture { kUnsaid, kScattered, kClustered };

// A course ends or passes at a zone, or at a feature (an index into LayoutPlan::features).
struct Waypoint {
  Zone zone;
  int feature = -1;  // -1: the zone counts
  bool said = true;  // false: supposed, for want of words
};

// One thing of the land as the words have it: "three small ponds in the northern half", "a winding
// river from the north to the village". Everything said of one thing in several sentences is
// gathered here.
struct PlannedFeature {
  char letter = '?';
  FeatureForm form = FeatureForm::kSpread;
  std::vector<Zone> zones;  // where: a share of it in each ("in the north and the south", "in the
                            // corners"); empty: anywhere
  int pieces = 0;           // said to be so many; 0: not said
  int pieces_least = 0;     // as the words have it ("several": 3 ..); 0: nothing said of them
  int pieces_most = 0;      // 0: nothing said, or no bound
  int cells = 40;           // natural size of one piece
  std::optional<double> share;        // said to cover so much of its zones (all together): 0 .. 1
  std::optional<double> share_least;  // what a reader takes for the share that was said; also
  std::optional<double> share_most;   // alone: "vast" is at least 0.08
  bool share_of_zones = false;        // the share is one of its zone: "the north is half forest"
  double located_least = 0.0;         // "most of the houses are in the north": so much of its class
  Zone located_in;                    // lies there; 0: nothing said
  double gap = 0.0;                   // steps that its pieces keep from each other; 0: not said
  bool confined = false;              // nowhere but in its zones: "only in the north"
  bool dominant = false;              // "mostly", "covers": more than any other class in its zones
  bool fills_rest = false;            // "the rest is": whatever nothing else takes
  Texture texture = Texture::kUnsaid;
  std::optional<ClaimShape> shape;

  // Lines only.
  std::optional<Waypoint> from;
  std::optional<Waypoint> to;
  std::vector<Waypoint> via;  // in the order said
  std::optional<Zone> along;  // keeps to it from end to end: "along the southern edge"
  double meander = 1.0;       // 0 straight, 1 gentle, 2 winding
  bool wide = false;

  bool supposed = false;  // no words speak of it, and nothing is claimed of it: it stands only for
                          // what others need, the pool around an island in a river
  std::string noun;       // that names it, in the singular: "snow mountain"
  bool plural = false;    // the words had it in the plural
  std::string words;
};

// What ties features together.
enum class RelationKind {
  kAdjacent,   // subject touches object
  kNear,       // subject within a few cells of object
  kApart,      // subject keeps away from object
  kSurrounds,  // subject all around object
  kWithin,     // subject lies in object: an island, a clearing, a village in the forest
  kBothSides,  // subject on both sides of object
  kBetween,    // subject between object and second_object
  kDirection,  // subject lies toward heading from object
  kMoreThan,   // subject covers more than object
  kAlong,      // subject, line or row of patches, follows object
  kThrough,    // subject, a line, runs through object
  kCrosses,    // two lines
  kParallel,   // two lines
  kConnects,   // subject, a line, from object to second_object
};

struct PlannedRelation {
  RelationKind kind = RelationKind::kAdjacent;
  int subject = -1;  // indices into LayoutPlan::features
  int object = -1;
  int second_object = -1;  // kBetween, kConnects
  Claim::Heading heading;  // kDirection; kBothSides: one of the two sides, if they were named
  double steps = 0.0;      // kAdjacent, kNear, kApart: the gap that the words allow; 0: not said
  std::string words;
};

// Features that follow each other: "from north to south: snow, then rock, then forest".
struct PlannedOrder {
  std::vector<int> features;  // indices into LayoutPlan::features
  Claim::Heading heading;
  std::string words;
};

// A class that shall not be in a zone.
struct PlannedAbsence {
  char letter = '?';
  Zone zone;
  std::string words;
};

// What an instruction asks for, ready to be laid out.
struct LayoutPlan {
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::vector<PlannedFeature> features;  // in the order of the words
  std::vector<PlannedRelation> relations;
  std::vector<PlannedOrder> orders;
  std::vector<PlannedAbsence> absences;
  std::vector<ReliefWish> reliefs;  // of the land's form, whatever lies on it (relief_reading.h)
  std::vector<HeightCover> covers;  // of classes by height
  std::vector<ThingWish> things;    // single ones; they take no land
  char background = '\0';           // what nothing else takes; always a letter of the vocabulary
  std::vector<Claim> claims;        // what the layout is measured by
  std::vector<std::string> not_understood;  // words, as they stand in the instruction
  std::vector<std::string> warnings;        // each quotes the words it is about
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_PLAN_H_
