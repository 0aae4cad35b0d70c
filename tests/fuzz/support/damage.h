#ifndef LATTICEWORLD_TESTS_FUZZ_SUPPORT_DAMAGE_H_
#define LATTICEWORLD_TESTS_FUZZ_SUPPORT_DAMAGE_H_

#include <cstdint>
#include <string>
#include <vector>

namespace latticeworld::fuzz {

// Damages an input as files and messages come damaged: bits and bytes turned, numbers grown, parts
// cut out, doubled, moved and taken from another input, the end cut off. One to four damages, drawn
// from `seed`; the same arguments give the same bytes. others: inputs to take parts from,
// at least one.
std::string Damaged(const std::string& input, const std::vector<std::string>& others,
                    std::uint64_t seed);

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_SUPPORT_DAMAGE_H_
