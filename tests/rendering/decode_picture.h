#ifndef LATTICEWORLD_TESTS_RENDERING_DECODE_PICTURE_H_
#define LATTICEWORLD_TESTS_RENDERING_DECODE_PICTURE_H_

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

inline cv::Mat Decode(const Result<std::string>& png) {
  EXPECT_TRUE(png.ok()) << png.status().ToString();
  const std::vector<unsigned char> bytes(png->begin(), png->end());
  return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_RENDERING_DECODE_PICTURE_H_
