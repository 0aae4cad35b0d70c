#ifndef LATTICEWORLD_LANGUAGE_REMOTE_JSON_OBJECTS_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_JSON_OBJECTS_H_

#include <string_view>
#include <vector>

namespace latticeworld {

// The outermost JSON objects in a text with anything around them, in order, at most sixteen; the
// last one may be cut.
std::vector<std::string_view> ObjectsIn(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_JSON_OBJECTS_H_
