#include "latticeworld/exporting/simulators/mjcf_text.h"

#include <cmath>
#include <cstddef>

#include "latticeworld/common/markup.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

std::string MjcfNumbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ' ';
    text += FormatDouble(value);
  }
  return text;
}

std::string MjcfNumbers(const Eigen::Vector3d& values) {
  return MjcfNumbers({values.x(), values.y(), values.z()});
}

std::string MjcfYaw(double yaw_rad) {
  return MjcfNumbers({std::cos(0.5 * yaw_rad), 0.0, 0.0, std::sin(0.5 * yaw_rad)});
}

void MjcfText::Add(std::string_view tag, const MjcfAttributes& attributes, const char* end) {
  text_.append(2 * static_cast<std::size_t>(depth_), ' ').append("<").append(tag);
  for (const auto& [name, value] : attributes)
    text_.append(" ").append(name).append("=\"").append(EscapeMarkup(value)).append("\"");
  text_ += end;
}

void MjcfText::Open(std::string_view tag, const MjcfAttributes& attributes) {
  Add(tag, attributes, ">\n");
  ++depth_;
}

void MjcfText::Leaf(std::string_view tag, const MjcfAttributes& attributes) {
  Add(tag, attributes, "/>\n");
}

void MjcfText::Close(std::string_view tag) {
  text_.append(2 * static_cast<std::size_t>(--depth_), ' ').append("</").append(tag).append(">\n");
}

void MjcfText::Comment(std::string_view text) {
  text_.append(2 * static_cast<std::size_t>(depth_), ' ').append("<!-- ").append(text);
  text_ += " -->\n";
}

}  // namespace latticeworld
