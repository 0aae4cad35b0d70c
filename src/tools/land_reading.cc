#include "tools/land_reading.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/relief/elevation/elevation_survey.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld::tools {
namespace {

constexpr int kMinSide = 64;
constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;

Result<Land> ReadBundle(const std::string& path) {
  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(path));
  const Terrain& terrain = *world->scene->terrain;
  Land land;
  land.resolution_m = terrain.geometry().resolution_m();
  land.height_m = terrain.ground.height_m();
  land.water = Grid<unsigned char>(land.height_m.rows(), land.height_m.cols());
  for (std::size_t i = 0; i < land.height_m.size(); ++i) {
    const float level_m = terrain.water_level_m.data()[i];
    if (std::isnan(level_m)) continue;
    land.height_m.data()[i] = level_m;
    land.water.data()[i] = 1;
  }
  return land;
}

Result<Land> ReadPicture(const std::string& bytes, const LandOptions& options) {
  if (options.size_m == 0.0) {
    return InvalidArgument("is a height map, whose width nobody knows: give --size METRES");
  }
  HeightMapOptions height_map;
  height_map.height_scale_m = options.height_scale_m;
  LW_ASSIGN_OR_RETURN(Relief relief, ReadWholeHeightMap(bytes, height_map));
  Land land;
  land.resolution_m = options.size_m / relief.height_m.cols();
  land.height_m = std::move(relief.height_m);
  land.water = Grid<unsigned char>(land.height_m.rows(), land.height_m.cols());
  land.warnings = std::move(relief.warnings);
  if (relief.height_step_m > 0.1 * land.resolution_m) {
    land.warnings.push_back("heights come in steps of " + FormatDouble(relief.height_step_m) +
                            " m: slopes and spectra are partly those of the steps");
  }
  return land;
}

Result<Land> ReadSurvey(const std::string& path, const std::string& bytes, ElevationUnit unit) {
  LW_ASSIGN_OR_RETURN(
      ElevationSurvey survey,
      SurveyElevation(bytes, std::filesystem::path(path).filename().string(), unit));
  Land land;
  land.height_m = std::move(survey.height_m);
  land.water = std::move(survey.missing);
  land.resolution_m = survey.resolution_m;
  land.warnings = std::move(survey.warnings);
  return land;
}

Result<Land> ReadAny(const std::string& path, const LandOptions& options) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return ReadBundle(path);
  LW_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path, kMaxFileBytes));
  const std::string extension = ToLowerAscii(std::filesystem::path(path).extension().string());
  const bool tiff = extension == ".tif" || extension == ".tiff";
  if (extension == ".png" || extension == ".pgm" || (tiff && options.size_m != 0.0)) {
    return ReadPicture(bytes, options);
  }
  return ReadSurvey(path, bytes, options.elevation_unit);
}

}  // namespace

Result<Land> ReadLand(const std::string& path, const LandOptions& options) {
  auto land = ReadAny(path, options);
  if (!land.ok()) return land.status().WithContext(Quote(path));
  land->path = path;
  if (land->height_m.rows() < kMinSide || land->height_m.cols() < kMinSide) {
    return InvalidArgument(Quote(path) + ": has " + std::to_string(land->height_m.cols()) + " x " +
                           std::to_string(land->height_m.rows()) +
                           " cells; legal are at least 64 x 64");
  }
  return land;
}

}  // namespace latticeworld::tools
