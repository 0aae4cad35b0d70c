#include "latticeworld/geomorphology/realism_channels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/geomorphology/realism_fit.h"

namespace latticeworld {
namespace {

constexpr double kMinChannelCells = 50.0;
constexpr double kMinChannelShare = 1.0 / 2000.0;  // of the piece
constexpr int kSegmentSteps = 8;
constexpr int kMinSegments = 5;  // in a half octave of area
constexpr int kMinLinks = 3;
constexpr int kMinStreams = 10;

// The land as the water runs over it. Vectors have one entry a cell.
struct Drained {
  FlowGraph flow;
  Grid<float> area_cells;
  std::vector<unsigned char> channel;
  std::vector<unsigned char> open;  // 1: water from beyond the edge may come through here
  std::vector<float> length_m;      // of the longest way that water takes to here
};

// One step of the water from a cell to its receiver.
double StepLength(const FlowGraph& flow, std::int32_t cell, double resolution_m) {
  const std::int32_t receiver = flow.receiver[cell];
  const bool straight =
      receiver / flow.cols == cell / flow.cols || receiver % flow.cols == cell % flow.cols;
  return receiver == cell ? 0.0 : resolution_m * (straight ? 1.0 : M_SQRT2);
}

bool IsBorder(int row, int col, int rows, int cols) {
  return row == 0 || col == 0 || row == rows - 1 || col == cols - 1;
}

Grid<unsigned char> Outlets(const Grid<unsigned char>& dry) {
  Grid<unsigned char> outlets(dry.rows(), dry.cols());
  for (int r = 0; r < dry.rows(); ++r) {
    for (int c = 0; c < dry.cols(); ++c) {
      outlets(r, c) = IsBorder(r, c, dry.rows(), dry.cols()) || dry(r, c) == 0 ? 1 : 0;
    }
  }
  return outlets;
}

// Returns the neighbour that the steepest way from a cell leads to; the cell itself if none is
// lower.
CellIndex SteepestNeighbour(const Grid<float>& height_m, CellIndex cell) {
  CellIndex steepest = cell;
  double steepest_drop = 0.0;
  for (int dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      const CellIndex neighbour{cell.row + dr, cell.col + dc};
      if (neighbour == cell || !height_m.Contains(neighbour)) continue;
      const double drop =
          (height_m[cell] - height_m[neighbour]) / (dr != 0 && dc != 0 ? M_SQRT2 : 1.0);
      if (drop > steepest_drop) {
        steepest_drop = drop;
        steepest = neighbour;
      }
    }
  }
  return steepest;
}

// Marks the cells at the border where water runs into the piece, and all below them.
std::vector<unsigned char> FindOpen(const Grid<float>& height_m, const Grid<unsigned char>& dry,
                                    const FlowGraph& flow) {
  std::vector<unsigned char> open(height_m.size(), 0);
  const int rows = height_m.rows();
  const int cols = height_m.cols();
  for (int r = 0; r < rows; ++r) {
    const int step = r == 0 || r == rows - 1 ? 1 : cols - 1;
    for (int c = 0; c < cols; c += step) {
      const CellIndex inward = SteepestNeighbour(height_m, {r, c});
      if (dry(r, c) != 0 && !IsBorder(inward.row, inward.col, rows, cols)) {
        open[inward.row * cols + inward.col] = 1;
      }
    }
  }
  for (auto cell = flow.order.rbegin(); cell != flow.order.rend(); ++cell) {
    if (open[*cell] != 0) open[flow.receiver[*cell]] = 1;
  }
  return open;
}

Drained Drain(const Grid<float>& height_m, double resolution_m, const Grid<unsigned char>& dry,
              double channel_cells, int threads) {
  Drained land;
  const Grid<unsigned char> outlets = Outlets(dry);
  land.flow = RouteFlow(height_m, &outlets, threads);
  land.area_cells = FlowAccumulation(land.flow, nullptr);  // no water above dry land: it ends there
  land.open = FindOpen(height_m, dry, land.flow);
  land.channel.resize(height_m.size());
  land.length_m.resize(height_m.size());
  for (auto cell = land.flow.order.rbegin(); cell != land.flow.order.rend(); ++cell) {
    land.channel[*cell] =
        dry.data()[*cell] != 0 && land.area_cells.data()[*cell] >= channel_cells ? 1 : 0;
    float* below_m = &land.length_m[land.flow.receiver[*cell]];
    const double step_m = StepLength(land.flow, *cell, resolution_m);
    *below_m = std::max(*below_m, static_cast<float>(land.length_m[*cell] + step_m));
  }
  return land;
}

// The cells of each link of the network from its upper to its lower end: from where a channel
// begins or two meet to before the next meeting or to the outlet.
std::vector<std::vector<std::int32_t>> Links(const FlowGraph& flow,
                                             const std::vector<unsigned char>& channel) {
  std::vector<std::uint8_t> donors(channel.size(), 0);
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const std::int32_t receiver = flow.receiver[i];
    if (channel[i] != 0 && receiver != static_cast<std::int32_t>(i)) ++donors[receiver];
  }
  std::vector<std::vector<std::int32_t>> links;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    if (channel[i] == 0 || donors[i] == 1) continue;
    auto cell = static_cast<std::int32_t>(i);
    links.push_back({cell});
    for (;;) {
      const std::int32_t receiver = flow.receiver[cell];
      if (receiver == cell || channel[receiver] == 0 || donors[receiver] != 1) break;
      cell = receiver;
      links.back().push_back(cell);
    }
  }
  return links;
}

