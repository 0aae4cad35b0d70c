#ifndef LATTICEWORLD_TESTS_CATALOGUE_LARCH_H_
#define LATTICEWORLD_TESTS_CATALOGUE_LARCH_H_

#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

// A legal file that adds a species, with every key that files may have.
std::string LarchFile();

// "code pointer" of every violation that reading the files finds; empty: they are legal.
std::vector<std::string> FaultsOf(const std::vector<CatalogueFile>& files);
std::vector<std::string> FaultsOf(const std::string& text);  // in "user.json"

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_CATALOGUE_LARCH_H_
