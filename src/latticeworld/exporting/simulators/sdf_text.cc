#include "latticeworld/exporting/simulators/sdf_text.h"

#include <cstdio>
#include <utility>

#include "latticeworld/common/markup.h"

namespace latticeworld {

SdfText::SdfText() : text_("<?xml version=\"1.0\"?>\n<sdf version=\"1.7\">\n"), depth_(1) {}

void SdfText::Open(std::string_view tag, std::string_view name, std::string_view type) {
  text_.append(2 * static_cast<std::size_t>(depth_++), ' ').append("<").append(tag);
  if (!name.empty()) text_ += " name=\"" + EscapeMarkup(name) + "\"";
  if (!type.empty()) text_ += " type=\"" + EscapeMarkup(type) + "\"";
  text_ += ">\n";
}

void SdfText::Close(std::string_view tag) {
  text_.append(2 * static_cast<std::size_t>(--depth_), ' ').append("</").append(tag).append(">\n");
}

void SdfText::Leaf(std::string_view tag, std::string_view text) {
  text_.append(2 * static_cast<std::size_t>(depth_), ' ').append("<").append(tag).append(">");
  text_ += EscapeMarkup(text);
  text_.append("</").append(tag).append(">\n");
}

void SdfText::Numbers(std::string_view tag, std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    char number[32];
    std::snprintf(number, sizeof number, text.empty() ? "%.9g" : " %.9g", value);
    text += number;
  }
  Leaf(tag, text);
}

void SdfText::Pose(const Eigen::Vector3d& position_m, double yaw_rad) {
  Numbers("pose", {position_m.x(), position_m.y(), position_m.z(), 0.0, 0.0, yaw_rad});
}

std::string SdfText::Take() { return std::move(text_) + "</sdf>\n"; }

}  // namespace latticeworld
