#include "latticeworld/relief/height_map/colour_picture.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/height_map/picture_header.h"

namespace latticeworld::internal {
namespace {

// A scanned A4 page in 600 dots an inch takes 105 MB raw; OpenCV counts bytes in an int.
constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

// One row of 1, 3 or 4 channels in OpenCV's order (grey; blue, green, red; the same and alpha).
template <typename Sample>
void ConvertRow(const Sample* source, int channels, int cols, int shift, Rgb* target) {
  constexpr int kOpaque = 255;
  for (int c = 0; c < cols; ++c, source += channels) {
    const auto sample = [source, shift](int i) { return static_cast<int>(source[i]) >> shift; };
    const int alpha = channels == 4 ? sample(3) : kOpaque;
    for (int i = 0; i < 3; ++i) {
      const int colour = sample(channels == 1 ? 0 : 2 - i);
      const int on_white = kOpaque + ((colour - kOpaque) * alpha - kOpaque / 2) / kOpaque;
      target[c][i] = static_cast<std::uint8_t>(on_white);
    }
  }
}

Result<Grid<Rgb>> Convert(const cv::Mat& image, std::string_view what) {
  const int channels = image.channels();
  const bool wide = image.depth() == CV_16U;
  if ((image.depth() != CV_8U && !wide) || (channels != 1 && channels != 3 && channels != 4)) {
    return InvalidArgument("the " + std::string(what) + " has " + std::to_string(channels) +
                           " channels of a depth that is not 8 or 16 bits; legal are grey, colour "
                           "and alpha of 8 or 16 bits");
  }
  Grid<Rgb> picture(image.rows, image.cols);
  for (int r = 0; r < image.rows; ++r) {
    if (wide) {
      ConvertRow(image.ptr<std::uint16_t>(r), channels, image.cols, 8, picture.row(r));
    } else {
      ConvertRow(image.ptr<std::uint8_t>(r), channels, image.cols, 0, picture.row(r));
    }
  }
  return picture;
}

}  // namespace

Result<PictureHeader> ReadColourPictureHeader(std::string_view bytes, std::string_view what) {
  using namespace std::string_view_literals;
  if (bytes.size() > kMaxBytes) {
    return InvalidArgument("the " + std::string(what) + " takes " + std::to_string(bytes.size()) +
                           " bytes; legal are at most " + std::to_string(kMaxBytes));
  }
  if (StartsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) return ReadColourPngHeader(bytes, what);
  if (StartsWith(bytes, "\xff\xd8\xff"sv)) return ReadJpegHeader(bytes, what);
  if (StartsWith(bytes, "II*\0"sv) || StartsWith(bytes, "MM\0*"sv)) {
    return ReadColourTiffHeader(bytes, what);
  }
  return InvalidArgument("the " + std::string(what) + " is " + DescribeFile(bytes) +
                         "; legal are PNG, JPEG and TIFF");
}

Result<Grid<Rgb>> ReadColourPicture(std::string_view bytes, std::string_view what) {
  LW_ASSIGN_OR_RETURN(const PictureHeader header, ReadColourPictureHeader(bytes, what));
  const std::string damaged = "the " + std::string(what) +
                              "'s pixels cannot be decoded: its data is damaged, or of a kind "
                              "that is not supported";
  try {
    // imdecode only reads; its interface has no const buffer. A JPEG has no alpha and no depth to
    // keep, and only when asked for colours does OpenCV turn it as its EXIF says.
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<char*>(bytes.data()));
    const cv::Mat image = cv::imdecode(
        buffer, header.format == PictureFormat::kJpeg ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED);
    const bool as_announced = image.cols == header.width && image.rows == header.height;
    const bool turned = image.cols == header.height && image.rows == header.width;
    if (image.empty() || (!as_announced && !turned)) return InvalidArgument(damaged);
    return Convert(image, what);
  } catch (const cv::Exception& error) {
    return InvalidArgument(damaged + " (" + Quote(error.err) + ")");
  }
}

}  // namespace latticeworld::internal
