#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_ASSETS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_ASSETS_H_

#include <string_view>

#include "latticeworld/catalogue/asset_type.h"

namespace latticeworld {

// AssetOf returns the asset type of a word of the small language's list "asset" ("crops");
// AssetWord returns the word of an asset type.
AssetType AssetOf(std::string_view word);
std::string_view AssetWord(AssetType asset);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_ASSETS_H_
