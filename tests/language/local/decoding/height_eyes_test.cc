#include "latticeworld/language/local/decoding/height_eyes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "language/local/tiny_eyes.h"
#include "language/local/tiny_model.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/local/decoding/area_means.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/relief_picture.h"

namespace latticeworld {
namespace {

const Progress kProgress;

// Rising to the east, with some roughness.
Grid<float> Land(int side, std::uint64_t seed, float per_sample_m = 1.0f) {
  RandomStream random(seed, "land");
  Grid<float> heights(side, side);
  for (int r = 0; r < side; ++r)
    for (int c = 0; c < side; ++c)
      heights(r, c) =
          per_sample_m * static_cast<float>(c) + static_cast<float>(random.Uniform(0, 3));
  return heights;
}

Result<HeightEyes> OpenEyes(const TinyEyes& tiny) {
  const ModelFile file(TinyEyesGguf(tiny));
  return HeightEyes::Open(file.path());
}

TEST(AreaMeansTest, KeepTheMeanAndTheSlopeOfAnyPicture) {
  for (const int samples : {33, 64, 100, 511}) {
    Grid<float> ramp(samples, samples);
    for (int r = 0; r < samples; ++r)
      for (int c = 0; c < samples; ++c) ramp(r, c) = static_cast<float>(c) + 0.5f;
    const std::vector<float> means = AreaMeans(ramp, 16);
    ASSERT_EQ(means.size(), 256u);
    for (std::size_t i = 0; i < means.size(); ++i)
      // A sample is flat, so that a cell's mean is off its middle by a fraction of a sample.
      EXPECT_NEAR(means[i], (static_cast<double>(i % 16) + 0.5) * samples / 16, 0.3);
    EXPECT_NEAR(std::accumulate(means.begin(), means.end(), 0.0) / 256, samples / 2.0, 1e-3);
  }
}

TEST(AreaMeansTest, OfAsManySamplesAreThemselves) {
  const Grid<float> land = Land(20, 1);
  EXPECT_EQ(AreaMeans(land, 20), std::vector<float>(land.begin(), land.end()));
}

class HeightEyesTest : public testing::TestWithParam<std::uint32_t> {};

TEST_P(HeightEyesTest, SeeTheShapeOfTheLandWhateverItsScale) {
  TinyEyes tiny;
  tiny.weight_type = GetParam();
  tiny.patch = 8;  // rows of q8_0 are multiples of 32
  const auto eyes = OpenEyes(tiny);
  ASSERT_TRUE(eyes.ok()) << eyes.status().ToString();
  EXPECT_EQ(eyes->places(), 1u);
  EXPECT_EQ(eyes->embedding(), 64u);
  Grid<float> land = Land(64, 1);
  const std::vector<float> seen = eyes->See(land);
  ASSERT_EQ(seen.size(), 64u);
  for (float& height : land) height = 100.0f + 7.0f * height;
  const std::vector<float> scaled = eyes->See(land);
  double difference = 0.0, other = 0.0;
  const std::vector<float> turned = eyes->See(Land(64, 1, -1.0f));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    ASSERT_TRUE(std::isfinite(seen[i]));
    difference = std::max(difference, std::abs(double{seen[i]} - scaled[i]));
    other = std::max(other, std::abs(double{seen[i]} - turned[i]));
  }
  EXPECT_LT(difference, 0.02 * other);
  for (const float value : eyes->See(Grid<float>(64, 64, 5.0f))) EXPECT_TRUE(std::isfinite(value));
}

INSTANTIATE_TEST_SUITE_P(Types, HeightEyesTest, testing::Values(0u, 1u, 8u));

TEST(HeightEyesFileTest, NamesEachKeyAndTensorThatIsMissing) {
  for (const char* name : {"eyes.side", "eyes.heads", "eyes.embedding", "eyes.patches.weight",
                           "eyes.whole.weight", "eyes.places.weight", "blk.1.up.bias",
                           "blk.0.queries_keys_values.weight", "projection.near.weight"}) {
    TinyEyes tiny;
    tiny.without = {name};
    const Status status = OpenEyes(tiny).status();
    EXPECT_EQ(status.code(), StatusCode::kDataLoss);
    EXPECT_NE(status.message().find(name), std::string::npos) << status.ToString();
  }
}

TEST(HeightEyesFileTest, RefusesSizesThatDoNotGoTogether) {
  TinyEyes odd;
  odd.side = 12;  // three patches a side
  TinyEyes uneven;
  uneven.heads = 5;
  for (const TinyEyes& tiny : {odd, uneven})
    EXPECT_EQ(OpenEyes(tiny).status().code(), StatusCode::kDataLoss);
  const ModelFile language_model(TinyGguf({}));
  EXPECT_NE(HeightEyes::Open(language_model.path()).status().message().find("'llama'"),
            std::string::npos);
}

TEST(HeightEyesFileTest, ReadsOrRefusesAFileWithAnyBytesChanged) {
  TinyEyes tiny;
  tiny.layers = 1;
  const std::string whole = TinyEyesGguf(tiny);
  RandomStream random(4, "damage");
  const int head = 1800;  // keys, names, shapes and offsets
  int refused = 0;
  for (int i = 0; i < 600; ++i) {
    std::string damaged = whole;
    const int changes = random.UniformInt(1, 4);
    for (int k = 0; k < changes; ++k)
      damaged[static_cast<std::size_t>(random.UniformInt(0, head))] =
          static_cast<char>(random.UniformInt(0, 255));
    const ModelFile file(damaged);
    const auto eyes = HeightEyes::Open(file.path());
    refused += eyes.ok() ? 0 : 1;
    if (eyes.ok()) {
      EXPECT_EQ(eyes->See(Land(33, 1)).size(), eyes->places() * eyes->embedding());
    } else {
      EXPECT_EQ(eyes.status().code(), StatusCode::kDataLoss) << eyes.status().ToString();
    }
  }
  EXPECT_GT(refused, 100);
}

// A model with eyes beside it.
class SeeingModel {
 public:
  explicit SeeingModel(const TinyEyes& eyes) : file_(Model()) {
    std::ofstream(EyesPath(), std::ios::binary) << TinyEyesGguf(eyes);
  }
  const std::string& path() const { return file_.path(); }
  std::string EyesPath() const {
    return std::filesystem::path(file_.path()).replace_extension(".eyes.gguf");
  }

