#include "latticeworld/viewer/server/viewer_request.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxIdBytes = 64;
constexpr std::size_t kMaxNameBytes = 128;
constexpr double kMostSpeed = 1000.0;
constexpr double kMostSteps = 100000.0;
constexpr double kMostSize_m = 8192.0;
constexpr double kMostTransition_s = 86400.0;

// Reads the keys of one object, each once; what is left over is unknown.
class RequestReader {
 public:
  explicit RequestReader(const json& object) : object_(object) {}

  // nullptr when the key is absent.
  const json* Take(const char* key) {
    taken_.emplace_back(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }

  std::string Text(const char* key, std::size_t max_bytes) {
    const json* value = Take(key);
    if (value == nullptr) return "";
    if (!value->is_string()) return Refuse(key, *value, "a text"), "";
    auto text = value->get<std::string>();
    if (const Status status = ValidateText(key, text, max_bytes); !status.ok()) {
      violations_.push_back({"bad_text", Pointer(key), status.message(), Quote(text)});
      return "";
    }
    return text;
  }

  // A name of ROS's: what topics are made of.
  std::string Robot(const char* key, bool required) {
    std::string name = Text(key, kMaxNameBytes);
    const bool legal = std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!legal || (required && name.empty()) ||
        (!name.empty() && name[0] >= '0' && name[0] <= '9')) {
      Refuse(key, json(name), "the name of an agent: letters, digits and '_'");
      return "";
    }
    return name;
  }

  double Number(const char* key, double low, double high, double absent) {
    const json* value = Take(key);
    if (value == nullptr) return absent;
    const double number = value->is_number() ? value->get<double>() : std::nan("");
    if (!(number >= low && number <= high)) {
      Refuse(key, *value, FormatDouble(low) + " .. " + FormatDouble(high));
      return absent;
    }
    return number;
  }

  // Reads a seed that is a number, or a text if it has more digits than a browser's numbers.
  std::uint64_t Seed(const char* key) {
    const json* value = Take(key);
    if (value == nullptr) return 0;
    if (value->is_number_unsigned()) return value->get<std::uint64_t>();
    if (value->is_string()) {
      const auto& text = value->get_ref<const std::string&>();
      std::uint64_t seed = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
      if (error == std::errc() && end == text.data() + text.size()) return seed;
    }
    Refuse(key, *value, "a whole number of at most 64 bits, as a number or a text");
    return 0;
  }

  void Layers(const char* key, ViewerRequest* request) {
    const json* value = Take(key);
    if (value == nullptr || !value->is_array()) {
      Refuse(key, value == nullptr ? json() : *value, "a list of \"lidar\" and \"paths\"");
      return;
    }
    for (const json& layer : *value) {
      if (layer == "lidar") {
        request->lidar = true;
      } else if (layer == "paths") {
        request->paths = true;
      } else {
        Refuse(key, layer, "\"lidar\" or \"paths\"");
      }
    }
  }

  void Refuse(const char* key, const json& given, const std::string& legal) {
    const std::string text = Quote(given.dump(-1, ' ', false, json::error_handler_t::replace));
    violations_.push_back(
        {"illegal_value", Pointer(key), text + " is not legal; legal is " + legal, text});
  }

  Status Finish(const std::string& what) {
    for (const auto& [key, value] : object_.items()) {
      if (std::find(taken_.begin(), taken_.end(), key) != taken_.end()) continue;
      violations_.push_back({"unknown_key", "/" + PointerToken(key),
                             "there is no such key; there are " + Join(taken_, ", "), Quote(key)});
    }
    return Status::FromViolations(what, std::move(violations_));
  }

 private:
  static std::string Pointer(const char* key) { return std::string("/") + key; }

  const json& object_;
  std::vector<std::string> taken_;
  std::vector<Violation> violations_;
};

void ReadDrive(RequestReader* reader, ViewerRequest* request) {
  request->robot = reader->Robot("robot", /*required=*/true);
  const char* const keys[] = {"linear_mps", "lateral_mps", "vertical_mps"};
  for (int i = 0; i < 3; ++i) {
    request->linear_mps[i] = reader->Number(keys[i], -kMostSpeed, kMostSpeed, 0.0);
  }
  request->angular_radps = reader->Number("angular_radps", -kMostSpeed, kMostSpeed, 0.0);
}

void ReadStep(RequestReader* reader, ViewerRequest* request) {
  const double steps = reader->Number("steps", 1.0, kMostSteps, 1.0);
  if (steps != std::floor(steps)) reader->Refuse("steps", json(steps), "a whole number");
  request->steps = static_cast<std::uint32_t>(steps);
}

