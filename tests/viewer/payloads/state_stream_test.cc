#include "latticeworld/viewer/payloads/state_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "latticeworld/common/random.h"
#include "viewer/stream_decoder.h"

namespace latticeworld {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Pose {
  Eigen::Vector3d position_m;
  Eigen::Quaterniond orientation;
};

Pose RandomPose(RandomStream* random) {
  Pose pose;
  pose.position_m = {random->Uniform(-4096.0, 4096.0), random->Uniform(-4096.0, 4096.0),
                     random->Uniform(-100.0, 3000.0)};
  pose.orientation = Eigen::Quaterniond(random->Normal(0, 1), random->Normal(0, 1),
                                        random->Normal(0, 1), random->Normal(0, 1))
                         .normalized();
  return pose;
}

Eigen::Quaterniond OrientationOf(const StreamedThing& thing) {
  const double unit = 2.0 * kPi / kStreamTurn;
  return Eigen::AngleAxisd(thing.angle[0] * unit, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(thing.angle[1] * unit, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(thing.angle[2] * unit, Eigen::Vector3d::UnitX());
}

std::vector<StreamedThing> RandomThings(std::size_t count, RandomStream* random) {
  std::vector<StreamedThing> things;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose pose = RandomPose(random);
    things.push_back(StreamedPose(pose.position_m, pose.orientation));
    things.back().behaviour = static_cast<std::uint8_t>(random->UniformInt(0, 16));
    things.back().health = static_cast<std::uint8_t>(random->UniformInt(0, 255));
  }
  return things;
}

// A few of them go on a little.
void Move(std::vector<StreamedThing>* things, RandomStream* random) {
  for (StreamedThing& thing : *things) {
    if (random->Chance(0.3)) continue;
    for (std::int32_t& value : thing.position_cm) value += random->UniformInt(-60, 60);
    if (random->Chance(0.5)) {
      thing.angle[0] = static_cast<std::uint16_t>(random->UniformInt(0, 65535));
    }
    if (random->Chance(0.1)) thing.behaviour = 5;
    if (random->Chance(0.1)) thing.health = static_cast<std::uint8_t>(thing.health / 2);
  }
}

TEST(StateStreamTest, PosesComeBackWithinTheirSteps) {
  RandomStream random(3, "poses");
  for (int i = 0; i < 2000; ++i) {
    const Pose pose = RandomPose(&random);
    const StreamedThing thing = StreamedPose(pose.position_m, pose.orientation);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(thing.position_cm[axis] * kStreamStep_m, pose.position_m[axis], 0.00501);
    }
    EXPECT_LT(OrientationOf(thing).angularDistance(pose.orientation), 3.0 * kPi / kStreamTurn);
  }
}

TEST(StateStreamTest, UprightAndHangingBodiesComeBackToo) {
  for (const double pitch : {kPi / 2.0, -kPi / 2.0}) {
    for (const double yaw : {0.0, 1.0, -2.5}) {
      const Eigen::Quaterniond wanted =
          Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::Quaterniond(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
      const StreamedThing thing = StreamedPose(Eigen::Vector3d::Zero(), wanted);
      EXPECT_LT(OrientationOf(thing).angularDistance(wanted), 1e-3) << pitch << ", " << yaw;
    }
  }
}

TEST(StateStreamTest, WhatIsNotFiniteBecomesSomethingLegal) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const StreamedThing thing =
      StreamedPose({nan, infinity, -1e300}, Eigen::Quaterniond(nan, 0.0, 0.0, 0.0));
  EXPECT_EQ(thing.position_cm, (std::array<std::int32_t, 3>{0, 0, -1000000000}));
  EXPECT_EQ(thing.angle, (std::array<std::uint16_t, 3>{0, 0, 0}));
  EXPECT_EQ(HealthByte(nan), 0);
  EXPECT_EQ(HealthByte(7.0), 255);
  EXPECT_EQ(OpeningByte(nan), 128);
  EXPECT_EQ(OpeningByte(1.4), 185);
}

TEST(StateStreamTest, DecodesToWhatWasEncodedWhicheverFramesAreLost) {
  RandomStream random(5, "frames");
  StateEncoder encoder(StreamKind::kAgents);
  StreamDecoder decoder;
  std::vector<StreamedThing> things = RandomThings(40, &random);
  std::uint64_t known_key = 0;
  int deltas = 0;
  for (int i = 0; i < 400; ++i) {
    Move(&things, &random);
    const StreamFrame frame = encoder.Encode(0.05 * i, 7, things, i % 40 == 0);
    if (random.Chance(0.4)) continue;  // lost
    if (known_key != frame.key_number) {
      ASSERT_TRUE(decoder.Read(*frame.key));
    }
    known_key = frame.key_number;
    if (frame.delta != nullptr) {
      ASSERT_TRUE(decoder.Read(*frame.delta));
      ++deltas;
    }
    ASSERT_EQ(decoder.things(), things) << "frame " << i;
    EXPECT_EQ(decoder.time_s(), 0.05 * i);
    EXPECT_EQ(decoder.version(), 7u);
  }
  EXPECT_GT(deltas, 100);
}

TEST(StateStreamTest, ADeltaWithoutItsKeyFrameIsIgnored) {
  RandomStream random(6, "frames");
  StateEncoder encoder(StreamKind::kProps);
  std::vector<StreamedThing> things = RandomThings(3, &random);
  const StreamFrame first = encoder.Encode(0.0, 1, things, false);
  Move(&things, &random);
  (void)encoder.Encode(1.0, 1, things, /*key=*/true);
  Move(&things, &random);
  const StreamFrame third = encoder.Encode(2.0, 1, things, false);
  ASSERT_NE(third.delta, nullptr);
  StreamDecoder decoder;
  EXPECT_FALSE(decoder.Read(*third.delta));
  ASSERT_TRUE(decoder.Read(*first.key));
  EXPECT_FALSE(decoder.Read(*third.delta));
  EXPECT_EQ(decoder.kind(), 2);
  ASSERT_TRUE(decoder.Read(*third.key));
  ASSERT_TRUE(decoder.Read(*third.delta));
  EXPECT_EQ(decoder.things(), things);
}

TEST(StateStreamTest, AnotherTableBeginsWithAKeyFrame) {
  RandomStream random(8, "frames");
  StateEncoder encoder(StreamKind::kAgents);
  const std::vector<StreamedThing> things = RandomThings(4, &random);
  EXPECT_EQ(encoder.Encode(0.0, 1, things, false).delta, nullptr);
  EXPECT_NE(encoder.Encode(0.1, 1, things, false).delta, nullptr);
  EXPECT_EQ(encoder.Encode(0.2, 2, things, false).delta, nullptr);
  EXPECT_EQ(encoder.Encode(0.3, 2, RandomThings(5, &random), false).delta, nullptr);
}

TEST(StateStreamTest, HasTheBytesOfTheDocumentation) {
  StreamedThing thing;
  thing.position_cm = {1, -2, 300};
  thing.angle = {0x1234, 0, 0xffff};
  thing.behaviour = 3;
  thing.health = 250;
  StateEncoder encoder(StreamKind::kAgents);
  const StreamFrame key = encoder.Encode(0.0, 5, {thing}, false);
  const std::string time(8, '\0');
  EXPECT_EQ(*key.key, std::string("\x01\x01\x01\x00\x05\x00\x00\x00", 8) + time +
                          std::string("\x01\x00\x00\x00", 4) +
                          std::string("\x01\x00\x00\x00\xfe\xff\xff\xff\x2c\x01\x00\x00", 12) +
                          std::string("\x34\x12\x00\x00\xff\xff\x03\xfa", 8));
  thing.position_cm = {1, -102, 299};
  thing.health = 0;
  const StreamFrame delta = encoder.Encode(0.0, 5, {thing}, false);
  // y: -100 -> 199 = c7 01; z: -1 -> 1.
  EXPECT_EQ(*delta.delta, std::string("\x01\x00\x01\x00\x05\x00\x00\x00", 8) + time +
                              std::string("\x01\x00\x00\x00\x86\xc7\x01\x01\x00", 9));
}

}  // namespace
}  // namespace latticeworld
