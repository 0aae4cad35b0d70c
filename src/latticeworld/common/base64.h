#ifndef LATTICEWORLD_COMMON_BASE64_H_
#define LATTICEWORLD_COMMON_BASE64_H_

#include <string>
#include <string_view>

namespace latticeworld {

// The bytes as text, padded: RFC 4648, section 4.
std::string Base64(std::string_view bytes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_BASE64_H_
