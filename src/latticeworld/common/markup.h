#ifndef LATTICEWORLD_COMMON_MARKUP_H_
#define LATTICEWORLD_COMMON_MARKUP_H_

#include <string>
#include <string_view>

namespace latticeworld {

// Text as HTML and XML hold it, between tags and in quoted attributes: & < > " are escaped, and
// control characters other than tabs and line ends, which XML does not know, become '?'. Bytes from
// 0x80 on pass unchanged.
std::string EscapeMarkup(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_MARKUP_H_
