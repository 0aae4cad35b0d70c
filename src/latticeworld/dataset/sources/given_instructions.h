#ifndef LATTICEWORLD_DATASET_SOURCES_GIVEN_INSTRUCTIONS_H_
#define LATTICEWORLD_DATASET_SOURCES_GIVEN_INSTRUCTIONS_H_

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/sources/instance_source.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// What somebody asked for.
struct GivenInstruction {
  std::string id;  // unique; letters, digits, '_' and '-'
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::string words;  // x_L, or x_C where environments are asked for
};

// Reads a JSON array of objects with "id", "vocabulary" and "instruction"; other members, as those
// of a fidelity benchmark, are passed over. Errors: NOT_FOUND, PERMISSION_DENIED; INVALID_ARGUMENT
// naming the file, every bad entry and what is wrong with it.
Result<std::vector<GivenInstruction>> ReadGivenInstructions(const std::filesystem::path& file);

struct GivenInstructionsOptions {
  int answers = 8;    // [1, 1000] different ones of the embedded generator for each
  int leave_out = 0;  // [0, 1000]: every so many instructions, from the first on, are not used, so
                      // that they can judge what is trained; 0: all are
  std::uint64_t seed = 0;
};
std::vector<Violation> Validate(const GivenInstructionsOptions& options);

// Those that are not left out. Errors: INVALID_ARGUMENT (options; no instruction is left).
Result<std::vector<GivenInstruction>> UsedInstructions(std::vector<GivenInstruction> instructions,
                                                       const GivenInstructionsOptions& options);

// Places that the embedded generator lays out for the instructions, a group an instruction. A
// layout without every claim that is read in the words is left out. Errors: those of
// UsedInstructions.
Result<std::unique_ptr<InstanceSource>> MakeGivenSource(std::vector<GivenInstruction> instructions,
                                                        const std::string& title,
                                                        const GivenInstructionsOptions& options);

// Says of these places what was asked for, and writes environments as the written annotator does.
std::unique_ptr<Annotator> MakeGivenAnnotator(std::vector<GivenInstruction> instructions,
                                              double size_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_GIVEN_INSTRUCTIONS_H_
