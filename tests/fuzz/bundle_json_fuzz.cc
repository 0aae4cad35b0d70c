// The text files of a world's bundle, each as the letter before it says. The world is a small one.

#include "fuzz/fuzz_target.h"
#include "latticeworld/generation/bundle/agents_json.h"
#include "latticeworld/generation/bundle/assets_csv.h"
#include "latticeworld/generation/bundle/bridges_json.h"
#include "latticeworld/generation/bundle/catalogue_json.h"
#include "latticeworld/generation/bundle/props_json.h"
#include "latticeworld/generation/bundle/replies_json.h"
#include "latticeworld/generation/bundle/things_json.h"
#include "latticeworld/generation/fidelity/fidelity_json.h"

namespace {

using namespace latticeworld;
using fuzz::Expect;

// What is read is written as it was read. encode: gives a text; decode: a Result.
template <typename Decode, typename Encode>
void CheckRoundTrip(std::string_view content, const Decode& decode, const Encode& encode) {
  const auto value = decode(content);
  if (!value.ok()) return;
  const std::string text = encode(*value);
  const auto again = decode(text);
  Expect(again.ok() && encode(*again) == text, "a bundle's file is written as it was read");
}

void ReadAssets(std::string_view content, const GridGeometry& geometry) {
  const auto catalogue = Catalogue::BuiltIn();
  const auto assets = DecodeAssets(content, geometry, *catalogue);
  if (!assets.ok()) return;
  const auto text = EncodeAssets(*assets, *catalogue);
  Expect(text.ok() && DecodeAssets(*text, geometry, *catalogue).ok(),
         "assets that were read can be written and read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view content = fuzz::TextOf(data, size);
  const std::size_t choice = fuzz::TakeChoice(&content, 9);
  static const GridGeometry geometry = *GridGeometry::Create(64.0, 1.0);
  switch (choice) {
    case 0:
      CheckRoundTrip(
          content, [](std::string_view text) { return DecodeAgents(text, geometry); },
          EncodeAgents);
      break;
    case 1:
      ReadAssets(content, geometry);
      break;
    case 2:
      CheckRoundTrip(
          content, [](std::string_view text) { return DecodeBridges(text, geometry); },
          EncodeBridges);
      break;
    case 3:
      (void)DecodeCatalogue(content);
      break;
    case 4:
      CheckRoundTrip(
          content, [](std::string_view text) { return DecodeProps(text, geometry, {}); },
          EncodeProps);
      break;
    case 5:
      CheckRoundTrip(content, DecodeReplies, EncodeReplies);
      break;
    case 6:
      CheckRoundTrip(
          content, [](std::string_view text) { return DecodeThings(text, geometry, 1000); },
          EncodeThings);
      break;
    case 7:
      (void)ParseThings(content, *Catalogue::BuiltIn(), Vocabulary::kSuburb);
      break;
    default:
      CheckRoundTrip(content, DecodeFidelity, EncodeFidelity);
  }
  return 0;
}
