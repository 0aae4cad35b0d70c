#ifndef LATTICEWORLD_TESTS_RELIEF_SKETCH_PICTURES_H_
#define LATTICEWORLD_TESTS_RELIEF_SKETCH_PICTURES_H_

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {

// A drawn sketch and what a person would say each pixel of it is.
struct DrawnSketch {
  cv::Mat picture;  // CV_8UC3, blue, green, red
  Sketch strokes;
};

struct Inks {
  cv::Scalar valley{230, 60, 20};  // blue, green, red
  cv::Scalar ridge{20, 20, 20};
  int thickness = 3;  // [pixels]
};

// Two rivers that join, with side valleys, and ridges between them, on white.
DrawnSketch DrawRiversAndRidges(int rows, int cols, const Inks& inks);

std::string EncodePicture(const std::string& extension, const cv::Mat& picture,
                          const std::vector<int>& parameters = {});

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_RELIEF_SKETCH_PICTURES_H_
