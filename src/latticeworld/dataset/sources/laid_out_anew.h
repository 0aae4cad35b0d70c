#ifndef LATTICEWORLD_DATASET_SOURCES_LAID_OUT_ANEW_H_
#define LATTICEWORLD_DATASET_SOURCES_LAID_OUT_ANEW_H_

#include <cstdint>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/instance.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// What the embedded generator lays out for the words that were written for an instance, on its
// relief. Every claim of the caption holds on it. Errors: DATA_LOSS (a claim does not, or the words
// were not understood), CANCELLED.
Result<SymbolicLayout> LaidOutAnew(const Instance& instance, const LayoutCaption& caption,
                                   std::uint64_t seed, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_LAID_OUT_ANEW_H_
