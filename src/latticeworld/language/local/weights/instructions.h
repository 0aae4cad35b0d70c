#ifndef LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_INSTRUCTIONS_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_INSTRUCTIONS_H_

#include <array>

namespace latticeworld {

// Instructions that sums over weights can be computed with, the slowest first. Each kind has those
// before it, and all give the same bits.
enum class Instructions { kPlain, kAvx2, kAvx512, kVnni };

inline constexpr std::array<Instructions, 4> kAllInstructions = {
    Instructions::kPlain, Instructions::kAvx2, Instructions::kAvx512, Instructions::kVnni};

bool HasInstructions(Instructions instructions);  // whether this processor does
Instructions FastestInstructions();               // of those that it has

// Those that sums are computed with: the fastest, unless a test has chosen others.
Instructions UsedInstructions();
// Chooses them for the whole process, between requests. This processor has them.
void UseInstructions(Instructions instructions);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_INSTRUCTIONS_H_
