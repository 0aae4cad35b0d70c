#include "latticeworld/dataset/sources/scenes_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/class_picture.h"
#include "latticeworld/dataset/sources/downsample.h"
#include "latticeworld/dataset/sources/source_files.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/relief/elevation/elevation_fill.h"
#include "latticeworld/relief/elevation/elevation_frame.h"
#include "latticeworld/relief/elevation/elevation_raster.h"

namespace latticeworld {
namespace fs = std::filesystem;
namespace {

using internal::ElevationFrame;
using internal::ElevationRaster;

constexpr double kMostOblong = 0.02;  // that samples may differ from squares
constexpr double kMostMissing = 0.5;  // of the elevation
constexpr int kErosionSteps = 4;

struct Land {
  Grid<float> height_m;
  double resolution_m = 0.0;
};

// Reads all samples of an elevation. cols, rows: of the picture that it belongs to.
Result<Land> ReadLand(std::string_view bytes, const std::string& path, int cols, int rows) {
  const Result<ElevationRaster> raster = ElevationRaster::Open(bytes, path);
  if (!raster.ok()) return raster.status().WithContext(path);
  if (StartsWith(raster->reference().crs, "GEOG")) {
    return InvalidArgument(path +
                           ": the elevation's samples lie a part of a degree apart, so that they "
                           "are no squares on the ground and do not fit a picture in metres; legal "
                           "is a projected coordinate system (gdalwarp -t_srs EPSG:326xx)");
  }
  if (raster->cols() != cols || raster->rows() != rows) {
    return InvalidArgument(path + " has " + std::to_string(raster->cols()) + " x " +
                           std::to_string(raster->rows()) + " samples and its segmentation " +
                           std::to_string(cols) + " x " + std::to_string(rows) +
                           " pixels; legal is the same size (gdalwarp -ts)");
  }
  const Result<ElevationFrame> frame = ElevationFrame::Create(*raster, {});
  if (!frame.ok()) return frame.status().WithContext(path);
  const double width_m = frame->sample_width_m(), height_m = frame->sample_height_m();
  if (std::abs(width_m - height_m) > kMostOblong * std::min(width_m, height_m)) {
    return InvalidArgument(path + ": the elevation's samples are " + FormatDouble(width_m) +
                           " m wide and " + FormatDouble(height_m) +
                           " m high; legal are squares (gdalwarp -tr)");
  }
  Result<Grid<float>> heights = raster->Read({0, 0, cols, rows, 1, 1});
  if (!heights.ok()) return DataLoss(path + ": " + heights.status().message());
  const double missing = internal::FillVoids(&*heights);
  if (missing > kMostMissing) {
    return InvalidArgument(path + ": " + FormatDouble(std::round(1000.0 * missing) / 10.0) +
                           " % of the elevation is no data; legal is at most half");
  }
  return Land{*std::move(heights), std::sqrt(width_m * height_m)};
}

// Lets the rivers of the scene work. A change of level runs up a river at erodibility * area^m, so
// that the time follows from how far it is to come.
void Erode(double share, Land* land) {
  if (share <= 0.0) return;
  FluvialOptions options;
  options.steps = kErosionSteps;
  const double side_m = land->resolution_m * std::min(land->height_m.rows(), land->height_m.cols());
  const double speed_m_per_yr =
      options.erodibility * std::pow(side_m * side_m, options.area_exponent);
  options.time_step_yr = share * side_m / speed_m_per_yr / kErosionSteps;
  ErodeFluvially(land->resolution_m, options, nullptr, nullptr, nullptr, /*threads=*/1,
                 &land->height_m);
}

template <typename T>
Grid<T> TileAt(const Grid<T>& all, int row, int col) {
  Grid<T> tile(kTileSize, kTileSize);
  for (int r = 0; r < kTileSize; ++r) {
    const T* source = all.row(row * kTileSize + r) + col * kTileSize;
    std::copy_n(source, kTileSize, tile.row(r));
  }
  return tile;
}

std::shared_ptr<const Relief> ReliefOf(Grid<float> height_m) {
  const float lowest_m = *std::min_element(height_m.begin(), height_m.end());
  for (float& height : height_m) height -= lowest_m;
  return std::make_shared<const Relief>(MakeRelief(std::move(height_m)));
}

// Counts the tiles that a folder's pictures have by their headers; one that cannot be read has
// none.
struct FolderCount {
  std::int64_t tiles = 0;
  std::int64_t pixels = 0;
  std::int64_t dropped = 0;
};

void AddTo(FolderCount* count, const fs::path& picture) {
  constexpr std::size_t kHeader = 24;  // signature, IHDR's length and type, width, height
  std::array<unsigned char, kHeader> header{};
  std::ifstream file(picture, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(header.data()), kHeader) || header[1] != 'P') return;
  const auto side = [&header](std::size_t at) {
    return std::int64_t{header[at]} << 24 | std::int64_t{header[at + 1]} << 16 |
           std::int64_t{header[at + 2]} << 8 | std::int64_t{header[at + 3]};
  };
  const std::int64_t width = side(16), height = side(20);
  if (width > kMaxReliefSize || height > kMaxReliefSize) return;
  const TileCount tiles = TilesOf(width, height);
  count->tiles += std::int64_t{tiles.rows} * tiles.cols;
  count->pixels += width * height;
  count->dropped += tiles.dropped;
}

std::string TitleOf(const FolderCount& count) {
  return "Segmented scenes with elevation, cut into " + std::to_string(count.tiles) +
         " tiles of 512 x 512 pixels; " + std::to_string(count.dropped) + " of " +
         std::to_string(count.pixels) + " pixels at the edges fill no tile and are left out";
}

class ScenesSource final : public InstanceSource {
 public:
  ScenesSource(const ScenesOptions& options, PictureLegend legend, std::vector<std::string> scenes)
      : options_(options), legend_(std::move(legend)), scenes_(std::move(scenes)) {
    for (const std::string& scene : scenes_) names_.push_back("scene-" + SafeName(scene));
    MakeUnique(&names_);
    FolderCount count;
    for (const std::string& scene : scenes_) AddTo(&count, FolderOf(scene) / "segmentation.png");
    card_ = {"scenes", TitleOf(count), legend_.licence, legend_.citation};
  }

