#ifndef LATTICEWORLD_TESTS_RELIEF_ELEVATION_ELEVATION_FILES_H_
#define LATTICEWORLD_TESTS_RELIEF_ELEVATION_ELEVATION_FILES_H_

#include <gdal.h>

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "latticeworld/relief/elevation/elevation.h"

namespace latticeworld {

constexpr double kPi = 3.14159265358979323846;
constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

// A height field in the coordinates of the data.
using Land = std::function<double(double x, double y)>;

// A GeoTIFF that a test writes with GDAL.
struct TiffSpec {
  int cols = 100;
  int rows = 100;
  int bands = 1;
  GDALDataType type = GDT_Float32;
  std::array<double, 6> transform = {500000, 10, 0, 4400000, 0, -10};
  bool has_transform = true;
  std::string crs = "EPSG:32613";  // UTM, zone 13 north: its middle meridian is 105 degrees west
  std::vector<std::string> creation = {};
  std::string unit = "";
  double scale = 1.0;
  double offset = 0.0;
  double no_data = kNoData;
  Land land = [](double, double) { return 100.0; };
  std::function<void(GDALDatasetH)> finish = [](GDALDatasetH) {};
};
std::string WriteTiff(const TiffSpec& spec);
// An Arc/Info ASCII grid; land takes the column and the row of a sample.
std::string WriteAscii(int cols, int rows, const std::string& rest_of_header, const Land& land);
// An SRTM tile: whole metres, big endian, the first row north.
std::string WriteSrtm(int cols, int rows, const std::function<int(int row, int col)>& land);
// The bytes of a file of GDAL's in memory, which is deleted.
std::string TakeMemoryFile(const char* name);

// A world in the middle of the data, whose heights stay as high as they are.
ElevationOptions WorldOptions(double size_m, double resolution_m);
// The same at a place on the earth.
ElevationOptions OptionsAt(double latitude_deg, double longitude_deg, ElevationOptions options);

// Reads it; fails the test when it is refused.
Relief ReadRelief(const std::string& bytes, const ElevationOptions& options,
                  const std::string& name = "data.tif");
// Fails the test unless it is refused in these words.
void ExpectRefused(const std::string& bytes, const std::vector<std::string>& words,
                   const ElevationOptions& options = WorldOptions(512, 4),
                   const std::string& name = "data.tif");
// The relief is that land, given in metres from the world's middle, everywhere.
void ExpectLand(const Relief& relief, double size_m, double tolerance_m, const Land& land);

// Metres a degree of latitude and of longitude on the WGS 84 ellipsoid.
struct DegreeLengths {
  double latitude_m;
  double longitude_m;
};
DegreeLengths DegreesAt(double latitude_deg);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_RELIEF_ELEVATION_ELEVATION_FILES_H_
