#ifndef LATTICEWORLD_VIEWER_PAYLOADS_WORLD_GRIDS_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_WORLD_GRIDS_H_

#include <string>
#include <vector>

namespace latticeworld {

struct Terrain;

// The ground of a world as the page gets it: docs/viewer.md has the bytes.

inline constexpr int kMostVertices = 1025;  // a side, of the ground
inline constexpr int kMostTexels = 1024;    // a side, of weights and surfaces

struct HeightGrid {
  int rows = 0, cols = 0;
  double spacing_m = 0.0;            // between vertices
  double west_m = 0.0;               // x of column 0
  double north_m = 0.0;              // y of row 0
  double low_m = 0.0, step_m = 0.0;  // height = low_m + value * step_m
  std::string heights;               // uint16 (rows x cols)
  std::string waters;                // uint16 (rows x cols); 0: none, else value - 1 steps
};
// Vertices at the centres of the terrain's cells where there are few enough, else evenly between
// the outermost centres, of HeightField's own surface.
HeightGrid MakeHeightGrid(const Terrain& terrain);

struct TextureGrid {
  int rows = 0, cols = 0;
  std::string letters;   // of the classes that have a plane, in order
  std::string weights;   // uint8, a plane (rows x cols) a class, mean of the cells in a texel
  std::string surfaces;  // uint8 (rows x cols), SurfaceClass of the cell in a texel's middle
};
TextureGrid MakeTextureGrid(const Terrain& terrain);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_WORLD_GRIDS_H_
