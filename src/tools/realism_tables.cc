#include "tools/realism_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <string>

#include "tools/realism_figures.h"

namespace latticeworld::tools {
namespace {

constexpr std::size_t kNameWidth = 28;
constexpr int kColumnWidth = 8;

// "-" for NaN.
std::string Number(double value, int decimals) {
  if (std::isnan(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  return text;
}

std::string Range(const RealismFigure& figure) {
  if (!figure.has_range()) return "-";
  const int decimals = figure.decimals == 1 ? 0 : figure.decimals;
  return Number(figure.low, decimals) + " to " + Number(figure.high, decimals);
}

std::string Padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string Right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

// The last part of a path that is too long tells more than the first.
std::string Name(const std::string& path) {
  if (path.size() < kNameWidth) return Padded(path, kNameWidth);
  return Padded("..." + path.substr(path.size() - (kNameWidth - 4)), kNameWidth);
}

// "240 x 187 cells of 70.9 m"
std::string Size(const MeasuredLand& land) {
  return std::to_string(land.cols) + " x " + std::to_string(land.rows) + " cells of " +
         Number(land.resolution_m, land.resolution_m < 9.995 ? 2 : 1) + " m";
}

template <typename Cell>
void PrintLine(const std::string& name, std::size_t columns, Cell cell, std::ostream* out) {
  *out << name;
  for (std::size_t i = 0; i < columns; ++i) *out << Right(cell(i), kColumnWidth);
  *out << "\n";
}

}  // namespace

void PrintLand(const MeasuredLand& land, std::ostream* out) {
  const RealismMeasures& m = land.measures;
  // The first lines tell what was measured, without a verdict.
  *out << "land         " << land.path << "\n"
       << "size         " << Size(land) << ", " << Number(100.0 * m.dry_share, 1)
       << " % of it dry land, " << Number(m.relief_m, 1) << " m from its lowest to its highest\n";
  *out << "slope        ";
  constexpr std::array<const char*, 5> kShares = {"5", "25", "50", "75", "95"};
  for (std::size_t q = 0; q < kShares.size(); ++q) {
    *out << (q == 0 ? "" : ", ") << Number(m.slope_quantiles_rad[q] * 180.0 / M_PI, 1) << " ("
         << kShares[q] << " %)";
  }
  *out << " degrees or less\n"
       << "hypsometry   ";
  for (std::size_t k = 0; k < m.hypsometric_curve.size(); ++k) {
    *out << (k == 0 ? "" : " ") << Number(m.hypsometric_curve[k], 2);
  }
  *out << " of the land above 0, 0.1 .. 1 of its height\n"
       << "channels     ";
  for (std::size_t i = 0; i < m.streams_of_order.size(); ++i) {
    *out << (i == 0 ? "" : ", ") << m.streams_of_order[i];
  }
  *out << (m.streams_of_order.empty() ? "none" : " streams of order 1, 2 ..") << " that drain "
       << Number(m.channel_area_m2, 0) << " m2 or more\n";
  if (!std::isnan(m.spectrum_min_m)) {
    *out << "spectra      wavelengths from " << Number(m.spectrum_min_m, 1) << " to "
         << Number(m.spectrum_max_m, 0) << " m\n";
  }
  // A table compares each figure with its range in nature.
  *out << "\n"
       << Padded("measure", 40) << Right("value", 8) << Right("+-", 7) << "   "
       << Padded("nature", 15) << Padded("within", 8) << "source\n";
  for (const RealismFigure& figure : FiguresOf(m, land.kind)) {
    *out << Padded(std::string(figure.title), 40)
         << Right(Number(figure.estimate.value, figure.decimals), 8)
         << Right(Number(figure.estimate.standard_error, figure.decimals), 7) << "   "
         << Padded(Range(figure), 15);
    const char* verdict = !figure.has_range()                 ? "-"
                          : std::isnan(figure.estimate.value) ? "?"
                          : figure.within()                   ? "yes"
                                                              : "NO";
    *out << (figure.source.empty() ? std::string(verdict)
                                   : Padded(verdict, 8) + std::string(figure.source))
         << "\n";
  }
}

void PrintLands(const std::vector<MeasuredLand>& lands, std::ostream* out) {
  std::vector<std::vector<RealismFigure>> figures;
  for (const MeasuredLand& land : lands) figures.push_back(FiguresOf(land.measures, land.kind));
  const std::vector<RealismFigure>& first = figures.front();
  const auto print = [&](const std::string& name, auto cell) {
    PrintLine(Name(name), first.size(), cell, out);
  };
  print("land", [&](std::size_t i) { return std::string(first[i].heading); });
  for (std::size_t l = 0; l < lands.size(); ++l) {
    print(lands[l].path, [&](std::size_t i) {
      return Number(figures[l][i].estimate.value, figures[l][i].decimals);
    });
  }
  const std::vector<FigureSummary> summaries = Summarize(lands);
  print("mean", [&](std::size_t i) { return Number(summaries[i].mean, first[i].decimals); });
  print("spread", [&](std::size_t i) { return Number(summaries[i].spread, first[i].decimals); });
  print("nature from", [&](std::size_t i) { return Number(first[i].low, first[i].decimals); });
  print("nature to", [&](std::size_t i) { return Number(first[i].high, first[i].decimals); });
  print("within", [&](std::size_t i) {
    return first[i].has_range()
               ? std::to_string(summaries[i].within) + "/" + std::to_string(lands.size())
               : std::string("-");
  });
  *out << "\n";
  for (const RealismFigure& figure : first) {
    *out << Padded(std::string(figure.heading), 8) << figure.title;
    if (!figure.source.empty()) *out << "; nature: " << figure.source;
    *out << "\n";
  }
}

}  // namespace latticeworld::tools
