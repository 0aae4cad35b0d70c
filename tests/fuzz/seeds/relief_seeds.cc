#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "fuzz/seeds/seeds.h"
#include "generation/test_world.h"

namespace latticeworld::fuzz {
namespace {

constexpr int kSide = 36;

// A slope in every channel.
cv::Mat Picture(int type) {
  cv::Mat picture(kSide, kSide, type);
  for (int row = 0; row < kSide; ++row) {
    for (int byte = 0; byte < static_cast<int>(picture.step); ++byte) {
      picture.ptr(row)[byte] = static_cast<std::uint8_t>(3 * row + byte / 4);
    }
  }
  return picture;
}

std::string Encoded(const char* extension, int type, const std::vector<int>& options = {}) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, Picture(type), bytes, options);
  return std::string(bytes.begin(), bytes.end());
}

std::string GeoTiff(GDALDataType type, const std::vector<const char*>& creation) {
  constexpr char kName[] = "/vsimem/seed.tif";
  constexpr int kCells = 24;
  CPLStringList options;
  for (const char* option : creation) options.AddString(option);
  GDALDatasetH file =
      GDALCreate(GDALGetDriverByName("GTiff"), kName, kCells, kCells, 1, type, options.List());
  double transform[6] = {500000, 10, 0, 4400000, 0, -10};
  GDALSetGeoTransform(file, transform);
  OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
  OSRImportFromEPSG(crs, 32613);
  GDALSetSpatialRef(file, crs);
  OSRDestroySpatialReference(crs);
  std::vector<float> heights_m(kCells * kCells);
  for (std::size_t i = 0; i < heights_m.size(); ++i) heights_m[i] = 100.0f + static_cast<float>(i);
  (void)GDALRasterIO(GDALGetRasterBand(file, 1), GF_Write, 0, 0, kCells, kCells, heights_m.data(),
                     kCells, kCells, GDT_Float32, 0, 0);
  GDALClose(file);
  vsi_l_offset size = 0;
  const GByte* data = VSIGetMemFileBuffer(kName, &size, FALSE);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  VSIUnlink(kName);
  return bytes;
}

std::string AsciiGrid(const std::string& place) {
  constexpr int kCells = 8;
  std::string text = "ncols 8\nnrows 8\n" + place + "NODATA_value -9999\n";
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) text += std::to_string(100 + row * col) + ".5 ";
    text += "\n";
  }
  return text;
}

// Fields of protocol buffers, of numbers below 16.
std::string Varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
  return bytes + static_cast<char>(value);
}
std::string Number(int field, std::uint64_t value) {
  return static_cast<char>(field << 3) + Varint(value);
}
std::string Bytes(int field, const std::string& bytes) {
  return static_cast<char>(field << 3 | 2) + Varint(bytes.size()) + bytes;
}

std::string Value(const std::string& name, int channels) {
  std::string shape;
  for (const int side : {1, channels, 32, 32}) {
    shape += Bytes(1, Number(1, static_cast<std::uint64_t>(side)));
  }
  return Bytes(1, name) + Bytes(2, Bytes(1, Number(1, 1) + Bytes(2, shape)));
}

std::string Constant(const std::string& name, const std::vector<int>& shape) {
  std::string tensor;
  std::size_t values = 1;
  for (const int side : shape) {
    tensor += Number(1, static_cast<std::uint64_t>(side));
    values *= static_cast<std::size_t>(side);
  }
  std::string raw;
  for (std::size_t i = 0; i < values; ++i) raw += std::string("\0\0\x80\x3e", 4);  // 0.25
  return tensor + Number(2, 1) + Bytes(8, name) + Bytes(9, raw);
}

std::string Sizes(const std::string& name, const std::vector<int>& sizes) {
  std::string packed;
  for (const int size : sizes) packed += Varint(static_cast<std::uint64_t>(size));
  return Bytes(5, Bytes(1, name) + Bytes(8, packed) + Number(20, 7));
}

