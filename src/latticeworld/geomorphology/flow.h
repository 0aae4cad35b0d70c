#ifndef LATTICEWORLD_GEOMORPHOLOGY_FLOW_H_
#define LATTICEWORLD_GEOMORPHOLOGY_FLOW_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// Says where water goes: every cell drains to one of its eight neighbours (D8, O'Callaghan and Mark
// 1984), depressions over their lowest saddle, all of it to an outlet. Cells are row * cols + col.
struct FlowGraph {
  int rows = 0;
  int cols = 0;
  std::vector<std::int32_t> receiver;  // of each cell; an outlet is its own
  // All cells, each after its receiver, what drains through a cell right behind it (the stack of
  // Braun and Willett 2013).
  std::vector<std::int32_t> order;
};

// height_m: finite. outlet: 1 where water leaves, at least once, or null for the border of the
// grid. threads: 0 for as many as cores; the result is the same with any.

// Depressions of height_m raised to their spill level, so that every cell has a way to an outlet
// that never rises. Exact, as by priority flood (Barnes, Lehman and Mulla 2014): the level of a
// cell is the lowest that the highest point of a way from it to an outlet can be.
Grid<float> FillDepressions(const Grid<float>& height_m, const Grid<unsigned char>* outlet,
                            int threads = 0);

// Steepest descent on slopes; over level ground the shortest way to where it drains; in a
// depression down to its pit, and from there back up to its lowest saddle and out (Cordonnier,
// Bovy and Braun 2019). Ties go to the smaller index.
FlowGraph RouteFlow(const Grid<float>& height_m, const Grid<unsigned char>* outlet,
                    int threads = 0);

// Drainage area [cells] of every cell, itself included; rain_cells weighs each cell's own share,
// or null for 1. Whole numbers are exact up to 2^24.
Grid<float> FlowAccumulation(const FlowGraph& flow, const Grid<float>* rain_cells);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_FLOW_H_
