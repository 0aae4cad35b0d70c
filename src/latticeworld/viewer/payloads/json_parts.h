#ifndef LATTICEWORLD_VIEWER_PAYLOADS_JSON_PARTS_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_JSON_PARTS_H_

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace latticeworld {

struct Atmosphere;

using Json = nlohmann::ordered_json;

// Text of a message: bytes that are no UTF-8 are replaced.
inline std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}
inline Json VectorJson(const Eigen::Vector3d& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

// The keys of the message `weather`, without its type.
Json AtmosphereJson(const Atmosphere& atmosphere);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_JSON_PARTS_H_
