#include "simulation.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "latticeworld/common/request_fields.h"
#include "latticeworld/learning/robot_view.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/sensed.h"
#include "latticeworld/simulation/start_warnings.h"

namespace latticeworld::python {
namespace {

using Use = PySimulation::Use;

// As world_server has it for worlds that lie nowhere on the earth.
constexpr double kLongitude_deg = 9.0;
constexpr int kNeutral = -1;  // team

std::shared_ptr<const SensorSuite> FindSuite(const std::string& name, const std::string& file) {
  std::shared_ptr<const SensorCatalogue> catalogue = SensorCatalogue::BuiltIn();
  if (!file.empty()) catalogue = Value(SensorCatalogue::Extended({{"sensors", file}}));
  const SensorSuite* suite = catalogue->FindSuite(name);
  if (suite == nullptr) {
    std::string names;
    for (const SensorSuite& legal : catalogue->suites()) names += ", " + legal.name;
    Check(
        InvalidArgument("there is no sensor suite \"" + name + "\"; legal are " + names.substr(2)));
  }
  return {catalogue, suite};  // shares the catalogue's life
}

// sensors: None, the name of a suite, or what has a name and a file of sensors as text.
std::shared_ptr<const SensorSuite> SuiteOf(nb::handle sensors) {
  if (sensors.is_none()) return nullptr;
  if (nb::isinstance<nb::str>(sensors)) return FindSuite(nb::cast<std::string>(sensors), "");
  if (!nb::hasattr(sensors, "sensor_file")) {
    throw nb::type_error(
        "sensors: legal are None, the name of a suite, and a latticeworld.Scanner");
  }
  return FindSuite(nb::cast<std::string>(sensors.attr("name")),
                   nb::cast<std::string>(sensors.attr("sensor_file")()));
}

std::shared_ptr<PySimulation> Create(std::shared_ptr<PyWorld> world, std::uint64_t seed,
                                     nb::object sensors, double step_s, double command_timeout_s,
                                     int physics_threads, const std::string& robot_species) {
  ArenaOptions options;
  options.simulator.step_s = step_s;
  options.simulator.command_timeout_s = command_timeout_s;
  options.simulator.physics_threads = physics_threads;
  options.simulator.robot_species = robot_species;
  options.sensors = SuiteOf(sensors);
  options.origin = world->world().geo.value_or(
      GeoOrigin{world->scene().atmosphere.latitude_deg, kLongitude_deg, 0.0});
  auto arena = WithoutLock([&] {
    return Arena::Create(world->world().scene, options,
                         seed != 0 ? seed : world->world().request.seed);
  });
  std::unique_ptr<Arena> made = Value(std::move(arena));
  for (const std::string& warning :
       StartWarnings(world->scene(), *made->simulator()->State(), *options.simulator.species)) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw nb::python_error();
  }
  return std::make_shared<PySimulation>(std::move(world), std::move(made));
}

const AgentSnapshot& MustFind(const WorldState& state, const std::string& name) {
  const AgentSnapshot* agent = FindAgent(state, name);
  if (agent != nullptr) return *agent;
  std::string names;
  for (const AgentSnapshot& other : state.agents) names += " " + other.name;
  throw StatusError(NotFound("there is no agent \"" + name + "\"; there are:" + names));
}

// Whoever carries sensors.
std::vector<std::string> Robots(const Arena& arena) {
  std::vector<std::string> robots;
  for (const AgentSnapshot& agent : arena.simulator().State()->agents) {
    if (HasSensors(agent)) robots.push_back(agent.name);
  }
  return robots;
}

void Command(PySimulation& self, const std::string& agent, double forward_mps,
             double yaw_rate_radps, double left_mps, double up_mps) {
  VelocityCommand command;
  command.linear_mps = {forward_mps, left_mps, up_mps};
  command.yaw_rate_radps = yaw_rate_radps;
  Check(Use(&self)->simulator()->Command(agent, command));
}

void Step(PySimulation& self, int steps, const std::optional<std::vector<std::string>>& scanned) {
  if (steps < 1) {
    Check(InvalidArgument("steps is " + std::to_string(steps) + "; legal is at least 1"));
  }
  const Use use(&self);
  const std::vector<std::string> robots = use->scanner() == nullptr ? std::vector<std::string>()
                                          : scanned                 ? *scanned
                                                                    : Robots(*use.get());
  for (const std::string& robot : robots) (void)MustFind(*use->simulator()->State(), robot);
  std::exception_ptr raised;
  const Status status = WithoutLock([&] {
    return use->Advance(steps, robots, [&raised] {
      const nb::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() == 0) return Status();
      raised = std::make_exception_ptr(nb::python_error());
      return Cancelled("interrupted");
    });
  });
  if (raised != nullptr) std::rethrow_exception(raised);
  Check(status);
}

