#ifndef LATTICEWORLD_LANGUAGE_REMOTE_JSON_OBJECTS_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_JSON_OBJECTS_H_

#include <string_view>
#include <vector>

namespace latticeworld {

// Returns the outermost JSON objects of a text that may hold anything around them, in order, at
// most sixteen. The last one may be cut off.
std::vector<std::string_view> ObjectsIn(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_JSON_OBJECTS_H_
