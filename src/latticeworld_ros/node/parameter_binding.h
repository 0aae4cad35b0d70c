#ifndef LATTICEWORLD_ROS_NODE_PARAMETER_BINDING_H_
#define LATTICEWORLD_ROS_NODE_PARAMETER_BINDING_H_

#include <XmlRpcValue.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/status.h"

namespace latticeworld {

// Each reads one value; false: of another type, and *out is as it was.
bool ReadParameter(XmlRpc::XmlRpcValue value, double* out);
bool ReadParameter(XmlRpc::XmlRpcValue value, int* out);
bool ReadParameter(XmlRpc::XmlRpcValue value, bool* out);
bool ReadParameter(XmlRpc::XmlRpcValue value, std::string* out);
bool ReadParameter(XmlRpc::XmlRpcValue value, std::vector<std::string>* out);
bool ReadParameter(XmlRpc::XmlRpcValue value, std::size_t* out);
// Reads an enumerator by its name.
template <typename Enum, typename = std::enable_if_t<std::is_enum_v<Enum>>>
bool ReadParameter(XmlRpc::XmlRpcValue value, Enum* out) {
  std::string name;
  if (!ReadParameter(std::move(value), &name)) return false;
  const auto read = FromName<Enum>(name);
  if (read) *out = *read;
  return read.has_value();
}

// What a value has to be, for messages: "a number".
inline std::string TypeName(const double&) { return "a number"; }
inline std::string TypeName(const int&) { return "a whole number"; }
inline std::string TypeName(const bool&) { return "true or false"; }
inline std::string TypeName(const std::string&) { return "a text"; }
inline std::string TypeName(const std::vector<std::string>&) { return "a list of texts"; }
inline std::string TypeName(const std::size_t&) { return "a whole number of at least 0"; }
template <typename Enum, typename = std::enable_if_t<std::is_enum_v<Enum>>>
std::string TypeName(const Enum&) {
  return "one of " + LegalNames<Enum>();
}

// A parameter and the field that it sets.
struct BoundParameter {
  std::function<bool(const XmlRpc::XmlRpcValue&)> read;
  std::string type;
};
using BoundParameters = std::map<std::string, BoundParameter>;

// The field has to outlive what is returned.
template <typename T>
BoundParameter Bind(T* field) {
  return {[field](const XmlRpc::XmlRpcValue& value) { return ReadParameter(value, field); },
          TypeName(*field)};
}

// Sets the fields of what is given: a struct of name to value, or an invalid value for none at all.
// Adds a violation for every unknown name and every value of a wrong type, whose field stays as it
// was.
void ReadParameters(const XmlRpc::XmlRpcValue& parameters, const BoundParameters& known,
                    std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_PARAMETER_BINDING_H_
