// world.json of a bundle. Its own digest is mended first, for no random change would get past it.

#include "fuzz/fuzz_target.h"
#include "latticeworld/common/digest.h"
#include "latticeworld/generation/bundle/manifest.h"

using latticeworld::DecodeManifest;
using latticeworld::fuzz::Expect;

namespace {

std::string WithDigest(std::string_view content) {
  constexpr std::string_view kKey = "\"manifest_sha256\": \"";
  constexpr std::size_t kDigits = 64;
  std::string mended(content);
  const std::size_t key = mended.rfind(kKey);
  if (key == std::string::npos || mended.size() - key < kKey.size() + kDigits) return mended;
  mended.replace(key + kKey.size(), kDigits, std::string(kDigits, '0'));
  return mended.replace(key + kKey.size(), kDigits, latticeworld::Sha256Hex(mended));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto manifest = DecodeManifest(WithDigest(latticeworld::fuzz::TextOf(data, size)));
  if (!manifest.ok()) return 0;
  const std::string text = EncodeManifest(*manifest);
  const auto again = DecodeManifest(text);
  Expect(again.ok() && EncodeManifest(*again) == text, "a manifest is written as it was read");
  return 0;
}
