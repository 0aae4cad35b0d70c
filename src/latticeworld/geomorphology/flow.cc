#include "latticeworld/geomorphology/flow.h"

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/drainage.h"
#include "latticeworld/geomorphology/drainage_order.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {

Grid<float> FillDepressions(const Grid<float>& height_m, const Grid<unsigned char>* outlet,
                            int threads) {
  Grid<float> filled = height_m;
  if (height_m.empty()) return filled;
  threads = internal::GridThreads(height_m.size(), threads);
  internal::Drainage drainage(height_m.rows(), height_m.cols());
  drainage.Route(height_m, outlet, threads);
  drainage.Fill(&filled);
  return filled;
}

FlowGraph RouteFlow(const Grid<float>& height_m, const Grid<unsigned char>* outlet, int threads) {
  FlowGraph flow;
  flow.rows = height_m.rows();
  flow.cols = height_m.cols();
  if (height_m.empty()) return flow;
  threads = internal::GridThreads(height_m.size(), threads);
  internal::Drainage drainage(flow.rows, flow.cols);
  drainage.Route(height_m, outlet, threads);
  const std::vector<std::uint8_t>& directions = drainage.directions();
  flow.receiver.resize(height_m.size());
  ParallelFor(flow.rows, threads, [&](int begin, int end) {
    for (std::int32_t cell = begin * flow.cols; cell < end * flow.cols; ++cell) {
      flow.receiver[cell] =
          directions[cell] == internal::kOutlet ? cell : cell + drainage.steps()[directions[cell]];
    }
  });
  internal::DrainageOrder order(flow.rows, flow.cols);
  order.Sort(drainage, threads);
  // A catchment takes as many places as it has cells: first its lowest cell, then its donors' in
  // turn.
  std::vector<std::int32_t> next(height_m.size());  // free place in the catchment of a cell
  std::int32_t next_catchment = 0;
  flow.order.resize(height_m.size());
  order.ForEachDownstreamFirst(1, [&](std::int32_t cell) {
    const std::int32_t receiver = flow.receiver[cell];
    std::int32_t& free = receiver == cell ? next_catchment : next[receiver];
    flow.order[free] = cell;
    next[cell] = free + 1;
    free += order.area_cells()[cell];
  });
  return flow;
}

Grid<float> FlowAccumulation(const FlowGraph& flow, const Grid<float>* rain_cells) {
  Grid<float> area(flow.rows, flow.cols, 1.0f);
  if (rain_cells != nullptr) area = *rain_cells;
  float* cells = area.data();
  for (auto cell = flow.order.rbegin(); cell != flow.order.rend(); ++cell) {
    const std::int32_t receiver = flow.receiver[*cell];
    if (receiver != *cell) cells[receiver] += cells[*cell];
  }
  return area;
}

}  // namespace latticeworld
