#ifndef LATTICEWORLD_VIEWER_PAYLOADS_STATE_STREAM_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_STATE_STREAM_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace latticeworld {

// State frames: docs/viewer.md, "Binary messages", has their bytes.

inline constexpr double kStreamStep_m = 0.01;    // of positions
inline constexpr int kStreamTurn = 65536;        // steps of a full turn
inline constexpr double kStreamKeyPeriod_s = 2;  // of wall time between key frames

// One agent or prop as the stream has it.
struct StreamedThing {
  std::array<std::int32_t, 3> position_cm = {0, 0, 0};  // x, y, z, map frame
  std::array<std::uint16_t, 3> angle = {0, 0, 0};       // yaw, pitch, roll in 2 pi / kStreamTurn
  std::uint8_t behaviour = 0;                           // of agents; props: 1 broken
  std::uint8_t health = 255;                            // of agents [1/255]; props: OpeningByte
  friend bool operator==(const StreamedThing& a, const StreamedThing& b) {
    return a.position_cm == b.position_cm && a.angle == b.angle && a.behaviour == b.behaviour &&
           a.health == b.health;
  }
};

// Rounded to the nearest step. The orientation becomes Rz(yaw) Ry(pitch) Rx(roll), pitch in
// [-pi/2, pi/2]. What is not finite becomes 0, what lies beyond 10000 km its edge.
StreamedThing StreamedPose(const Eigen::Vector3d& position_m,
                           const Eigen::Quaterniond& orientation);
std::uint8_t HealthByte(double health);        // [0, 1] -> [0, 255]
std::uint8_t OpeningByte(double opening_rad);  // [-pi, pi] -> 128 + opening / (pi / 128)

enum class StreamKind : std::uint8_t { kAgents = 1, kProps = 2 };

// A frame for everybody: who has the key frame gets `delta`, who has not gets `key` before it.
struct StreamFrame {
  std::uint64_t key_number = 0;  // grows; its lowest 16 bits stand in the frames
  std::shared_ptr<const std::string> key;
  std::shared_ptr<const std::string> delta;  // null: the state is that of `key`
};

// Makes frames of states, in their order. Deltas build on their key frame alone, so that any
// frame may be left out for any client.
class StateEncoder {
 public:
  explicit StateEncoder(StreamKind kind) : kind_(kind) {}

  // things: by their indices in the table of that version, at most 65535 of them. A key frame is
  // made for the first state, for another table, and where `key` asks for one.
  StreamFrame Encode(double time_s, std::uint32_t table_version,
                     const std::vector<StreamedThing>& things, bool key);

 private:
  StreamKind kind_;
  std::uint32_t table_version_ = 0;
  std::uint64_t key_number_ = 0;  // 0: there is none yet
  std::vector<StreamedThing> key_things_;
  std::shared_ptr<const std::string> key_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_STATE_STREAM_H_
