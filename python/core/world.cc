#include "world.h"

#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "errors.h"
#include "interrupt.h"
#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/fidelity/fidelity_json.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld::python {
namespace {

using Path = std::filesystem::path;
// Latitude and longitude, WGS 84 [deg].
using LatitudeLongitude = std::pair<double, double>;

// A grid's own memory, read only; `owner` lives as long as the array.
template <typename T, typename Cell>
auto ViewOf(const Grid<Cell>& grid, nb::handle owner) {
  static_assert(sizeof(T) == sizeof(Cell), "a view shows the cells as they are");
  return nb::ndarray<nb::numpy, const T, nb::ndim<2>>(
      reinterpret_cast<const T*>(grid.data()),
      {static_cast<std::size_t>(grid.rows()), static_cast<std::size_t>(grid.cols())}, owner);
}

std::uint64_t DrawSeed() {
  std::random_device device;
  return 1 + device() % 1000000000u;
}

void ReadVisual(const std::optional<Path>& height_map, const std::optional<Path>& sketch,
                const std::optional<Path>& elevation, GenerationRequest* request) {
  const std::pair<const std::optional<Path>&, VisualKind> kinds[] = {
      {height_map, VisualKind::kHeightMap},
      {sketch, VisualKind::kSketch},
      {elevation, VisualKind::kElevation}};
  for (const auto& [file, kind] : kinds) {
    if (!file) continue;
    if (request->visual_kind != VisualKind::kNone) {
      Check(InvalidArgument("height_map, sketch and elevation exclude each other; give one"));
    }
    request->visual_kind = kind;
    request->visual = Value(ReadFile(*file, kMaxVisualBytes));
    request->visual_name = file->string();
  }
}

// Which land of real elevation, and how its file is read.
void ReadElevationOptions(const std::optional<LatitudeLongitude>& place, bool keep_altitude,
                          const std::string& unit, GenerationRequest* request) {
  const std::optional<ElevationUnit> known = FromName<ElevationUnit>(unit);
  if (!known) {
    Check(InvalidArgument("elevation_unit is " + Quote(unit) +
                          "; legal are degrees, metres, or none to let the numbers decide"));
  }
  if ((place || keep_altitude || !unit.empty()) && request->visual_kind != VisualKind::kElevation) {
    Check(
        InvalidArgument("place, keep_altitude and elevation_unit are of an elevation; give its "
                        "file as elevation"));
  }
  request->elevation.unit = *known;
  request->elevation.keep_altitude = keep_altitude;
  if (!place) return;
  request->elevation.centered = false;
  request->elevation.latitude_deg = place->first;
  request->elevation.longitude_deg = place->second;
}

std::shared_ptr<PyWorld> Generate(
    const std::string& layout, const std::string& environment, std::uint64_t seed, double size_m,
    double resolution_m, const std::string& vocabulary, const std::optional<Path>& height_map,
    const std::optional<Path>& sketch, const std::optional<Path>& elevation,
    const std::optional<double>& height_scale_m, const std::optional<double>& height_offset_m,
    const std::optional<LatitudeLongitude>& place, bool keep_altitude,
    const std::string& elevation_unit, nb::object progress) {
  GenerationRequest request;
  request.layout_instruction = layout;
  request.environment_instruction = environment;
  request.seed = seed != 0 ? seed : DrawSeed();
  request.size_m = size_m;
  request.resolution_m = resolution_m;
  request.vocabulary = vocabulary;
  if (height_scale_m) request.height_map.height_scale_m = *height_scale_m;
  if (height_offset_m) request.height_map.height_offset_m = *height_offset_m;
  ReadVisual(height_map, sketch, elevation, &request);
  ReadElevationOptions(place, keep_altitude, elevation_unit, &request);
  Interruptible interruptible(std::move(progress));
  Result<std::shared_ptr<const World>> world = WithoutLock(
      [&] { return MakeDefaultWorldGenerator().Generate(request, interruptible.progress()); });
  interruptible.Check();
  return std::make_shared<PyWorld>(Value(std::move(world)));
}

std::shared_ptr<PyWorld> Load(const Path& path) {
  auto world = WithoutLock([&] { return LoadBundle(path); });
  return std::make_shared<PyWorld>(Value(std::move(world)));
}

double HeightAt(const PyWorld& world, double x_m, double y_m) {
  const WorldPoint point{x_m, y_m};
  if (!world.scene().geometry().Contains(point)) {
    Check(Status(StatusCode::kOutOfRange,
                 "(" + std::to_string(x_m) + ", " + std::to_string(y_m) +
                     ") is no place of the world; legal are x and y within half its size, " +
                     std::to_string(world.scene().geometry().half_size_m()) + " m"));
  }
  return world.scene().terrain->ground.HeightAt(point);
}

// (latitude [deg], longitude [deg], altitude [m]), or None.
nb::object PlaceOf(const PyWorld& world) {
  const auto& geo = world.world().geo;
  if (!geo) return nb::none();
  return nb::make_tuple(geo->latitude_deg, geo->longitude_deg, geo->altitude_m);
}

nb::list AgentsOf(const PyWorld& world) {
  nb::list agents;
  for (const AgentStart& start : world.scene().agents) {
    nb::dict agent;
    agent["name"] = start.name;
    agent["category"] = std::string(NameOf(start.category));
    agent["controllable"] = start.controllable;
    agent["x_m"] = start.position.x_m;
    agent["y_m"] = start.position.y_m;
    agent["heading_rad"] = start.heading_rad;
    agents.append(agent);
  }
  return agents;
}

auto OccupancyOf(nb::handle_t<PyWorld> self, const std::string& species) {
  auto& world = nb::cast<PyWorld&>(self);
  const auto* grid = WithoutLock([&] { return &world.OccupancyFor(species); });
  return ViewOf<std::int8_t>(*grid, self);
}

nb::list SurfaceNames() {
  nb::list names;
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    names.append(nb::str(entry.name.data(), entry.name.size()));
  }
  return names;
}

}  // namespace

