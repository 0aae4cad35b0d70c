#ifndef LATTICEWORLD_BENCHMARKS_SIMULATION_STEP_TIMES_H_
#define LATTICEWORLD_BENCHMARKS_SIMULATION_STEP_TIMES_H_

#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

namespace latticeworld {

// Processor time of the process [s]: other programs on the machine do not count.
double ProcessorTime();
// By the clock on the wall [s]: for what several threads do together.
double WallTime();

// How long each step of a run took.
class StepTimes {
 public:
  explicit StepTimes(double (*clock)() = &ProcessorTime) : clock_(clock) {}

  // Times step() so many times; answers the seconds in all.
  template <typename Step>
  double Run(int steps, Step&& step) {
    double sum_s = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double begin_s = clock_();
      step();
      times_s_.push_back(clock_() - begin_s);
      sum_s += times_s_.back();
    }
    return sum_s;
  }

  // A step that was timed elsewhere [s].
  void Add(double time_s) { times_s_.push_back(time_s); }

  double Mean() const;
  // share: in [0, 1]; 0.5 is the median.
  double Quantile(double share) const;
  std::size_t count() const { return times_s_.size(); }

 private:
  double (*clock_)();
  std::vector<double> times_s_;
};

// Counters steps_ps, real_time_factor, p50_us, p99_us and p99_over_p50.
void Report(benchmark::State& state, const StepTimes& ours, double step_s);
// Also bare_steps_ps, and vs_bare: how many times as fast as the bare loop ours is.
void ReportBeside(benchmark::State& state, const StepTimes& ours, const StepTimes& bare,
                  double step_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_BENCHMARKS_SIMULATION_STEP_TIMES_H_
