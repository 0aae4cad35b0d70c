#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_FORMS_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_FORMS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/forms/relief_things.h"
#include "latticeworld/terrain/water/water_bodies.h"

namespace latticeworld::internal {

// What words of relief make of the land, on the lattice. Areas, such as mountains, rise by
// themselves: landscape evolution gets their uplift and their steepest rock. Things, such as hills
// and gorges, are laid into the land that it leaves. Without pieces nothing is changed.
class ReliefForms {
 public:
  // built: 1 where roads, buildings and fields are. over: 1 on roads that lead over gorges. water
  // must outlive the forms.
  ReliefForms(std::vector<ReliefPiece> pieces, const GridGeometry& lattice,
              Grid<unsigned char> built, Grid<unsigned char> over, const WaterBodies& water,
              std::uint64_t seed);
  ReliefForms(const ReliefForms&) = delete;
  ReliefForms& operator=(const ReliefForms&) = delete;

  bool empty() const { return pieces_.empty(); }
  const std::vector<ReliefPiece>& pieces() const { return pieces_; }

  // Changes what evolution starts from: uplift over erodibility [m], the steepest slope that rock
  // holds [m/m], and that of loose ground.
  void Raise(Grid<float>* steepness_m, Grid<float>* slide_slope, Grid<float>* talus) const;
  // A mountain that is all of the world falls to every edge of it: outlets, with their heights [m].
  void OpenEdges(const Grid<float>& hills_m, Grid<unsigned char>* outlet,
                 Grid<float>* height_m) const;
  // How much creep rounds the land, in [0, 1].
  void Roughen(Grid<float>* smoothness) const;
  // Whether words say that land of a class, such as rock and snow, is mountains.
  bool MountainsByClass() const;
  // How much of the world rises as words say: its summits are as high as they say, too.
  double RaisedShare() const;
  // Brings areas to their heights and lays things into the land [m]. level_m: of the water, NaN
  // where dry. foot_m: what the land rises from, everywhere.
  void Lay(const Grid<float>& level_m, const Grid<float>& foot_m, Grid<float>* land_m) const;
  // 1 in the bottoms of basins and craters, which no water leaves.
  Grid<unsigned char> Hollows() const;

 private:
  struct Area {
    const ReliefPiece* piece;
    Grid<float> share;  // in [0, 1], soft at the rim
  };

  ReliefGround ground() const { return {lattice_, built_, over_, water_, seed_}; }
  Grid<float> ShareOf(const LayoutMask& area, bool off_built) const;
  // How far inside an area: 0 at its rim, 1 where it is widest; summits stand where it is more.
  Grid<float> Inward(const Area& area) const;
  // Mountains of a class rise more in the middle of their area than at its rim.
  void RaiseMiddle(const Area& area, Grid<float>* steepness_m) const;
  // The distance from the axis of a valley, or from the water that it follows, in half widths.
  Grid<float> FromFloor(const ReliefPiece& valley) const;
  void RaiseBeside(const ReliefPiece& valley, Grid<float>* steepness_m) const;
  void ScaleArea(const Area& area, const Grid<float>& foot_m, Grid<float>* land_m) const;
  void ScaleValleys(const Grid<float>& foot_m, Grid<float>* land_m) const;
  // Returns the factor by which the land beside a valley's floor is to be multiplied so that its
  // rims lie as high above the floor as the valley is deep. from: as FromFloor has it.
  float ValleyFactor(const ReliefPiece& valley, const Grid<float>& from, const Grid<float>& foot_m,
                     const Grid<float>& land_m) const;
  void LayTilt(const Area& area, Grid<float>* land_m) const;
  void LayDunes(const Area& area, Grid<float>* land_m) const;

  std::vector<ReliefPiece> pieces_;
  std::vector<Area> areas_;
  GridGeometry lattice_;
  Grid<unsigned char> built_;
  Grid<unsigned char> over_;
  const WaterBodies& water_;
  std::uint64_t seed_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_FORMS_H_
