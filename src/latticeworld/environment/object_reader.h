#ifndef LATTICEWORLD_ENVIRONMENT_OBJECT_READER_H_
#define LATTICEWORLD_ENVIRONMENT_OBJECT_READER_H_

// This header is for .cc files of this room only: a public one would make nlohmann's JSON
// everybody's.

#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/status.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

// The JSON as it was given, cut where it is too long for a message.
inline std::string GivenJson(const nlohmann::json& json) {
  if (json.is_string()) return Quote(json.get<std::string>());
  const std::string quoted = Quote(json.dump());  // with quotation marks around it
  return quoted.substr(1, quoted.size() - 2);
}

inline Violation WrongType(const std::string& pointer, const std::string& wanted,
                           const nlohmann::json& given) {
  return {"wrong_type", pointer,
          "must be " + wanted + ", not " + GivenJson(given) + " (" + given.type_name() + ")",
          GivenJson(given)};
}

// Reads fields of one object, noting what is missing, unknown or of the wrong type.
class ObjectReader {
 public:
  ObjectReader(const nlohmann::json& json, std::string pointer, std::vector<Violation>* violations)
      : json_(json), pointer_(std::move(pointer)), violations_(violations) {
    if (!json_.is_object()) Wrong(pointer_, "an object", json_);
  }
  ~ObjectReader() {
    if (!json_.is_object()) return;
    for (const auto& [key, value] : json_.items()) {
      if (known_.count(key) > 0) continue;
      std::vector<std::string> legal(known_.begin(), known_.end());
      violations_->push_back({"unknown_key", pointer_ + "/" + PointerToken(key),
                              Quote(key) + " is not one of " + Join(legal, ", "), Quote(key)});
    }
  }
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  // nullptr, and a violation, when the key is missing.
  const nlohmann::json* Find(const std::string& key) {
    known_.insert(key);
    if (!json_.is_object()) return nullptr;
    const auto found = json_.find(key);
    if (found != json_.end()) return &*found;
    violations_->push_back({"missing_key", pointer_ + "/" + key, "is missing", ""});
    return nullptr;
  }

  void Read(const std::string& key, std::string* value) {
    const nlohmann::json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong(At(key), "a string", *json);
    *value = json->get<std::string>();
  }
  void Read(const std::string& key, double* value) {
    const nlohmann::json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_number()) return Wrong(At(key), "a number", *json);
    *value = json->get<double>();
  }
  // `least` and `most` are for the message about a number that no int holds.
  void Read(const std::string& key, int least, int most, int* value) {
    const nlohmann::json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_number_integer()) return Wrong(At(key), "a whole number", *json);
    const double number = json->get<double>();  // any integer that JSON can hold
    if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max()) {
      violations_->push_back({"out_of_range", At(key),
                              "must be from " + std::to_string(least) + " to " +
                                  std::to_string(most) + ", not " + GivenJson(*json),
                              GivenJson(*json)});
      return;
    }
    *value = json->get<int>();
  }
  template <typename Enum>
  void ReadName(const std::string& key, Enum* value) {
    std::string name;
    const nlohmann::json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong(At(key), "a string", *json);
    name = json->get<std::string>();
    if (const auto found = FromName<Enum>(name)) {
      *value = *found;
    } else {
      violations_->push_back({"unknown_value", At(key),
                              Quote(name) + " is not one of " + LegalNames<Enum>(), Quote(name)});
    }
  }

  void Wrong(const std::string& pointer, const std::string& wanted, const nlohmann::json& given) {
    violations_->push_back(WrongType(pointer, wanted, given));
  }
  std::string At(const std::string& key) const { return pointer_ + "/" + key; }

 private:
  const nlohmann::json& json_;
  std::string pointer_;
  std::vector<Violation>* violations_;
  std::set<std::string> known_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_OBJECT_READER_H_