void ReadGenerate(RequestReader* reader, ViewerRequest* request) {
  request->layout = reader->Text("layout", kMaxRequestBytes);
  request->environment = reader->Text("environment", kMaxRequestBytes);
  request->vocabulary = reader->Text("vocabulary", kMaxNameBytes);
  request->reader = reader->Text("reader", kMaxNameBytes);
  request->generator = reader->Text("generator", kMaxNameBytes);
  request->seed = reader->Seed("seed");
  request->size_m = reader->Number("size_m", 0.0, kMostSize_m, 0.0);
  request->resolution_m = reader->Number("resolution_m", 0.0, kMostSize_m, 0.0);
}

void ReadWeather(RequestReader* reader, ViewerRequest* request) {
  request->weather = reader->Text("weather", kMaxNameBytes);
  const double absent = std::nan("");
  const double intensity = reader->Number("intensity", 0.0, 1.0, absent);
  const double hour = reader->Number("hour", 0.0, 24.0, absent);
  if (!std::isnan(intensity)) request->intensity = intensity;
  if (!std::isnan(hour)) request->hour = hour;
  request->transition_s = reader->Number("transition_s", 0.0, kMostTransition_s, 0.0);
}

void ReadFields(RequestReader* reader, ViewerRequest* request) {
  // Each type has fields of its own; RequestReader refuses what is left over.
  switch (request->type) {
    case RequestType::kAuthenticate:
      request->token = reader->Text("token", kMaxRequestBytes);
      break;
    case RequestType::kSubscribe:
      reader->Layers("layers", request);
      request->robot = reader->Robot("robot", /*required=*/false);
      break;
    case RequestType::kDrive:
      ReadDrive(reader, request);
      break;
    case RequestType::kStrike:
      request->robot = reader->Robot("robot", /*required=*/true);
      break;
    case RequestType::kStep:
      ReadStep(reader, request);
      break;
    case RequestType::kSpeed:
      request->factor = reader->Number("factor", 0.0, 1000.0, 1.0);
      if (request->factor != 0.0 && request->factor < 0.01) {
        reader->Refuse("factor", json(request->factor), "0, or 0.01 .. 1000");
      }
      break;
    case RequestType::kReset:
      request->seed = reader->Seed("seed");
      break;
    case RequestType::kGenerate:
      ReadGenerate(reader, request);
      break;
    case RequestType::kLoadWorld:
    case RequestType::kSaveWorld:
      request->name = reader->Text("name", kMaxNameBytes);
      break;
    case RequestType::kSetWeather:
      ReadWeather(reader, request);
      break;
    case RequestType::kListWorlds:
    case RequestType::kPause:
    case RequestType::kUnpause:
    case RequestType::kCancel:
      break;
  }
}

}  // namespace

bool IsControl(RequestType type) {
  return type != RequestType::kAuthenticate && type != RequestType::kSubscribe &&
         type != RequestType::kListWorlds;
}

Result<ViewerRequest> ParseRequest(std::string_view text, std::string* id, std::string* type) {
  *id = "null";
  type->clear();
  // Texts come from anybody: they are small and shallow, or refused.
  JsonLimits limits;
  limits.max_bytes = kMaxRequestBytes;
  limits.max_depth = 3;
  limits.max_keys = 32;
  limits.max_elements = 16;
  json object;
  std::vector<Violation> violations;
  if (!ParseStrictly(text, "", limits, &object, &violations) || !violations.empty()) {
    LimitViolations(&violations);
    return Status::FromViolations("a message", std::move(violations));
  }
  if (!object.is_object()) return InvalidArgument("a message is a JSON object with a type");
  RequestReader reader(object);
  ViewerRequest request;
  // The id goes back with the answer, whatever else is wrong.
  if (const json* given = reader.Take("id"); given != nullptr) {
    const std::string written = given->dump(-1, ' ', false, json::error_handler_t::replace);
    if ((given->is_number() || given->is_string() || given->is_null()) &&
        written.size() <= kMaxIdBytes) {
      *id = written;
    } else {
      reader.Refuse("id", *given, "a number or a text of at most 64 bytes");
    }
  }
  request.id = *id;
  // The type says which fields are read.
  const json* given_type = reader.Take("type");
  const bool is_text = given_type != nullptr && given_type->is_string();
  const auto known =
      is_text ? FromName<RequestType>(given_type->get_ref<const std::string&>()) : std::nullopt;
  if (!known) {
    return InvalidArgument("type is " +
                           (given_type == nullptr ? "missing" : Quote(given_type->dump())) +
                           "; legal are " + LegalNames<RequestType>());
  }
  *type = NameOf(*known);
  request.type = *known;
  ReadFields(&reader, &request);
  LW_RETURN_IF_ERROR(reader.Finish(*type));
  return request;
}

}  // namespace latticeworld
