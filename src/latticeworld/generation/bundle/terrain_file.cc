#include "latticeworld/generation/bundle/terrain_file.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::string_view kMagic = "LWTERR2\n";
constexpr float kMaxHeight_m = 100000.0f;  // far above every legal relief
constexpr int kCompressionLevel = 1;

template <typename Integer>
void AppendInteger(Integer value, std::string* out) {
  for (std::size_t i = 0; i < sizeof(Integer); ++i) {
    out->push_back(static_cast<char>((value >> (8 * i)) & 0xff));
  }
}

// The cells as planes of bytes, least significant first: independent of the machine's byte order.
std::string ToPlanes(const Grid<float>& grid) {
  const std::size_t cells = grid.size();
  std::string planes(4 * cells, '\0');
  for (std::size_t i = 0; i < cells; ++i) {
    std::uint32_t bits;
    std::memcpy(&bits, grid.data() + i, sizeof(bits));
    for (int plane = 0; plane < 4; ++plane) {
      planes[plane * cells + i] = static_cast<char>((bits >> (8 * plane)) & 0xff);
    }
  }
  return planes;
}

void FromPlanes(const std::string& planes, Grid<float>* grid) {
  const std::size_t cells = grid->size();
  for (std::size_t i = 0; i < cells; ++i) {
    std::uint32_t bits = 0;
    for (int plane = 0; plane < 4; ++plane) {
      bits |= std::uint32_t{static_cast<unsigned char>(planes[plane * cells + i])} << (8 * plane);
    }
    std::memcpy(grid->data() + i, &bits, sizeof(bits));
  }
}

Status AppendCompressed(const void* bytes, std::size_t size, std::string* out) {
  std::string compressed(compressBound(size), '\0');
  uLongf length = compressed.size();
  if (compress2(reinterpret_cast<Bytef*>(compressed.data()), &length,
                static_cast<const Bytef*>(bytes), size, kCompressionLevel) != Z_OK) {
    return Internal("zlib cannot compress a grid");
  }
  AppendInteger(static_cast<std::uint64_t>(length), out);
  out->append(compressed, 0, length);
  return Status();
}

Status AppendGrid(const Grid<float>& grid, std::string* out) {
  const std::string planes = ToPlanes(grid);
  return AppendCompressed(planes.data(), planes.size(), out);
}

// Reads front to back and never past the end.
class Reader {
 public:
  explicit Reader(std::string_view content) : left_(content) {}

  bool ReadBytes(std::size_t count, std::string_view* bytes) {
    if (count > left_.size()) return false;
    *bytes = left_.substr(0, count);
    left_.remove_prefix(count);
    return true;
  }
  template <typename Integer>
  bool ReadInteger(Integer* value) {
    std::string_view bytes;
    if (!ReadBytes(sizeof(Integer), &bytes)) return false;
    *value = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      *value |= static_cast<Integer>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    }
    return true;
  }
  bool AtEnd() const { return left_.empty(); }

 private:
  std::string_view left_;
};

// The next zlib stream, which must hold exactly `size` bytes: a stream that would unpack to more
// than a grid costs no memory.
Result<std::string> ReadCompressed(Reader* reader, std::size_t size, const std::string& what) {
  std::uint64_t length = 0;
  std::string_view compressed;
  if (!reader->ReadInteger(&length) || !reader->ReadBytes(length, &compressed)) {
    return DataLoss("is cut within the " + what);
  }
  std::string bytes(size, '\0');
  uLongf unpacked = size;
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &unpacked,
                 reinterpret_cast<const Bytef*>(compressed.data()), compressed.size()) != Z_OK ||
      unpacked != size) {
    return DataLoss("the " + what + " does not unpack to " + std::to_string(size) + " bytes");
  }
  return bytes;
}

template <typename Legal>  // a predicate of float
Result<Grid<float>> ReadGrid(Reader* reader, const GridGeometry& geometry, const std::string& what,
                             const std::string& legal_text, Legal&& legal) {
  Grid<float> grid(geometry.rows(), geometry.cols());
  LW_ASSIGN_OR_RETURN(const std::string planes, ReadCompressed(reader, 4 * grid.size(), what));
  FromPlanes(planes, &grid);
  const auto bad = std::find_if_not(grid.begin(), grid.end(), legal);
  if (bad != grid.end()) {
    return DataLoss("the " + what + " of cell " + std::to_string(bad - grid.begin()) + " is " +
                    FormatDouble(*bad) + "; " + legal_text);
  }
  return grid;
}