// Slope against area.
RealismEstimate Concavity(const Grid<float>& height_m, double resolution_m, const Drained& land,
                          const std::vector<std::vector<std::int32_t>>& links,
                          double channel_cells) {
  HalfOctaves by_area(channel_cells);
  for (const std::vector<std::int32_t>& link : links) {
    const int cells = static_cast<int>(link.size());
    const int segments = std::max(1, cells / kSegmentSteps);
    for (int s = 0; s < segments; ++s) {
      const int begin = s * cells / segments;
      const int end = (s + 1) * cells / segments;
      double length_m = 0.0;
      double log_area = 0.0;
      for (int i = begin; i < end; ++i) {
        length_m += StepLength(land.flow, link[i], resolution_m);
        log_area += std::log(land.area_cells.data()[link[i]]) / (end - begin);
      }
      if (length_m == 0.0 || land.open[link[end - 1]] != 0) continue;
      const double drop_m = height_m.data()[link[begin]] -
                            static_cast<double>(height_m.data()[land.flow.receiver[link[end - 1]]]);
      by_area.Add(std::exp(log_area), drop_m, length_m);
    }
  }
  std::vector<double> log_area, log_slope;
  int count = 0;
  for (const HalfOctaves::Bin& bin : by_area.bins()) {
    if (bin.count < kMinSegments || !(bin.value > 0.0)) continue;
    log_area.push_back(bin.log_key / bin.weight);
    log_slope.push_back(std::log(bin.value / bin.weight));
    count += bin.count;
  }
  RealismEstimate concavity = FitSlope(log_area, log_slope);
  concavity.value = -concavity.value;
  concavity.count = count;
  return concavity;
}

// Longest length upstream against area.
RealismEstimate HackExponent(const Drained& land,
                             const std::vector<std::vector<std::int32_t>>& links,
                             double channel_cells) {
  HalfOctaves by_area(channel_cells);
  for (const std::vector<std::int32_t>& link : links) {
    const std::int32_t end = link.back();
    if (land.open[end] != 0 || !(land.length_m[end] > 0.0f)) continue;
    by_area.Add(land.area_cells.data()[end], std::log(land.length_m[end]), 1.0);
  }
  std::vector<double> log_area, log_length;
  int count = 0;
  for (const HalfOctaves::Bin& bin : by_area.bins()) {
    if (bin.count < kMinLinks) continue;
    log_area.push_back(bin.log_key / bin.weight);
    log_length.push_back(bin.value / bin.weight);
    count += bin.count;
  }
  RealismEstimate exponent = FitSlope(log_area, log_length);
  exponent.count = count;
  return exponent;
}

