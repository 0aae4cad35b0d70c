#include "dataset/source_pictures.h"

#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {
namespace fs = std::filesystem;
namespace {

constexpr double kPi = 3.14159265358979323846;

std::string Encode(const cv::Mat& picture) {
  std::vector<std::uint8_t> bytes;
  EXPECT_TRUE(cv::imencode(".png", picture, bytes));
  return std::string(bytes.begin(), bytes.end());
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "latticeworld_source_XXXXXX").string();
  EXPECT_NE(mkdtemp(name.data()), nullptr);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void ScratchFolder::Write(const fs::path& relative, std::string_view bytes) const {
  fs::create_directories((path_ / relative).parent_path());
  std::ofstream file(path_ / relative, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  EXPECT_TRUE(file.good());
}

std::string GreyPng(const Grid<std::uint8_t>& values) {
  cv::Mat picture(values.rows(), values.cols(), CV_8UC1);
  for (int r = 0; r < values.rows(); ++r) {
    for (int c = 0; c < values.cols(); ++c) picture.at<std::uint8_t>(r, c) = values(r, c);
  }
  return Encode(picture);
}

std::string PalettePng(const Grid<char>& mask, Vocabulary vocabulary) {
  cv::Mat picture(mask.rows(), mask.cols(), CV_8UC3);
  for (int r = 0; r < mask.rows(); ++r) {
    for (int c = 0; c < mask.cols(); ++c) {
      const Rgb color = FindClass(vocabulary, mask(r, c))->color;
      picture.at<cv::Vec3b>(r, c) = {color.b, color.g, color.r};
    }
  }
  return Encode(picture);
}

std::string LoveDaPng(const Grid<char>& mask) {
  constexpr std::string_view kByValue("\0GBRWDFA", 8);
  Grid<std::uint8_t> values(mask.rows(), mask.cols());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    values.data()[i] = static_cast<std::uint8_t>(kByValue.find(mask.data()[i]));
  }
  return GreyPng(values);
}

std::string ElevationTiff(const Grid<float>& height_m, const TiffLook& look) {
  GDALRegister_GTiff();
  constexpr char kName[] = "/vsimem/dataset_source_test.tif";
  const bool degrees = look.crs == "EPSG:4326";
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), kName, height_m.cols(),
                                 height_m.rows(), 1, GDT_Float32, nullptr);
  double transform[6] = {degrees ? -105.0 : 500000.0, look.sample, 0.0,
                         degrees ? 40.0 : 4400000.0,  0.0,         -look.sample * look.tallness};
  GDALSetGeoTransform(file, transform);
  OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
  EXPECT_EQ(OSRSetFromUserInput(crs, look.crs.c_str()), OGRERR_NONE);
  GDALSetSpatialRef(file, crs);
  OSRDestroySpatialReference(crs);
  EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(file, 1), GF_Write, 0, 0, height_m.cols(),
                         height_m.rows(), const_cast<float*>(height_m.data()), height_m.cols(),
                         height_m.rows(), GDT_Float32, 0, 0),
            CE_None);
  GDALClose(file);
  vsi_l_offset size = 0;
  const GByte* data = VSIGetMemFileBuffer(kName, &size, FALSE);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  VSIUnlink(kName);
  return bytes;
}

void DrawCurve(char letter, double width, bool upright, RandomStream* random, Grid<char>* mask) {
  const int length = upright ? mask->rows() : mask->cols();
  const int across = upright ? mask->cols() : mask->rows();
  const double from = random->Uniform(0.15, 0.85), to = random->Uniform(0.15, 0.85);
  const double wave = random->Uniform(0.0, 0.06), phase = random->Uniform(0.0, 2.0 * kPi);
  const int reach = static_cast<int>(std::ceil(0.5 * width));
  constexpr int kFiner = 4;  // points a pixel
  for (int i = -kFiner * reach; i < kFiner * (length + reach); ++i) {
    const double t = i / static_cast<double>(kFiner * length);
    const double along = t * length;
    const double aside = across * (from + t * (to - from) + wave * std::sin(phase + 3.0 * kPi * t));
    for (int a = -reach; a <= reach; ++a) {
      for (int b = -reach; b <= reach; ++b) {
        const int u = static_cast<int>(std::lround(along)) + a;
        const int v = static_cast<int>(std::lround(aside)) + b;
        const CellIndex pixel = upright ? CellIndex{u, v} : CellIndex{v, u};
        if (mask->Contains(pixel) && std::hypot(u - along, v - aside) <= 0.5 * width) {
          (*mask)[pixel] = letter;
        }
      }
    }
  }
}

void DrawBlot(char letter, double radius, RandomStream* random, Grid<char>* mask) {
  const double row = random->Uniform(0.0, mask->rows()), col = random->Uniform(0.0, mask->cols());
  const double p = random->Uniform(0.0, 6.0), q = random->Uniform(0.0, 6.0);
  const int reach = static_cast<int>(1.3 * radius);
  const int south = std::min(mask->rows(), static_cast<int>(row) + reach);
  const int east = std::min(mask->cols(), static_cast<int>(col) + reach);
  for (int r = std::max(0, static_cast<int>(row) - reach); r < south; ++r) {
    for (int c = std::max(0, static_cast<int>(col) - reach); c < east; ++c) {
      const double angle = std::atan2(r - row, c - col);
      const double edge =
          radius * (1.0 + 0.15 * std::sin(3.0 * angle + p) + 0.05 * std::sin(13.0 * angle + q) +
                    0.02 * std::sin(41.0 * angle + p));
      if (std::hypot(r - row, c - col) < edge) (*mask)(r, c) = letter;
    }
  }
}

}  // namespace latticeworld