 private:
  static std::string Model() {
    TinyModel tiny;
    tiny.sees = true;
    tiny.guidance = 2.0f;
    return TinyGguf(tiny);
  }
  ModelFile file_;
};

ChatRequest Request(const std::string& picture) {
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "a lake", picture}};
  request.form = LayoutForm(Vocabulary::kWild);
  request.max_tokens = 200;
  request.seed = 3;
  return request;
}

TEST(SeeingServerTest, AnswersByWhatItIsShown) {
  const SeeingModel model(TinyEyes{});
  const auto server = MakeLocalChatServer(model.path());
  ASSERT_TRUE(server.ok()) << server.status().ToString();
  EXPECT_TRUE((*server)->sees());
  const std::string east = *ReliefPicture(Land(64, 1)), west = *ReliefPicture(Land(64, 1, -1.0f));
  const auto answer = [&](const std::string& picture) {
    const auto reply = (*server)->Complete(Request(picture), {}, kProgress);
    EXPECT_TRUE(reply.ok()) << reply.status().ToString();
    return reply.ok() ? reply->text : "";
  };
  const std::string to_east = answer(east);
  EXPECT_NE(answer(west), to_east);
  EXPECT_NE(answer(""), to_east);
  EXPECT_EQ(answer(east), to_east);
}

TEST(SeeingServerTest, ACancelledLookLeavesTheNextAsItWouldBe) {
  const SeeingModel model(TinyEyes{});
  const auto server = MakeLocalChatServer(model.path());
  ASSERT_TRUE(server.ok());
  const ChatRequest request = Request(*ReliefPicture(Land(64, 1)));
  Progress progress;
  const auto cancelled = (*server)->Complete(
      request,
      [&](std::string_view text) {
        if (text.size() > 20) progress.Cancel();
        return true;
      },
      progress);
  EXPECT_EQ(cancelled.status().code(), StatusCode::kCancelled);
  const auto fresh = MakeLocalChatServer(model.path());
  EXPECT_EQ((*server)->Complete(request, {}, kProgress)->text,
            (*fresh)->Complete(request, {}, kProgress)->text);
}

TEST(SeeingServerTest, RefusesWhatIsNoHeightMap) {
  const SeeingModel model(TinyEyes{});
  const auto server = MakeLocalChatServer(model.path());
  ASSERT_TRUE(server.ok());
  const std::string picture = *ReliefPicture(Land(64, 1));
  for (const std::string& damaged : {std::string("png"), picture.substr(0, picture.size() / 2)})
    EXPECT_EQ((*server)->Complete(Request(damaged), {}, kProgress).status().code(),
              StatusCode::kInvalidArgument);
}

TEST(SeeingServerTest, WantsItsEyes) {
  const SeeingModel model(TinyEyes{});
  std::filesystem::remove(model.EyesPath());
  const Status missing = MakeLocalChatServer(model.path()).status();
  EXPECT_EQ(missing.code(), StatusCode::kNotFound);
  EXPECT_NE(missing.message().find("model.eyes.gguf"), std::string::npos) << missing.ToString();
  TinyEyes wide;
  wide.embedding = 96;
  const SeeingModel other(wide);
  const Status apart = MakeLocalChatServer(other.path()).status();
  EXPECT_EQ(apart.code(), StatusCode::kDataLoss);
  EXPECT_NE(apart.message().find("96"), std::string::npos) << apart.ToString();
}

}  // namespace
}  // namespace latticeworld
