#include "latticeworld/campaign/reports/report_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "latticeworld/campaign/reports/metric_fields.h"
#include "latticeworld/common/markup.h"

namespace latticeworld {
namespace {

constexpr int kBins = 12;
constexpr int kBarsHeight_px = 110, kBarWidth_px = 20;

std::string Percent(double share) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.0f&nbsp;%%", 100.0 * share);
  return text;
}

std::string Row(const std::vector<std::string>& cells, const char* kind = "td") {
  std::string row = "<tr>";
  for (const std::string& cell : cells)
    row += std::string("<") + kind + ">" + cell + "</" + kind + ">";
  return row + "</tr>\n";
}

std::string NameOfGroup(const TrialGroup& group) {
  if (group.by == "all") return "<b>all</b>";
  return EscapeMarkup(group.by) + " <b>" + EscapeMarkup(group.name) + "</b>";
}

// Text of that class with its middle, or its begin, at a place.
std::string Label(double x_px, double y_px, const std::string& text, const char* anchor) {
  char begin[96];
  std::snprintf(begin, sizeof(begin), "<text x=\"%.0f\" y=\"%.0f\" text-anchor=\"%s\">", x_px, y_px,
                anchor);
  return begin + EscapeMarkup(text) + "</text>";
}

}  // namespace

std::string FigureText(double value) {
  if (!std::isfinite(value)) return "-";
  char text[32];
  if (value == std::floor(value) && std::abs(value) < 1e6) {
    std::snprintf(text, sizeof(text), "%.0f", value);
  } else {
    std::snprintf(text, sizeof(text), std::abs(value) < 10.0 ? "%.2f" : "%.1f", value);
  }
  return text;
}

std::string GroupTable(const std::vector<TrialGroup>& groups) {
  std::string table = "<table class=\"figures\">\n" +
                      Row({"trials of", "number", "errors", "success", "95&nbsp;% interval", "SPL",
                           "SCT", "BARN 2-8", "with collisions", "collisions", "time-outs",
                           "survived", "hits", "time s", "way m", "energy J"},
                          "th");
  for (const TrialGroup& group : groups) {
    const TrialSummary& s = group.summary;
    if (s.trials == 0) {
      table += Row({NameOfGroup(group), "0", std::to_string(group.errors)});
      continue;
    }
    table +=
        Row({NameOfGroup(group), std::to_string(s.trials), std::to_string(group.errors),
             "<b>" + Percent(s.success_share) + "</b>",
             Percent(s.success_low) + " to " + Percent(s.success_high), FigureText(s.mean_spl),
             FigureText(s.mean_sct), FigureText(s.mean_barn_2_8), Percent(s.collision_share),
             FigureText(s.mean_collisions), Percent(s.timeout_share), Percent(s.survival_share),
             FigureText(s.mean_adversary_hits), FigureText(s.mean_time_s),
             FigureText(s.mean_length_m), FigureText(s.mean_energy_j)});
  }
  return table + "</table>\n";
}

std::string Histogram(const std::string& title, const std::vector<double>& values) {
  std::vector<double> finite;
  for (const double value : values) {
    if (std::isfinite(value)) finite.push_back(value);
  }
  if (finite.empty()) return "";
  const double low = *std::min_element(finite.begin(), finite.end());
  const double high = *std::max_element(finite.begin(), finite.end());
  const double width = high > low ? (high - low) / kBins : 1.0;
  std::vector<int> counts(kBins, 0);
  for (const double value : finite)
    ++counts[static_cast<std::size_t>(
        std::clamp(static_cast<int>((value - low) / width), 0, kBins - 1))];
  const int most = *std::max_element(counts.begin(), counts.end());
  const int all_px = kBins * kBarWidth_px;
  char head[160];
  std::snprintf(head, sizeof(head),
                "<svg class=\"bars\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\">",
                all_px + 20, kBarsHeight_px + 50, all_px + 20, kBarsHeight_px + 50);
  std::string svg = head + Label(10, 14, title, "start");
  for (int i = 0; i < kBins; ++i) {
    const int count = counts[static_cast<std::size_t>(i)];
    const double height_px = static_cast<double>(kBarsHeight_px) * count / most;
    char bar[240];
    std::snprintf(bar, sizeof(bar),
                  "<rect x=\"%d\" y=\"%.1f\" width=\"%d\" height=\"%.1f\"><title>%s to %s: "
                  "%d</title></rect>",
                  10 + i * kBarWidth_px, 24 + kBarsHeight_px - height_px, kBarWidth_px - 2,
                  height_px, FigureText(low + i * width).c_str(),
                  FigureText(low + (i + 1) * width).c_str(), count);
    svg += bar;
  }
  const double axis_px = 24 + kBarsHeight_px + 16;
  return svg + Label(10, axis_px, FigureText(low), "start") +
         Label(10 + all_px / 2.0, axis_px, "most: " + std::to_string(most), "middle") +
         Label(10 + all_px, axis_px, FigureText(high), "end") + "</svg>\n";
}

