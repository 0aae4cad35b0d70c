#include "latticeworld/exporting/maps/map_server.h"

#include <gtest/gtest.h>

#include <sstream>

namespace latticeworld {
namespace {

struct ReadMap {
  int width = 0, height = 0;
  std::vector<int> occupancy;  // row 0 north
};

// What ROS map_server's image loader makes of the files.
ReadMap ReadAsMapServer(const MapServerFiles& files) {
  std::istringstream yaml(files.yaml);
  double occupied = 0.0, free = 0.0;
  std::string mode;
  for (std::string key; yaml >> key;) {
    if (key == "occupied_thresh:") yaml >> occupied;
    if (key == "free_thresh:") yaml >> free;
    if (key == "mode:") yaml >> mode;
  }
  std::istringstream pgm(files.pgm);
  std::string magic;
  int largest = 0;
  ReadMap map;
  pgm >> magic >> map.width >> map.height >> largest;
  EXPECT_EQ(magic, "P5");
  EXPECT_EQ(largest, 255);
  pgm.get();
  for (int i = 0; i < map.width * map.height; ++i) {
    const int grey = pgm.get();
    EXPECT_NE(grey, std::char_traits<char>::eof());
    const double p = (255 - grey) / 255.0;
    if (mode == "raw")
      map.occupancy.push_back(static_cast<signed char>(grey));
    else if (p > occupied)
      map.occupancy.push_back(100);
    else if (p < free)
      map.occupancy.push_back(0);
    else if (mode == "trinary")
      map.occupancy.push_back(-1);
    else
      map.occupancy.push_back(static_cast<int>(1 + 98 * (p - free) / (occupied - free)));
  }
  EXPECT_EQ(pgm.get(), std::char_traits<char>::eof());
  return map;
}

Grid<std::int8_t> Ramp(int first) {
  Grid<std::int8_t> occupancy(11, 11);
  int value = first;
  for (std::int8_t& cell : occupancy) {
    cell = static_cast<std::int8_t>(value);
    value = value == 100 ? 0 : value + 1;
  }
  return occupancy;
}

TEST(MapServerTest, MapServerReadsTheSameOccupancyAgain) {
  const auto occupancy = Ramp(0);
  const auto files = ToMapServer(occupancy, GridGeometry::FromCells(11, 5.5));
  ASSERT_TRUE(files.ok());
  const ReadMap map = ReadAsMapServer(*files);
  EXPECT_EQ(map.width, 11);
  EXPECT_EQ(map.height, 11);
  for (std::size_t i = 0; i < occupancy.size(); ++i) {
    const int value = occupancy.data()[i];
    EXPECT_EQ(map.occupancy[i], value == 99 ? 98 : value);
  }
}

TEST(MapServerTest, UnknownCellsSurvive) {
  const auto occupancy = Ramp(-1);
  const auto files = ToMapServer(occupancy, GridGeometry::FromCells(11, 5.5));
  ASSERT_TRUE(files.ok());
  const ReadMap map = ReadAsMapServer(*files);
  for (std::size_t i = 0; i < occupancy.size(); ++i)
    EXPECT_EQ(map.occupancy[i], occupancy.data()[i]);
}

TEST(MapServerTest, TrinaryMapsReadBackAsFreeOccupiedAndUnknown) {
  const auto graded = Ramp(-1);
  const auto trinary = WithValues(graded, MapValues::kTrinary);
  const auto files = ToMapServer(trinary, GridGeometry::FromCells(11, 5.5), MapValues::kTrinary);
  ASSERT_TRUE(files.ok());
  EXPECT_NE(files->yaml.find("mode: trinary\n"), std::string::npos);
  const ReadMap map = ReadAsMapServer(*files);
  for (std::size_t i = 0; i < graded.size(); ++i) {
    const int value = graded.data()[i];
    EXPECT_EQ(trinary.data()[i], value == 100 || value == -1 ? value : 0);
    EXPECT_EQ(map.occupancy[i], trinary.data()[i]);
  }
}

TEST(MapServerTest, YamlPlacesTheLowerLeftCorner) {
  const auto files = ToMapServer(Grid<std::int8_t>(64, 64, 0), GridGeometry::FromCells(64, 32.0));
  ASSERT_TRUE(files.ok());
  EXPECT_EQ(files->yaml,
            "image: map.pgm\nresolution: 0.5\norigin: [-16, -16, 0]\nnegate: 0\n"
            "occupied_thresh: 0.9\nfree_thresh: 0.1\nmode: scale\n");
}

TEST(MapServerTest, RefusesForeignValuesAndShapes) {
  const GridGeometry geometry = GridGeometry::FromCells(11, 5.5);
  for (const int value : {-2, 101, 127, -128}) {
    Grid<std::int8_t> occupancy(11, 11, 0);
    occupancy(3, 4) = static_cast<std::int8_t>(value);
    EXPECT_EQ(ToMapServer(occupancy, geometry).status().code(), StatusCode::kInvalidArgument);
  }
  EXPECT_FALSE(ToMapServer(Grid<std::int8_t>(11, 10, 0), geometry).ok());
}

}  // namespace
}  // namespace latticeworld
