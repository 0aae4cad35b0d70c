#include "latticeworld_ros/node/parameter_binding.h"

#include "latticeworld/common/text.h"

namespace latticeworld {

using XmlRpc::XmlRpcValue;

// Values are taken by value throughout, for XmlRpcValue's own conversions are not const.
bool ReadParameter(XmlRpcValue value, double* out) {
  if (value.getType() == XmlRpcValue::TypeInt) return *out = static_cast<int>(value), true;
  if (value.getType() == XmlRpcValue::TypeDouble) return *out = static_cast<double>(value), true;
  return false;
}

bool ReadParameter(XmlRpcValue value, int* out) {
  if (value.getType() != XmlRpcValue::TypeInt) return false;
  *out = static_cast<int>(value);
  return true;
}

bool ReadParameter(XmlRpcValue value, bool* out) {
  if (value.getType() != XmlRpcValue::TypeBoolean) return false;
  *out = static_cast<bool>(value);
  return true;
}

bool ReadParameter(XmlRpcValue value, std::string* out) {
  if (value.getType() != XmlRpcValue::TypeString) return false;
  *out = static_cast<std::string>(value);
  return true;
}

bool ReadParameter(XmlRpcValue value, std::vector<std::string>* out) {
  if (value.getType() != XmlRpcValue::TypeArray) return false;
  std::vector<std::string> read(static_cast<std::size_t>(value.size()));
  for (int i = 0; i < value.size(); ++i) {
    if (!ReadParameter(value[i], &read[static_cast<std::size_t>(i)])) return false;
  }
  *out = std::move(read);
  return true;
}

bool ReadParameter(XmlRpcValue value, std::size_t* out) {
  int number = 0;
  if (!ReadParameter(std::move(value), &number) || number < 0) return false;
  *out = static_cast<std::size_t>(number);
  return true;
}

void ReadParameters(const XmlRpcValue& parameters, const BoundParameters& known,
                    std::vector<Violation>* violations) {
  XmlRpcValue given = parameters;
  if (given.getType() == XmlRpcValue::TypeStruct) {
    for (const auto& [name, value] : given) {
      const auto parameter = known.find(name);
      if (parameter == known.end()) {
        std::vector<std::string> names;
        for (const auto& entry : known) names.push_back(entry.first);
        violations->push_back({"unknown_key", name,
                               "there is no such parameter; there are " + Join(names, ", "), name});
      } else if (!parameter->second.read(value)) {
        violations->push_back(
            {"wrong_type", name, "must be " + parameter->second.type, value.toXml()});
      }
    }
  } else if (given.valid()) {
    violations->push_back({"wrong_type", "", "the parameters are no dictionary", given.toXml()});
  }
}

}  // namespace latticeworld
