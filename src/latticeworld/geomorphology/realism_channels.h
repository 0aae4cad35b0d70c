#ifndef LATTICEWORLD_GEOMORPHOLOGY_REALISM_CHANNELS_H_
#define LATTICEWORLD_GEOMORPHOLOGY_REALISM_CHANNELS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/geomorphology/realism.h"

namespace latticeworld {

// Strahler's order (1957) of each cell of a network: 1 where it begins, one more than theirs where
// two of one order meet, else the highest of what comes in; 0 where there is no channel. channel:
// 1 where there is; below a channel cell there is channel as far as it goes.
std::vector<std::uint8_t> StrahlerOrders(const FlowGraph& flow,
                                         const std::vector<unsigned char>& channel);

// Streams of order 1, 2, ...: each runs from where its order begins to where it ends.
std::vector<int> CountStreams(const FlowGraph& flow, const std::vector<std::uint8_t>& orders);

// Mean ratio of the streams of one order to those of the next, weighted by both (Strahler 1953);
// its standard error is that of counts. NaN for fewer than ten streams or fewer than two orders.
RealismEstimate BifurcationRatio(const std::vector<int>& streams_of_order);

// The part of MeasureRealism that follows the water. dry: 1 where dry.
void MeasureChannels(const Grid<float>& height_m, double resolution_m,
                     const Grid<unsigned char>& dry, int threads, RealismMeasures* measures);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_REALISM_CHANNELS_H_