// (9,) doubles: latticeworld.simulation.ROBOT_FIELDS.
nb::object ViewOfAgent(PySimulation& self, const std::string& name) {
  const Use use(&self);
  const auto state = use->simulator()->State();
  const RobotView view = ViewOf(MustFind(*state, name));
  const auto* values = reinterpret_cast<const double*>(&view);
  nb::list list;
  for (int i = 0; i < kRobotViewFields; ++i) list.append(values[i]);
  return nb::tuple(list);
}

nb::dict AgentOf(PySimulation& self, const std::string& name) {
  const Use use(&self);
  const auto state = use->simulator()->State();
  const AgentSnapshot& agent = MustFind(*state, name);
  const Eigen::Quaterniond& q = agent.orientation;
  const auto vector = [](const Eigen::Vector3d& v) { return nb::make_tuple(v.x(), v.y(), v.z()); };
  nb::dict dict;
  dict["name"] = agent.name;
  dict["species"] = agent.species;
  dict["radius_m"] = use->simulator()->options().species->Find(agent.species)->radius_m;
  dict["policy"] = agent.policy;
  dict["team"] = agent.team;
  dict["controllable"] = agent.controllable;
  dict["behaviour"] = std::string(NameOf(agent.behaviour));
  dict["alive"] = agent.behaviour != Behaviour::kDead;
  dict["health"] = agent.health;
  dict["position_m"] = vector(agent.position_m);
  dict["orientation_xyzw"] = nb::make_tuple(q.x(), q.y(), q.z(), q.w());
  dict["linear_velocity_mps"] = vector(agent.linear_velocity_mps);
  dict["angular_velocity_radps"] = vector(agent.angular_velocity_radps);
  dict["contact_n"] = agent.contact_force_n;
  return dict;
}

nb::list AgentNames(PySimulation& self) {
  const Use use(&self);
  nb::list names;
  for (const AgentSnapshot& agent : use->simulator()->State()->agents) names.append(agent.name);
  return names;
}

nb::list EventsOf(PySimulation& self) {
  const Use use(&self);
  nb::list events;
  for (const Event& event : use->events()) {
    nb::dict dict;
    dict["step"] = event.step;
    dict["kind"] = std::string(NameOf(event.kind));
    dict["agent"] = event.agent;
    dict["other"] = event.other;
    dict["position_m"] =
        nb::make_tuple(event.position_m.x(), event.position_m.y(), event.position_m.z());
    events.append(dict);
  }
  return events;
}

using FloatArray = nb::ndarray<nb::numpy, float, nb::ndim<1>>;

FloatArray NewArray(std::size_t size, float** values) {
  *values = new float[size];
  const nb::capsule owner(*values, [](void* p) noexcept { delete[] static_cast<float*>(p); });
  return FloatArray(*values, {size}, owner);
}

const LidarModel& MustHaveScanner(const Arena& arena) {
  if (arena.scanner() == nullptr) {
    Check(FailedPrecondition("this simulation was made without sensors"));
  }
  return *arena.scanner();
}

// None while no sweep is complete.
nb::object ScanOf(PySimulation& self, const std::string& robot) {
  const Use use(&self);
  (void)MustHaveScanner(*use.get());
  const LidarSweep* sweep = use->SweepOf(robot);
  if (sweep == nullptr) return nb::none();
  float* values = nullptr;
  FloatArray array = NewArray(sweep->ranges_m.size(), &values);
  std::copy(sweep->ranges_m.begin(), sweep->ranges_m.end(), values);
  return array.cast();
}

