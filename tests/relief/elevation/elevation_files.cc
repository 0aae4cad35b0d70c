#include "relief/elevation/elevation_files.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_frmts.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {

std::string TakeMemoryFile(const char* name) {
  vsi_l_offset size = 0;
  GByte* data = VSIGetMemFileBuffer(name, &size, FALSE);
  std::string bytes(reinterpret_cast<char*>(data), size);
  VSIUnlink(name);
  return bytes;
}

std::string WriteTiff(const TiffSpec& spec) {
  GDALRegister_GTiff();
  constexpr char kName[] = "/vsimem/elevation_test.tif";
  CPLStringList creation;
  for (const std::string& option : spec.creation) creation.AddString(option.c_str());
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), kName, spec.cols, spec.rows,
                                 spec.bands, spec.type, creation.List());
  const std::array<double, 6>& t = spec.transform;
  if (spec.has_transform) GDALSetGeoTransform(file, const_cast<double*>(t.data()));
  if (!spec.crs.empty()) {
    OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
    EXPECT_EQ(OSRSetFromUserInput(crs, spec.crs.c_str()), OGRERR_NONE) << spec.crs;
    GDALSetSpatialRef(file, crs);
    OSRDestroySpatialReference(crs);
  }
  for (int band = 1; band <= spec.bands; ++band) {
    GDALRasterBandH target = GDALGetRasterBand(file, band);
    if (!spec.unit.empty()) GDALSetRasterUnitType(target, spec.unit.c_str());
    if (spec.scale != 1.0) GDALSetRasterScale(target, spec.scale);
    if (spec.offset != 0.0) GDALSetRasterOffset(target, spec.offset);
    if (!std::isnan(spec.no_data)) GDALSetRasterNoDataValue(target, spec.no_data);
    std::vector<double> row(spec.cols);
    for (int r = 0; r < spec.rows; ++r) {
      for (int c = 0; c < spec.cols; ++c) {
        row[c] = spec.land(t[0] + t[1] * (c + 0.5) + t[2] * (r + 0.5),
                           t[3] + t[4] * (c + 0.5) + t[5] * (r + 0.5));
      }
      EXPECT_EQ(GDALRasterIO(target, GF_Write, 0, r, spec.cols, 1, row.data(), spec.cols, 1,
                             GDT_Float64, 0, 0),
                CE_None);
    }
  }
  spec.finish(file);
  GDALClose(file);
  return TakeMemoryFile(kName);
}

std::string WriteAscii(int cols, int rows, const std::string& rest_of_header, const Land& land) {
  std::string text =
      "ncols " + std::to_string(cols) + "\nnrows " + std::to_string(rows) + "\n" + rest_of_header;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) text += FormatDouble(land(c, r)) + " ";
    text += "\n";
  }
  return text;
}

std::string WriteSrtm(int cols, int rows, const std::function<int(int row, int col)>& land) {
  std::string bytes;
  bytes.reserve(std::size_t{2} * cols * rows);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const int value = land(r, c);
      bytes.push_back(static_cast<char>((value >> 8) & 0xff));
      bytes.push_back(static_cast<char>(value & 0xff));
    }
  }
  return bytes;
}

ElevationOptions WorldOptions(double size_m, double resolution_m) {
  ElevationOptions options;
  options.size_m = size_m;
  options.resolution_m = resolution_m;
  options.keep_altitude = true;
  return options;
}

ElevationOptions OptionsAt(double latitude_deg, double longitude_deg, ElevationOptions options) {
  options.centered = false;
  options.latitude_deg = latitude_deg;
  options.longitude_deg = longitude_deg;
  return options;
}

Relief ReadRelief(const std::string& bytes, const ElevationOptions& options,
                  const std::string& name) {
  Result<Relief> relief = ReadElevation(bytes, name, options);
  EXPECT_TRUE(relief.ok()) << relief.status().ToString();
  if (!relief.ok()) return MakeRelief(Grid<float>(33, 33));
  for (const float height : relief->height_m) {
    if (!std::isfinite(height)) {
      ADD_FAILURE() << "a height is " << height;
      break;
    }
  }
  return *std::move(relief);
}

void ExpectRefused(const std::string& bytes, const std::vector<std::string>& words,
                   const ElevationOptions& options, const std::string& name) {
  const Result<Relief> relief = ReadElevation(bytes, name, options);
  ASSERT_FALSE(relief.ok()) << "read what should be refused: " << words.front();
  EXPECT_EQ(relief.status().code(), StatusCode::kInvalidArgument) << relief.status().ToString();
  for (const std::string& word : words) {
    EXPECT_NE(relief.status().message().find(word), std::string::npos)
        << word << " | " << relief.status().message();
  }
  EXPECT_EQ(relief.status().message().find("/vsimem"), std::string::npos)
      << relief.status().message();
}

void ExpectLand(const Relief& relief, double size_m, double tolerance_m, const Land& land) {
  const int rows = relief.height_m.rows(), cols = relief.height_m.cols();
  double worst_m = 0.0;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const double expected =
          land(((c + 0.5) / cols - 0.5) * size_m, (0.5 - (r + 0.5) / rows) * size_m);
      worst_m = std::max(worst_m, std::abs(relief.height_m(r, c) - expected));
    }
  }
  EXPECT_LE(worst_m, tolerance_m);
}

DegreeLengths DegreesAt(double latitude_deg) {
  constexpr double kA = 6378137.0, kE2 = 0.00669437999014;
  const double s = std::sin(latitude_deg * kPi / 180.0);
  const double w = std::sqrt(1.0 - kE2 * s * s);
  return {kPi / 180.0 * kA * (1.0 - kE2) / (w * w * w),
          kPi / 180.0 * kA / w * std::cos(latitude_deg * kPi / 180.0)};
}

}  // namespace latticeworld
