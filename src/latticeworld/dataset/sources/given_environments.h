#ifndef LATTICEWORLD_DATASET_SOURCES_GIVEN_ENVIRONMENTS_H_
#define LATTICEWORLD_DATASET_SOURCES_GIVEN_ENVIRONMENTS_H_

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/captions/written_annotator.h"
#include "latticeworld/dataset/sources/given_instructions.h"
#include "latticeworld/dataset/sources/instance_source.h"

namespace latticeworld {

// Places of LatticeWorld's own generator, of the vocabulary and without a relief, that the
// instructions (x_C, of environments) are said of; a group an instruction, options.answers
// places each. Errors: those of UsedInstructions.
Result<std::unique_ptr<InstanceSource>> MakeGivenEnvironmentSource(
    std::vector<GivenInstruction> instructions, const std::string& title,
    const GivenInstructionsOptions& options);

// Says of these places what was asked for, with the embedded generator's environment, which has
// every claim that is read in the words (DATA_LOSS otherwise). Writes of layouts as the written
// annotator does with these options, which are valid.
std::unique_ptr<Annotator> MakeGivenEnvironmentAnnotator(std::vector<GivenInstruction> instructions,
                                                         const WrittenOptions& written = {});

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_GIVEN_ENVIRONMENTS_H_
