#ifndef LATTICEWORLD_GENERATION_VISUAL_H_
#define LATTICEWORLD_GENERATION_VISUAL_H_

#include <optional>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// Every violation of a request's visual instruction that shows before it is read: kind, bytes,
// names and options.
std::vector<Violation> ValidateVisual(const GenerationRequest& request,
                                      const SketchTranslator& sketches);
// Returns the violations of the options alone that the kind of the visual instruction looks at.
std::vector<Violation> ValidateVisualOptions(const GenerationRequest& request);

// The request as it is recorded: the translator of a sketch is named, options that its kind does
// not look at are the default ones, a file's name has no directories.
void ResolveVisual(const SketchTranslator& sketches, GenerationRequest* request);

// Reads the visual instruction of a request that is valid; nullopt when it has none. Reports stage
// "relief". Errors: INVALID_ARGUMENT (not such a file), CANCELLED.
Result<std::optional<Relief>> ReadVisual(const GenerationRequest& request,
                                         const SketchTranslator& sketches,
                                         const GridGeometry& geometry, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_VISUAL_H_
