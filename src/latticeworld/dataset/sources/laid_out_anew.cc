#include "latticeworld/dataset/sources/laid_out_anew.h"

#include <memory>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

Result<SymbolicLayout> LaidOutAnew(const Instance& instance, const LayoutCaption& caption,
                                   std::uint64_t seed, const Progress& progress) {
  LayoutRequest request;
  request.instruction = caption.text;
  request.vocabulary = instance.layout.vocabulary;
  request.relief = instance.relief.get();
  request.seed = seed;
  const std::unique_ptr<LayoutGenerator> generator = MakeGroundedLayoutGenerator();
  LW_ASSIGN_OR_RETURN(LayoutAnswer answer, generator->Generate(request, progress));
  if (!answer.warnings.empty()) {
    return DataLoss("the embedded generator answers " + Quote(caption.text) + " with " +
                    answer.warnings.front());
  }
  for (const Claim& claim : caption.claims) {
    const ClaimMeasure measure = Measure(claim, answer.layout);
    if (!measure.holds) {
      return DataLoss("the embedded generator's layout for " + Quote(caption.text) +
                      " does not have it: " + measure.explanation);
    }
  }
  return std::move(answer.layout);
}

}  // namespace latticeworld
