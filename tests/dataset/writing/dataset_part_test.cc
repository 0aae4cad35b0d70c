#include "latticeworld/dataset/writing/dataset_part.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

DatasetPart SomePart() {
  DatasetPart part;
  part.lines[0][0] = "{\"id\":\"a\"}\n{\"id\":\"b\"}\n";
  part.lines[2][1] = "{\"id\":\"\\u00e9\"}\n";
  part.image_sums = "00  images/000000/a.png\n";
  part.tallies = {{"relief", 1}, {"records/layout/train", 2}};
  part.failed = {{"c", "", "DATA_LOSS: broken \"file\"\n\xff"}};
  return part;
}

TEST(DatasetPartTest, ComesBackAsItWas) {
  const DatasetPart part = SomePart();
  const auto back = DecodePart(EncodePart(part), "it");
  ASSERT_TRUE(back.ok()) << back.status().ToString();
  EXPECT_EQ(back->lines, part.lines);
  EXPECT_EQ(back->image_sums, part.image_sums);
  EXPECT_EQ(back->tallies, part.tallies);
  ASSERT_EQ(back->failed.size(), 1u);
  EXPECT_EQ(back->failed[0].group, "c");
}

TEST(DatasetPartTest, NothingTruncatedOrChangedCounts) {
  const std::string bytes = EncodePart(SomePart());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_EQ(DecodePart(bytes.substr(0, size), "it").status().code(), StatusCode::kDataLoss);
  for (std::size_t i = bytes.find('\n') + 1; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] ^= 1;
    ASSERT_EQ(DecodePart(changed, "it").status().code(), StatusCode::kDataLoss) << i;
  }
  EXPECT_EQ(DecodePart(bytes + "\n", "it").status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(DecodePart("{\"sizes\":[1,2]}\n", "it").status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(DecodePart("[]\n", "it").status().code(), StatusCode::kDataLoss);
}

TEST(DatasetPartTest, CountsAreWholeNumbers) {
  for (const char* counts : {"-1", "1e300", "2.5", "\"2\"", "null", "[]"}) {
    std::string bytes = EncodePart(SomePart());
    const std::size_t relief = bytes.find("\"relief\":1");
    ASSERT_NE(relief, std::string::npos);
    bytes.replace(relief, 10, std::string("\"relief\":") + counts);
    EXPECT_EQ(DecodePart(bytes, "it").status().code(), StatusCode::kDataLoss) << counts;
    bytes = EncodePart(SomePart());
    const std::size_t sizes = bytes.find("\"sizes\":[") + 9;
    bytes.replace(sizes, bytes.find(',', sizes) - sizes, counts);
    EXPECT_EQ(DecodePart(bytes, "it").status().code(), StatusCode::kDataLoss) << counts;
  }
}

}  // namespace
}  // namespace latticeworld
