#ifndef LATTICEWORLD_LANGUAGE_READING_LAND_COMPLETION_H_
#define LATTICEWORLD_LANGUAGE_READING_LAND_COMPLETION_H_

#include <vector>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/thing_wish.h"

namespace latticeworld {

// Returns the claims of a second reading without those of classes that the text names by single
// things of the first alone ("a wooden pier", which is a building to others).
std::vector<Claim> WithoutThings(std::vector<Claim> claims, const LayoutRequest& request,
                                 const std::vector<ThingWish>& things);

// Adds to a model's reading, as sentences, what the claims of a second reading of the same text say
// and it says nothing of:
//  - classes of land that it does not name, but not the numbers of their pieces;
//  - the shape of a class and how it lies to others, where it says no such thing of the class;
//  - an order of classes, and which class there is most of, where it says none.
// It stays as it is where it says what the rest of the land is, and where it was not made of
// sentences.
Result<LayoutReading> Completed(const LayoutRequest& request, LayoutReading reading,
                                const std::vector<Claim>& second);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_LAND_COMPLETION_H_
