#include "latticeworld/dataset/captions/relief_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace latticeworld {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFlat_m = 0.5;      // less is called flat
constexpr double kSlanted = 0.4;     // of the variance: the land as a whole rises one way
constexpr double kStandsOut = 0.15;  // of the relief, between the means of ninths

// The eighth of the compass that a direction points to.
void SetHeading(double east, double south, ReliefFacts* facts) {
  const int eighth = static_cast<int>(std::lround(std::atan2(south, east) / (kPi / 4.0)));
  static constexpr std::array<std::array<int, 2>, 9> kSteps = {
      {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};
  facts->rise_east = kSteps[static_cast<std::size_t>(eighth + 4)][0];
  facts->rise_south = kSteps[static_cast<std::size_t>(eighth + 4)][1];
}

// Lays a plane through the summary: columns and rows are orthogonal on a full grid, so that each
// slope is fitted alone.
void FitPlane(const Grid<float>& summary, double relief_m, ReliefFacts* facts) {
  const double middle_row = 0.5 * (summary.rows() - 1), middle_col = 0.5 * (summary.cols() - 1);
  double mean = 0.0, by_row = 0.0, by_col = 0.0, rows = 0.0, cols = 0.0;
  for (const float value : summary) mean += value;
  mean /= static_cast<double>(summary.rows()) * summary.cols();
  double variance = 0.0;
  for (int r = 0; r < summary.rows(); ++r) {
    for (int c = 0; c < summary.cols(); ++c) {
      const double value = summary(r, c) - mean;
      variance += value * value;
      by_row += value * (r - middle_row);
      by_col += value * (c - middle_col);
      rows += (r - middle_row) * (r - middle_row);
      cols += (c - middle_col) * (c - middle_col);
    }
  }
  if (variance <= 0.0) return;
  const double south = by_row / rows, east = by_col / cols;
  facts->rise_share = (south * south * rows + east * east * cols) / variance;
  facts->rise_m = std::hypot(south, east) * (summary.rows() - 1) * relief_m;
  SetHeading(east, south, facts);
}

std::string Metres(double value_m) {
  const double step = std::abs(value_m) >= 100.0 ? 10.0 : std::abs(value_m) >= 10.0 ? 1.0 : 0.5;
  const double rounded = std::round(value_m / step) * step;
  const bool half = rounded != std::round(rounded);
  std::string text = std::to_string(static_cast<long>(rounded));
  if (half) text = (rounded < 0 && rounded > -1 ? "-" : "") + text + ".5";
  return text;
}

std::string_view Compass(int east, int south) {
  static constexpr std::array<std::array<std::string_view, 3>, 3> kWords = {
      {{"north-west", "north", "north-east"},
       {"west", "middle", "east"},
       {"south-west", "south", "south-east"}}};
  return kWords[static_cast<std::size_t>(south + 1)][static_cast<std::size_t>(east + 1)];
}

std::string_view Picture(int east, int south) {
  static constexpr std::array<std::array<std::string_view, 3>, 3> kWords = {
      {{"upper left", "top", "upper right"},
       {"left", "middle", "right"},
       {"lower left", "bottom", "lower right"}}};
  return kWords[static_cast<std::size_t>(south + 1)][static_cast<std::size_t>(east + 1)];
}

std::string Side(int east, int south, bool picture) {
  return std::string(picture ? Picture(east, south) : Compass(east, south));
}

std::string Side(Region region, bool picture) {
  const int ninth = static_cast<int>(region);
  return Side(ninth % 3 - 1, ninth / 3 - 1, picture);
}

// "at the top", "on the left", "in the upper left", "in the north".
std::string Placed(const std::string& side) {
  const bool end = side == "top" || side == "bottom";
  const bool flank = side == "left" || side == "right";
  return (end ? "at the " : flank ? "on the " : "in the ") + side;
}

}  // namespace

ReliefFacts FactsOf(const Relief& relief) {
  ReliefFacts facts;
  const auto [low, high] = std::minmax_element(relief.height_m.begin(), relief.height_m.end());
  facts.low_m = *low;
  facts.high_m = *high;
  const double relief_m = facts.high_m - facts.low_m;

  std::array<double, 9> sums{}, counts{};
  for (int r = 0; r < relief.summary.rows(); ++r) {
    for (int c = 0; c < relief.summary.cols(); ++c) {
      const auto ninth = static_cast<std::size_t>(3 * (3 * r / relief.summary.rows()) +
                                                  3 * c / relief.summary.cols());
      sums[ninth] += relief.summary(r, c);
      counts[ninth] += 1.0;
    }
  }
  for (std::size_t i = 0; i < 9; ++i) sums[i] /= counts[i];
  const auto [lowest, highest] = std::minmax_element(sums.begin(), sums.end());
  facts.highest = static_cast<Region>(highest - sums.begin());
  facts.lowest = static_cast<Region>(lowest - sums.begin());
  facts.means_m = (*highest - *lowest) * relief_m;
  facts.middle_high = facts.highest == Region::kCenter;
  facts.middle_low = facts.lowest == Region::kCenter;
  FitPlane(relief.summary, relief_m, &facts);
  return facts;
}

std::string WordRelief(const ReliefFacts& facts, Voice voice, bool picture, RandomStream* random) {
  const PhraseBook& book = PhraseBook::BuiltIn();
  const double relief_m = facts.high_m - facts.low_m;
  const std::vector<Slot> slots = {
      {"from", Side(-facts.rise_east, -facts.rise_south, picture)},
      {"to", Side(facts.rise_east, facts.rise_south, picture)},
      {"high", Side(facts.highest, picture)},
      {"low", Side(facts.lowest, picture)},
      {"high_at", Placed(Side(facts.highest, picture))},
      {"low_at", Placed(Side(facts.lowest, picture))},
      {"rise", Metres(facts.rise_m)},
      {"relief", Metres(relief_m)},
      {"lowest", Metres(facts.low_m)},
      {"highest", Metres(facts.high_m)},
  };
  std::vector<std::string> keys;
  if (relief_m < kFlat_m) {
    keys = {"relief.flat"};
  } else if (facts.rise_share >= kSlanted && facts.rise_m >= 1.0) {
    keys = {"relief.rise"};
  } else if (facts.means_m < kStandsOut * relief_m) {
    keys = {"relief.rolling"};
  } else if (facts.middle_high || facts.middle_low) {
    keys = {facts.middle_high ? "relief.hill" : "relief.basin"};
  } else {
    keys = {"relief.places"};
  }
  if (keys.front() == "relief.rise" && random->Chance(0.5)) keys.push_back("relief.places");
  if (relief_m >= kFlat_m && random->Chance(0.6)) keys.push_back("relief.metres");
  std::string text;
  for (const std::string& key : keys) {
    if (!text.empty()) text += ' ';
    text += Capitalised(FillPhrase(book.Pick(key, voice, random), slots, false)) + ".";
  }
  return text;
}

}  // namespace latticeworld