FloatArray SectorsOf(PySimulation& self, const std::string& robot, int sectors, float max_range_m) {
  const Use use(&self);
  const LidarModel& model = MustHaveScanner(*use.get());
  if (sectors < 1) Check(InvalidArgument("sectors must be at least 1"));
  float* values = nullptr;
  FloatArray array = NewArray(static_cast<std::size_t>(sectors), &values);
  NearestInSectors(use->SweepOf(robot), model.min_range_m, sectors, max_range_m, values);
  return array;
}

nb::object ScannerOf(PySimulation& self) {
  const Use use(&self);
  const LidarModel* model = use->scanner();
  if (model == nullptr) return nb::none();
  nb::dict dict;
  dict["beams"] = model->columns;
  dict["rate_hz"] = use->scan_rate_hz();
  dict["first_azimuth_rad"] = model->first_azimuth_rad;
  dict["field_of_view_rad"] = model->field_of_view_rad;
  dict["min_range_m"] = model->min_range_m;
  dict["max_range_m"] = model->max_range_m;
  return std::move(dict);
}

// The name of what was made; what is wrong with what was asked for is told of the arguments.
std::string Made(const Result<std::string>& name, std::string_view what,
                 const FieldNames& arguments) {
  if (name.ok() || name.status().violations().empty()) return Value(name);
  std::vector<Violation> violations = name.status().violations();
  Rename(arguments, &violations);
  throw StatusError(Status::FromViolations(what, std::move(violations)));
}

std::string Spawn(PySimulation& self, const std::string& name, const std::string& species,
                  const std::optional<std::pair<double, double>>& position_m,
                  const std::string& place, double heading_rad, bool controllable, int team,
                  const std::string& policy) {
  const Use use(&self);
  const SimulatorOptions& options = use->simulator()->options();
  SpawnRequest request;
  request.name = name;
  request.species = species.empty() ? options.robot_species : species;
  if (const Species* found = options.species->Find(request.species)) {
    request.species = found->name;
    request.category = found->category;
  }
  std::vector<Violation> unread;
  if (!place.empty()) {
    request.region = ReadName<Region>("place", place, &unread).value_or(Region::kAnywhere);
  } else if (position_m) {
    request.position = WorldPoint{position_m->first, position_m->second};
  }
  request.heading_rad = heading_rad;
  request.controllable = controllable;
  if (team != 0) request.team = team == kNeutral ? 0 : team;
  request.policy = policy;
  const auto spawned = [&]() -> Result<std::string> {
    if (unread.empty()) return use->simulator()->Spawn(request);
    return RefuseUnread("spawn", std::move(unread), Validate(request, *options.species));
  }();
  return Made(
      spawned, "spawn",
      {{"position.x", "position_m"}, {"position.y", "position_m"}, {"heading", "heading_rad"}});
}

std::string SpawnProp(PySimulation& self, const std::string& kind, double x_m, double y_m,
                      double heading_rad, const std::string& name) {
  const Use use(&self);
  std::vector<Violation> unread;
  Prop prop = UsualProp(ReadName<PropKind>("kind", kind, &unread).value_or(PropKind::kCrate));
  prop.name = name;
  prop.position = {x_m, y_m};
  prop.yaw_rad = heading_rad;
  const auto spawned = [&]() -> Result<std::string> {
    if (unread.empty()) return use->simulator()->SpawnProp(prop);
    return RefuseUnread("illegal element", std::move(unread), ValidateSpawn(prop));
  }();
  return Made(spawned, "illegal element",
              {{"position.x", "x_m"}, {"position.y", "y_m"}, {"heading", "heading_rad"}});
}

}  // namespace

