#ifndef LATTICEWORLD_DATASET_SOURCES_GENERATED_SOURCE_H_
#define LATTICEWORLD_DATASET_SOURCES_GENERATED_SOURCE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/dataset/sources/instance_source.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

struct GeneratedSourceOptions {
  std::size_t groups = 1000;  // [1, 10^7], one instance each
  std::uint64_t seed = 0;
  double relief_share = 0.5;  // [0, 1] of the places have a relief, 129 x 129 samples
};
std::vector<Violation> Validate(const GeneratedSourceOptions& options);

// One generated place, and what is known of it.
struct GeneratedPlace {
  Instance instance;
  std::vector<Claim> claims;  // of the plan that it was made by, those that the layout satisfies
};
// Depends on the seed and the index alone. index: any.
GeneratedPlace GeneratePlace(const GeneratedSourceOptions& options, std::size_t index);

// Makes a source of as many places as wanted: a random plan, laid out by the grounded synthesis
// without its search for claims, which would take most of the time and make places alike. Both
// vocabularies in equal parts; about relief_share of the places on procedural or fractal land of 3
// to 1500 m. Errors: INVALID_ARGUMENT (options).
Result<std::unique_ptr<InstanceSource>> MakeGeneratedSource(const GeneratedSourceOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_GENERATED_SOURCE_H_
