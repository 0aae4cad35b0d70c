#ifndef LATTICEWORLD_RELIEF_SKETCH_ONNX_INPUT_H_
#define LATTICEWORLD_RELIEF_SKETCH_ONNX_INPUT_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld::internal {

// The shape of the only input of an ONNX network as its file says it, 0 for a side that it leaves
// open. OpenCV reads networks, but not what they want to be fed. Errors: INVALID_ARGUMENT (not a
// network in protocol buffers; no or several inputs).
Result<std::vector<std::int64_t>> ReadOnnxInputShape(std::string_view bytes);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_ONNX_INPUT_H_
