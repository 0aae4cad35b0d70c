// TIFF revision 6.0 (Adobe, 1992): the first image file directory.
#include <algorithm>
#include <string>
#include <vector>

#include "latticeworld/relief/height_map/picture_header.h"

namespace latticeworld::internal {
namespace {

enum Tag : std::uint32_t {
  kImageWidth = 256,
  kImageLength = 257,
  kBitsPerSample = 258,
  kCompression = 259,
  kPhotometric = 262,
  kStripOffsets = 273,
  kSamplesPerPixel = 277,
  kRowsPerStrip = 278,
  kStripByteCounts = 279,
  kTileWidth = 322,
  kTileLength = 323,
  kTileOffsets = 324,
  kTileByteCounts = 325,
  kSampleFormat = 339,
};
constexpr std::uint32_t kShort = 3;
constexpr std::uint32_t kLong = 4;
constexpr std::size_t kEntrySize = 12;
constexpr std::uint32_t kUncompressed = 1;

Status CutOff(std::string_view what, const std::string& where) {
  return InvalidArgument("the TIFF " + std::string(what) + " is cut off or damaged: " + where);
}

// Integers of a TIFF file in its own byte order; reading outside gives 0 and remembers it.
class Tiff {
 public:
  explicit Tiff(std::string_view bytes) : bytes_(bytes), big_endian_(bytes[0] == 'M') {}

  bool Has(std::uint64_t at, std::uint64_t size) const {
    return at <= bytes_.size() && size <= bytes_.size() - at;
  }
  std::uint32_t Read(std::uint64_t at, int size) const {
    if (!Has(at, size)) return 0;
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) {
      const int index = big_endian_ ? i : size - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes_[at + index]);
    }
    return value;
  }

 private:
  std::string_view bytes_;
  bool big_endian_;
};

// The fields of the first directory.
class Directory {
 public:
  static Result<Directory> Read(const Tiff& tiff, std::string_view what) {
    Directory directory(tiff);
    directory.begin_ = tiff.Read(4, 4);
    if (!tiff.Has(directory.begin_, 2)) return CutOff(what, "its directory lies outside the file");
    directory.count_ = tiff.Read(directory.begin_, 2);
    if (!tiff.Has(directory.begin_ + 2, directory.count_ * kEntrySize)) {
      return CutOff(what, "its directory lies outside the file");
    }
    return directory;
  }

  // The values of a SHORT or LONG field; empty when it is absent, of another type, or not in the
  // file.
  std::vector<std::uint32_t> Values(Tag tag) const {
    for (std::uint64_t i = 0; i < count_; ++i) {
      const std::uint64_t entry = begin_ + 2 + i * kEntrySize;
      if (tiff_.Read(entry, 2) != tag) continue;
      const std::uint32_t type = tiff_.Read(entry + 2, 2);
      const std::uint64_t count = tiff_.Read(entry + 4, 4);
      if (type != kShort && type != kLong) return {};
      const int size = type == kShort ? 2 : 4;
      const std::uint64_t at = count * size <= 4 ? entry + 8 : tiff_.Read(entry + 8, 4);
      if (!tiff_.Has(at, count * size)) return {};
      std::vector<std::uint32_t> values(count);
      for (std::uint64_t k = 0; k < count; ++k) values[k] = tiff_.Read(at + k * size, size);
      return values;
    }
    return {};
  }
  std::uint32_t Value(Tag tag, std::uint32_t absent) const {
    const std::vector<std::uint32_t> values = Values(tag);
    return values.empty() ? absent : values.front();
  }

 private:
  explicit Directory(const Tiff& tiff) : tiff_(tiff) {}

  Tiff tiff_;
  std::uint64_t begin_ = 0;
  std::uint64_t count_ = 0;
};

