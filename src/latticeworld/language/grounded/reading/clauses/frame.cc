#include "latticeworld/language/grounded/reading/clauses/frame.h"

namespace latticeworld {

Heading HeadingOfFrame(const Frame& frame) {
  if (frame.is_direction && frame.use != DirectionUse::kInside) return frame.heading;
  switch (frame.sense) {
    case Sense::kAbove:
    case Sense::kBehind:
      return {0, -1};
    case Sense::kBelow:
    case Sense::kInFront:
      return {0, 1};
    default:
      return {0, 0};
  }
}

bool IsCourse(Sense sense) {
  switch (sense) {
    case Sense::kFrom:
    case Sense::kTo:
    case Sense::kThrough:
    case Sense::kCrosses:
    case Sense::kPast:
    case Sense::kAlong:
    case Sense::kParallel:
    case Sense::kConnects:
      return true;
    default:
      return false;
  }
}

bool IsParticiple(Sense sense) {
  switch (sense) {
    case Sense::kSurroundedBy:
    case Sense::kBorderedBy:
    case Sense::kDottedWith:
    case Sense::kFlankedBy:
    case Sense::kLinedWith:
    case Sense::kCutBy:
    case Sense::kWith:
    case Sense::kCoveredBy:
      return true;
    default:
      return false;
  }
}

bool TakesList(Sense sense) {
  switch (sense) {
    case Sense::kSurroundedBy:
    case Sense::kBorderedBy:
    case Sense::kDottedWith:
    case Sense::kFlankedBy:
    case Sense::kSurrounds:
    case Sense::kAway:
    case Sense::kThrough:
    case Sense::kConnects:
      return true;
    default:
      return false;
  }
}

bool MayLackObject(Sense sense) {
  switch (sense) {
    case Sense::kBothSides:
    case Sense::kNear:
    case Sense::kNextTo:
    case Sense::kAway:
    case Sense::kSurrounds:
    case Sense::kBetween:
    case Sense::kBehind:
    case Sense::kBeyond:
    case Sense::kInFront:
    case Sense::kAbove:
    case Sense::kBelow:
    case Sense::kWithinIt:
      return true;
    default:
      return false;
  }
}

bool WantsTwo(Sense sense) { return sense == Sense::kBetween || sense == Sense::kConnects; }

}  // namespace latticeworld
