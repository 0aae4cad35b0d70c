#include "latticeworld/dataset/writing/instance_images.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>
#include <vector>

#include "latticeworld/generation/bundle/raster_files.h"

namespace latticeworld {

Result<std::string> SketchPng(const Sketch& sketch) {
  try {
    cv::Mat picture(sketch.rows(), sketch.cols(), CV_8UC3, cv::Scalar(255, 255, 255));
    for (int r = 0; r < sketch.rows(); ++r) {
      for (int c = 0; c < sketch.cols(); ++c) {
        // Blue, green, red.
        if (sketch(r, c) == Stroke::kValley) picture.at<cv::Vec3b>(r, c) = {255, 0, 0};
        if (sketch(r, c) == Stroke::kRidge) picture.at<cv::Vec3b>(r, c) = {0, 0, 0};
      }
    }
    std::vector<unsigned char> bytes;
    if (!cv::imencode(".png", picture, bytes)) return Internal("cannot encode a sketch as PNG");
    return std::string(bytes.begin(), bytes.end());
  } catch (const cv::Exception& error) {
    return Internal(std::string("cannot encode a sketch as PNG: ") + error.what());
  }
}

Result<InstanceImages> DrawImages(const Grid<float>& height_m, double sketch_share) {
  InstanceImages images;
  LW_ASSIGN_OR_RETURN(HeightPng heights, EncodeHeights(height_m));
  images.height_png = std::move(heights.png);
  images.height_scale_m = heights.scale_m;
  images.height_offset_m = heights.offset_m;
  LW_ASSIGN_OR_RETURN(images.sketch_png, SketchPng(DrawSketch(height_m, sketch_share)));
  return images;
}

}  // namespace latticeworld