std::string Node(const std::vector<std::string>& inputs, const std::string& output,
                 const std::string& type, const std::string& attributes) {
  std::string fields;
  for (const std::string& input : inputs) fields += Bytes(1, input);
  return Bytes(1, fields + Bytes(2, output) + Bytes(4, type) + attributes);
}

// Two convolutions with what stands between them in a network that draws land.
std::string OnnxNetwork() {
  const std::string window = Sizes("kernel_shape", {3, 3}) + Sizes("pads", {1, 1, 1, 1});
  const std::string graph =
      Node({"sketch", "first", "first_bias"}, "a", "Conv", window) + Node({"a"}, "b", "Relu", "") +
      Node({"b"}, "half", "AveragePool", Sizes("kernel_shape", {2, 2}) + Sizes("strides", {2, 2})) +
      Node({"half", "up", "up_bias"}, "c", "ConvTranspose",
           Sizes("kernel_shape", {2, 2}) + Sizes("strides", {2, 2})) +
      Node({"b", "c"}, "both", "Concat",
           Bytes(5, Bytes(1, "axis") + Number(3, 1) + Number(20, 2))) +
      Node({"both", "last", "last_bias"}, "d", "Conv", window) +
      Node({"d"}, "height", "Sigmoid", "") + Bytes(2, "sketch") +
      Bytes(5, Constant("first", {2, 3, 3, 3})) + Bytes(5, Constant("first_bias", {2})) +
      Bytes(5, Constant("up", {2, 2, 2, 2})) + Bytes(5, Constant("up_bias", {2})) +
      Bytes(5, Constant("last", {1, 4, 3, 3})) + Bytes(5, Constant("last_bias", {1})) +
      Bytes(11, Value("sketch", 3)) + Bytes(12, Value("height", 1));
  return Number(1, 6) + Bytes(7, graph) + Bytes(8, Number(2, 11));
}

}  // namespace

void ReliefSeeds(const TakeSeed& take) {
  take("png", "grey8", Encoded(".png", CV_8UC1));
  take("png", "grey16", Encoded(".png", CV_16UC1));
  take("png", "colour", Encoded(".png", CV_8UC3));
  take("png", "alpha16", Encoded(".png", CV_16UC4));
  take("jpeg", "colour", Encoded(".jpg", CV_8UC3));
  take("jpeg", "grey", Encoded(".jpg", CV_8UC1));
  take("jpeg", "progressive", Encoded(".jpg", CV_8UC3, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}));
  take("tiff", "grey8", Encoded(".tif", CV_8UC1));
  take("tiff", "grey16_raw", Encoded(".tif", CV_16UC1, {cv::IMWRITE_TIFF_COMPRESSION, 1}));
  take("tiff", "colour", Encoded(".tif", CV_8UC3));
  take("pgm", "binary", MakePgm(kSide, kSide));
  take("pgm", "plain", Encoded(".pgm", CV_8UC1, {cv::IMWRITE_PXM_BINARY, 0}));
  take("pgm", "wide", Encoded(".pgm", CV_16UC1, {cv::IMWRITE_PXM_BINARY, 1}));
  GDALAllRegister();
  take("geotiff", "float", GeoTiff(GDT_Float32, {}));
  take("geotiff", "whole_packed", GeoTiff(GDT_Int16, {"COMPRESS=DEFLATE"}));
  take("geotiff", "tiled", GeoTiff(GDT_UInt16, {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"}));
  take("ascii_grid", "metres", AsciiGrid("xllcorner 500000\nyllcorner 4400000\ncellsize 10\n"));
  take("ascii_grid", "degrees", AsciiGrid("xllcenter 11.5\nyllcenter 47.25\ncellsize 0.001\n"));
  take("hgt", "hills", "N40W106.hgt\n" + std::string("\x03\xe8\x03\xea\x80\0\x03\xf0\x04\0", 10));
  take("hgt", "short", "s01e000.SRTMGL1.hgt\n!");
  take("onnx", "network", OnnxNetwork());
}

}  // namespace latticeworld::fuzz
