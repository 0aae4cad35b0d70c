#ifndef LATTICEWORLD_TESTS_FUZZ_SEEDS_SEEDS_H_
#define LATTICEWORLD_TESTS_FUZZ_SEEDS_SEEDS_H_

#include <functional>
#include <string>

namespace latticeworld::fuzz {

// Takes a seed: the target that it is for, the name of its file, its bytes.
using TakeSeed = std::function<void(const std::string& target, const std::string& name,
                                    const std::string& bytes)>;

// Legal inputs, made by the writers of the project itself and of its tests.
void LanguageSeeds(const TakeSeed& take);  // layouts, environments, sentences, grammars, models
void ReliefSeeds(const TakeSeed& take);    // pictures, elevation, networks
void WorldSeeds(const TakeSeed& take);     // bundles, journals, campaigns
void RosSeeds(const TakeSeed& take);       // serialized messages, bags

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_SEEDS_SEEDS_H_
