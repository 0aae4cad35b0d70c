#include "latticeworld/relief/sketch/sketch_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/dnn.hpp>
#include <utility>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/relief/sketch/onnx_check.h"
#include "latticeworld/relief/sketch/onnx_input.h"
#include "latticeworld/relief/sketch/sketch_lines.h"

namespace latticeworld {
namespace {

constexpr int kMinSide = 32;
constexpr int kMaxSide = 4096;
constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
constexpr char kLegal[] =
    "; legal is an input of 1 x 1 x N x N or 1 x 3 x N x N and an output of 1 x 1 x N x N, N from "
    "32 to 4096";

template <typename Side>
std::string ShapeText(const std::vector<Side>& shape) {
  std::vector<std::string> sides;
  for (const Side side : shape) sides.push_back(side == 0 ? "?" : std::to_string(side));
  return sides.empty() ? "no shape" : Join(sides, " x ");
}

// Strokes as the network sees them, (1 x channels x side x side).
cv::Mat InputOf(const Sketch& sketch, int channels) {
  const std::array<int, 4> shape = {1, channels, sketch.rows(), sketch.cols()};
  cv::Mat input(static_cast<int>(shape.size()), shape.data(), CV_32F);
  auto* value = input.ptr<float>();
  for (int k = 0; k < channels; ++k) {
    for (const Stroke stroke : sketch) {
      if (channels == 1) {
        *value++ = stroke == Stroke::kNone ? 0.5f : stroke == Stroke::kRidge ? 1.0f : 0.0f;
      } else {
        // Red, green and blue of a valley: 0, 0, 1.
        *value++ = stroke == Stroke::kNone || (stroke == Stroke::kValley && k == 2) ? 1.0f : 0.0f;
      }
    }
  }
  return input;
}

}  // namespace

struct SketchModel::Network {
  // Errors: INTERNAL.
  Result<cv::Mat> Forward(const cv::Mat& input) {
    const std::lock_guard<std::mutex> lock(mutex);
    try {
      net.setInput(input);
      return cv::Mat(net.forward().clone());
    } catch (const std::exception& error) {
      return Internal("the sketch model fails: " + Quote(error.what(), 400));
    }
  }

  std::mutex mutex;  // OpenCV's network holds its buffers
  cv::dnn::Net net;
  int side = 0;
  int channels = 0;
};

SketchModel::SketchModel(std::unique_ptr<Network> network) : network_(std::move(network)) {}
SketchModel::SketchModel(SketchModel&& other) noexcept = default;
SketchModel& SketchModel::operator=(SketchModel&& other) noexcept = default;
SketchModel::~SketchModel() = default;

int SketchModel::side() const { return network_->side; }
int SketchModel::channels() const { return network_->channels; }

Result<SketchModel> SketchModel::Load(const std::string& path) {
  const std::string name = "sketch model " + Quote(path);
  Result<std::string> bytes = ReadFile(path, kMaxBytes);
  if (!bytes.ok()) return bytes.status().WithContext(name);
  const Result<std::vector<std::int64_t>> input = internal::ReadOnnxInputShape(*bytes);
  if (!input.ok()) return input.status().WithContext(name);
  const std::vector<std::int64_t>& shape = *input;
  const bool legal = shape.size() == 4 && shape[0] == 1 && (shape[1] == 1 || shape[1] == 3) &&
                     shape[2] == shape[3] && shape[2] >= kMinSide && shape[2] <= kMaxSide;
  if (!legal) return InvalidArgument(name + " takes an input of " + ShapeText(shape) + kLegal);
  const Status trusted = internal::CheckOnnxNetwork(*bytes);
  if (!trusted.ok()) return trusted.WithContext(name);
  auto network = std::make_unique<Network>();
  network->channels = static_cast<int>(shape[1]);
  network->side = static_cast<int>(shape[2]);
  try {
    network->net = cv::dnn::readNetFromONNX(bytes->data(), bytes->size());
    if (network->net.empty()) return InvalidArgument(name + " is an empty network");
    network->net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    network->net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
  } catch (const std::exception& error) {
    return InvalidArgument(name +
                           " cannot be read as an ONNX network: " + Quote(error.what(), 400));
  }
  SketchModel model(std::move(network));
  // One run on blank paper tells what comes out.
  const Result<Grid<float>> blank = model.Run(Sketch(model.side(), model.side(), Stroke::kNone));
  if (!blank.ok()) return InvalidArgument(name + ": " + blank.status().message());
  return model;
}

Result<Grid<float>> SketchModel::Run(const Sketch& sketch) const {
  const int side = network_->side;
  const Sketch strokes = internal::ResampleSketch(sketch, side, side);
  LW_ASSIGN_OR_RETURN(const cv::Mat output,
                      network_->Forward(InputOf(strokes, network_->channels)));
  const std::vector<int> shape(output.size.p, output.size.p + output.dims);
  if (output.type() != CV_32F || shape != std::vector<int>{1, 1, side, side}) {
    return Internal("the sketch model gives an output of " + ShapeText(shape) + kLegal);
  }
  Grid<float> height(side, side);
  std::copy(output.ptr<float>(), output.ptr<float>() + height.size(), height.begin());
  if (!std::all_of(height.begin(), height.end(), [](float h) { return std::isfinite(h); })) {
    return Internal("the sketch model gives heights that are not finite");
  }
  return height;
}

}  // namespace latticeworld
