#ifndef LATTICEWORLD_EXPORTING_GLTF_MEDIA_H_
#define LATTICEWORLD_EXPORTING_GLTF_MEDIA_H_

#include <opencv2/core/mat.hpp>
#include <string>

#include "latticeworld/common/result.h"

namespace latticeworld::internal {

// What worlds for other simulators have in common.

// Letters, digits and '_' in the place of all else, for files, models and names.
std::string PlainName(const std::string& name);

// The bytes of a PNG. Errors: INTERNAL.
Result<std::string> EncodePng(const cv::Mat& picture);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_EXPORTING_GLTF_MEDIA_H_
