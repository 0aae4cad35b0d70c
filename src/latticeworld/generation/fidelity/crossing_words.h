#ifndef LATTICEWORLD_GENERATION_FIDELITY_CROSSING_WORDS_H_
#define LATTICEWORLD_GENERATION_FIDELITY_CROSSING_WORDS_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {

struct Scene;
struct SymbolicLayout;

// Whether a layout instruction asks for fords, or for bridges: it has the word, without a denial
// right before it.
bool AsksForFords(std::string_view instruction);
bool AsksForBridges(std::string_view instruction);

// The kind of all bridges of roads: that of the last "stone bridge", "wooden bridges", "steel
// bridge" ... that the instruction has; none: it names no kind.
std::optional<BridgeKind> BridgeKindAskedFor(std::string_view instruction);

// Whether roads ford narrow rivers in a world of that size: where the words ask for fords, and
// where rivers are shallow and the words do not ask for bridges.
bool FordsRivers(std::string_view instruction, double size_m);

// What the words ask for over water and the world has nowhere, and why, one warning each.
std::vector<std::string> CrossingWarnings(std::string_view instruction,
                                          const SymbolicLayout& layout, const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_FIDELITY_CROSSING_WORDS_H_
