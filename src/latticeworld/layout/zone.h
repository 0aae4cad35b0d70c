#ifndef LATTICEWORLD_LAYOUT_ZONE_H_
#define LATTICEWORLD_LAYOUT_ZONE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/geometry/region.h"
#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {

// A place of a layout in words, upper = north, left = west: what its boxes cover together. A cell
// belongs to it when its centre does.
struct Zone {
  std::string name = "anywhere";  // for people and for JSON
  std::vector<UnitBox> boxes;     // empty: the whole layout

  bool is_anywhere() const { return boxes.empty(); }
  friend bool operator==(const Zone& a, const Zone& b);
};

LayoutMask MaskOf(const Zone& zone);

// The zone of one ninth, with the ninth's name ("upper left").
Zone ZoneOf(Region region);
// The ninth that a zone is about: the one of its middle ("northern half" is upper); kAnywhere for
// the whole layout, kCenter for a zone whose middle is the middle.
Region RegionOf(const Zone& zone);

// The zones with names:
//   anywhere
//   upper left, upper, upper right, middle left, center, middle right, lower left, lower,
//     lower right                                         ninths
//   northern half, southern half, western half, eastern half
//   northern third, southern third, western third, eastern third; middle rows and middle columns,
//     the thirds between them
//   northern quarter, southern quarter, western quarter, eastern quarter      bands of a quarter
//   north-western quarter, north-eastern quarter, south-western quarter, south-eastern quarter
//   north-west corner, north-east corner, south-west corner, south-east corner   a quarter a side
//   northern edge, southern edge, western edge, eastern edge      bands of an eighth
//   edges, the ring of these four; interior, all but that ring
// nullopt for another name.
std::optional<Zone> FindZone(std::string_view name);
std::vector<std::string_view> ZoneNames();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_ZONE_H_