const Grid<std::int8_t>& PyWorld::OccupancyFor(const std::string& species) {
  const Species* robot = SpeciesCatalogue::BuiltIn()->Find(species);
  if (robot == nullptr) {
    std::vector<std::string> names;
    for (const Species& one : SpeciesCatalogue::BuiltIn()->all()) names.push_back(one.name);
    Check(InvalidArgument("there is no species " + Quote(species) + "; legal are " +
                          Join(names, ", ")));
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto [made, is_new] = occupancy_.try_emplace(robot->name);
  if (is_new) {
    RobotLimits limits;
    limits.radius_m = robot->radius_m;
    made->second = BuildOccupancy(scene(), limits);
  }
  return made->second;
}

void BindWorld(nb::module_& module) {
  module.attr("SURFACES") = nb::tuple(SurfaceNames());
  nb::class_<PyWorld>(module, "World", nb::is_weak_referenceable(),
                      "A generated world: immutable, shared, never copied.\n\n"
                      "Arrays are (rows, cols), row 0 north, column 0 west, values at the middles "
                      "of cells. They are read-only views of the world's own memory, and keep it "
                      "alive.")
      .def_static(
          "generate", &Generate, nb::arg("layout") = "", nb::arg("environment") = "", nb::kw_only(),
          nb::arg("seed") = 0, nb::arg("size_m") = 512.0, nb::arg("resolution_m") = 0.5,
          nb::arg("vocabulary") = "", nb::arg("height_map").none() = nb::none(),
          nb::arg("sketch").none() = nb::none(), nb::arg("elevation").none() = nb::none(),
          nb::arg("height_scale_m").none() = nb::none(),
          nb::arg("height_offset_m").none() = nb::none(), nb::arg("place").none() = nb::none(),
          nb::arg("keep_altitude") = false, nb::arg("elevation_unit") = "",
          nb::arg("progress").none() = nb::none(),
          "A world from words, and from a picture of its relief where a file is given. "
          "seed 0: one is drawn. place: of an elevation, the (latitude, longitude) [deg], WGS 84, "
          "that becomes the middle; None: the middle of the data. keep_altitude: z is the height "
          "in the data, else 0 is the lowest point. elevation_unit: of an ASCII grid's "
          "coordinates, \"degrees\" or \"metres\"; \"\": judged by its numbers. progress: called "
          "with (stage, fraction); what it raises ends the generation, as Ctrl-C does.")
      .def_static("load", &Load, nb::arg("path"), "A world from its bundle.")
      .def(
          "save",
          [](const PyWorld& world, const Path& path) {
            Check(WithoutLock([&] { return SaveBundle(world.world(), path); }));
          },
          nb::arg("path"), "Writes its bundle: a directory that is not there yet.")
      .def_prop_ro(
          "id", [](const PyWorld& world) { return world.world().id; }, "Same content, same id.")
      .def_prop_ro("seed", [](const PyWorld& world) { return world.world().request.seed; })
      .def_prop_ro("size_m", [](const PyWorld& world) { return world.scene().geometry().size_m(); })
      .def_prop_ro("resolution_m",
                   [](const PyWorld& world) { return world.scene().geometry().resolution_m(); })
      .def_prop_ro(
          "layout", [](const PyWorld& world) { return ToText(world.world().layout); },
          "y_L: 32 lines of 32 letters.")
      .def_prop_ro(
          "environment_json",
          [](const PyWorld& world) {
            return ToJson(world.scene().environment, *world.scene().catalogue);
          },
          "y_C.")
      .def_prop_ro(
          "fidelity_json",
          [](const PyWorld& world) { return EncodeFidelity(world.world().fidelity); },
          "How well it matches the words.")
      .def_prop_ro("warnings", [](const PyWorld& world) { return world.world().warnings; })
      .def_prop_ro("place", &PlaceOf,
                   "Where its middle lies: (latitude [deg], longitude [deg], altitude of z = 0 "
                   "[m]), WGS 84 and the datum of the data; None: nowhere on the earth.")
      .def_prop_ro("agents", &AgentsOf, "Where agents begin: a list of dicts.")
      .def_prop_ro(
          "heights",
          [](nb::handle_t<PyWorld> self) {
            return ViewOf<float>(nb::cast<PyWorld&>(self).scene().terrain->ground.height_m(), self);
          },
          "Of the ground [m], float32; below water: of the bed.")
      .def_prop_ro(
          "water_level",
          [](nb::handle_t<PyWorld> self) {
            return ViewOf<float>(nb::cast<PyWorld&>(self).scene().terrain->water_level_m, self);
          },
          "Of the water's surface [m], float32; NaN: dry.")
      .def_prop_ro(
          "surface",
          [](nb::handle_t<PyWorld> self) {
            return ViewOf<std::uint8_t>(nb::cast<PyWorld&>(self).scene().terrain->surface, self);
          },
          "What the ground is made of, uint8: places in latticeworld.SURFACES.")
      .def_prop_ro(
          "occupancy",
          [](nb::handle_t<PyWorld> self) { return OccupancyOf(self, "wheeled robot"); },
          "Of the wheeled robot, int8: 0 free .. 100 occupied, graded on slopes; made when first "
          "asked for.")
      .def(
          "occupancy_for",
          [](nb::handle_t<PyWorld> self, const std::string& species) {
            return OccupancyOf(self, species);
          },
          nb::arg("species"),
          "The same for the footprint of another species: what Simulation's robot_species takes.")
      .def("height_at", &HeightAt, nb::arg("x_m"), nb::arg("y_m"),
           "Of the ground's triangulation [m].");
}

}  // namespace latticeworld::python
