#ifndef LATTICEWORLD_TESTS_DATASET_MADE_LAYOUTS_H_
#define LATTICEWORLD_TESTS_DATASET_MADE_LAYOUTS_H_

#include <cstdint>

#include "latticeworld/dataset/instance.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// A layout that no words were there for, as a segmented picture gives it: land in patches with
// uneven borders, lakes, houses, a river or roads from edge to edge, stray cells. Every seed
// another; odd seeds are noisier.
SymbolicLayout MadeLayout(Vocabulary vocabulary, std::uint64_t seed);

// The same as an instance; with a relief of hills and a slope where `relief`.
Instance MadeInstance(Vocabulary vocabulary, std::uint64_t seed, bool relief);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_DATASET_MADE_LAYOUTS_H_