void BindSimulation(nb::module_& module) {
  nb::class_<SimulatorSnapshot>(module, "Snapshot", "A simulation's state, to go back to.");
  nb::class_<PySimulation>(
      module, "Simulation", nb::is_weak_referenceable(),
      "A world that is stepped, and what its robots see. Same world, seed and calls: the same "
      "states and scans, bit for bit, as the service lockstep of world_server has them.")
      .def(nb::new_(&Create), nb::arg("world"), nb::kw_only(), nb::arg("seed") = 0,
           nb::arg("sensors").none() = "scanner", nb::arg("step_s") = 0.01,
           nb::arg("command_timeout_s") = 0.5, nb::arg("physics_threads") = 1,
           nb::arg("robot_species") = "wheeled robot",
           "seed: of behaviour and noise; 0: the world's. sensors: the name of a suite, a Scanner, "
           "or None.")
      .def_prop_ro("world", &PySimulation::world)
      .def_prop_ro("seed", [](PySimulation& self) { return Use(&self)->simulator()->seed(); })
      .def_prop_ro("step_s",
                   [](PySimulation& self) { return Use(&self)->simulator()->options().step_s; })
      .def_prop_ro(
          "episode_step",
          [](PySimulation& self) { return Use(&self)->simulator()->State()->episode_step; },
          "Fixed steps since the last reset.")
      .def_prop_ro("agents", &AgentNames, "Names of the agents, sorted.")
      .def_prop_ro("events", &EventsOf, "Of the last step(), in order: a list of dicts.")
      .def_prop_ro("scanner", &ScannerOf, "The robots' 2D lidar: a dict; None: they have none.")
      .def("command", &Command, nb::arg("agent"), nb::arg("forward_mps"),
           nb::arg("yaw_rate_radps") = 0.0, nb::arg("left_mps") = 0.0, nb::arg("up_mps") = 0.0,
           "Holds for command_timeout_s of simulated time.")
      .def("step", &Step, nb::arg("steps") = 1, nb::arg("scanned").none() = nb::none(),
           "So many fixed steps. scanned: names of robots whose sweeps are kept; None: of all that "
           "carry sensors. Ctrl-C ends it between two steps.")
      .def("agent", &AgentOf, nb::arg("name"), "All of an agent's state: a dict.")
      .def("view", &ViewOfAgent, nb::arg("robot"),
           "The values that latticeworld.ROBOT_FIELDS names, a tuple of floats.")
      .def("scan", &ScanOf, nb::arg("robot"),
           "Ranges [m] of the last complete sweep, float32, counter-clockwise; inf: nothing met, "
           "NaN: dropped, -inf: too near. None: no sweep yet.")
      .def("sectors", &SectorsOf, nb::arg("robot"), nb::arg("sectors"), nb::arg("max_range_m"),
           "The nearest return in each of so many equal parts of the sweep [m], float32, in "
           "0 .. max_range_m.")
      .def(
          "strike",
          [](PySimulation& self, const std::string& agent) {
            Check(Use(&self)->simulator()->Strike(agent));
          },
          nb::arg("agent"), "Strikes the nearest enemy within its reach.")
      .def("spawn", &Spawn, nb::arg("name") = "", nb::arg("species") = "",
           nb::arg("position_m").none() = nb::none(), nb::arg("place") = "",
           nb::arg("heading_rad") = 0.0, nb::arg("controllable") = true, nb::arg("team") = 0,
           nb::arg("policy") = "",
           "A new agent at a position (x, y) or at a place in words; its name. team: 0: what suits "
           "the species, -1: neutral.")
      .def("spawn_element", &SpawnProp, nb::arg("kind"), nb::arg("x_m"), nb::arg("y_m"),
           nb::arg("heading_rad") = 0.0, nb::arg("name") = "", "A crate, gate ...; its name.")
      .def(
          "remove",
          [](PySimulation& self, const std::string& agent) {
            Check(Use(&self)->simulator()->Remove(agent));
          },
          nb::arg("agent"))
      .def(
          "reset",
          [](PySimulation& self, std::uint64_t seed) {
            const Use use(&self);
            WithoutLock([&] { use->Reset(seed != 0 ? seed : use->simulator()->seed()); });
          },
          nb::arg("seed") = 0, "Back to the start. seed: of behaviour and noise; 0: as it is.")
      .def(
          "snapshot",
          [](PySimulation& self) {
            const Use use(&self);
            return std::const_pointer_cast<SimulatorSnapshot>(
                WithoutLock([&] { return use->simulator()->Save(); }));
          },
          "The whole state, to go back to as often as wanted.")
      .def(
          "restore",
          [](PySimulation& self, const SimulatorSnapshot& snapshot) {
            const Use use(&self);
            Check(WithoutLock([&] { return use->Restore(snapshot); }));
          },
          nb::arg("snapshot"), "Back to a snapshot; scans begin anew.")
      .def(
          "hash",
          [](PySimulation& self) {
            const Use use(&self);
            return WithoutLock([&] { return use->simulator()->StateHash(); });
          },
          "SHA-256 of all that the future depends on.");
}

}  // namespace latticeworld::python
