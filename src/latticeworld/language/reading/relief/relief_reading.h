#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_READING_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_READING_H_

#include <string_view>

#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Reads what a layout instruction says of the land's form, whoever read the rest. It reads the
// sentences of the small language where the reading has them, else the text. It fills
// `plan.reliefs` and `plan.covers`, and takes what it has read off the plan's warnings, off what
// was not understood, and off the features that the words of a cover were taken for. Features that
// a relief noun names ("snow mountain") lie where the relief is; the others lie where the words
// say, or are tied to what they are said to lie at.
void ReadRelief(std::string_view text, LayoutReading* reading);

// Adds the terrain type that the environment's words name to the layout's plan, where the layout's
// words say nothing of relief: mountains, hills or a plain all over the world.
void AddTerrainType(const EnvironmentReading& environment, LayoutReading* layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_READING_H_
