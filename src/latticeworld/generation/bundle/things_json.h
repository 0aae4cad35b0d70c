#ifndef LATTICEWORLD_GENERATION_BUNDLE_THINGS_JSON_H_
#define LATTICEWORLD_GENERATION_BUNDLE_THINGS_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/scene/props/thing.h"

namespace latticeworld {

// The single things of a request (GenerationRequest::things), a JSON array of objects:
//   kind         thing_kinds.h, or a model of the catalogue; all other keys may be missing
//   name         letter, then letters, digits and '_', unique; of several "<name>_1" ...
//   x, y         exact place, frame map [m]; yaw_deg: of its front, 0 east, counter-clockwise
//   count        1 .. kMostThings
//   arrangement  none, row, ring, grid, pair, cluster; spacing_m: [0.1, 500]
//   size         over that of the kind, [0.2, 5]
//   place        name of a zone ("upper left", "northern half")
//   relation     in, near, in front of, around, along; of: the name of a thing before it, or a noun
//                of land ("village", "road"); distance_m: from its edge, [0.1, 80]
//   facing       the same as of
// "" is none. Errors: INVALID_ARGUMENT with every violation, `pointer` being
// "things/<index>/<key>".
Result<std::vector<ThingWish>> ParseThings(std::string_view json, const Catalogue& catalogue,
                                           Vocabulary vocabulary);

// The file of a bundle: what a request had, and what stands of all wishes.
struct ThingsFile {
  std::string request;
  std::vector<SceneThing> things;
};
std::string EncodeThings(const ThingsFile& file);
// Errors: DATA_LOSS saying what is wrong.
Result<ThingsFile> DecodeThings(std::string_view content, const GridGeometry& geometry,
                                std::size_t assets);

// The things of a request, and behind them those of its words. Errors: those of ParseThings.
Result<std::vector<ThingWish>> WishedThings(std::string_view json, const LayoutPlan& plan,
                                            const Catalogue& catalogue, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_THINGS_JSON_H_
