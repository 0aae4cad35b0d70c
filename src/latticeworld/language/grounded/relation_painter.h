#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_RELATION_PAINTER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_RELATION_PAINTER_H_

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/canvas.h"
#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// Makes the relation true on a full canvas where it is not yet: grows subject towards object until
// they touch, or a ring of subject around every piece of object. Locked cells stay.
void PaintRelation(const RelationWish& relation, RandomStream* random, Canvas* canvas);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_RELATION_PAINTER_H_