std::string Definitions() {
  std::string list = "<dl id=\"definitions\">\n";
  const auto add = [&list](const char* name, const char* meaning) {
    if (*meaning == '\0') return;
    list += std::string("<dt id=\"") + name + "\">" + name + "</dt><dd>" + EscapeMarkup(meaning) +
            "</dd>\n";
  };
  for (const DifficultyField& field : kDifficultyFields) add(field.name, field.meaning);
  for (const MetricField& field : kMetricFields) add(field.name, field.meaning);
  return list + "</dl>\n";
}

std::string FailureList(const std::vector<FinishedTrial>& trials, const std::string& command) {
  std::string rows;
  for (const FinishedTrial& trial : trials) {
    const TrialResult& result = trial.result;
    if (result.error.empty() && result.metrics.success) continue;
    rows += Row({EscapeMarkup(trial.plan.id), EscapeMarkup(result.Outcome()),
                 EscapeMarkup(result.error.empty() ? result.why : result.error),
                 result.error.empty() ? FigureText(result.metrics.goal_distance_m) : "",
                 "<code>" + EscapeMarkup(command + " --only " + trial.plan.id) + "</code>"});
  }
  if (rows.empty()) return "";
  return "<table>\n" + Row({"trial", "outcome", "reason", "from goal m", "shows it again"}, "th") +
         rows + "</table>\n";
}

std::string TrialTable(const std::vector<FinishedTrial>& trials) {
  std::vector<std::string> head = {"trial", "outcome"};
  for (const DifficultyField& field : kDifficultyFields)
    head.push_back(std::string("<a href=\"#") + field.name + "\">" + field.name + "</a>");
  for (const MetricField& field : kMetricFields) {
    if (*field.meaning != '\0')
      head.push_back(std::string("<a href=\"#") + field.name + "\">" + field.name + "</a>");
  }
  std::string table = "<table class=\"figures\">\n" + Row(head, "th");
  for (const FinishedTrial& trial : trials) {
    std::vector<std::string> cells = {EscapeMarkup(trial.plan.id),
                                      EscapeMarkup(trial.result.Outcome())};
    if (trial.result.error.empty()) {
      for (const DifficultyField& field : kDifficultyFields)
        cells.push_back(FigureText(field.get(trial.result.difficulty)));
      for (const MetricField& field : kMetricFields) {
        if (*field.meaning != '\0') cells.push_back(FigureText(field.get(trial.result.metrics)));
      }
    }
    table += Row(cells);
  }
  return table + "</table>\n";
}

std::string StyleSheet() {
  return R"(<style>
body{font:15px/1.45 sans-serif;max-width:1280px;margin:2em auto;padding:0 1em;color:#222}
h1{font-size:1.7em}h2{margin-top:2em;border-bottom:1px solid #ccc}
table{border-collapse:collapse;font-size:.85em}th,td{padding:.2em .55em;text-align:left;white-space:nowrap}
th{border-bottom:2px solid #888;vertical-align:bottom}tr:nth-child(even) td{background:#f4f4f2}
.figures td:not(:first-child){text-align:right}.wide{overflow-x:auto;max-height:32em}
code{font-size:.9em}figure{display:inline-block;margin:.4em;vertical-align:top}
figcaption{max-width:400px;font-size:.85em}dt{font-weight:bold;float:left;clear:left;width:15em}
dd{margin-left:16em}.bars rect{fill:#0072b2}.bars text{font:12px sans-serif}
.map polyline{fill:none;stroke-linejoin:round}.shortest{stroke:#111;stroke-width:1.6;stroke-dasharray:5 3}
.halo{stroke:#fff;stroke-width:3.6;opacity:.75}.driven{stroke:#0072b2;stroke-width:2}
.lost{stroke:#d55e00}.start{fill:#fff;stroke:#111}.goal{fill:#f0e442;stroke:#111}
</style>
)";
}

}  // namespace latticeworld
