#ifndef LATTICEWORLD_GENERATION_SKETCH_TRANSLATOR_H_
#define LATTICEWORLD_GENERATION_SKETCH_TRANSLATOR_H_

#include <memory>
#include <string>
#include <string_view>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {

class SketchModel;

inline constexpr char kEmbeddedTranslator[] = "embedded";

// What turns sketches into land: the embedded method, or a learned model.
class SketchTranslator {
 public:
  SketchTranslator() = default;  // the embedded one
  // The ONNX model of that file; "" gives the embedded one. Errors: NOT_FOUND, INVALID_ARGUMENT
  // (no such model), what reading the file says.
  static Result<SketchTranslator> Load(const std::string& path);

  // "embedded", or "onnx-<first 12 digits of the file's SHA-256>": a world says by it what it was
  // made with.
  const std::string& name() const { return name_; }

  // Errors: INVALID_ARGUMENT (no sketch, options), CANCELLED, INTERNAL (the model fails).
  Result<Relief> Translate(std::string_view picture, const SketchOptions& options,
                           const Progress& progress) const;

 private:
  std::string name_ = kEmbeddedTranslator;
  std::shared_ptr<const SketchModel> model_;  // null: embedded
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_SKETCH_TRANSLATOR_H_
