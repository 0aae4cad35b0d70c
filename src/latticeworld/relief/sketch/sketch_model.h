#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_MODEL_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_MODEL_H_

#include <memory>
#include <string>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {

// A learned translation from strokes to heights: an ONNX network that OpenCV runs on the CPU.
// Input: (1 x 3 x N x N), the sketch in red, green and blue, [0, 1], valleys (0, 0, 1), ridges
// (0, 0, 0), paper (1, 1, 1); or (1 x 1 x N x N), valleys 0, paper 0.5, ridges 1. Output:
// (1 x 1 x N x N), heights of any scale, as a rule [0, 1]. Float32; N as the file says, 32 to 4096.
class SketchModel {
 public:
  // Errors: NOT_FOUND (no such file), INVALID_ARGUMENT (not an ONNX network, or not of those
  // shapes, saying which were found).
  static Result<SketchModel> Load(const std::string& path);

  SketchModel(SketchModel&& other) noexcept;
  SketchModel& operator=(SketchModel&& other) noexcept;
  ~SketchModel();

  int side() const;      // N
  int channels() const;  // of the input, 1 or 3

  // Heights of the land, (N x N), as the network gives them. Errors: INTERNAL (the network fails,
  // or gives what is not finite). May be called from several threads; they take turns.
  Result<Grid<float>> Run(const Sketch& sketch) const;

 private:
  struct Network;
  explicit SketchModel(std::unique_ptr<Network> network);

  std::unique_ptr<Network> network_;
};

// Land whose strokes are those of the sketch and whose heights between them, and along its ridges,
// are those that the model gives: valleys fall along their course, and water works on it as on the
// land without a model. Errors: INVALID_ARGUMENT (options), CANCELLED, INTERNAL (as Run, or an
// output that is level).
Result<Grid<float>> SketchToHeight(const Sketch& sketch, const SketchModel& model,
                                   const SketchOptions& options, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_MODEL_H_
