#ifndef LATTICEWORLD_EXPORTING_CONTACT_SHEET_H_
#define LATTICEWORLD_EXPORTING_CONTACT_SHEET_H_

#include <cstdint>
#include <string>

#include "latticeworld/exporting/picture.h"

namespace latticeworld {

// PNG of one land in four seasons, three styles, six weathers and seven hours: a small view from
// the south each, labelled. Everything else is as the scene has it; its assets are placed anew with
// the seed for each environment, since seasons and weathers change what grows. options.width_px: of
// the whole sheet, [700, 4096]. Errors: INVALID_ARGUMENT and those of the views.
Result<std::string> DrawContactSheet(const Scene& scene, std::uint64_t seed,
                                     const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_CONTACT_SHEET_H_