Status ReadHeader(Reader* reader, const GridGeometry& geometry, Vocabulary vocabulary,
                  std::string_view* letters) {
  std::string_view magic;
  if (!reader->ReadBytes(kMagic.size(), &magic) || magic != kMagic) {
    return DataLoss("does not begin as a terrain file does");
  }
  std::uint32_t rows = 0, cols = 0, classes = 0;
  if (!reader->ReadInteger(&rows) || !reader->ReadInteger(&cols) ||
      !reader->ReadInteger(&classes) || !reader->ReadBytes(classes, letters)) {
    return DataLoss("is cut within its header");
  }
  const std::uint32_t cells = static_cast<std::uint32_t>(geometry.rows());
  if (rows != cells || cols != cells) {
    return DataLoss("has " + std::to_string(rows) + " x " + std::to_string(cols) +
                    " cells; the world has " + std::to_string(cells) + " x " +
                    std::to_string(cells));
  }
  char last = '\0';
  for (const char letter : *letters) {
    if (FindClass(vocabulary, letter) == nullptr || letter <= last) {
      return DataLoss("has the classes " + Quote(*letters) + "; legal are letters of " +
                      std::string(LegalLetters(vocabulary)) + " in alphabetical order");
    }
    last = letter;
  }
  return Status();
}

Result<Grid<SurfaceClass>> ReadSurface(Reader* reader, const GridGeometry& geometry) {
  constexpr std::size_t kSurfaces = EnumNames(SurfaceClass{}).size();
  Grid<SurfaceClass> surface(geometry.rows(), geometry.cols());
  LW_ASSIGN_OR_RETURN(const std::string bytes,
                      ReadCompressed(reader, surface.size(), "surface classes"));
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const auto value = static_cast<unsigned char>(bytes[i]);
    if (value >= kSurfaces) {
      return DataLoss("the surface class of cell " + std::to_string(i) + " is " +
                      std::to_string(value) + "; legal are 0 to " + std::to_string(kSurfaces - 1));
    }
    surface.data()[i] = static_cast<SurfaceClass>(value);
  }
  return surface;
}

}  // namespace

Result<std::string> EncodeTerrain(const Terrain& terrain) {
  static_assert(sizeof(SurfaceClass) == 1, "a surface class is stored as one byte");
  std::string content(kMagic);
  AppendInteger(static_cast<std::uint32_t>(terrain.geometry().rows()), &content);
  AppendInteger(static_cast<std::uint32_t>(terrain.geometry().cols()), &content);
  AppendInteger(static_cast<std::uint32_t>(terrain.weights.classes.size()), &content);
  for (const ClassWeight& entry : terrain.weights.classes) content.push_back(entry.letter);
  LW_RETURN_IF_ERROR(AppendGrid(terrain.ground.height_m(), &content));
  LW_RETURN_IF_ERROR(AppendGrid(terrain.water_level_m, &content));
  LW_RETURN_IF_ERROR(AppendCompressed(terrain.surface.data(), terrain.surface.size(), &content));
  for (const ClassWeight& entry : terrain.weights.classes) {
    LW_RETURN_IF_ERROR(
        AppendCompressed(entry.weight.levels().data(), entry.weight.size(), &content));
  }
  return content;
}

Result<Terrain> DecodeTerrain(std::string_view content, const GridGeometry& geometry,
                              Vocabulary vocabulary) {
  Reader reader(content);
  std::string_view letters;
  LW_RETURN_IF_ERROR(ReadHeader(&reader, geometry, vocabulary, &letters));
  const auto is_height = [](float height) { return std::abs(height) <= kMaxHeight_m; };
  const std::string height_text =
      "legal are heights from -" + FormatDouble(kMaxHeight_m) + " to " + FormatDouble(kMaxHeight_m);
  Terrain terrain;
  LW_ASSIGN_OR_RETURN(Grid<float> elevation_m,
                      ReadGrid(&reader, geometry, "elevation", height_text, is_height));
  terrain.ground = HeightField(geometry, std::move(elevation_m));
  LW_ASSIGN_OR_RETURN(terrain.water_level_m,
                      ReadGrid(&reader, geometry, "water level", height_text + " and NaN",
                               [&](float level) { return std::isnan(level) || is_height(level); }));
  LW_ASSIGN_OR_RETURN(terrain.surface, ReadSurface(&reader, geometry));
  terrain.weights.vocabulary = vocabulary;
  for (const char letter : letters) {
    LW_ASSIGN_OR_RETURN(
        const std::string levels,
        ReadCompressed(&reader, terrain.surface.size(), std::string("weight of class ") + letter));
    WeightGrid weight(geometry.rows(), geometry.cols());
    std::copy(levels.begin(), levels.end(), weight.levels().begin());
    terrain.weights.classes.push_back({letter, std::move(weight)});
  }
  if (!reader.AtEnd()) return DataLoss("goes on after its last grid");
  return terrain;
}

}  // namespace latticeworld
