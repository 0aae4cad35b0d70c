#ifndef LATTICEWORLD_TESTS_DATASET_SOURCE_PICTURES_H_
#define LATTICEWORLD_TESTS_DATASET_SOURCE_PICTURES_H_

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "latticeworld/common/random.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// A folder of its own for one test, removed at its end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  // Writes a file and the folders above it.
  void Write(const std::filesystem::path& relative, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

// PNG bytes: 8-bit grey; the palette of a vocabulary's pictures.
std::string GreyPng(const Grid<std::uint8_t>& values);
std::string PalettePng(const Grid<char>& mask, Vocabulary vocabulary);
// The grey values that LoveDA's masks have for letters.
std::string LoveDaPng(const Grid<char>& mask);

// A GeoTIFF of 32-bit floats, or of whole degrees where crs is "EPSG:4326".
struct TiffLook {
  std::string crs = "EPSG:32613";  // UTM, zone 13 north
  double sample = 2.0;             // width of a sample, in units of the crs
  double tallness = 1.0;           // of a sample: height / width
};
std::string ElevationTiff(const Grid<float>& height_m, const TiffLook& look = {});

// A curve from one edge of a mask to the opposite one, `width` pixels wide; top to bottom where
// `upright`.
void DrawCurve(char letter, double width, bool upright, RandomStream* random, Grid<char>* mask);
// A blot with wavering edges, about `radius` pixels wide.
void DrawBlot(char letter, double radius, RandomStream* random, Grid<char>* mask);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_DATASET_SOURCE_PICTURES_H_
