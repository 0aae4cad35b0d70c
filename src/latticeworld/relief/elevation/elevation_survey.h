#ifndef LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_SURVEY_H_
#define LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_SURVEY_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/elevation/elevation.h"

namespace latticeworld {

// Elevation data as a whole, for measuring: nothing is cut out of it and no sample is made up
// between the data's own.
struct ElevationSurvey {
  Grid<float> height_m;         // as in the file; row 0 north; filled from around where missing
  Grid<unsigned char> missing;  // 1: no-data, NaN, infinity
  double resolution_m = 0.0;    // cells are square
  std::vector<std::string> warnings;
};

// Reads what ReadElevation reads. The samples' shorter side at the middle of the data becomes the
// side of a cell; along the longer one heights are interpolated. Data of more than 8192 samples a
// side is averaged in blocks. Data in degrees that spans much of the earth is not laid flat: meant
// for pieces of up to a degree. unit: of an ASCII grid. Errors: INVALID_ARGUMENT (not elevation;
// nothing but no-data).
Result<ElevationSurvey> SurveyElevation(std::string_view bytes, std::string_view name,
                                        ElevationUnit unit = ElevationUnit::kJudged);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RELIEF_ELEVATION_ELEVATION_SURVEY_H_
