#include "crew.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "errors.h"
#include "latticeworld/learning/arena_crew.h"
#include "simulation.h"

namespace latticeworld::python {
namespace {

using Doubles = nb::ndarray<const double, nb::ndim<3>, nb::c_contig, nb::device::cpu>;
using Flags = nb::ndarray<const bool, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Views = nb::ndarray<double, nb::ndim<3>, nb::c_contig, nb::device::cpu>;
using Scans = nb::ndarray<float, nb::ndim<3>, nb::c_contig, nb::device::cpu>;

class PyCrew {
 public:
  PyCrew(std::vector<std::string> robots, int sectors, float max_range_m, int threads)
      : crew_(std::make_unique<ArenaCrew>(CrewLayout{std::move(robots), sectors, max_range_m},
                                          threads)) {}
  ~PyCrew() {
    if (guard_.forked()) (void)crew_.release();  // its threads cannot be waited for
  }
  PyCrew(const PyCrew&) = delete;
  PyCrew& operator=(const PyCrew&) = delete;

  int threads() const { return crew_->threads(); }

  // Arrays are (simulations, robots, ...). The answers: None or an error's words, by simulation.
  nb::list Advance(const std::vector<std::shared_ptr<PySimulation>>& simulations,
                   const std::vector<int>& steps, const Doubles& actions, const Flags& acting,
                   const Views& views, const Scans& scans) {
    guard_.Check();
    CheckShapes(simulations.size(), steps.size(), actions, acting, views, scans);
    std::deque<PySimulation::Use> uses;
    std::vector<Arena*> arenas;
    for (const auto& simulation : simulations) {
      arenas.push_back(uses.emplace_back(simulation.get()).get());
      if (crew_->layout().sectors > 0 && arenas.back()->scanner() == nullptr) {
        Check(FailedPrecondition("a simulation was made without sensors"));
      }
    }
    CrewArrays arrays;
    arrays.actions = actions.data();
    arrays.acting = reinterpret_cast<const unsigned char*>(acting.data());
    arrays.views = reinterpret_cast<RobotView*>(views.data());
    arrays.scans = scans.data();
    arrays.scan_stride = static_cast<std::size_t>(crew_->layout().sectors);
    const std::vector<Status> statuses =
        WithoutLock([&] { return crew_->Advance(arenas, steps, arrays); });
    nb::list answers;
    for (const Status& status : statuses) {
      answers.append(status.ok() ? nb::object(nb::none())
                                 : nb::object(nb::str(status.ToString().c_str())));
    }
    return answers;
  }

  // Resets simulations side by side, each with its seed.
  void Reset(const std::vector<std::shared_ptr<PySimulation>>& simulations,
             const std::vector<std::uint64_t>& seeds) {
    guard_.Check();
    if (simulations.size() != seeds.size()) Check(InvalidArgument("a seed for each is legal"));
    std::deque<PySimulation::Use> uses;
    std::vector<Arena*> arenas;
    for (const auto& simulation : simulations) {
      arenas.push_back(uses.emplace_back(simulation.get()).get());
    }
    WithoutLock([&] { Check(crew_->Reset(arenas, seeds)); });
  }

 private:
  void CheckShapes(std::size_t simulations, std::size_t steps, const Doubles& actions,
                   const Flags& acting, const Views& views, const Scans& scans) const {
    const CrewLayout& layout = crew_->layout();
    const std::size_t robots = layout.robots.size();
    const auto fits = [&](const auto& array, std::size_t depth) {
      return array.shape(0) == simulations && array.shape(1) == robots &&
             (array.ndim() < 3 || array.shape(2) == depth);
    };
    if (steps == simulations && fits(actions, 2) && fits(acting, 0) &&
        fits(views, kRobotViewFields) && fits(scans, static_cast<std::size_t>(layout.sectors))) {
      return;
    }
    Check(InvalidArgument("the arrays do not fit " + std::to_string(simulations) +
                          " simulations of " + std::to_string(robots) + " robots"));
  }

  ForkGuard guard_{"this crew of threads"};
  std::unique_ptr<ArenaCrew> crew_;
};

using Map = nb::ndarray<const bool, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Cells = nb::ndarray<nb::numpy, std::int64_t, nb::ndim<2>>;

// As FreeSpace of the client has it: cells (row, column), sorted, that are linked by sides with
// that one, which counts as free itself and so does what is `near` to it, at most `reach` away.
Cells Reachable(const Map& free, int row, int column, int reach, int near) {
  const int rows = static_cast<int>(free.shape(0)), columns = static_cast<int>(free.shape(1));
  const int low_row = std::max(0, row - reach), high_row = std::min(rows, row + reach + 1);
  const int low_column = std::max(0, column - reach);
  const int high_column = std::min(columns, column + reach + 1);
  const int width = high_column - low_column;
  std::vector<char> seen(static_cast<std::size_t>(std::max(0, high_row - low_row)) *
                         static_cast<std::size_t>(std::max(0, width)));
  const auto place = [&](int r, int c) {
    return static_cast<std::size_t>(r - low_row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(c - low_column);
  };
  std::deque<std::pair<int, int>> waiting;
  const auto visit = [&](int r, int c) {
    if (r < low_row || r >= high_row || c < low_column || c >= high_column) return;
    if (seen[place(r, c)] != 0) return;
    const bool is_near = std::abs(r - row) <= near && std::abs(c - column) <= near;
    const bool is_own = r == row && c == column;
    if (!is_own && !is_near && !free(static_cast<std::size_t>(r), static_cast<std::size_t>(c))) {
      return;
    }
    seen[place(r, c)] = 1;
    waiting.emplace_back(r, c);
  };
  visit(row, column);
  while (!waiting.empty()) {
    const auto [r, c] = waiting.front();
    waiting.pop_front();
    visit(r - 1, c);
    visit(r + 1, c);
    visit(r, c - 1);
    visit(r, c + 1);
  }
  const auto count = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), 1));
  auto* cells = new std::int64_t[2 * count];
  const nb::capsule owner(cells, [](void* p) noexcept { delete[] static_cast<std::int64_t*>(p); });
  std::size_t i = 0;
  for (int r = low_row; r < high_row; ++r) {
    for (int c = low_column; c < high_column; ++c) {
      if (seen[place(r, c)] == 0) continue;
      cells[i++] = r;
      cells[i++] = c;
    }
  }
  return Cells(cells, {count, 2}, owner);
}

}  // namespace

void BindCrew(nb::module_& module) {
  module.attr("ROBOT_FIELDS") = nb::make_tuple("x_m", "y_m", "z_m", "yaw_rad", "forward_mps",
                                               "yaw_rate_radps", "health", "contact_n", "alive");
  nb::class_<PyCrew>(module, "Crew")
      .def(nb::init<std::vector<std::string>, int, float, int>(), nb::arg("robots"),
           nb::arg("sectors"), nb::arg("max_range_m"), nb::arg("threads"))
      .def_prop_ro("threads", &PyCrew::threads)
      .def("advance", &PyCrew::Advance, nb::arg("simulations"), nb::arg("steps"),
           nb::arg("actions").noconvert(), nb::arg("acting").noconvert(),
           nb::arg("views").noconvert(), nb::arg("scans").noconvert())
      .def("reset", &PyCrew::Reset, nb::arg("simulations"), nb::arg("seeds"));
  module.def("reachable", &Reachable, nb::arg("free"), nb::arg("row"), nb::arg("column"),
             nb::arg("reach"), nb::arg("near"));
}

}  // namespace latticeworld::python
