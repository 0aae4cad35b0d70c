// Writes messages of the stream, and what is in them, for tests of the page:
//   write_stream_samples DIR     key.bin, delta.bin, points.bin, expected.json

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/common/random.h"
#include "latticeworld/viewer/payloads/points_message.h"
#include "latticeworld/viewer/payloads/state_stream.h"

namespace latticeworld {
namespace {

constexpr std::uint32_t kVersion = 4;

nlohmann::json ToJson(const std::vector<StreamedThing>& things) {
  nlohmann::json list = nlohmann::json::array();
  for (const StreamedThing& thing : things) {
    list.push_back({{"position_cm", thing.position_cm},
                    {"angle", thing.angle},
                    {"behaviour", thing.behaviour},
                    {"health", thing.health}});
  }
  return list;
}

Status Write(const std::filesystem::path& directory) {
  RandomStream random(1, "samples");
  std::vector<StreamedThing> things(20);
  for (StreamedThing& thing : things) {
    for (auto& value : thing.position_cm) value = random.UniformInt(-400000, 400000);
    for (auto& value : thing.angle) value = static_cast<std::uint16_t>(random.UniformInt(0, 65535));
    thing.behaviour = static_cast<std::uint8_t>(random.UniformInt(0, 16));
  }
  nlohmann::json expected;
  StateEncoder encoder(StreamKind::kAgents);
  const StreamFrame key = encoder.Encode(12.25, kVersion, things, true);
  expected["key"] = {{"time_s", 12.25}, {"version", kVersion}, {"things", ToJson(things)}};
  for (std::size_t i = 0; i < things.size(); i += 2) {
    for (auto& value : things[i].position_cm) value += random.UniformInt(-20000, 20000);
    if (i % 3 == 0) things[i].angle[0] = 40000;
    if (i % 4 == 0) things[i].health = 17;
    if (i % 5 == 0) things[i].behaviour = 9;
  }
  const StreamFrame delta = encoder.Encode(12.3, kVersion, things, false);
  expected["delta"] = {{"time_s", 12.3}, {"version", kVersion}, {"things", ToJson(things)}};
  const std::vector<ViewerPoint> points = {{{1.0f, -2.0f, 0.5f}, 10}, {{-3.0f, 0.0f, 4.0f}, 200}};
  expected["points"] = {{"time_s", 1.5},
                        {"sensor_m", {10.0, 20.0, 3.0}},
                        {"points_m", {{11.0, 18.0, 3.5}, {7.0, 20.0, 7.0}}},
                        {"intensity", {10, 200}}};
  LW_RETURN_IF_ERROR(WriteFile(directory / "key.bin", *key.key));
  LW_RETURN_IF_ERROR(WriteFile(directory / "delta.bin", *delta.delta));
  LW_RETURN_IF_ERROR(
      WriteFile(directory / "points.bin", PointsMessage(1.5, {10.0, 20.0, 3.0}, points)));
  return WriteFile(directory / "expected.json", expected.dump(1));
}

}  // namespace
}  // namespace latticeworld

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_stream_samples DIR\n";
    return 2;
  }
  const latticeworld::Status status = latticeworld::Write(argv[1]);
  if (!status.ok()) std::cerr << status.ToString() << "\n";
  return status.ok() ? 0 : 1;
}
