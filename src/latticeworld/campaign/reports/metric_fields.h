#ifndef LATTICEWORLD_CAMPAIGN_REPORTS_METRIC_FIELDS_H_
#define LATTICEWORLD_CAMPAIGN_REPORTS_METRIC_FIELDS_H_

#include <algorithm>
#include <limits>
#include <type_traits>

#include "latticeworld/navigation/tasks.h"
#include "latticeworld/navigation/trial_metrics.h"

namespace latticeworld {

// A number of a struct, by the name that files and tables give it.
template <typename Struct>
struct NumberField {
  const char* name;
  double (*get)(const Struct&);
  void (*set)(Struct*, double);
  const char* meaning;
};
using MetricField = NumberField<TrialMetrics>;
using DifficultyField = NumberField<TaskDifficulty>;

// set: a whole number takes the nearest that it can be.
template <auto Member, typename Struct>
constexpr NumberField<Struct> FieldOf(const char* name, const char* meaning) {
  return {name, [](const Struct& from) { return static_cast<double>(from.*Member); },
          [](Struct* to, double value) {
            using Value = std::decay_t<decltype(to->*Member)>;
            using Limits = std::numeric_limits<Value>;
            if constexpr (std::is_integral_v<Value>) {
              value = std::clamp<double>(value, Limits::lowest(), Limits::max());
            }
            to->*Member = static_cast<Value>(value);
          },
          meaning};
}

inline constexpr DifficultyField kDifficultyFields[] = {
    FieldOf<&TaskDifficulty::length_m, TaskDifficulty>("length_m", "length of the shortest way"),
    FieldOf<&TaskDifficulty::climb_m, TaskDifficulty>("climb_m", "all that it goes up"),
    FieldOf<&TaskDifficulty::density, TaskDifficulty>(
        "density", "share of the ground within 3 m of it that is not free"),
    FieldOf<&TaskDifficulty::detour, TaskDifficulty>("detour",
                                                     "its length by the straight distance"),
    FieldOf<&TaskDifficulty::agents, TaskDifficulty>("agents", "that begin within 20 m of it")};

// docs/navigation.md has the formulas and their sources.
inline constexpr MetricField kMetricFields[] = {
    FieldOf<&TrialMetrics::success, TrialMetrics>(
        "success", "survived, in time, and at the end within the goal's radius"),
    FieldOf<&TrialMetrics::goal_distance_m, TrialMetrics>("goal_distance_m",
                                                          "to the goal at the end, in plan"),
    FieldOf<&TrialMetrics::time_s, TrialMetrics>("time_s", "simulated"),
    FieldOf<&TrialMetrics::length_m, TrialMetrics>("driven_m", "length of the driven way"),
    FieldOf<&TrialMetrics::spl, TrialMetrics>("spl",
                                              "success weighted by path length (Anderson 2018)"),
    FieldOf<&TrialMetrics::sct, TrialMetrics>(
        "sct", "success weighted by completion time (Yokoyama 2021)"),
    FieldOf<&TrialMetrics::barn_4_8, TrialMetrics>("barn_4_8", "BARN's score (Xiao 2022)"),
    FieldOf<&TrialMetrics::barn_2_8, TrialMetrics>("barn_2_8", "BARN's score (Xiao 2023)"),
    FieldOf<&TrialMetrics::collisions, TrialMetrics>(
        "collisions", "contacts of physics with what is not ground that began"),
    FieldOf<&TrialMetrics::collision_free_m, TrialMetrics>("collision_free_m",
                                                           "driven before the first of them"),
    FieldOf<&TrialMetrics::least_time_to_collision_s, TrialMetrics>(
        "least_time_to_collision_s", "with the nearest other body (Hayward 1972)"),
    FieldOf<&TrialMetrics::path_irregularity_radpm, TrialMetrics>(
        "path_irregularity_radpm", "turning beyond what a straight way needs (Guzzi 2013)"),
    FieldOf<&TrialMetrics::mean_curvature_pm, TrialMetrics>("mean_curvature_pm",
                                                            "of the driven way (Menger)"),
    FieldOf<&TrialMetrics::mean_jerk_mps3, TrialMetrics>("mean_jerk_mps3",
                                                         "third derivative of the position"),
    FieldOf<&TrialMetrics::energy_j, TrialMetrics>("energy_j", "of the motors, absolute values"),
    FieldOf<&TrialMetrics::adversary_hits, TrialMetrics>("adversary_hits", "blows that it took"),
    FieldOf<&TrialMetrics::survived, TrialMetrics>("survived", ""),
    FieldOf<&TrialMetrics::timed_out, TrialMetrics>("timed_out", "")};

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_REPORTS_METRIC_FIELDS_H_
