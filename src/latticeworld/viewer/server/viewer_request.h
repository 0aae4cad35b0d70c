#ifndef LATTICEWORLD_VIEWER_SERVER_VIEWER_REQUEST_H_
#define LATTICEWORLD_VIEWER_SERVER_VIEWER_REQUEST_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

enum class RequestType : std::uint8_t {
  kAuthenticate,
  kSubscribe,
  kListWorlds,
  kDrive,
  kStrike,
  kPause,
  kUnpause,
  kStep,
  kSpeed,
  kReset,
  kGenerate,
  kCancel,
  kLoadWorld,
  kSaveWorld,
  kSetWeather
};
constexpr std::array<EnumName<RequestType>, 15> EnumNames(RequestType) {
  return {{{RequestType::kAuthenticate, "authenticate"},
           {RequestType::kSubscribe, "subscribe"},
           {RequestType::kListWorlds, "list_worlds"},
           {RequestType::kDrive, "drive"},
           {RequestType::kStrike, "strike"},
           {RequestType::kPause, "pause"},
           {RequestType::kUnpause, "unpause"},
           {RequestType::kStep, "step"},
           {RequestType::kSpeed, "speed"},
           {RequestType::kReset, "reset"},
           {RequestType::kGenerate, "generate"},
           {RequestType::kCancel, "cancel"},
           {RequestType::kLoadWorld, "load_world"},
           {RequestType::kSaveWorld, "save_world"},
           {RequestType::kSetWeather, "set_weather"}}};
}
// Whether it changes something, so that it takes a controller.
bool IsControl(RequestType type);

inline constexpr std::size_t kMaxRequestBytes = 4096;

// What a client asks for: docs/viewer.md has the keys. Only the fields of its type are set. Which
// values are legal, world_server says where it answers the request; [ ] are limits of the message.
struct ViewerRequest {
  RequestType type = RequestType::kListWorlds;
  std::string id = "null";  // as JSON: a number, a short text or null; the reply repeats it

  std::string token;                  // authenticate
  bool lidar = false, paths = false;  // subscribe: the layers
  std::string robot;                  // subscribe, drive, strike: legal as a ROS name, or empty
  std::array<double, 3> linear_mps = {0.0, 0.0, 0.0};  // drive: forward, left, up; [-1000, 1000]
  double angular_radps = 0.0;                          // drive: counter-clockwise, [-1000, 1000]
  std::uint32_t steps = 1;                             // step: at least 1
  double factor = 1.0;                                 // speed
  std::uint64_t seed = 0;                              // reset, generate; 0: not given
  std::string layout, environment;                     // generate
  std::string vocabulary, reader, generator;           // generate; empty: not given
  double size_m = 0.0, resolution_m = 0.0;             // generate; 0: not given
  std::string name;                                    // load_world, save_world
  std::string weather;                                 // set_weather; empty: not given
  std::optional<double> intensity, hour;               // set_weather
  double transition_s = 0.0;                           // set_weather
};

// Reads a message of a client; trusts nothing. Errors: INVALID_ARGUMENT naming everything that is
// wrong: no JSON, too long, unknown type or keys, wrong types, limits of the message. id: receives
// the request's id where one can be read, else "null"; type: its type as it was given, or "".
Result<ViewerRequest> ParseRequest(std::string_view text, std::string* id, std::string* type);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_VIEWER_REQUEST_H_
