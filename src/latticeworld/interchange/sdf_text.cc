#include "latticeworld/interchange/sdf_text.h"

#include <cstdio>
#include <utility>

namespace latticeworld {

SdfText::SdfText() : text_("<?xml version=\"1.0\"?>\n<sdf version=\"1.7\">\n"), depth_(1) {}

void SdfText::Open(std::string_view tag, std::string_view name, std::string_view type) {
  text_.append(2 * static_cast<std::size_t>(depth_++), ' ').append("<").append(tag);
  if (!name.empty()) text_ += " name=\"" + XmlEscaped(name) + "\"";
  if (!type.empty()) text_ += " type=\"" + XmlEscaped(type) + "\"";
  text_ += ">\n";
}

void SdfText::Close(std::string_view tag) {
  text_.append(2 * static_cast<std::size_t>(--depth_), ' ').append("</").append(tag).append(">\n");
}

void SdfText::Leaf(std::string_view tag, std::string_view text) {
  text_.append(2 * static_cast<std::size_t>(depth_), ' ').append("<").append(tag).append(">");
  text_ += XmlEscaped(text);
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

std::string XmlEscaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return escaped;
}

}  // namespace latticeworld
