#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_ROOM_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_ROOM_H_

#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/layout_mask.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/layout/zone.h"
#include "latticeworld/terrain/forms/relief_places.h"

namespace latticeworld::internal {

// Where forms of relief find room in a layout: off water, roads, buildings and fields, and off the
// forms that were laid before them. The layout must outlive it.
class ReliefRoom {
 public:
  // size_m: the side of the world.
  ReliefRoom(const SymbolicLayout& layout, double size_m);

  const SymbolicLayout& layout() const { return layout_; }
  double size_m() const { return size_m_; }
  double cell_m() const { return size_m_ / kLayoutSize; }
  // What water, roads, buildings and fields take.
  const LayoutMask& taken() const { return taken_; }
  // What the forms so far cover.
  const LayoutMask& laid() const { return laid_; }

  LayoutMask Letters(char letter, const LayoutMask& in) const;
  // Middle of a cell, or a place between cells.
  WorldPoint PointOf(double row, double col) const;
  CellIndex CellAt(WorldPoint point) const;
  // The cells whose middles a form with an axis covers.
  LayoutMask CellsOf(const ReliefPiece& piece) const;

  // How far the middle of an area lies from its rim [m]. ends_at_edge: the world's edge is a rim
  // too; else the area goes on beyond it.
  double HalfWidth(const LayoutMask& area, bool ends_at_edge) const;
  // The cell of a zone that lies farthest from obstacles, from forms that are laid and from the
  // zone's rim, as far as it is wanted; among equals the one nearest to the zone's middle.
  // *room_cells: from there to the nearest obstacle or form.
  CellIndex Freest(const LayoutMask& zone, const LayoutMask& obstacles, double wanted_cells,
                   double* room_cells) const;

  void MarkLaid(CellIndex at, double radius_cells);
  void MarkLaid(const LayoutMask& cells) { laid_ = laid_ | cells; }

 private:
  const SymbolicLayout& layout_;
  const double size_m_;
  LayoutMask taken_, laid_;
};

// All cells of the zones; every cell where there are none.
LayoutMask UnionOf(const std::vector<Zone>& zones);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_ROOM_H_
