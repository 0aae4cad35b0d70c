#ifndef LATTICEWORLD_TESTS_FUZZ_SUPPORT_PICTURE_READING_H_
#define LATTICEWORLD_TESTS_FUZZ_SUPPORT_PICTURE_READING_H_

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fuzz/fuzz_target.h"
#include "latticeworld/relief/height_map/colour_picture.h"
#include "latticeworld/relief/height_map/picture_header.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld::fuzz {

// Pixels of pictures beyond this side are not decoded: they take other time, and no other way.
constexpr std::int64_t kMostPictureSide = 160;

inline bool IsSmall(const Result<internal::PictureHeader>& header) {
  return header.ok() && std::max(header->width, header->height) <= kMostPictureSide;
}

// Reads bytes as a height map and as a sketch: the header, and the pixels of a small one.
inline void ReadAsPictures(std::string_view bytes) {
  if (IsSmall(internal::ReadPictureHeader(bytes))) {
    const auto relief = ReadHeightMap(bytes, HeightMapOptions());
    if (relief.ok()) {
      Expect(std::all_of(relief->height_m.begin(), relief->height_m.end(),
                         [](float height_m) { return std::isfinite(height_m); }),
             "heights of a height map are finite");
    }
  }
  if (IsSmall(internal::ReadColourPictureHeader(bytes, "sketch"))) {
    (void)internal::ReadColourPicture(bytes, "sketch");
  }
}

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_SUPPORT_PICTURE_READING_H_
