#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAUSES_FRAME_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAUSES_FRAME_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/grounded/reading/discourse.h"
#include "latticeworld/language/grounded/reading/sense.h"
#include "latticeworld/language/places.h"

namespace latticeworld {

// A relation whose parts are being read: "X next to Y", "next to Y lies X".
struct Frame {
  Sense sense = Sense::kNone;
  bool is_direction = false;  // "north of": heading and use count
  Heading heading;
  DirectionUse use = DirectionUse::kBeyond;
  std::vector<int> subjects;
  std::vector<int> objects;
  bool fronted = false;   // the subject comes after the object
  bool expecting = true;  // an object is to come
  bool of_it = false;     // the words name their object themselves: "on its shore"
  bool negated = false;   // "not next to"
  bool at_end = false;    // "at the head of the fjord": where it runs to
  bool both = false;      // in the heading and against it: "at both ends"
  bool touching = false;  // "on the western bank", "just south of": there and close by
  bool along = false;     // "along the northern shore of": all the way
  bool partly = false;    // "on three sides": not all around
  bool inside = false;    // "in the lake", not "on the lake"
  double steps = 0.0;     // the gap that the words allow, where they are strict: "touching"
};

// Returns in which direction the subject lies from the object; (0, 0): the frame does not tell.
Heading HeadingOfFrame(const Frame& frame);
// Tells how a line runs, rather than where a thing lies.
bool IsCourse(Sense sense);
// Follows the noun that it is said of: "surrounded by", "dotted with".
bool IsParticiple(Sense sense);
// Goes on through a list: "surrounded by fields, meadows and woods".
bool TakesList(Sense sense);
// May stand without an object, which is then what was spoken of: "with houses on both sides".
bool MayLackObject(Sense sense);
// Wants two objects: "between", "connects".
bool WantsTwo(Sense sense);

// Says what the frame says of one subject and the last of its objects (of both, where it wants two)
// to the discourse.
void Assert(const Frame& frame, int subject, Discourse* discourse);
// The same for a frame whose subjects are tied to each other: "two roads cross".
void AssertEachOther(const Frame& frame, Discourse* discourse);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAUSES_FRAME_H_
