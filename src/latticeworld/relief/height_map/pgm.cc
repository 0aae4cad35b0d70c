// Portable greymap, as the Netpbm project describes it (pgm(5)).
#include "latticeworld/relief/height_map/pgm.h"

#include <cctype>
#include <cstdint>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/height_map/picture_header.h"

namespace latticeworld::internal {
namespace {

constexpr int kMaxValue = 65535;
constexpr std::int64_t kTooLarge = 1000000000;  // numbers stop growing here

// Reads the numbers of a greymap, which white space and comments part.
class Reader {
 public:
  Reader(std::string_view bytes, std::size_t position) : bytes_(bytes), position_(position) {}

  std::size_t position() const { return position_; }

  // The next number; -1 when there is none.
  std::int64_t Next() {
    bool in_comment = false;
    for (; position_ < bytes_.size(); ++position_) {
      const char c = bytes_[position_];
      if (in_comment) {
        in_comment = c != '\n' && c != '\r';
      } else if (c == '#') {
        in_comment = true;
      } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
        break;
      }
    }
    if (position_ >= bytes_.size() || !IsDigit(bytes_[position_])) return -1;
    std::int64_t value = 0;
    for (; position_ < bytes_.size() && IsDigit(bytes_[position_]); ++position_) {
      if (value < kTooLarge) value = value * 10 + (bytes_[position_] - '0');
    }
    return value;
  }

 private:
  static bool IsDigit(char c) { return c >= '0' && c <= '9'; }

  std::string_view bytes_;
  std::size_t position_;
};

struct PgmHeader {
  std::int64_t width = -1;
  std::int64_t height = -1;
  std::int64_t max_value = -1;
  bool plain = false;
  std::size_t data = 0;  // where the samples begin
};

PgmHeader ParsePgmHeader(std::string_view bytes) {
  Reader reader(bytes, 2);
  PgmHeader header;
  header.plain = bytes[1] == '2';
  header.width = reader.Next();
  header.height = reader.Next();
  header.max_value = reader.Next();
  header.data = reader.position() + 1;  // one white space after maxval
  return header;
}

int BytesPerSample(const PgmHeader& header) { return header.max_value > 255 ? 2 : 1; }

}  // namespace

Result<PictureHeader> ReadPgmHeader(std::string_view bytes) {
  const PgmHeader pgm = ParsePgmHeader(bytes);
  if (pgm.width < 0 || pgm.height < 0 || pgm.max_value < 0) {
    return InvalidArgument(
        "the header of the PGM height map is cut off or damaged; legal is \"P5\" or \"P2\", then "
        "width, height and maxval in decimal digits");
  }
  LW_RETURN_IF_ERROR(CheckPictureSize(pgm.width, pgm.height, "height map"));
  if (pgm.max_value < 1 || pgm.max_value > kMaxValue) {
    return InvalidArgument("the maxval of the PGM height map is " + std::to_string(pgm.max_value) +
                           "; legal are 1 to 65535");
  }
  const std::int64_t samples = pgm.width * pgm.height;
  const auto available =
      static_cast<std::int64_t>(bytes.size()) - static_cast<std::int64_t>(pgm.data);
  // A plain sample takes a digit and, but for the last, a white space.
  const std::int64_t needed = pgm.plain ? 2 * samples - 1 : samples * BytesPerSample(pgm);
  if (available < needed) {
    return InvalidArgument("the PGM height map is cut off: " + std::to_string(pgm.width) + " x " +
                           std::to_string(pgm.height) + " samples take at least " +
                           std::to_string(needed) + " bytes after the header, not " +
                           std::to_string(available < 0 ? 0 : available));
  }
  PictureHeader header;
  header.format = PictureFormat::kPgm;
  header.width = pgm.width;
  header.height = pgm.height;
  header.bits = 8 * BytesPerSample(pgm);
  return header;
}

Result<PgmPicture> DecodePgm(std::string_view bytes) {
  const PgmHeader header = ParsePgmHeader(bytes);
  PgmPicture picture;
  picture.max_value = static_cast<int>(header.max_value);
  picture.values = Grid<float>(static_cast<int>(header.height), static_cast<int>(header.width));
  Reader reader(bytes, header.data);
  const char* data = bytes.data() + header.data;
  const bool wide = BytesPerSample(header) == 2;
  std::int64_t index = 0;
  for (float& sample : picture.values) {
    std::int64_t value;
    if (header.plain) {
      value = reader.Next();
    } else if (wide) {
      value = static_cast<unsigned char>(data[2 * index]) << 8 |
              static_cast<unsigned char>(data[2 * index + 1]);
    } else {
      value = static_cast<unsigned char>(data[index]);
    }
    if (value < 0 || value > header.max_value) {
      return InvalidArgument("sample " + std::to_string(index + 1) + " of the PGM height map is " +
                             (value < 0 ? "missing or no number" : std::to_string(value)) +
                             "; legal are 0 to its " + "maxval " +
                             std::to_string(header.max_value));
    }
    sample = static_cast<float>(value);
    ++index;
  }
  return picture;
}

}  // namespace latticeworld::internal
