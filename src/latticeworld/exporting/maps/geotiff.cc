#include "latticeworld/exporting/maps/geotiff.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "latticeworld/exporting/maps/map_reference.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/relief/elevation/gdal_errors.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "geotiff";

// Named although every cell has a value: readers that find none (pysheds) take 0 for it, which is a
// height, grass, and closed ground.
constexpr double kNoHeight_m = -9999.0, kNoTraversability = -1.0;
constexpr double kNoClass = 255.0;

// How maps show a class of the ground: red, green, blue.
GDALColorEntry MapColor(SurfaceClass surface) {
  switch (surface) {
    case SurfaceClass::kGrass:
      return {134, 170, 92, 255};
    case SurfaceClass::kForestFloor:
      return {62, 104, 58, 255};
    case SurfaceClass::kFarmland:
      return {214, 190, 110, 255};
    case SurfaceClass::kBarren:
      return {196, 176, 148, 255};
    case SurfaceClass::kRoad:
      return {96, 96, 100, 255};
    case SurfaceClass::kBuilding:
      return {178, 84, 70, 255};
    case SurfaceClass::kRock:
      return {134, 128, 120, 255};
    case SurfaceClass::kSnow:
      return {240, 244, 250, 255};
    case SurfaceClass::kWaterBed:
      return {78, 128, 186, 255};
  }
  return {};
}

// One file that GDAL writes in memory.
class TiffFile {
 public:
  TiffFile()
      : name_("/vsimem/latticeworld-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) +
              ".tif") {}
  ~TiffFile() {
    if (dataset_ != nullptr) GDALClose(dataset_);
    VSIUnlink(name_.c_str());
    VSIUnlink((name_ + kBeside).c_str());
  }
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  Status Create(int cols, int rows, GDALDataType type) {
    const GDALDriverH driver = GDALGetDriverByName("GTiff");
    if (driver == nullptr) return Internal("this GDAL has no GeoTIFF driver");
    // There is no predictor, though one would save a third: Whitebox Workflows 2.0 ignores it.
    char** options = CSLSetNameValue(nullptr, "COMPRESS", "DEFLATE");
    options = CSLSetNameValue(options, "NUM_THREADS", "1");
    dataset_ = GDALCreate(driver, name_.c_str(), cols, rows, 1, type, options);
    CSLDestroy(options);
    return dataset_ != nullptr ? Status() : Failed("create");
  }

  Status Place(const std::string& wkt, double west_m, double north_m, double cell_m) {
    double transform[6] = {west_m, cell_m, 0.0, north_m, 0.0, -cell_m};
    if (GDALSetProjection(dataset_, wkt.c_str()) != CE_None) return Failed("reference");
    return GDALSetGeoTransform(dataset_, transform) == CE_None ? Status() : Failed("place");
  }

  void Describe(const char* key, const std::string& value) {
    GDALSetMetadataItem(dataset_, key, value.c_str(), nullptr);
  }
  void SetNoData(double value) { GDALSetRasterNoDataValue(band(), value); }
  void SetUnit(const char* unit) { GDALSetRasterUnitType(band(), unit); }

  template <typename T>
  Status Write(const Grid<T>& layer, const CellRange& cells, GDALDataType type) {
    std::vector<T> row(static_cast<std::size_t>(cells.cols()));
    for (int r = 0; r < cells.rows(); ++r) {
      const T* from = layer.row(cells.first_row + r) + cells.first_col;
      std::copy(from, from + cells.cols(), row.begin());
      if (GDALRasterIO(band(), GF_Write, 0, r, cells.cols(), 1, row.data(), cells.cols(), 1, type,
                       0, 0) != CE_None) {
        return Failed("write");
      }
    }
    return Status();
  }

  // The bytes of the file, which is closed.
  Result<std::string> Take() {
    GDALClose(dataset_);
    dataset_ = nullptr;
    return BytesOf(name_);
  }
  // The bytes of a file beside this one, once this one is taken: classes as maps show them, by name
  // and colour. GDAL keeps there what is set of a file that it may only read, so that the TIFF
  // stays one of numbers, which every reader knows; a palette within it would have 256 entries.
  Result<std::string> ClassesBeside() {
    dataset_ = GDALOpen(name_.c_str(), GA_ReadOnly);
    if (dataset_ == nullptr) return Failed("read");
    const GDALColorTableH colors = GDALCreateColorTable(GPI_RGB);
    char** names = nullptr;
    for (const auto& entry : EnumNames(SurfaceClass())) {
      const GDALColorEntry color = MapColor(entry.value);
      GDALSetColorEntry(colors, static_cast<int>(entry.value), &color);
      names = CSLAddString(names, std::string(entry.name).c_str());
    }
    GDALSetRasterColorTable(band(), colors);
    GDALSetRasterColorInterpretation(band(), GCI_PaletteIndex);
    GDALSetRasterCategoryNames(band(), names);
    GDALDestroyColorTable(colors);
    CSLDestroy(names);
    GDALClose(dataset_);
    dataset_ = nullptr;
    return BytesOf(name_ + kBeside);
  }

  static constexpr char kBeside[] = ".aux.xml";

