#ifndef LATTICEWORLD_GEOMETRY_HEIGHT_FIELD_H_
#define LATTICEWORLD_GEOMETRY_HEIGHT_FIELD_H_

#include <Eigen/Core>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// The one triangulation of the ground that physics, rays, queries and maps share. Vertices stand at
// the cell centres; each quad of four neighbouring centres is split along the diagonal from its
// north-west to its south-east vertex. Beyond the outermost centres (half a cell) and beyond the
// world the surface continues flat from its edge.
class HeightField {
 public:
  HeightField() = default;
  // height_m: (geometry.rows() x geometry.cols()), finite.
  HeightField(GridGeometry geometry, Grid<float> height_m);

  const GridGeometry& geometry() const { return geometry_; }
  const Grid<float>& height_m() const { return height_m_; }
  float min_m() const { return min_m_; }
  float max_m() const { return max_m_; }

  // Height [m] of the triangulated surface above the point.
  double HeightAt(WorldPoint point) const;
  // Unit normal of the triangle below the point, map frame, z > 0.
  Eigen::Vector3d NormalAt(WorldPoint point) const;
  // Angle between that normal and the vertical [rad].
  double SlopeAt(WorldPoint point) const;

 private:
  struct Sample {
    double height_m;
    double dz_dx;  // [m/m]
    double dz_dy;
  };
  Sample SampleAt(WorldPoint point) const;

  GridGeometry geometry_;
  Grid<float> height_m_;
  float min_m_ = 0.0f;
  float max_m_ = 0.0f;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMETRY_HEIGHT_FIELD_H_
