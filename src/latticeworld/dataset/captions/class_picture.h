#ifndef LATTICEWORLD_DATASET_CAPTIONS_CLASS_PICTURE_H_
#define LATTICEWORLD_DATASET_CAPTIONS_CLASS_PICTURE_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/common/rgb.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// What the pixels of segmented pictures mean.
struct PictureLegend {
  struct Entry {
    Rgb color;           // of a grey value v: {v, v, v}
    char letter = '\0';  // of the vocabulary, or kNoData (downsample.h)
  };
  Vocabulary vocabulary = Vocabulary::kWild;
  std::vector<Entry> entries;
  std::string licence;   // of the pictures; SPDX where there is one, "" not known
  std::string citation;  // "" none
};

// The colours that pictures of layouts have (ClassesOf).
PictureLegend PaletteLegend(Vocabulary vocabulary);

// Reads a legend that a user wrote, strictly: {"vocabulary": "wild", "values": {"1": "F", "2":
// "W"}} or {"vocabulary": "suburb", "colors": {"#00ff00": "G"}}; "" as a letter: no data. what:
// names the text in messages. Errors: INVALID_ARGUMENT with every violation.
Result<PictureLegend> ReadLegend(std::string_view json, const std::string& what);

// The letters of a PNG of any kind with at most 8193 pixels a side, (rows x cols). what: names the
// picture in messages. Errors: DATA_LOSS (no such picture, cut off, damaged, a size that is not
// legal); INVALID_ARGUMENT (colours that the legend does not have: each with its first pixel and
// how many there are).
Result<Grid<char>> ReadClassPicture(std::string_view bytes, const PictureLegend& legend,
                                    const std::string& what);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_CLASS_PICTURE_H_