// Share of the dry cells that lie below where their water would spill.
double DepressionShare(const Grid<float>& height_m, const Grid<unsigned char>& dry, int threads) {
  const Grid<unsigned char> outlets = Outlets(dry);
  const Grid<float> filled_m = FillDepressions(height_m, &outlets, threads);
  std::size_t below = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < dry.size(); ++i) {
    if (dry.data()[i] == 0) continue;
    ++all;
    if (height_m.data()[i] < filled_m.data()[i]) ++below;
  }
  return static_cast<double>(below) / all;
}

}  // namespace

std::vector<std::uint8_t> StrahlerOrders(const FlowGraph& flow,
                                         const std::vector<unsigned char>& channel) {
  std::vector<std::uint8_t> orders(channel.size(), 0);
  std::vector<std::uint8_t> highest(channel.size(), 0);  // of what comes in
  std::vector<std::uint8_t> times(channel.size(), 0);    // how often, up to two
  for (auto cell = flow.order.rbegin(); cell != flow.order.rend(); ++cell) {
    if (channel[*cell] == 0) continue;
    orders[*cell] = std::max<std::uint8_t>(highest[*cell] + (times[*cell] >= 2 ? 1 : 0), 1);
    const std::int32_t receiver = flow.receiver[*cell];
    if (receiver == *cell) continue;
    if (orders[*cell] > highest[receiver]) {
      highest[receiver] = orders[*cell];
      times[receiver] = 1;
    } else if (orders[*cell] == highest[receiver]) {
      times[receiver] = 2;
    }
  }
  return orders;
}

std::vector<int> CountStreams(const FlowGraph& flow, const std::vector<std::uint8_t>& orders) {
  std::vector<unsigned char> continues(orders.size(), 0);  // a stream of this order comes in
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const std::int32_t receiver = flow.receiver[i];
    if (receiver != static_cast<std::int32_t>(i) && orders[i] != 0 &&
        orders[receiver] == orders[i]) {
      continues[receiver] = 1;
    }
  }
  std::vector<int> streams;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    if (orders[i] == 0 || continues[i] != 0) continue;
    if (orders[i] > streams.size()) streams.resize(orders[i], 0);
    ++streams[orders[i] - 1];
  }
  return streams;
}

RealismEstimate BifurcationRatio(const std::vector<int>& streams_of_order) {
  RealismEstimate ratio;
  for (const int streams : streams_of_order) ratio.count += streams;
  if (ratio.count < kMinStreams || streams_of_order.size() < 2) return ratio;
  double weights = 0.0;
  double sum = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i + 1 < streams_of_order.size(); ++i) {
    const double lower = streams_of_order[i];
    const double higher = streams_of_order[i + 1];
    const double weight = lower + higher;
    const double term = weight * lower / higher;
    weights += weight;
    sum += term;
    variance += term * term * (1.0 / lower + 1.0 / higher);
  }
  ratio.value = sum / weights;
  ratio.standard_error = std::sqrt(variance) / weights;
  return ratio;
}

void MeasureChannels(const Grid<float>& height_m, double resolution_m,
                     const Grid<unsigned char>& dry, int threads, RealismMeasures* measures) {
  const double channel_cells = std::max(kMinChannelCells, kMinChannelShare * dry.size());
  measures->channel_area_m2 = channel_cells * resolution_m * resolution_m;
  measures->depression_share = DepressionShare(height_m, dry, threads);
  const Drained land = Drain(height_m, resolution_m, dry, channel_cells, threads);
  const auto links = Links(land.flow, land.channel);
  measures->concavity = Concavity(height_m, resolution_m, land, links, channel_cells);
  measures->hack_exponent = HackExponent(land, links, channel_cells);
  measures->streams_of_order = CountStreams(land.flow, StrahlerOrders(land.flow, land.channel));
  measures->bifurcation_ratio = BifurcationRatio(measures->streams_of_order);
}

}  // namespace latticeworld
