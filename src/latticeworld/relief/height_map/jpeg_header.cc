// JPEG (ITU-T T.81 | ISO/IEC 10918-1), annex B: the order of markers.
#include <string>

#include "latticeworld/relief/height_map/picture_header.h"

namespace latticeworld::internal {
namespace {

enum Marker : int {
  kSof0 = 0xc0,
  kDht = 0xc4,
  kJpgExtension = 0xc8,
  kDac = 0xcc,
  kSof15 = 0xcf,
  kRst0 = 0xd0,
  kRst7 = 0xd7,
  kEoi = 0xd9,
  kSos = 0xda,
};

constexpr int kMostScans = 100;

int Byte(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }
int BigEndian16(std::string_view bytes, std::size_t at) {
  return Byte(bytes, at) << 8 | Byte(bytes, at + 1);
}

bool IsFrame(int marker) {
  return marker >= kSof0 && marker <= kSof15 && marker != kDht && marker != kJpgExtension &&
         marker != kDac;
}

// The next place from `at` on where a marker other than a restart stands in coded data.
std::size_t SkipCodedData(std::string_view bytes, std::size_t at) {
  for (; at + 1 < bytes.size(); ++at) {
    if (Byte(bytes, at) != 0xff) continue;
    const int next = Byte(bytes, at + 1);
    if (next != 0x00 && next != 0xff && (next < kRst0 || next > kRst7)) return at;
  }
  return bytes.size();
}

}  // namespace

Result<PictureHeader> ReadJpegHeader(std::string_view bytes, std::string_view what) {
  const auto cut_off = [what](std::string_view where) {
    return InvalidArgument("the JPEG " + std::string(what) + " is cut off or damaged " +
                           std::string(where) +
                           "; a whole file that ends with its EOI marker is "
                           "needed");
  };
  PictureHeader header;
  header.format = PictureFormat::kJpeg;
  int scans = 0;
  // libjpeg paints what is missing of a cut file grey: walk to its end before it sees it.
  for (std::size_t at = 2; at < bytes.size();) {
    if (Byte(bytes, at) != 0xff) return cut_off("where a marker is due");
    while (at < bytes.size() && Byte(bytes, at) == 0xff) ++at;
    if (at >= bytes.size()) break;
    const int marker = Byte(bytes, at++);
    if (marker == kEoi) {
      if (scans == 0) return cut_off("before its pixel data");
      return header;
    }
    if (bytes.size() - at < 2) break;
    const auto length = static_cast<std::size_t>(BigEndian16(bytes, at));
    if (length < 2 || length > bytes.size() - at) return cut_off("inside a segment");
    if (IsFrame(marker)) {
      constexpr std::size_t kFrameSize = 8;
      if (length < kFrameSize) return cut_off("inside its frame header");
      header.bits = Byte(bytes, at + 2);
      header.height = BigEndian16(bytes, at + 3);
      header.width = BigEndian16(bytes, at + 5);
      LW_RETURN_IF_ERROR(CheckPictureSize(header.width, header.height, what));
    }
    at += length;
    if (marker == kSos) {
      if (header.width == 0) return cut_off("before its frame header");
      // Each scan of a progressive file goes over the whole picture: a few bytes, much work.
      if (++scans > kMostScans) {
        return InvalidArgument("the JPEG " + std::string(what) + " has more than " +
                               std::to_string(kMostScans) + " scans; legal are at most that many");
      }
      at = SkipCodedData(bytes, at);
    }
  }
  return cut_off("before its end");
}

}  // namespace latticeworld::internal