  const SourceCard& card() const override { return card_; }
  std::size_t group_count() const override { return scenes_.size(); }
  std::string GroupName(std::size_t index) const override {
    LW_CHECK(index < names_.size(), "there is no such group");
    return names_[index];
  }

  Result<std::vector<Instance>> ReadGroup(std::size_t index) const override {
    LW_CHECK(index < scenes_.size(), "there is no such group");
    const fs::path picture = FolderOf(scenes_[index]) / "segmentation.png";
    const fs::path elevation = FolderOf(scenes_[index]) / "elevation.tif";
    LW_ASSIGN_OR_RETURN(const std::string picture_bytes, ReadHalf(picture, elevation));
    LW_ASSIGN_OR_RETURN(const std::string elevation_bytes, ReadHalf(elevation, picture));
    LW_ASSIGN_OR_RETURN(const Grid<char> mask,
                        ReadClassPicture(picture_bytes, legend_, picture.string()));
    const TileCount tiles = TilesOf(mask.cols(), mask.rows());
    if (tiles.rows * tiles.cols == 0) {
      return InvalidArgument(picture.string() + " has " + std::to_string(mask.cols()) + " x " +
                             std::to_string(mask.rows()) +
                             " pixels, and no tile fits; legal are "
                             "at least 512 a side");
    }
    LW_ASSIGN_OR_RETURN(Land land,
                        ReadLand(elevation_bytes, elevation.string(), mask.cols(), mask.rows()));
    Erode(options_.erosion, &land);

    std::vector<Instance> instances;
    for (int r = 0; r < tiles.rows; ++r) {
      for (int c = 0; c < tiles.cols; ++c) {
        Result<SymbolicLayout> layout = Downsample(TileAt(mask, r, c), legend_.vocabulary);
        if (!layout.ok()) continue;  // a tile of no data
        instances.push_back({names_[index] + "-y" + std::to_string(r) + "-x" + std::to_string(c),
                             names_[index], *std::move(layout),
                             ReliefOf(TileAt(land.height_m, r, c))});
      }
    }
    if (instances.empty()) {
      return InvalidArgument(picture.string() +
                             ": more than half of every tile is no data; legal is at most half");
    }
    return instances;
  }

 private:
  fs::path FolderOf(const std::string& scene) const { return options_.folder / "scenes" / scene; }

  // A file of a pair; that it is missing is said of the pair.
  static Result<std::string> ReadHalf(const fs::path& path, const fs::path& other) {
    Result<std::string> bytes = ReadSourceFile(path);
    if (bytes.ok() || bytes.status().code() != StatusCode::kNotFound) return bytes;
    std::error_code ignored;
    return NotFound(path.string() + " is missing" +
                    (fs::exists(other, ignored) ? "; " + other.string() + " is there"
                                                : ", and so is " + other.string()));
  }

  const ScenesOptions options_;
  const PictureLegend legend_;
  const std::vector<std::string> scenes_;  // folders below scenes/
  std::vector<std::string> names_;         // of the groups
  SourceCard card_;
};

}  // namespace

std::vector<Violation> Validate(const ScenesOptions& options) {
  std::vector<Violation> violations;
  CheckRange("erosion", options.erosion, {0.0, 0.5}, "", &violations);
  return violations;
}

TileCount TilesOf(std::int64_t width, std::int64_t height) {
  TileCount count;
  count.rows = static_cast<int>(height / kTileSize);
  count.cols = static_cast<int>(width / kTileSize);
  count.dropped = width * height - std::int64_t{count.rows} * count.cols * kTileSize * kTileSize;
  return count;
}

Result<std::unique_ptr<InstanceSource>> MakeScenesSource(const ScenesOptions& options) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal scenes options", Validate(options)));
  LW_ASSIGN_OR_RETURN(const std::vector<std::string> inside, NamesIn(options.folder, ""));
  const std::string folder = options.folder.string();
  if (std::find(inside.begin(), inside.end(), "scenes") == inside.end()) {
    return InvalidArgument(
        folder + " is no folder of scenes (" +
        (inside.empty() ? "it holds no folders" : "it holds " + Quote(Join(inside, ", "), 200)) +
        "); legal is one with scenes/<name>/segmentation.png and "
        "scenes/<name>/elevation.tif");
  }
  LW_ASSIGN_OR_RETURN(std::vector<std::string> scenes, NamesIn(options.folder / "scenes", ""));
  if (scenes.empty()) {
    return InvalidArgument((options.folder / "scenes").string() +
                           " is empty; legal are folders with segmentation.png and elevation.tif");
  }
  PictureLegend legend = PaletteLegend(Vocabulary::kWild);
  const fs::path classes = options.folder / "classes.json";
  std::error_code error;
  if (fs::exists(classes, error)) {
    LW_ASSIGN_OR_RETURN(const std::string json, ReadSourceFile(classes));
    LW_ASSIGN_OR_RETURN(legend, ReadLegend(json, classes.string()));
  }
  return std::unique_ptr<InstanceSource>(
      new ScenesSource(options, std::move(legend), std::move(scenes)));
}

}  // namespace latticeworld
