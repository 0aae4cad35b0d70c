#ifndef LATTICEWORLD_DATASET_SOURCES_RANDOM_PLAN_H_
#define LATTICEWORLD_DATASET_SOURCES_RANDOM_PLAN_H_

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// A place that nobody asked for in words: a background, land with shares and regions, countable
// pieces with shapes, rivers and roads with courses, and what ties them together. Every class of
// the vocabulary, every form and every relation that a plan knows comes up. Its claims are those
// that a reader takes from such a plan. The same draws give the same plan.
LayoutPlan RandomPlan(Vocabulary vocabulary, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_RANDOM_PLAN_H_
