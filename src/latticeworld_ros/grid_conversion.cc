#include "latticeworld_ros/grid_conversion.h"

#include <boost/endian/conversion.hpp>
#include <cstring>
#include <iterator>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld_ros/geometry_conversion.h"

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

}  // namespace

grid_map_msgs::GridMap ToGridMap(const GridGeometry& geometry,
                                 const std::vector<GridLayer>& layers) {
  grid_map_msgs::GridMap message;
  message.info.header.frame_id = kMapFrame;
  message.info.resolution = geometry.resolution_m();
  message.info.length_x = geometry.size_m();
  message.info.length_y = geometry.size_m();
  message.info.pose.orientation.w = 1.0;
  message.layers.reserve(layers.size());
  for (const GridLayer& layer : layers) {
    LW_CHECK(layer.values->rows() == geometry.rows() && layer.values->cols() == geometry.cols(),
             "layer " + layer.name + " has another shape than the geometry");
    message.layers.push_back(layer.name);
  }
  message.data.resize(layers.size());
  ParallelFor(static_cast<int>(layers.size()), 0, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) message.data[i] = ToMultiArray(*layers[i].values);
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
