#ifndef LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FRAME_H_
#define LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FRAME_H_

#include <memory>
#include <optional>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/relief/elevation/elevation.h"
#include "latticeworld/relief/elevation/elevation_raster.h"

namespace latticeworld::internal {

// Says where something lies among the samples, continuous: (0, 0) is the outer corner of the first
// one, (0.5, 0.5) its centre.
struct DataPoint {
  double col = 0.0;
  double row = 0.0;
};

// DataPoints of nodes x nodes places that span the world evenly, edges included, row 0 north. In
// between they are interpolated linearly, which is off by less than a hundredth of a sample.
struct PlaceLattice {
  int nodes = 0;
  std::vector<DataPoint> points;  // (nodes x nodes), row-major
};

// The frame map of a world laid over elevation data: x east, y north, metres from the world's
// origin. On the earth it is the azimuthal equidistant projection around the origin on the WGS 84
// ellipsoid (Snyder 1987, "Map Projections: A Working Manual", p. 191), which keeps distances and
// directions from the origin.
class ElevationFrame {
 public:
  // Errors: INVALID_ARGUMENT (the place lies outside the data, or nobody knows where the data
  // lies).
  static Result<ElevationFrame> Create(const ElevationRaster& raster,
                                       const ElevationOptions& options);
  ElevationFrame(ElevationFrame&&) noexcept;
  ElevationFrame& operator=(ElevationFrame&&) = delete;
  ~ElevationFrame();

  // Returns the place of the origin on the earth, altitude 0; nullopt: it is not known.
  const std::optional<GeoOrigin>& geo() const;
  // Side of a sample at the origin, along its row and along its column [m].
  double sample_width_m() const;
  double sample_height_m() const;

  // The places of a world of that size. Errors: INVALID_ARGUMENT naming the data's extent and the
  // largest legal size when it does not lie within the data.
  Result<PlaceLattice> Lattice(double size_m) const;

 private:
  struct Mapping;
  explicit ElevationFrame(std::unique_ptr<Mapping> mapping);

  std::unique_ptr<Mapping> mapping_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_FRAME_H_
