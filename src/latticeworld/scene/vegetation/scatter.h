#ifndef LATTICEWORLD_SCENE_VEGETATION_SCATTER_H_
#define LATTICEWORLD_SCENE_VEGETATION_SCATTER_H_

#include <functional>
#include <string_view>
#include <vector>

#include "latticeworld/layout/class_letters.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/point_random.h"

namespace latticeworld {

// A place that a scattered thing may get.
struct ScatterPlace {
  WorldPoint point;
  char letter = suburb_letter::kGrassland;  // of the class that it stands there for
  double per_m2 = 0.0;                      // of the kind here, clumping included
};

// How dense a kind is over a world. Functions are called from several threads at once.
class ScatterDensity {
 public:
  virtual ~ScatterDensity() = default;

  // No less than any density in the world [1/m^2]; 0: the kind stands nowhere.
  virtual double largest_per_m2() const = 0;
  // No less than the density of any point of the cell, cheap.
  virtual double MostAt(CellIndex cell) const = 0;
  // The density at a point; draw, [0, 1), picks the class that what stands there stands for.
  virtual double At(WorldPoint point, double draw, char* letter) const = 0;
};

// The densities of the catalogue, clumped.
class ClumpedDensity : public ScatterDensity {
 public:
  // How much denser than its class says the kind stands at a point of a class, relative to other
  // points of it. The mean over the class is taken out, so that it changes no number.
  using Clumping = std::function<double(WorldPoint point, char letter)>;
  // Times the density of a class that its densest point has at most.
  using Peak = std::function<double(char letter)>;

  // The placement and the clumping must outlive it.
  ClumpedDensity(const Placement& placement, AssetKind kind, const Clumping& clumping,
                 const Peak& peak);

  double largest_per_m2() const override { return largest_per_m2_; }
  double MostAt(CellIndex cell) const override;
  double At(WorldPoint point, double draw, char* letter) const override;

 private:
  double MeanOf(const DensityField::Term& term, double peak) const;

  const GridGeometry& geometry_;
  DensityField density_;
  const Clumping& clumping_;
  std::vector<double> peaks_, means_;  // of the terms
  double largest_per_m2_ = 0.0;
};

// Makes the asset at a place (kind, position and base are set), or says why it cannot be there.
// Draws come from the stream of the place. Called from several threads at once.
using MakeAt = std::function<Refusal(const ScatterPlace& place, PointRandom* random, Asset* asset)>;

// Scatters a kind by blue noise, thinned to the density of each place, and adds what is made to the
// placement, solid kinds where they overlap nothing solid. What stands in one place moves nothing
// in another but by standing in its way; the number of threads changes nothing.
void Scatter(Placement* placement, AssetKind kind, std::string_view stream,
             const ScatterDensity& density, const MakeAt& make);

// Its z and the given position, as the asset stores them.
void StandAt(const Terrain& terrain, WorldPoint point, Asset* asset);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_SCATTER_H_
