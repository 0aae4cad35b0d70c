#ifndef LATTICEWORLD_RENDERING_PICTURE_ENCODING_H_
#define LATTICEWORLD_RENDERING_PICTURE_ENCODING_H_

#include <opencv2/core/mat.hpp>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/rendering/picture.h"

namespace latticeworld {

// Errors: INVALID_ARGUMENT naming what is out of its range.
Status Validate(const PictureOptions& options);

// A supersampled picture (CV_8UC3) at its final size.
cv::Mat Averaged(const cv::Mat& supersampled);

// Errors: INTERNAL.
Result<std::string> EncodePng(const cv::Mat& picture, const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_PICTURE_ENCODING_H_
