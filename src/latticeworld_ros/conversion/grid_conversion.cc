#include "latticeworld_ros/conversion/grid_conversion.h"

#include <algorithm>
#include <boost/endian/conversion.hpp>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

// out[i * rows + j] with i along -y (our rows) and j along -x (our columns, mirrored): grid_map's
// first index runs along x and is the fast one of its column-major storage.
void CopyGridMapLayer(const Grid<float>& values, std::vector<float>* out) {
  out->reserve(values.size());
  for (int row = 0; row < values.rows(); ++row) {
    const float* from = values.row(row);
    out->insert(out->end(), std::make_reverse_iterator(from + values.cols()),
                std::make_reverse_iterator(from));
  }
}

std_msgs::Float32MultiArray ToMultiArray(const Grid<float>& values) {
  std_msgs::Float32MultiArray array;
  // grid_map counts rows along x and columns along y.
  const auto grid_map_rows = static_cast<std::uint32_t>(values.cols());
  const auto grid_map_cols = static_cast<std::uint32_t>(values.rows());
  array.layout.dim.resize(2);
  array.layout.dim[0].label = "column_index";
  array.layout.dim[0].size = grid_map_cols;
  array.layout.dim[0].stride = grid_map_rows * grid_map_cols;
  array.layout.dim[1].label = "row_index";
  array.layout.dim[1].size = grid_map_rows;
  array.layout.dim[1].stride = grid_map_rows;
  CopyGridMapLayer(values, &array.data);
  return array;
}

// The bytes of a layer beside its cells: its name and layout, generously.
constexpr std::uint64_t kLayerBytes = 1024;

int CoarseCells(int cells, int coarsening) { return (cells + coarsening - 1) / coarsening; }

float Merged(const Grid<float>& values, CellMerge merge, int coarsening, CellIndex coarse) {
  const int end_row = std::min(values.rows(), (coarse.row + 1) * coarsening);
  const int end_col = std::min(values.cols(), (coarse.col + 1) * coarsening);
  float least = std::numeric_limits<float>::infinity(), most = -least;
  double sum = 0.0;
  int count = 0;
  for (int row = coarse.row * coarsening; row < end_row; ++row) {
    for (int col = coarse.col * coarsening; col < end_col; ++col) {
      const float value = values(row, col);
      if (std::isnan(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
      sum += value;
      ++count;
    }
  }
  if (count == 0) return std::numeric_limits<float>::quiet_NaN();
  if (merge == CellMerge::kLeast) return least;
  return merge == CellMerge::kMost ? most : static_cast<float>(sum / count);
}

Grid<float> Coarsened(const Grid<float>& values, CellMerge merge, int coarsening) {
  Grid<float> coarse(CoarseCells(values.rows(), coarsening),
                     CoarseCells(values.cols(), coarsening));
  for (int row = 0; row < coarse.rows(); ++row) {
    for (int col = 0; col < coarse.cols(); ++col) {
      coarse(row, col) = Merged(values, merge, coarsening, {row, col});
    }
  }
  return coarse;
}

}  // namespace

int CoarseningFor(int cells, std::size_t layers, std::uint64_t most_bytes) {
  const auto bytes = [&](int coarsening) {
    const auto side = static_cast<std::uint64_t>(CoarseCells(cells, coarsening));
    return layers * (side * side * sizeof(float) + kLayerBytes) + kLayerBytes;
  };
  int coarsening = 1;
  while (bytes(coarsening) >= most_bytes && coarsening < cells) coarsening *= 2;
  return coarsening;
}

grid_map_msgs::GridMap ToGridMap(const GridGeometry& geometry, const std::vector<GridLayer>& layers,
                                 int coarsening) {
  grid_map_msgs::GridMap message;
  message.info.header.frame_id = kMapFrame;
  message.info.resolution = geometry.resolution_m() * coarsening;
  message.info.length_x = CoarseCells(geometry.cols(), coarsening) * message.info.resolution;
  message.info.length_y = CoarseCells(geometry.rows(), coarsening) * message.info.resolution;
  message.info.pose.position.x = 0.5 * (message.info.length_x - geometry.size_m());
  message.info.pose.position.y = 0.5 * (geometry.size_m() - message.info.length_y);
  message.info.pose.orientation.w = 1.0;
  message.layers.reserve(layers.size());
  for (const GridLayer& layer : layers) {
    LW_CHECK(layer.values->rows() == geometry.rows() && layer.values->cols() == geometry.cols(),
             "layer " + layer.name + " has another shape than the geometry");
    message.layers.push_back(layer.name);
  }
  message.data.resize(layers.size());
  ParallelFor(static_cast<int>(layers.size()), 0, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const GridLayer& layer = layers[i];
      message.data[i] = coarsening == 1
                            ? ToMultiArray(*layer.values)
                            : ToMultiArray(Coarsened(*layer.values, layer.merge, coarsening));
    }
  });
  if (!layers.empty()) message.basic_layers.push_back(layers.front().name);
  return message;
}

nav_msgs::OccupancyGrid ToOccupancyGrid(const GridGeometry& geometry,
                                        const Grid<std::int8_t>& occupancy) {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = kMapFrame;
  message.info.resolution = static_cast<float>(geometry.resolution_m());
  message.info.width = static_cast<std::uint32_t>(occupancy.cols());
  message.info.height = static_cast<std::uint32_t>(occupancy.rows());
  message.info.origin.position.x = -geometry.half_size_m();
  message.info.origin.position.y = -geometry.half_size_m();
  message.info.origin.orientation.w = 1.0;
  message.data.reserve(occupancy.size());
  for (int row = occupancy.rows() - 1; row >= 0; --row) {
    message.data.insert(message.data.end(), occupancy.row(row),
                        occupancy.row(row) + occupancy.cols());
  }
  return message;
}

sensor_msgs::Image ToImage(const Grid<float>& values) {
  sensor_msgs::Image message;
  message.header.frame_id = kMapFrame;
  message.height = static_cast<std::uint32_t>(values.rows());
  message.width = static_cast<std::uint32_t>(values.cols());
  message.encoding = "32FC1";
  message.is_bigendian = boost::endian::order::native == boost::endian::order::big;
  message.step = message.width * static_cast<std::uint32_t>(sizeof(float));
  message.data.resize(values.size() * sizeof(float));
  if (!values.empty()) std::memcpy(message.data.data(), values.data(), message.data.size());
  return message;
}

}  // namespace latticeworld
