// Networks that say nonsense: each is refused, fails with words, or gives heights.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/common/random.h"
#include "latticeworld/relief/sketch/onnx_check.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "latticeworld/relief/sketch/sketch_model.h"

namespace latticeworld {
namespace {

// Fields of protocol buffers, of numbers below 16.
std::string Varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
  return bytes + static_cast<char>(value);
}
std::string Number(int field, std::int64_t value) {
  return static_cast<char>(field << 3) + Varint(static_cast<std::uint64_t>(value));
}
std::string Bytes(int field, const std::string& bytes) {
  return static_cast<char>(field << 3 | 2) + Varint(bytes.size()) + bytes;
}

// A constant of 2 x 3 floats, but for what `more` says.
std::string Constant(const std::string& values, const std::string& more = "") {
  return Bytes(8, "grain") + Number(2, 1) + Number(1, 2) + Number(1, 3) + values + more;
}
std::string Raw(std::size_t bytes) { return Bytes(9, std::string(bytes, '\1')); }
std::string Node(const std::string& type, const std::string& attribute) {
  return Bytes(11, Bytes(1, "in")) + Bytes(1, Bytes(1, "in") + Bytes(1, "in") + Bytes(2, "out") +
                                                  Bytes(4, type) + Bytes(5, attribute));
}
std::string Sizes(const std::string& name, const std::vector<std::int64_t>& sizes) {
  std::string packed;
  for (const std::int64_t size : sizes) packed += Varint(static_cast<std::uint64_t>(size));
  return Bytes(1, name) + Bytes(8, packed);
}
Status Checked(const std::string& graph) { return internal::CheckOnnxNetwork(Bytes(7, graph)); }

void ExpectRefused(const std::string& graph, const std::string& words) {
  const Status status = Checked(graph);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_NE(status.message().find(words), std::string::npos) << status.ToString();
}

TEST(OnnxCheckTest, ConstantsHaveTheValuesOfTheirShapes) {
  const std::string floats = Bytes(4, std::string(24, '\1'));
  EXPECT_TRUE(Checked(Bytes(5, Constant(Raw(24)))).ok());
  EXPECT_TRUE(Checked(Bytes(5, Constant(floats))).ok());
  EXPECT_TRUE(Checked(Bytes(5, Constant("", Number(1, 0)))).ok());
  EXPECT_TRUE(Checked(Bytes(5, Constant(Raw(48), Number(2, 7)))).ok());
  for (const std::string& constant :
       {Constant(Raw(20)), Constant(Raw(28)), Constant(""), Constant(Bytes(4, "1234")),
        Constant(floats, Raw(20)), Constant(Raw(24), Number(1, 2)), Constant(Raw(24), Number(2, 7)),
        Constant(Raw(24), Bytes(7, "\1\2\3"))}) {
    ExpectRefused(Bytes(5, constant), "\"grain\" does not have the ");
    ExpectRefused(Node("Constant", Bytes(1, "value") + Bytes(5, constant)), "\"grain\"");
  }
  ExpectRefused(Bytes(5, Constant(Raw(24), Number(1, -1))), "size that cannot be");
  ExpectRefused(Bytes(5, Constant(Raw(24), Number(1, std::int64_t{1} << 62))),
                "size that cannot be");
  ExpectRefused(Bytes(5, Constant(Raw(24), Number(2, 8))), "of type 8");
  ExpectRefused(Bytes(5, Constant(Raw(24), "\x09")), "damaged");
}

TEST(OnnxCheckTest, WindowsStepsGroupsAndMarginsAreSizes) {
  EXPECT_TRUE(Checked(Node("Conv", Sizes("strides", {1, 2}))).ok());
  EXPECT_TRUE(Checked(Node("Conv", Sizes("pads", {0, 3, 0, 3}))).ok());
  EXPECT_TRUE(Checked(Node("Pad", Sizes("pads", {0, -3, 0, 3}))).ok());
  EXPECT_TRUE(Checked(Node("Concat", Bytes(1, "axis") + Number(3, -1))).ok());
  for (const char* name : {"kernel_shape", "strides", "dilations"}) {
    for (const std::int64_t size : {0, -1, 1 << 20})
      ExpectRefused(Node("Conv", Sizes(name, {1, size})),
                    "\"" + std::string(name) + "\" of a node \"Conv\" is " + std::to_string(size));
  }
  ExpectRefused(Node("Conv", Sizes("pads", {0, -3, 0, 3})), "-3; legal are 0 to 65536");
  ExpectRefused(Node("Conv", Bytes(1, "group") + Number(3, 0)), "0; legal are 1 to 65536");
}

TEST(OnnxCheckTest, NodesTakeWhatIsThereBeforeThem) {
  const std::string before = Bytes(11, Bytes(1, "in")) + Bytes(5, Constant(Raw(24)));
  const auto node = [](const std::vector<std::string>& inputs, const std::string& output) {
    std::string fields = Bytes(4, "Conv") + Bytes(2, output);
    for (const std::string& input : inputs) fields += Bytes(1, input);
    return Bytes(1, fields);
  };
  const std::string first = node({"in", "grain"}, "a");
  EXPECT_TRUE(Checked(before + first + node({"a", "grain", ""}, "b")).ok());
  ExpectRefused(before + node({"in", "gram"}, "a"), "takes \"gram\"");
  ExpectRefused(before + node({"b", "grain"}, "a") + node({"a", "grain"}, "b"), "takes \"b\"");
  ExpectRefused(before + node({"in"}, "a"), "has 1 inputs; legal are 2 or more");
  ExpectRefused(before + node({"in", ""}, "a"), "has 1 inputs");
  ExpectRefused(before + first + first, "makes \"a\", which is there already");
}

TEST(OnnxCheckTest, AFileIsOneNetwork) {
  const std::string graph = Bytes(7, Bytes(5, Constant(Raw(24))));
  EXPECT_TRUE(internal::CheckOnnxNetwork(graph).ok());
  for (const std::string& file : {std::string(), graph + graph, graph.substr(0, graph.size() - 1)})
    EXPECT_EQ(internal::CheckOnnxNetwork(file).code(), StatusCode::kInvalidArgument);
}

// Tests run side by side, each in a process of its own.
std::string TempFile(const std::string& name) {
  return ::testing::TempDir() + "/latticeworld_" + std::to_string(getpid()) + "_" + name;
}

// What became of damaged files.
struct Outcomes {
  int refused = 0, failed = 0, ran = 0;
};

// Loads the file with some of its first bytes changed, once for each seed, and runs what can be
// run.
Outcomes RunDamaged(const std::string& path, int seeds, int most_changes, std::size_t first) {
  const std::string whole = ReadFile(path, 16 << 20).value();
  const int last = static_cast<int>(std::min(first, whole.size())) - 1;
  const std::string file = TempFile("damaged.onnx");
  Outcomes outcomes;
  for (int seed = 0; seed < seeds; ++seed) {
    RandomStream random(seed, "damage");
    std::string damaged = whole;
    const int changes = random.UniformInt(1, most_changes);
    for (int i = 0; i < changes; ++i)
      damaged[random.UniformInt(0, last)] = static_cast<char>(random.UniformInt(0, 255));
    std::ofstream(file, std::ios::binary) << damaged;
    const Result<SketchModel> model = SketchModel::Load(file);
    if (!model.ok()) {
      EXPECT_EQ(model.status().code(), StatusCode::kInvalidArgument) << model.status().ToString();
      ++outcomes.refused;
      continue;
    }
    Sketch sketch(model->side(), model->side(), Stroke::kNone);
    for (int i = 0; i < sketch.rows(); ++i) {
      sketch(i, i) = Stroke::kRidge;
      sketch(i, sketch.cols() / 2) = Stroke::kValley;
    }
    const Result<Grid<float>> height = model->Run(sketch);
    if (!height.ok()) {
      EXPECT_EQ(height.status().code(), StatusCode::kInternal) << height.status().ToString();
      ++outcomes.failed;
      continue;
    }
    ++outcomes.ran;
    EXPECT_EQ(height->rows(), model->side());
    EXPECT_TRUE(
        std::all_of(height->begin(), height->end(), [](float h) { return std::isfinite(h); }))
        << "seed " << seed;
  }
  std::filesystem::remove(file);
  return outcomes;
}

constexpr std::size_t kAnywhere = std::size_t{1} << 30;

TEST(DamagedSketchModelTest, WithAnyBytesChangedIsRefusedFailsOrGivesHeights) {
  const Outcomes outcomes = RunDamaged(LATTICEWORLD_SKETCH_MODELS "/unet.onnx", 300, 8, kAnywhere);
  EXPECT_GT(outcomes.refused, 50);
  EXPECT_GT(outcomes.ran, 50);
}

TEST(DamagedSketchModelTest, WithNodesChangedIsRefusedFailsOrGivesHeights) {
  // Nodes come first in the file, then constants.
  const Outcomes outcomes = RunDamaged(LATTICEWORLD_SKETCH_MODELS "/unet.onnx", 1500, 3, 560);
  EXPECT_GT(outcomes.refused, 500);
  EXPECT_GT(outcomes.ran, 50);
}

TEST(DamagedSketchModelTest, TheShippedOneToo) {
  const Outcomes outcomes = RunDamaged(LATTICEWORLD_SHIPPED_SKETCH_MODEL, 20, 1000, kAnywhere);
  EXPECT_GT(outcomes.refused + outcomes.failed, 0);
  EXPECT_GT(outcomes.ran + outcomes.failed, 0);
}

TEST(DamagedSketchModelTest, AConvolutionWithoutItsWeightsIsRefused) {
  std::string network = ReadFile(LATTICEWORLD_SKETCH_MODELS "/unet.onnx", 16 << 20).value();
  // Each name is there first where a node takes it.
  for (const std::string name : {"first", "first_bias"}) network[network.find(name)] = '?';
  const std::string file = TempFile("no_weights.onnx");
  ASSERT_TRUE(WriteFile(file, network).ok());
  const Status status = SketchModel::Load(file).status();
  std::filesystem::remove(file);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_NE(status.message().find("takes \"?irst\", which nothing before it makes"),
            std::string::npos)
      << status.ToString();
}

}  // namespace
}  // namespace latticeworld
