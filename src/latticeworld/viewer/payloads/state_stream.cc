#include "latticeworld/viewer/payloads/state_stream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/viewer/payloads/little_endian.h"

namespace latticeworld {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFarthest_m = 1e7;
constexpr std::size_t kHeaderBytes = 18;
constexpr std::size_t kKeyEntryBytes = 22;
constexpr std::size_t kMostRows = 65535;

// Bits of a delta entry's mask.
constexpr unsigned kBehaviourBit = 64, kHealthBit = 128;

std::int32_t Centimetres(double value_m) {
  if (!std::isfinite(value_m)) return 0;
  return static_cast<std::int32_t>(
      std::lround(std::clamp(value_m, -kFarthest_m, kFarthest_m) / kStreamStep_m));
}

std::uint16_t AngleSteps(double angle_rad) {
  if (!std::isfinite(angle_rad)) return 0;
  const double turns = angle_rad / (2.0 * kPi);
  const double steps = (turns - std::floor(turns)) * kStreamTurn;
  return static_cast<std::uint16_t>(static_cast<std::uint32_t>(std::lround(steps)) &
                                    (kStreamTurn - 1));
}

void AppendVarint(std::int64_t value, std::string* bytes) {
  auto zigzag = static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
  while (zigzag >= 0x80) {
    bytes->push_back(static_cast<char>((zigzag & 0x7f) | 0x80));
    zigzag >>= 7;
  }
  bytes->push_back(static_cast<char>(zigzag));
}

std::string Header(StreamKind kind, bool key, std::uint64_t key_number, std::uint32_t table_version,
                   double time_s) {
  std::string bytes;
  bytes.reserve(kHeaderBytes);
  AppendLittleEndian(static_cast<std::uint8_t>(kind), &bytes);
  AppendLittleEndian(static_cast<std::uint8_t>(key), &bytes);
  AppendLittleEndian(static_cast<std::uint16_t>(key_number), &bytes);
  AppendLittleEndian(table_version, &bytes);
  AppendLittleEndian(time_s, &bytes);
  return bytes;
}

void AppendKeyEntry(std::size_t index, const StreamedThing& thing, std::string* bytes) {
  AppendLittleEndian(static_cast<std::uint16_t>(index), bytes);
  for (const std::int32_t value : thing.position_cm) AppendLittleEndian(value, bytes);
  for (const std::uint16_t value : thing.angle) AppendLittleEndian(value, bytes);
  AppendLittleEndian(thing.behaviour, bytes);
  AppendLittleEndian(thing.health, bytes);
}

void AppendDeltaEntry(std::size_t index, const StreamedThing& thing, const StreamedThing& key,
                      std::string* bytes) {
  unsigned mask = 0;
  for (unsigned i = 0; i < 3; ++i) {
    if (thing.position_cm[i] != key.position_cm[i]) mask |= 1u << i;
    if (thing.angle[i] != key.angle[i]) mask |= 8u << i;
  }
  if (thing.behaviour != key.behaviour) mask |= kBehaviourBit;
  if (thing.health != key.health) mask |= kHealthBit;
  AppendLittleEndian(static_cast<std::uint16_t>(index), bytes);
  AppendLittleEndian(static_cast<std::uint8_t>(mask), bytes);
  for (unsigned i = 0; i < 3; ++i) {
    if ((mask & 1u << i) == 0) continue;
    AppendVarint(static_cast<std::int64_t>(thing.position_cm[i]) - key.position_cm[i], bytes);
  }
  for (unsigned i = 0; i < 3; ++i) {
    if ((mask & 8u << i) != 0) AppendLittleEndian(thing.angle[i], bytes);
  }
  if ((mask & kBehaviourBit) != 0) AppendLittleEndian(thing.behaviour, bytes);
  if ((mask & kHealthBit) != 0) AppendLittleEndian(thing.health, bytes);
}

}  // namespace

StreamedThing StreamedPose(const Eigen::Vector3d& position_m,
                           const Eigen::Quaterniond& orientation) {
  StreamedThing thing;
  for (int i = 0; i < 3; ++i) thing.position_cm[i] = Centimetres(position_m[i]);
  const double norm = orientation.norm();
  if (!(norm > 1e-9) || !std::isfinite(norm)) return thing;
  const Eigen::Matrix3d turn = orientation.normalized().toRotationMatrix();
  const double pitch = std::asin(std::clamp(-turn(2, 0), -1.0, 1.0));
  double yaw = 0.0, roll = 0.0;
  if (std::hypot(turn(0, 0), turn(1, 0)) > 1e-6) {
    yaw = std::atan2(turn(1, 0), turn(0, 0));
    roll = std::atan2(turn(2, 1), turn(2, 2));
  } else {  // straight up or down: yaw and roll turn about the same axis
    yaw = std::atan2(-turn(0, 1), turn(1, 1));
  }
  thing.angle = {AngleSteps(yaw), AngleSteps(pitch), AngleSteps(roll)};
  return thing;
}

std::uint8_t HealthByte(double health) {
  if (!std::isfinite(health)) return 0;
  return static_cast<std::uint8_t>(std::lround(std::clamp(health, 0.0, 1.0) * 255.0));
}

std::uint8_t OpeningByte(double opening_rad) {
  if (!std::isfinite(opening_rad)) return 128;
  return static_cast<std::uint8_t>(
      std::clamp(std::lround(128.0 + opening_rad / (kPi / 128.0)), 0L, 255L));
}

StreamFrame StateEncoder::Encode(double time_s, std::uint32_t table_version,
                                 const std::vector<StreamedThing>& things, bool key) {
  LW_CHECK(things.size() <= kMostRows, "a table of the stream has at most 65535 entries");
  StreamFrame frame;
  if (key || key_number_ == 0 || table_version != table_version_ ||
      things.size() != key_things_.size()) {
    ++key_number_;
    table_version_ = table_version;
    key_things_ = things;
    std::string bytes = Header(kind_, true, key_number_, table_version, time_s);
    bytes.reserve(kHeaderBytes + things.size() * kKeyEntryBytes);
    AppendLittleEndian(static_cast<std::uint16_t>(things.size()), &bytes);
    for (std::size_t i = 0; i < things.size(); ++i) AppendKeyEntry(i, things[i], &bytes);
    key_ = std::make_shared<const std::string>(std::move(bytes));
    frame.key_number = key_number_;
    frame.key = key_;
    return frame;
  }
  std::uint16_t count = 0;
  std::string entries;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i] == key_things_[i]) continue;
    AppendDeltaEntry(i, things[i], key_things_[i], &entries);
    ++count;
  }
  std::string bytes = Header(kind_, false, key_number_, table_version, time_s);
  AppendLittleEndian(count, &bytes);
  bytes += entries;
  frame.key_number = key_number_;
  frame.key = key_;
  frame.delta = std::make_shared<const std::string>(std::move(bytes));
  return frame;
}

}  // namespace latticeworld
