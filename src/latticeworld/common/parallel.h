#ifndef LATTICEWORLD_COMMON_PARALLEL_H_
#define LATTICEWORLD_COMMON_PARALLEL_H_

#include <functional>

namespace latticeworld {

// How many threads the machine can run at once, at least 1, as it was when first asked.
int CoreCount();

// Calls body(begin, end) on the parts of [0, count), several threads at once, and returns when all
// are done. threads: how many at most; 0: as many as the machine has cores. Where the parts begin
// and end depends on the number of threads: a body whose result depends on that is a bug, since
// every result has to be the same with any number of threads. body must not throw.
void ParallelFor(int count, int threads, const std::function<void(int begin, int end)>& body);

// The same, of parts of `piece` (> 0) that each thread takes when it is done with its last one: for
// work of which some parts take longer than others. Where parts begin does not depend on the
// number of threads.
void ParallelInPieces(int count, int piece, int threads,
                      const std::function<void(int begin, int end)>& body);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_PARALLEL_H_
