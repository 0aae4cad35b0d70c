#ifndef LATTICEWORLD_LANGUAGE_READING_LAND_COMPLETION_H_
#define LATTICEWORLD_LANGUAGE_READING_LAND_COMPLETION_H_

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Adds to a model's reading, as sentences, what a second reading of the same text says and it says
// nothing of:
//  - classes of land that it does not name, but not the numbers of their pieces;
//  - the shape of a class and how it lies to others, where it says no such thing of the class;
//  - an order of classes, and which class there is most of, where it says none;
// but nothing of words that it takes for a single thing ("a pier", which is a building to others).
// It stays as it is where it says what the rest of the land is, and where it was not made of
// sentences.
Result<LayoutReading> Completed(const LayoutRequest& request, LayoutReading reading,
                                const LayoutReading& second);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_LAND_COMPLETION_H_
