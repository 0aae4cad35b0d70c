#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "latticeworld/exporting/bytes.h"
#include "latticeworld/exporting/maps/map_reference.h"
#include "latticeworld/exporting/maps/point_cloud.h"

namespace latticeworld {
namespace {

// These numbers are those of LAS 1.4 R15.
constexpr std::uint16_t kHeaderBytes = 375, kRecordHeaderBytes = 54, kPointBytes = 36;
constexpr std::uint8_t kPointFormat = 7;
constexpr std::uint16_t kSyntheticReturns = 8, kWktReference = 16;
constexpr std::uint16_t kWktRecord = 2112;
constexpr int kReturns = 15;
constexpr double kScale_m = 0.001;
constexpr std::uint16_t kByteToWord = 257;  // 255 becomes 65535

std::int32_t Steps(float value_m) {
  return static_cast<std::int32_t>(std::lround(static_cast<double>(value_m) / kScale_m));
}

void AddLasHeader(const std::vector<CloudPoint>& points, std::size_t wkt_bytes, Bytes* bytes) {
  // The bounds are those of the points as they are written, in whole steps.
  Eigen::Array3d low = Eigen::Array3d::Zero(), high = Eigen::Array3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f& p = points[i].position_m;
    const Eigen::Array3d steps(Steps(p.x()), Steps(p.y()), Steps(p.z()));
    low = i == 0 ? steps : low.min(steps);
    high = i == 0 ? steps : high.max(steps);
  }
  low *= kScale_m;
  high *= kScale_m;

  // The fields follow in the order of the format.
  bytes->AddText("LASF", 4);
  bytes->Add<std::uint16_t>(0);  // file source
  bytes->Add<std::uint16_t>(kSyntheticReturns | kWktReference);
  bytes->AddText("", 16);  // project
  bytes->Add<std::uint8_t>(1);
  bytes->Add<std::uint8_t>(4);
  bytes->AddText("SIMULATION", 32);
  bytes->AddText("LatticeWorld", 32);
  bytes->Add<std::uint16_t>(0);  // day and year of creation
  bytes->Add<std::uint16_t>(0);
  bytes->Add<std::uint16_t>(kHeaderBytes);
  bytes->Add<std::uint32_t>(
      static_cast<std::uint32_t>(kHeaderBytes + kRecordHeaderBytes + wkt_bytes));
  bytes->Add<std::uint32_t>(1);  // variable length records
  bytes->Add<std::uint8_t>(kPointFormat);
  bytes->Add<std::uint16_t>(kPointBytes);
  for (int i = 0; i < 6; ++i) bytes->Add<std::uint32_t>(0);  // counts of older versions
  for (int i = 0; i < 3; ++i) bytes->Add<double>(kScale_m);
  for (int i = 0; i < 3; ++i) bytes->Add<double>(0.0);  // offsets
  for (int i = 0; i < 3; ++i) {
    bytes->Add<double>(high[i]);
    bytes->Add<double>(low[i]);
  }
  bytes->Add<std::uint64_t>(0);  // waveforms
  bytes->Add<std::uint64_t>(0);  // extended records, and how many
  bytes->Add<std::uint32_t>(0);
  bytes->Add<std::uint64_t>(points.size());
  bytes->Add<std::uint64_t>(points.size());  // first returns
  for (int i = 1; i < kReturns; ++i) bytes->Add<std::uint64_t>(0);
}

}  // namespace

std::string ToPly(const std::vector<CloudPoint>& points) {
  std::string ply = "ply\nformat binary_little_endian 1.0\ncomment LatticeWorld, metres, z up\n";
  for (const auto& entry : EnumNames(PointLabel())) {
    ply += "comment label " + std::to_string(static_cast<int>(entry.value)) + " " +
           std::string(entry.name) + "\n";
  }
  ply += "element vertex " + std::to_string(points.size()) + "\n";
  for (const char* property : {"float x", "float y", "float z", "uchar red", "uchar green",
                               "uchar blue", "uchar label", "int asset"}) {
    ply += std::string("property ") + property + "\n";
  }
  ply += "end_header\n";
  constexpr std::size_t kVertexBytes = 20;
  ply.reserve(ply.size() + points.size() * kVertexBytes);
  Bytes bytes(&ply);
  for (const CloudPoint& point : points) {
    for (int i = 0; i < 3; ++i) bytes.Add<float>(point.position_m[i]);
    bytes.Add<std::uint8_t>(point.color.r);
    bytes.Add<std::uint8_t>(point.color.g);
    bytes.Add<std::uint8_t>(point.color.b);
    bytes.Add<std::uint8_t>(static_cast<std::uint8_t>(point.label));
    bytes.Add<std::int32_t>(point.asset);
  }
  return ply;
}

Result<std::string> ToLas(const std::vector<CloudPoint>& points,
                          const std::optional<GeoOrigin>& origin) {
  LW_ASSIGN_OR_RETURN(const std::string wkt, MapWkt(origin));
  const std::size_t wkt_bytes = wkt.size() + 1;  // and its end
  std::string las;
  las.reserve(kHeaderBytes + kRecordHeaderBytes + wkt_bytes + points.size() * kPointBytes);
  Bytes bytes(&las);
  AddLasHeader(points, wkt_bytes, &bytes);
  bytes.Add<std::uint16_t>(0);
  bytes.AddText("LASF_Projection", 16);
  bytes.Add<std::uint16_t>(kWktRecord);
  bytes.Add<std::uint16_t>(static_cast<std::uint16_t>(wkt_bytes));
  bytes.AddText("OGC WKT", 32);
  bytes.AddText(wkt, wkt_bytes);
  for (const CloudPoint& point : points) {
    for (int i = 0; i < 3; ++i) bytes.Add<std::int32_t>(Steps(point.position_m[i]));
    bytes.Add<std::uint16_t>(0);    // intensity
    bytes.Add<std::uint8_t>(0x11);  // the first return of one
    bytes.Add<std::uint8_t>(0);     // flags
    bytes.Add<std::uint8_t>(LasClassOf(point.label));
    bytes.Add<std::uint8_t>(0);   // of the user
    bytes.Add<std::int16_t>(0);   // scan angle
    bytes.Add<std::uint16_t>(0);  // source
    bytes.Add<double>(0.0);       // time
    bytes.Add<std::uint16_t>(static_cast<std::uint16_t>(point.color.r * kByteToWord));
    bytes.Add<std::uint16_t>(static_cast<std::uint16_t>(point.color.g * kByteToWord));
    bytes.Add<std::uint16_t>(static_cast<std::uint16_t>(point.color.b * kByteToWord));
  }
  return las;
}

}  // namespace latticeworld
