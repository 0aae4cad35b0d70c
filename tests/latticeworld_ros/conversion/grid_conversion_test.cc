#include "latticeworld_ros/conversion/grid_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

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
  // Cell (i, j): x falls with i, y falls with j; prop (i, j) stands at j * rows + i.
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

TEST(GridConversionTest, AGridMapIsMadeCoarserUntilItsMessageCanBeReceived) {
  constexpr std::uint64_t kMost = 1'000'000'000;
  EXPECT_EQ(CoarseningFor(512, 12, kMost), 1);
  EXPECT_EQ(CoarseningFor(4500, 12, kMost), 1);
  EXPECT_EQ(CoarseningFor(4600, 12, kMost), 2);
  EXPECT_EQ(CoarseningFor(8192, 12, kMost), 2);
  EXPECT_EQ(CoarseningFor(8192, 20, kMost), 4);
  EXPECT_EQ(CoarseningFor(32, 1, 1), 32) << "of one cell there is nothing coarser";
  for (int cells = 4000; cells <= 8192; cells += 131) {
    const std::uint64_t coarsening = CoarseningFor(cells, 12, kMost);
    const auto bytes = [cells](std::uint64_t by) {
      const std::uint64_t side = (cells + by - 1) / by;
      return 12 * 4 * side * side;
    };
    EXPECT_LT(bytes(coarsening), kMost);
    if (coarsening == 1) continue;
    EXPECT_GT(bytes(coarsening / 2), kMost - 100'000) << "a finer one could be received";
  }
}

// Row 0 north, column 0 west:   1 2 5
//                               3 4 .
//                               . . 9
TEST(GridConversionTest, ACoarserGridMapKeepsItsCornerAndWhatMatters) {
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  Grid<float> grid(3, 3);
  const float rows[3][3] = {{1, 2, 5}, {3, 4, unknown}, {unknown, unknown, 9}};
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) grid(row, col) = rows[row][col];
  }
  const auto message = ToGridMap(
      GridGeometry::FromCells(3, 6.0),
      {{"mean", &grid}, {"least", &grid, CellMerge::kLeast}, {"most", &grid, CellMerge::kMost}}, 2);
  EXPECT_DOUBLE_EQ(message.info.resolution, 4.0);
  EXPECT_DOUBLE_EQ(message.info.length_x, 8.0);
  EXPECT_DOUBLE_EQ(message.info.length_y, 8.0);
  // The north-west corner is where it was, at (-3, 3).
  EXPECT_DOUBLE_EQ(message.info.pose.position.x - 4.0, -3.0);
  EXPECT_DOUBLE_EQ(message.info.pose.position.y + 4.0, 3.0);
  EXPECT_EQ(message.data[0].layout.dim[0].size, 2u);
  // From the north-east on: to the west, then south.
  const auto expect = [&](int layer, std::vector<float> values) {
    ASSERT_EQ(message.data[layer].data.size(), values.size());
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
      EXPECT_FLOAT_EQ(message.data[layer].data[i], values[i]);
    EXPECT_TRUE(std::isnan(message.data[layer].data.back())) << "all of it is unknown";
  };
  expect(0, {5.0f, 2.5f, 9.0f, unknown});
  expect(1, {5.0f, 1.0f, 9.0f, unknown});
  expect(2, {5.0f, 4.0f, 9.0f, unknown});
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
