// Claims of layouts in either vocabulary, and of environments, as JSON.

#include "fuzz/fuzz_target.h"
#include "latticeworld/environment/environment_claims_json.h"
#include "latticeworld/layout/claims/claims_json.h"

using latticeworld::DecodeClaims;
using latticeworld::Vocabulary;
using latticeworld::fuzz::Expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text = latticeworld::fuzz::TextOf(data, size);
  const std::size_t choice = latticeworld::fuzz::TakeChoice(&text, 3);
  if (choice == 2) {
    (void)latticeworld::ParseEnvironmentClaims(text);
    return 0;
  }
  const Vocabulary vocabulary = choice == 0 ? Vocabulary::kSuburb : Vocabulary::kWild;
  const auto claims = DecodeClaims(text, vocabulary);
  if (!claims.ok()) return 0;
  const std::string encoded = EncodeClaims(*claims);
  const auto again = DecodeClaims(encoded, vocabulary);
  Expect(again.ok() && EncodeClaims(*again) == encoded, "claims are written as they were read");
  return 0;
}
