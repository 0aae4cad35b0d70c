#include "latticeworld/exporting/maps/height_arrays.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "latticeworld/exporting/bytes.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "heights";

using Json = nlohmann::ordered_json;

// NumPy's format 1.0 (numpy.lib.format): the header ends on a multiple of 64 bytes.
std::string NpyHeader(const char* type, int rows, int cols) {
  constexpr std::size_t kBeforeText = 10, kAlignment = 64;
  std::string text = std::string("{'descr': '") + type + "', 'fortran_order': False, 'shape': (" +
                     std::to_string(rows) + ", " + std::to_string(cols) + "), }";
  while ((kBeforeText + text.size() + 1) % kAlignment != 0) text += ' ';
  text += '\n';
  std::string header = "\x93NUMPY";
  Bytes bytes(&header);
  bytes.Add(std::uint8_t{1});
  bytes.Add(std::uint8_t{0});
  bytes.Add(static_cast<std::uint16_t>(text.size()));
  return header + text;
}

// value: of a cell, gives a float or an uint8_t.
template <typename Value>
std::string ToNpy(const CellRange& cells, const Value& value) {
  using T = std::decay_t<decltype(value(CellIndex()))>;
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, std::uint8_t>);
  std::string npy = NpyHeader(std::is_same_v<T, float> ? "<f4" : "|u1", cells.rows(), cells.cols());
  npy.reserve(npy.size() + sizeof(T) * static_cast<std::size_t>(cells.rows()) * cells.cols());
  Bytes bytes(&npy);
  for (int row = cells.first_row; row <= cells.last_row; ++row) {
    for (int col = cells.first_col; col <= cells.last_col; ++col)
      bytes.Add(value(CellIndex{row, col}));
  }
  return npy;
}

class HeightArrays {
 public:
  HeightArrays(const Scene& scene, const CellRange& cells, const Progress& progress)
      : scene_(scene), terrain_(*scene.terrain), cells_(cells), progress_(progress) {}

  Result<std::vector<ExportFile>> Build(const std::string& name,
                                        const std::optional<GeoOrigin>& origin) {
    LW_RETURN_IF_ERROR(Advance(0.0));
    const Grid<float>& height_m = terrain_.ground.height_m();
    Add("heights", ToNpy(cells_, [&](CellIndex cell) { return height_m[cell]; }));
    LW_RETURN_IF_ERROR(Advance(0.3));
    if (IsWet()) {
      const Grid<float>& level_m = terrain_.water_level_m;
      Add("water", ToNpy(cells_, [&](CellIndex cell) { return level_m[cell]; }));
    }
    LW_RETURN_IF_ERROR(Advance(0.6));
    Add("classes", ToNpy(cells_, [&](CellIndex cell) {
          return static_cast<std::uint8_t>(terrain_.surface[cell]);
        }));
    Add("letters", ToNpy(cells_, [&](CellIndex cell) {
          return static_cast<std::uint8_t>(terrain_.weights.DominantAt(cell));
        }));
    files_.push_back({"heights.json", Description(name, origin).dump(2) + "\n"});
    LW_RETURN_IF_ERROR(Advance(1.0));
    return std::move(files_);
  }

 private:
  Status Advance(double fraction) const {
    progress_.Report(kStage, fraction);
    return progress_.CheckCancelled();
  }

  void Add(const std::string& layer, std::string npy) {
    layers_[layer] = layer + ".npy";
    files_.push_back({layer + ".npy", std::move(npy)});
  }

  bool IsWet() const {
    for (int row = cells_.first_row; row <= cells_.last_row; ++row) {
      const float* const levels = terrain_.water_level_m.row(row);
      if (std::any_of(levels + cells_.first_col, levels + cells_.last_col + 1,
                      [](float level) { return !std::isnan(level); })) {
        return true;
      }
    }
    return false;
  }

  Json Description(const std::string& name, const std::optional<GeoOrigin>& origin) const {
    const GridGeometry& geometry = scene_.geometry();
    const ExportRegion centers = BetweenCenters(cells_, geometry);
    Json json;
    json["world"] = name;
    json["layers"] = layers_;
    json["rows"] = cells_.rows();
    json["cols"] = cells_.cols();
    json["row_0"] = "north";
    json["col_0"] = "west";
    json["values_at"] = "centres of cells";
    json["frame"] = "map: x east, y north, z up";
    json["unit"] = "m";
    json["resolution"] = geometry.resolution_m();
    // x = origin[0] + col * resolution, y = origin[1] - row * resolution.
    json["origin"] = {centers.west_m, centers.north_m};
    json["center"] = {centers.center().x_m, centers.center().y_m};
    json["size"] = {centers.width_m(), centers.depth_m()};
    AddHeightRange(&json);
    json["quads"] = "of four neighbouring centres, split from north-west to south-east";
    json["classes"] = Classes();
    json["letters"] = Letters();
    json["earth"] = nullptr;
    if (origin) {
      json["earth"] = {{"at", "x = 0, y = 0, z = 0 of the frame"},
                       {"datum", "WGS 84, altitude as the elevation data"},
                       {"latitude_deg", origin->latitude_deg},
                       {"longitude_deg", origin->longitude_deg},
                       {"altitude_m", origin->altitude_m}};
    }
    return json;
  }

  void AddHeightRange(Json* json) const {
    const Grid<float>& height_m = terrain_.ground.height_m();
    float low_m = height_m(cells_.first_row, cells_.first_col), high_m = low_m;
    for (int row = cells_.first_row; row <= cells_.last_row; ++row) {
      const auto [low, high] = std::minmax_element(height_m.row(row) + cells_.first_col,
                                                   height_m.row(row) + cells_.last_col + 1);
      low_m = std::min(low_m, *low);
      high_m = std::max(high_m, *high);
    }
    (*json)["lowest"] = low_m;
    (*json)["highest"] = high_m;
  }

  Json Classes() const {
    const SurfaceTable surfaces(scene_, scene_.atmosphere.ground());
    Json classes = Json::array();
    for (const auto& entry : EnumNames(SurfaceClass{})) {
      classes.push_back({{"number", static_cast<int>(entry.value)},
                         {"name", entry.name},
                         {"friction", surfaces.Of(entry.value).friction}});
    }
    return classes;
  }

  Json Letters() const {
    Json letters = Json::array();
    for (const LayoutClass& layout_class : ClassesOf(terrain_.weights.vocabulary)) {
      letters.push_back({{"number", static_cast<int>(layout_class.letter)},
                         {"letter", std::string(1, layout_class.letter)},
                         {"name", layout_class.name}});
    }
    return letters;
  }

  const Scene& scene_;
  const Terrain& terrain_;
  const CellRange cells_;
  const Progress& progress_;
  Json layers_;
  std::vector<ExportFile> files_;
};

}  // namespace

Result<std::vector<ExportFile>> HeightFiles(const Scene& scene, const std::string& name,
                                            const std::optional<GeoOrigin>& origin,
                                            const HeightArraysOptions& options,
                                            const Progress& progress) {
  const GridGeometry& geometry = scene.geometry();
  LW_RETURN_IF_ERROR(Status::FromViolations(
      "arrays", ValidateGround(options.region, geometry, "an array has at least two heights")));
  const CellRange cells = CellsIn(options.region.value_or(WholeWorld(geometry)), geometry);
  return HeightArrays(scene, cells, progress).Build(name, origin);
}

}  // namespace latticeworld
