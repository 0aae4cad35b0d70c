#include "simulation/step_times.h"

#include <algorithm>
#include <ctime>
#include <numeric>

#include "process_time.h"

namespace latticeworld {

double ProcessorTime() { return ProcessCpuSeconds(); }

double WallTime() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double StepTimes::Mean() const {
  return std::accumulate(times_s_.begin(), times_s_.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, times_s_.size()));
}

double StepTimes::Quantile(double share) const {
  if (times_s_.empty()) return 0.0;
  std::vector<double> sorted = times_s_;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return sorted[static_cast<std::size_t>(rank)];
}

void Report(benchmark::State& state, const StepTimes& ours, double step_s) {
  constexpr double kMicroseconds = 1e6;
  const double median_s = ours.Quantile(0.5), late_s = ours.Quantile(0.99);
  state.counters["steps_ps"] = 1.0 / ours.Mean();
  state.counters["real_time_factor"] = step_s / ours.Mean();
  state.counters["p50_us"] = kMicroseconds * median_s;
  state.counters["p99_us"] = kMicroseconds * late_s;
  state.counters["p99_over_p50"] = late_s / median_s;
}

void ReportBeside(benchmark::State& state, const StepTimes& ours, const StepTimes& bare,
                  double step_s) {
  Report(state, ours, step_s);
  state.counters["bare_steps_ps"] = 1.0 / bare.Mean();
  state.counters["vs_bare"] = bare.Mean() / ours.Mean();
}

}  // namespace latticeworld
