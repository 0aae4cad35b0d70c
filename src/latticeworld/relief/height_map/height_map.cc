#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/relief/height_map/middle_square.h"
#include "latticeworld/relief/height_map/pgm.h"
#include "latticeworld/relief/height_map/picture_header.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {
namespace {

struct Picture {
  Grid<float> values;
  int max_value = 0;  // 255, 65535, or a PGM's maxval
};

template <typename Sample>
Grid<float> ToGrid(const cv::Mat& image) {
  Grid<float> values(image.rows, image.cols);
  for (int r = 0; r < image.rows; ++r) {
    const Sample* source = image.ptr<Sample>(r);
    float* target = values.row(r);
    for (int c = 0; c < image.cols; ++c) target[c] = static_cast<float>(source[c]);
  }
  return values;
}

// Errors: INVALID_ARGUMENT when OpenCV cannot decode what the header promised.
Result<Picture> DecodeWithOpenCv(std::string_view bytes, const internal::PictureHeader& header) {
  try {
    // imdecode only reads; its interface has no const buffer.
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<char*>(bytes.data()));
    const cv::Mat image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    const int expected_type = header.bits == 8 ? CV_8UC1 : CV_16UC1;
    if (image.empty() || image.cols != header.width || image.rows != header.height ||
        image.type() != expected_type) {
      return InvalidArgument("the height map's pixels cannot be decoded: its data is damaged");
    }
    if (header.bits == 8) return Picture{ToGrid<std::uint8_t>(image), 255};
    return Picture{ToGrid<std::uint16_t>(image), 65535};
  } catch (const cv::Exception& error) {
    return InvalidArgument("the height map's pixels cannot be decoded: " + std::string(error.err));
  }
}

Result<Picture> Decode(std::string_view bytes) {
  LW_ASSIGN_OR_RETURN(const internal::PictureHeader header, internal::ReadPictureHeader(bytes));
  if (header.format != internal::PictureFormat::kPgm) return DecodeWithOpenCv(bytes, header);
  LW_ASSIGN_OR_RETURN(internal::PgmPicture pgm, internal::DecodePgm(bytes));
  return Picture{std::move(pgm.values), pgm.max_value};
}

// Errors: as ReadHeightMap.
Result<Picture> CheckAndDecode(std::string_view bytes, const HeightMapOptions& options) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal height map options", Validate(options)));
  // OpenCV counts the bytes of its input in an int; the largest legal picture takes 129 MiB raw.
  constexpr std::size_t kMaxBytes = std::size_t{512} << 20;
  if (bytes.size() > kMaxBytes) {
    return InvalidArgument("the height map takes " + std::to_string(bytes.size()) +
                           " bytes; legal are at most " + std::to_string(kMaxBytes));
  }
  return Decode(bytes);
}

Relief ReliefOf(Picture picture, const HeightMapOptions& options) {
  const double step_m = options.height_scale_m / picture.max_value;
  for (float& value : picture.values) {
    value = static_cast<float>(options.height_offset_m + step_m * value);
  }
  return MakeRelief(std::move(picture.values), step_m);
}

}  // namespace

Result<Relief> ReadHeightMap(std::string_view bytes, const HeightMapOptions& options) {
  LW_ASSIGN_OR_RETURN(Picture picture, CheckAndDecode(bytes, options));
  const internal::MiddleSquare square(picture.values.rows(), picture.values.cols());
  if (!square.cuts()) return ReliefOf(std::move(picture), options);
  picture.values = CutOut(square, picture.values);
  Relief relief = ReliefOf(std::move(picture), options);
  relief.warnings.push_back(CutWarning(square, "height map"));
  return relief;
}

Result<Relief> ReadWholeHeightMap(std::string_view bytes, const HeightMapOptions& options) {
  LW_ASSIGN_OR_RETURN(Picture picture, CheckAndDecode(bytes, options));
  return ReliefOf(std::move(picture), options);
}

}  // namespace latticeworld
