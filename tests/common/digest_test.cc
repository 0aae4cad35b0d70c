#include "latticeworld/common/digest.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

// Test vectors of FIPS 180-4.
TEST(DigestTest, AgreesWithPublishedVectors) {
  EXPECT_EQ(Sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(Sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(DigestTest, TextsDoNotRunTogether) {
  Digest first;
  first.AddText("ab");
  first.AddText("c");
  Digest second;
  second.AddText("a");
  second.AddText("bc");
  EXPECT_NE(first.Hex(), second.Hex());
}

}  // namespace
}  // namespace latticeworld
