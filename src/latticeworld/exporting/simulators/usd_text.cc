#include "latticeworld/exporting/simulators/usd_text.h"

#include <charconv>
#include <cmath>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

void Append(float value, std::string* text) {
  char digits[32];
  *text += std::string_view(
      digits,
      static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits));
}

template <typename Vector>
std::string ArrayOf(const std::vector<Vector>& values) {
  std::string text = "[";
  for (const Vector& value : values) {
    text += text.size() > 1 ? ", (" : "(";
    for (Eigen::Index i = 0; i < value.size(); ++i) {
      if (i > 0) text += ", ";
      Append(value[i], &text);
    }
    text += ')';
  }
  return text + "]";
}

}  // namespace

std::string UsdTuple(std::initializer_list<double> values) {
  std::string text = "(";
  for (const double value : values) {
    if (text.size() > 1) text += ", ";
    text += FormatDouble(value);
  }
  return text + ")";
}

std::string UsdTuple(const Eigen::Vector3d& values) {
  return UsdTuple({values.x(), values.y(), values.z()});
}

std::string UsdArray(const std::vector<Eigen::Vector3f>& values) { return ArrayOf(values); }
std::string UsdArray(const std::vector<Eigen::Vector2f>& values) { return ArrayOf(values); }

std::string UsdArray(const std::vector<std::uint32_t>& values) {
  std::string text = "[";
  for (const std::uint32_t value : values) {
    if (text.size() > 1) text += ", ";
    text += std::to_string(value);
  }
  return text + "]";
}

std::string UsdQuoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + '"';
}

void UsdText::Open(const UsdPrim& prim) {
  Indent();
  text_.append(prim.is_abstract ? "class " : "def ").append(prim.type).append(" \"");
  text_.append(prim.name).append("\"");
  ++depth_;
  std::vector<std::string> metadata;
  if (!prim.schemas.empty()) {
    std::string list;
    for (const std::string_view schema : prim.schemas)
      list.append(list.empty() ? "\"" : ", \"").append(schema).append("\"");
    metadata.push_back("prepend apiSchemas = [" + list + "]");
  }
  if (prim.is_instance) metadata.push_back("instanceable = true");
  if (!prim.reference.empty()) metadata.push_back("prepend references = <" + prim.reference + ">");
  if (!metadata.empty()) {
    text_ += " (\n";
    for (const std::string& line : metadata) {
      Indent();
      text_.append(line).append("\n");
    }
  }
  --depth_;
  if (!metadata.empty()) {
    Indent();
    text_ += ")";
  }
  text_ += "\n";
  Indent();
  text_ += "{\n";
  ++depth_;
}

void UsdText::Close() {
  --depth_;
  Indent();
  text_ += "}\n";
}

void UsdText::Declare(std::string_view attribute) {
  Indent();
  text_.append(attribute).append("\n");
}

void UsdText::Value(std::string_view attribute, std::string_view value) {
  Indent();
  text_.append(attribute).append(" = ").append(value).append("\n");
}

void UsdText::Number(std::string_view attribute, double value) {
  Value(attribute, FormatDouble(value));
}

void UsdText::Primvar(std::string_view attribute, std::string_view interpolation,
                      std::string_view value) {
  Value(attribute,
        std::string(value) + " (interpolation = \"" + std::string(interpolation) + "\")");
}

void UsdText::Relation(std::string_view name, const std::vector<std::string>& paths) {
  std::string list;
  for (const std::string& path : paths) list += (list.empty() ? "<" : ", <") + path + ">";
  Value("rel " + std::string(name), paths.size() == 1 ? list : "[" + list + "]");
}

void UsdText::Label(std::string_view label) {
  Value("token[] semantics:labels:class", "[" + UsdQuoted(label) + "]");
}

void UsdText::Place(const Eigen::Vector3d& place_m, double yaw_rad) {
  Value("double3 xformOp:translate", UsdTuple(place_m));
  Number("double xformOp:rotateZ", yaw_rad * 180.0 / M_PI);
  Value("uniform token[] xformOpOrder", R"(["xformOp:translate", "xformOp:rotateZ"])");
}

void UsdText::Place(const Eigen::Vector3d& place_m, double yaw_rad, const Eigen::Vector3d& scale) {
  Value("double3 xformOp:translate", UsdTuple(place_m));
  Number("double xformOp:rotateZ", yaw_rad * 180.0 / M_PI);
  Value("double3 xformOp:scale", UsdTuple(scale));
  Value("uniform token[] xformOpOrder",
        R"(["xformOp:translate", "xformOp:rotateZ", "xformOp:scale"])");
}

}  // namespace latticeworld
