#include "latticeworld/language/chat/model_list.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace latticeworld {

std::string FirstModel(std::string_view list) {
  using Json = nlohmann::json;
  const Json json = Json::parse(list, nullptr, /*allow_exceptions=*/false);
  for (const auto& [array, name] : {std::pair{"data", "id"}, std::pair{"models", "name"}}) {
    if (!json.is_object() || !json.contains(array) || !json[array].is_array()) continue;
    for (const Json& model : json[array]) {
      if (model.is_object() && model.contains(name) && model[name].is_string()) {
        return model[name].get<std::string>();
      }
    }
  }
  return "";
}

}  // namespace latticeworld
