#ifndef LATTICEWORLD_RELIEF_SKETCH_ONNX_CHECK_H_
#define LATTICEWORLD_RELIEF_SKETCH_ONNX_CHECK_H_

#include <string_view>

#include "latticeworld/common/status.h"

namespace latticeworld::internal {

// Checks what OpenCV takes on trust when it reads an ONNX network, and crashes where it is not so:
// that constants have as many values as their shapes say; that nodes take, of what they need, what
// is there before them; that windows, strides, dilations, groups and margins are sizes. Errors:
// INVALID_ARGUMENT saying which is not.
Status CheckOnnxNetwork(std::string_view bytes);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_ONNX_CHECK_H_
