#ifndef LATTICEWORLD_GENERATION_BUNDLE_CATALOGUE_JSON_H_
#define LATTICEWORLD_GENERATION_BUNDLE_CATALOGUE_JSON_H_

#include <memory>
#include <string>
#include <string_view>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// catalogue.json: the files that a user added to the built-in catalogue, in order, each with its
// name and text.
std::string EncodeCatalogue(const Catalogue& catalogue);
// Errors: DATA_LOSS saying what is wrong: more than 65 MiB, keys, types, or what the files' own
// reading says.
Result<std::shared_ptr<const Catalogue>> DecodeCatalogue(std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_CATALOGUE_JSON_H_
