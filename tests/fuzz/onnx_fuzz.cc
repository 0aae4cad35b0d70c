// ONNX networks that draw land from sketches: what we check before OpenCV sees it, and OpenCV.

#include "fuzz/fuzz_target.h"
#include "latticeworld/relief/sketch/onnx_check.h"
#include "latticeworld/relief/sketch/onnx_input.h"
#include "latticeworld/relief/sketch/sketch_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = latticeworld::fuzz::TextOf(data, size);
  (void)latticeworld::internal::ReadOnnxInputShape(bytes);
  if (!latticeworld::internal::CheckOnnxNetwork(bytes).ok()) return 0;
  const latticeworld::fuzz::InputFile file(bytes);
  (void)latticeworld::SketchModel::Load(file.path());
  return 0;
}
