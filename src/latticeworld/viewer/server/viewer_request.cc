#include "latticeworld/viewer/server/viewer_request.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
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
// Nobody else refuses a speed: robots drive as fast as they can.
constexpr double kMostSpeed = 1000.0;
constexpr char kLegalSpeeds[] = "-1000 .. 1000";

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

  // nullopt when the key is absent. What is no number of [low, high] is refused.
  std::optional<double> Number(const char* key, double low, double high, const std::string& legal) {
    const json* value = Take(key);
    if (value == nullptr) return std::nullopt;
    const double number = value->is_number() ? value->get<double>() : std::nan("");
    if (number >= low && number <= high) return number;
    Refuse(key, *value, legal);
    return std::nullopt;
  }
  // Any finite number.
  std::optional<double> Number(const char* key) {
    constexpr double kMost = std::numeric_limits<double>::max();
    return Number(key, -kMost, kMost, "a number");
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

  // What was refused so far.
  Status Refused(std::string_view what) const { return Status::FromViolations(what, violations_); }

  // The same with keys that nobody took.
  Status Finish(const std::string& what) {
    for (const auto& [key, value] : object_.items()) {
      if (std::find(taken_.begin(), taken_.end(), key) != taken_.end()) continue;
      violations_.push_back({"unknown_key", "/" + PointerToken(key),
                             "there is no such key; there are " + Join(taken_, ", "), Quote(key)});
    }
    return Refused(what);
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
    request->linear_mps[i] =
        reader->Number(keys[i], -kMostSpeed, kMostSpeed, kLegalSpeeds).value_or(0.0);
  }
  request->angular_radps =
      reader->Number("angular_radps", -kMostSpeed, kMostSpeed, kLegalSpeeds).value_or(0.0);
}

void ReadStep(RequestReader* reader, ViewerRequest* request) {
  constexpr char kLegal[] = "a whole number of at least 1, of 32 bits";
  const double steps =
      reader->Number("steps", 1.0, std::numeric_limits<std::uint32_t>::max(), kLegal).value_or(1.0);
  if (steps != std::floor(steps)) reader->Refuse("steps", json(steps), kLegal);
  request->steps = static_cast<std::uint32_t>(steps);
}

void ReadGenerate(RequestReader* reader, ViewerRequest* request) {
  request->layout = reader->Text("layout", kMaxRequestBytes);
  request->environment = reader->Text("environment", kMaxRequestBytes);
  request->vocabulary = reader->Text("vocabulary", kMaxRequestBytes);
  request->reader = reader->Text("reader", kMaxRequestBytes);
  request->generator = reader->Text("generator", kMaxRequestBytes);
  request->seed = reader->Seed("seed");
  request->size_m = reader->Number("size_m").value_or(0.0);
  request->resolution_m = reader->Number("resolution_m").value_or(0.0);
}

void ReadWeather(RequestReader* reader, ViewerRequest* request) {
  request->weather = reader->Text("weather", kMaxRequestBytes);
  request->intensity = reader->Number("intensity");
  request->hour = reader->Number("hour");
  request->transition_s = reader->Number("transition_s").value_or(0.0);
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
      request->factor = reader->Number("factor").value_or(1.0);
      break;
    case RequestType::kReset:
      request->seed = reader->Seed("seed");
      break;
    case RequestType::kGenerate:
      ReadGenerate(reader, request);
      break;
    case RequestType::kLoadWorld:
    case RequestType::kSaveWorld:
      request->name = reader->Text("name", kMaxRequestBytes);
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
    reader.Refuse("type", given_type == nullptr ? json() : *given_type, LegalNames<RequestType>());
    return reader.Refused("a message");
  }
  *type = NameOf(*known);
  request.type = *known;
  ReadFields(&reader, &request);
  LW_RETURN_IF_ERROR(reader.Finish(*type));
  return request;
}

}  // namespace latticeworld
