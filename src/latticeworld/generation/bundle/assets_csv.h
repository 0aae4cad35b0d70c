#ifndef LATTICEWORLD_GENERATION_BUNDLE_ASSETS_CSV_H_
#define LATTICEWORLD_GENERATION_BUNDLE_ASSETS_CSV_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/asset.h"

namespace latticeworld {

// assets.csv: a line of column names, then one line an asset: the names of its kind, model,
// seasonal variant and material, then its numbers in the order of Asset, each in the shortest form
// that reads back as the same float. Errors: INTERNAL (an asset with a model or variant that its
// kind has not).
Result<std::string> EncodeAssets(const std::vector<Asset>& assets, const Catalogue& catalogue);

// Errors: DATA_LOSS naming the line and what is wrong with it. Every asset stands in the world, has
// finite numbers and no negative extent.
Result<std::vector<Asset>> DecodeAssets(std::string_view content, const GridGeometry& geometry,
                                        const Catalogue& catalogue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_ASSETS_CSV_H_
