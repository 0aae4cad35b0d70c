#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_USD_TEXT_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_USD_TEXT_H_

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace latticeworld {

// Values as USDA spells them; numbers are the shortest text that reads back as the same float or
// double.
std::string UsdTuple(std::initializer_list<double> values);
std::string UsdTuple(const Eigen::Vector3d& values);
std::string UsdArray(const std::vector<Eigen::Vector3f>& values);
std::string UsdArray(const std::vector<Eigen::Vector2f>& values);
std::string UsdArray(const std::vector<std::uint32_t>& values);
std::string UsdQuoted(std::string_view text);

// A box along the axes that grows around points; "extent" of what has one.
struct UsdExtent {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e30f);
  Eigen::Vector3f high = Eigen::Vector3f::Constant(-1e30f);

  void Add(const Eigen::Vector3f& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  std::string Text() const { return UsdArray(std::vector<Eigen::Vector3f>{low, high}); }
};

struct UsdPrim {
  std::string_view type;
  std::string name;
  std::vector<std::string_view> schemas = {};  // applied to it
  std::string reference = {};                  // path of the prim that it begins as
  bool is_abstract = false;                    // a class: nothing in it is drawn or collides
  bool is_instance = false;                    // of its reference
};

// Prims of USDA text, written from the outside in, two blanks a level.
class UsdText {
 public:
  explicit UsdText(int depth = 0) : depth_(depth) {}

  void Open(const UsdPrim& prim);
  void Close();
  // An attribute without a value.
  void Declare(std::string_view attribute);
  // attribute: with its type, "double radius".
  void Value(std::string_view attribute, std::string_view value);
  void Number(std::string_view attribute, double value);
  void Primvar(std::string_view attribute, std::string_view interpolation, std::string_view value);
  void Relation(std::string_view name, const std::vector<std::string>& paths);
  // Labels of SemanticsLabelsAPI:class, which the prim has to have.
  void Label(std::string_view label);
  // Says where it stands in its parent: place, then turn about z. scale: times its size.
  void Place(const Eigen::Vector3d& place_m, double yaw_rad);
  void Place(const Eigen::Vector3d& place_m, double yaw_rad, const Eigen::Vector3d& scale);
  // What another one has written.
  void Append(UsdText part) { text_ += part.Take(); }

  std::string Take() { return std::move(text_); }

 private:
  void Indent() { text_.append(2 * static_cast<std::size_t>(depth_), ' '); }

  std::string text_;
  int depth_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_USD_TEXT_H_
