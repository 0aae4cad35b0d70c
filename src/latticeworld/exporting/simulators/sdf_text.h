#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_SDF_TEXT_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_SDF_TEXT_H_

#include <Eigen/Core>
#include <initializer_list>
#include <string>
#include <string_view>

namespace latticeworld {

// XML that is written from the outside in, two spaces a level.
class SdfText {
 public:
  SdfText();
  // <tag name="...">, or <tag> when the name is empty, until Close.
  void Open(std::string_view tag, std::string_view name = {}, std::string_view type = {});
  void Close(std::string_view tag);
  void Leaf(std::string_view tag, std::string_view text);
  // Numbers parted by spaces, nine digits.
  void Numbers(std::string_view tag, std::initializer_list<double> values);
  // <pose>: x, y, z [m], roll, pitch 0, yaw [rad].
  void Pose(const Eigen::Vector3d& position_m, double yaw_rad);

  std::string Take();

 private:
  std::string text_;
  int depth_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_SDF_TEXT_H_
