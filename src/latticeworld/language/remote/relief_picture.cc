#include "latticeworld/language/remote/relief_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace latticeworld {

Result<std::string> ReliefPicture(const Grid<float>& height_m) {
  const int longer = std::max(height_m.rows(), height_m.cols());
  const double shrink = std::min(1.0, static_cast<double>(kMaxReliefPictureSide) / longer);
  const auto side = [shrink](int samples) {
    return std::max(1, static_cast<int>(std::lround(samples * shrink)));
  };
  try {
    // OpenCV knows no constant images; this one is only read.
    const cv::Mat heights(height_m.rows(), height_m.cols(), CV_32F,
                          const_cast<float*>(height_m.data()));
    cv::Mat small;
    cv::resize(heights, small, cv::Size(side(height_m.cols()), side(height_m.rows())), 0.0, 0.0,
               cv::INTER_AREA);
    double low = 0.0;
    double high = 0.0;
    cv::minMaxLoc(small, &low, &high);
    const double scale = high > low ? 255.0 / (high - low) : 0.0;
    cv::Mat grey;
    small.convertTo(grey, CV_8U, scale, -low * scale);
    std::vector<unsigned char> bytes;
    cv::imencode(".png", grey, bytes);
    return std::string(bytes.begin(), bytes.end());
  } catch (const cv::Exception& exception) {
    return Internal(std::string("cannot draw the relief for the model: ") + exception.what());
  }
}

}  // namespace latticeworld
