#include "latticeworld/relief/sketch/sketch.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/relief/height_map/middle_square.h"
#include "latticeworld/relief/sketch/sketch_model.h"

namespace latticeworld {
namespace {

constexpr int kMinSamples = 64;
constexpr int kMaxSamples = 8192;

void CheckCount(std::string pointer, int value, int low, int high,
                std::vector<Violation>* violations) {
  if (value >= low && value <= high) return;
  violations->push_back({"out_of_range", pointer,
                         pointer + " is " + std::to_string(value) + "; legal are " +
                             std::to_string(low) + " to " + std::to_string(high),
                         std::to_string(value)});
}

// Cuts its middle square out of a sketch that is not square and says so. Errors: INVALID_ARGUMENT
// (no stroke is left).
Status MakeSquare(Sketch* sketch, std::vector<std::string>* warnings) {
  const internal::MiddleSquare square(sketch->rows(), sketch->cols());
  if (!square.cuts()) return Status();
  *sketch = CutOut(square, *sketch);
  const std::string warning = CutWarning(square, "sketch");
  if (std::all_of(sketch->begin(), sketch->end(), [](Stroke s) { return s == Stroke::kNone; })) {
    return InvalidArgument("no stroke of the sketch lies in its middle square (" + warning +
                           "); legal are strokes there, or a square sketch");
  }
  warnings->push_back(warning);
  return Status();
}

}  // namespace

std::vector<Violation> Validate(const SketchOptions& options) {
  std::vector<Violation> violations;
  CheckCount("samples", options.samples, kMinSamples, kMaxSamples, &violations);
  CheckRange("size", options.size_m, {kMinSize_m, kMaxSize_m}, " m", &violations);
  CheckRange("height_scale", options.height_scale_m, {1.0, 9000.0}, " m", &violations);
  CheckRange("height_offset", options.height_offset_m, {-9000.0, 9000.0}, " m", &violations);
  constexpr int kMostThreads = 1024;
  CheckCount("threads", options.threads, 0, kMostThreads, &violations);
  return violations;
}

Result<Relief> SketchToRelief(std::string_view bytes, const SketchOptions& options,
                              const Progress& progress, const SketchModel* model) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal sketch options", Validate(options)));
  progress.Report("relief", 0.0);
  LW_ASSIGN_OR_RETURN(Sketch sketch, ReadSketch(bytes, options.threads));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  std::vector<std::string> warnings;
  LW_RETURN_IF_ERROR(MakeSquare(&sketch, &warnings));
  LW_ASSIGN_OR_RETURN(Grid<float> height_m, model != nullptr
                                                ? SketchToHeight(sketch, *model, options, progress)
                                                : SketchToHeight(sketch, options, progress));
  Relief relief = MakeRelief(std::move(height_m));
  relief.warnings = std::move(warnings);
  return relief;
}

}  // namespace latticeworld
