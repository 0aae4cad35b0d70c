#include "latticeworld/generation/sketch_translator.h"

#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"
#include "latticeworld/relief/sketch/sketch_model.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxModelBytes = std::size_t{2} << 30;
constexpr std::size_t kNameDigits = 12;

}  // namespace

Result<SketchTranslator> SketchTranslator::Load(const std::string& path) {
  SketchTranslator translator;
  if (path.empty()) return translator;
  LW_ASSIGN_OR_RETURN(const std::string content, ReadFile(path, kMaxModelBytes));
  LW_ASSIGN_OR_RETURN(SketchModel model, SketchModel::Load(path));
  translator.name_ = "onnx-" + Sha256Hex(content).substr(0, kNameDigits);
  translator.model_ = std::make_shared<const SketchModel>(std::move(model));
  return translator;
}

Result<Relief> SketchTranslator::Translate(std::string_view picture, const SketchOptions& options,
                                           const Progress& progress) const {
  return SketchToRelief(picture, options, progress, model_.get());
}

}  // namespace latticeworld