std::uint64_t CeilDivide(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

// Every strip or tile that the size asks for is announced and lies inside the file. pixel_bits: of
// all samples of a pixel together.
Status CheckPieces(const Tiff& tiff, const Directory& directory, const PictureHeader& header,
                   std::uint64_t pixel_bits, std::string_view what) {
  const bool tiled = !directory.Values(kTileOffsets).empty();
  const auto width = static_cast<std::uint64_t>(header.width);
  const auto height = static_cast<std::uint64_t>(header.height);
  // The number of tiles or strips follows from the size.
  std::uint64_t needed;
  std::uint64_t bytes_a_piece;
  if (tiled) {
    const std::uint64_t tile_width = directory.Value(kTileWidth, 0);
    const std::uint64_t tile_height = directory.Value(kTileLength, 0);
    // Tiles beyond this would let a small file ask for much memory.
    constexpr std::uint64_t kMaxTile = 16384;
    if (tile_width == 0 || tile_height == 0 || tile_width > kMaxTile || tile_height > kMaxTile) {
      return CutOff(what, "its tiles are " + std::to_string(tile_width) + " x " +
                              std::to_string(tile_height) +
                              " samples; legal are 1 to 16384 a side");
    }
    needed = CeilDivide(width, tile_width) * CeilDivide(height, tile_height);
    bytes_a_piece = tile_width * tile_height * pixel_bits / 8;
  } else {
    const std::uint64_t rows =
        std::clamp<std::uint64_t>(directory.Value(kRowsPerStrip, 0xffffffffu), 1, height);
    needed = CeilDivide(height, rows);
    bytes_a_piece = 0;  // strips differ: the last one is shorter
  }
  // As many must be announced.
  const std::vector<std::uint32_t> offsets = directory.Values(tiled ? kTileOffsets : kStripOffsets);
  const std::vector<std::uint32_t> sizes =
      directory.Values(tiled ? kTileByteCounts : kStripByteCounts);
  const char* const pieces = tiled ? " tiles" : " strips";
  if (offsets.size() < needed || sizes.size() < needed) {
    return CutOff(what, std::to_string(needed) + pieces + " are needed, " +
                            std::to_string(std::min(offsets.size(), sizes.size())) + " are there");
  }
  // Each lies in the file, and together they hold all samples if these are not compressed.
  std::uint64_t total = 0;
  for (std::uint64_t i = 0; i < needed; ++i) {
    if (sizes[i] == 0 || !tiff.Has(offsets[i], sizes[i])) {
      return CutOff(what, "piece " + std::to_string(i + 1) + " of its " + std::to_string(needed) +
                              pieces + " lies outside the file");
    }
    total += sizes[i];
  }
  const std::uint64_t raw = tiled ? needed * bytes_a_piece : width * height * pixel_bits / 8;
  if (directory.Value(kCompression, kUncompressed) == kUncompressed && total < raw) {
    return CutOff(what, "its samples take " + std::to_string(raw) + " bytes, " +
                            std::to_string(total) + " are there");
  }
  return Status();
}

constexpr std::size_t kFileHeaderSize = 8;

// Width and height of the first picture.
Result<PictureHeader> ReadSize(const Directory& directory, std::string_view what) {
  PictureHeader header;
  header.format = PictureFormat::kTiff;
  header.width = directory.Value(kImageWidth, 0);
  header.height = directory.Value(kImageLength, 0);
  LW_RETURN_IF_ERROR(CheckPictureSize(header.width, header.height, what));
  return header;
}

}  // namespace

Result<PictureHeader> ReadColourTiffHeader(std::string_view bytes, std::string_view what) {
  if (bytes.size() < kFileHeaderSize) return CutOff(what, "it ends inside its header");
  const Tiff tiff(bytes);
  LW_ASSIGN_OR_RETURN(const Directory directory, Directory::Read(tiff, what));
  LW_ASSIGN_OR_RETURN(PictureHeader header, ReadSize(directory, what));
  constexpr std::uint32_t kFloat = 3;
  const std::uint32_t bits = directory.Value(kBitsPerSample, 1);
  const std::uint32_t samples = directory.Value(kSamplesPerPixel, 1);
  const std::uint32_t sample_format = directory.Value(kSampleFormat, 1);
  if (samples < 1 || samples > 5 || bits < 1 || bits > 16 || sample_format == kFloat) {
    return InvalidArgument("the TIFF " + std::string(what) + " has " + std::to_string(samples) +
                           " sample(s) a pixel of " + std::to_string(bits) +
                           " bits, sample format " + std::to_string(sample_format) +
                           "; legal are 1 to 5 samples of 1 to 16 bits, not floating point");
  }
  header.bits = static_cast<int>(bits);
  LW_RETURN_IF_ERROR(CheckPieces(tiff, directory, header, bits, what));
  return header;
}

Result<PictureHeader> ReadTiffHeader(std::string_view bytes) {
  constexpr std::string_view kWhat = "height map";
  if (bytes.size() < kFileHeaderSize) return CutOff(kWhat, "it ends inside its header");
  const Tiff tiff(bytes);
  LW_ASSIGN_OR_RETURN(const Directory directory, Directory::Read(tiff, kWhat));
  LW_ASSIGN_OR_RETURN(PictureHeader header, ReadSize(directory, kWhat));
  const std::uint32_t bits = directory.Value(kBitsPerSample, 1);
  const std::uint32_t samples = directory.Value(kSamplesPerPixel, 1);
  const std::uint32_t photometric = directory.Value(kPhotometric, 1);
  const std::uint32_t sample_format = directory.Value(kSampleFormat, 1);
  if (samples != 1 || photometric != 1 || sample_format != 1 || (bits != 8 && bits != 16)) {
    return InvalidArgument(
        "the TIFF height map has " + std::to_string(samples) + " sample(s) a pixel of " +
        std::to_string(bits) + " bits, photometric interpretation " + std::to_string(photometric) +
        ", sample format " + std::to_string(sample_format) +
        "; legal is greyscale: 1 sample of 8 or 16 bits, photometric interpretation 1 (black is "
        "zero), sample format 1 (unsigned)");
  }
  header.bits = static_cast<int>(bits);
  LW_RETURN_IF_ERROR(CheckPieces(tiff, directory, header, bits, kWhat));
  return header;
}

}  // namespace latticeworld::internal
