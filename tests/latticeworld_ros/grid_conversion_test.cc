#include "latticeworld_ros/grid_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace latticeworld {
namespace {

// Row 0 north, column 0 west:   1 2
//                               3 4
template <typename T>
Grid<T> Corners() {
  Grid<T> grid(2, 2);
  grid(0, 0) = 1;
  grid(0, 1) = 2;
  grid(1, 0) = 3;
  grid(1, 1) = 4;
  return grid;
}

TEST(GridConversionTest, GridMapStartsInTheNorthEastAndRunsSouthThenIsStoredByColumns) {
  const Grid<float> grid = Corners<float>();
  const auto message = ToGridMap(GridGeometry::FromCells(2, 4.0), {{"elevation", &grid}});
  ASSERT_EQ(message.data.size(), 1u);
  // Cell (i, j): x falls with i, y falls with j; element (i, j) stands at j * rows + i.
  EXPECT_EQ(message.data[0].data, (std::vector<float>{2, 1, 4, 3}));
  EXPECT_EQ(message.data[0].layout.dim[0].label, "column_index");
  EXPECT_EQ(message.data[0].layout.dim[0].size, 2u);
  EXPECT_EQ(message.data[0].layout.dim[0].stride, 4u);
  EXPECT_EQ(message.data[0].layout.dim[1].label, "row_index");
  EXPECT_EQ(message.data[0].layout.dim[1].size, 2u);
  EXPECT_EQ(message.data[0].layout.dim[1].stride, 2u);
  EXPECT_EQ(message.layers, (std::vector<std::string>{"elevation"}));
  EXPECT_EQ(message.basic_layers, (std::vector<std::string>{"elevation"}));
  EXPECT_EQ(message.info.header.frame_id, "map");
  EXPECT_DOUBLE_EQ(message.info.resolution, 2.0);
  EXPECT_DOUBLE_EQ(message.info.length_x, 4.0);
  EXPECT_DOUBLE_EQ(message.info.length_y, 4.0);
  EXPECT_DOUBLE_EQ(message.info.pose.orientation.w, 1.0);
}

TEST(GridConversionTest, GridMapKeepsUnknownCells) {
  Grid<float> grid = Corners<float>();
  grid(0, 0) = std::numeric_limits<float>::quiet_NaN();
  const auto message = ToGridMap(GridGeometry::FromCells(2, 4.0), {{"water", &grid}});
  EXPECT_TRUE(std::isnan(message.data[0].data[1]));
}

TEST(GridConversionTest, OccupancyStartsInTheSouthWestRowByRow) {
  Grid<std::int8_t> grid = Corners<std::int8_t>();
  grid(0, 1) = -1;
  const auto message = ToOccupancyGrid(GridGeometry::FromCells(2, 4.0), grid);
  EXPECT_EQ(message.data, (std::vector<std::int8_t>{3, 4, 1, -1}));
  EXPECT_EQ(message.info.width, 2u);
  EXPECT_EQ(message.info.height, 2u);
  EXPECT_FLOAT_EQ(message.info.resolution, 2.0f);
  EXPECT_DOUBLE_EQ(message.info.origin.position.x, -2.0);
  EXPECT_DOUBLE_EQ(message.info.origin.position.y, -2.0);
  EXPECT_DOUBLE_EQ(message.info.origin.orientation.w, 1.0);
}

TEST(GridConversionTest, ImageHasNorthUpAndValuesAsTheyAre) {
  const auto message = ToImage(Corners<float>());
  EXPECT_EQ(message.encoding, "32FC1");
  EXPECT_EQ(message.step, 8u);
  ASSERT_EQ(message.data.size(), 16u);
  float values[4];
  std::memcpy(values, message.data.data(), sizeof(values));
  EXPECT_EQ(std::vector<float>(values, values + 4), (std::vector<float>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace latticeworld
