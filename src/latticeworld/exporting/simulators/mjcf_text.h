#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_TEXT_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_TEXT_H_

#include <Eigen/Core>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace latticeworld {

// Attributes in the order in which they are written.
using MjcfAttributes = std::vector<std::pair<std::string_view, std::string>>;

// Numbers parted by blanks, each the shortest text that reads back as the same double.
std::string MjcfNumbers(std::initializer_list<double> values);
std::string MjcfNumbers(const Eigen::Vector3d& values);
// Quaternion of a turn about z: w x y z.
std::string MjcfYaw(double yaw_rad);

// The props of MJCF, which have attributes and no text, written from the outside in, two blanks
// a level.
class MjcfText {
 public:
  explicit MjcfText(int depth = 0) : depth_(depth) {}

  void Open(std::string_view tag, const MjcfAttributes& attributes = {});
  void Close(std::string_view tag);
  void Leaf(std::string_view tag, const MjcfAttributes& attributes);
  // Must hold no "--".
  void Comment(std::string_view text);
  // What another one has written.
  void Append(MjcfText part) { text_ += part.Take(); }

  std::string Take() { return std::move(text_); }

 private:
  void Add(std::string_view tag, const MjcfAttributes& attributes, const char* end);

  std::string text_;
  int depth_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_TEXT_H_
