#include "latticeworld_ros/episode/parameters_json.h"

#include <nlohmann/json.hpp>

namespace latticeworld {
namespace {

using XmlRpc::XmlRpcValue;
using Json = nlohmann::ordered_json;

// XmlRpcValue's own conversions are not const.
Json ToJson(XmlRpcValue value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value);
    case XmlRpcValue::TypeInt:
      return static_cast<int>(value);
    case XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    case XmlRpcValue::TypeArray: {
      Json array = Json::array();
      for (int i = 0; i < value.size(); ++i) array.push_back(ToJson(value[i]));
      return array;
    }
    case XmlRpcValue::TypeStruct: {
      Json object = Json::object();
      for (const auto& [name, member] : value) object[name] = ToJson(member);
      return object;
    }
    case XmlRpcValue::TypeInvalid:
      return nullptr;
    default:
      return value.toXml();
  }
}

}  // namespace

std::string ParametersToJson(const XmlRpcValue& parameters) {
  return ToJson(parameters).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace latticeworld