 private:
  Result<std::string> BytesOf(const std::string& name) const {
    vsi_l_offset length = 0;
    const GByte* bytes = VSIGetMemFileBuffer(name.c_str(), &length, FALSE);
    if (bytes == nullptr) return Failed("write");
    return std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length));
  }
  GDALRasterBandH band() const { return GDALGetRasterBand(dataset_, 1); }
  Status Failed(const char* what) const {
    return Internal(std::string("cannot ") + what + " the GeoTIFF" + errors_.Last(name_));
  }

  const internal::GdalErrors errors_;
  std::string name_;
  GDALDatasetH dataset_ = nullptr;
};

// What the layers of a world have in common.
struct Frame {
  CellRange cells;
  std::string wkt;
  double west_m, north_m, cell_m;
};

// classes: gets the file of ClassesBeside, where it is asked for.
template <typename T, typename Describe>
Result<ExportFile> Layer(const char* name, const Grid<T>& values, GDALDataType type,
                         const Frame& frame, const Describe& describe,
                         ExportFile* classes = nullptr) {
  TiffFile file;
  LW_RETURN_IF_ERROR(file.Create(frame.cells.cols(), frame.cells.rows(), type));
  LW_RETURN_IF_ERROR(file.Place(frame.wkt, frame.west_m, frame.north_m, frame.cell_m));
  describe(&file);
  LW_RETURN_IF_ERROR(file.Write(values, frame.cells, type));
  LW_ASSIGN_OR_RETURN(std::string bytes, file.Take());
  if (classes != nullptr) {
    classes->name = std::string(name) + TiffFile::kBeside;
    LW_ASSIGN_OR_RETURN(classes->content, file.ClassesBeside());
  }
  return ExportFile{name, std::move(bytes)};
}

}  // namespace

Result<std::vector<ExportFile>> GeoTiffFiles(const Scene& scene,
                                             const std::optional<GeoOrigin>& origin,
                                             const GeoTiffOptions& options,
                                             const Progress& progress) {
  const GridGeometry& geometry = scene.geometry();
  LW_RETURN_IF_ERROR(Status::FromViolations("GeoTIFF", Validate(options.region, geometry)));
  const ExportRegion region = options.region.value_or(WholeWorld(geometry));
  internal::PrepareGdal();
  // All layers share the frame: cells, coordinate system and the outer corner in the north-west.
  Frame frame;
  frame.cells = CellsIn(region, geometry);
  if (frame.cells.rows() < 1 || frame.cells.cols() < 1)
    return InvalidArgument("the region holds no cell of the world's grid");
  LW_ASSIGN_OR_RETURN(frame.wkt, MapWkt(origin));
  frame.cell_m = geometry.resolution_m();
  const WorldPoint corner = geometry.CenterOf({frame.cells.first_row, frame.cells.first_col});
  frame.west_m = corner.x_m - 0.5 * frame.cell_m;
  frame.north_m = corner.y_m + 0.5 * frame.cell_m;

  const auto advance = [&progress](double fraction) {
    progress.Report(kStage, fraction);
    return progress.CheckCancelled();
  };
  std::vector<ExportFile> files;
  LW_RETURN_IF_ERROR(advance(0.0));
  // Each file has one layer, with its unit or the meaning of its numbers, and what stands for no
  // data.
  const Terrain& terrain = *scene.terrain;
  LW_ASSIGN_OR_RETURN(
      ExportFile elevation,
      Layer("elevation.tif", terrain.ground.height_m(), GDT_Float32, frame, [&](TiffFile* file) {
        file->SetUnit("m");
        file->SetNoData(kNoHeight_m);
        if (origin) file->Describe("ZERO_ALTITUDE_M", std::to_string(origin->altitude_m));
      }));
  files.push_back(std::move(elevation));
  LW_RETURN_IF_ERROR(advance(0.25));
  LW_ASSIGN_OR_RETURN(
      ExportFile water,
      Layer("water.tif", terrain.water_level_m, GDT_Float32, frame, [](TiffFile* file) {
        file->SetUnit("m");
        file->SetNoData(std::numeric_limits<double>::quiet_NaN());
      }));
  files.push_back(std::move(water));
  LW_RETURN_IF_ERROR(advance(0.5));
  Grid<std::uint8_t> classes(geometry.rows(), geometry.cols());
  std::transform(terrain.surface.begin(), terrain.surface.end(), classes.begin(),
                 [](SurfaceClass surface) { return static_cast<std::uint8_t>(surface); });
  const auto describe_classes = [](TiffFile* file) {
    file->SetNoData(kNoClass);
    for (const auto& entry : EnumNames(SurfaceClass())) {
      const std::string key = "CLASS_" + std::to_string(static_cast<int>(entry.value));
      file->Describe(key.c_str(), std::string(entry.name));
    }
  };
  ExportFile names;
  LW_ASSIGN_OR_RETURN(ExportFile surface,
                      Layer("classes.tif", classes, GDT_Byte, frame, describe_classes, &names));
  files.push_back(std::move(surface));
  files.push_back(std::move(names));
  LW_RETURN_IF_ERROR(advance(0.75));
  LW_ASSIGN_OR_RETURN(
      ExportFile traversability,
      Layer("traversability.tif", BuildTraversability(scene, RobotLimits()), GDT_Float32, frame,
            [](TiffFile* file) { file->SetNoData(kNoTraversability); }));
  files.push_back(std::move(traversability));
  LW_RETURN_IF_ERROR(advance(1.0));
  return files;
}

}  // namespace latticeworld
