#ifndef LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_H_
#define LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/scene/props/thing_claims.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

enum class InstructionPart : std::uint8_t { kLayout, kEnvironment };

constexpr std::array<EnumName<InstructionPart>, 2> EnumNames(InstructionPart) {
  return {{{InstructionPart::kLayout, "layout"}, {InstructionPart::kEnvironment, "environment"}}};
}

// One claim of an instruction, measured.
struct ClaimOutcome {
  InstructionPart part = InstructionPart::kLayout;
  std::string kind;   // "present", "course", ... of ClaimKind or EnvironmentClaimKind;
                      // "relief_form", ... of ReliefMeasure
  std::string words;  // of the instruction
  bool satisfied = false;
  double distance = 0.0;    // how far the world is from the claim: 0 when satisfied, up to 1
  std::string explanation;  // "forest covers 41 % of upper left; at least 1.5 % is asked"
};

// How well a world matches the words that it was made from.
struct FidelityReport {
  std::vector<ClaimOutcome> claims;         // in the order of the words, layout first
  std::vector<std::string> not_understood;  // words, as they stand in the instructions
  // What the instructions were read as, sentences of the small language.
  std::vector<std::string> layout_sentences;
  std::vector<std::string> environment_sentences;
  int words = 0;                     // of both instructions, that say something
  int words_read = 0;                // of them
  std::vector<ClaimOutcome> second;  // claims of a second reading of the same words; empty: none

  int satisfied() const;
};

// Measures layout and environment by what was read, whoever made them; places that features of the
// land name ("by the lake") are those of this layout.
FidelityReport AssessFidelity(const LayoutReading& layout_reading,
                              const EnvironmentReading& environment_reading,
                              const SymbolicLayout& layout, const EnvironmentConfig& environment);

// Adds what the layout reading says of the land's form, measured on the finished ground, behind the
// layout's claims.
void AssessReliefFidelity(const LayoutReading& reading, const SymbolicLayout& layout,
                          const Terrain& terrain, FidelityReport* report);

// One claim on an environment, measured.
ClaimOutcome OutcomeOf(const EnvironmentClaim& claim, const EnvironmentConfig& environment);

// The same of a layout alone.
FidelityReport AssessLayoutFidelity(const LayoutReading& reading, const SymbolicLayout& layout);

// Adds the claims of single things, which stand once there is a scene, after those of the layout.
void AddThings(const std::vector<ThingOutcome>& things, FidelityReport* report);

// Reads both instructions first, with what they say of the land's form and of single things, and
// measures these and the things of a request (things_json.h) on the scene. Errors: the reader's.
Result<FidelityReport> ReadAndAssess(InstructionReader* reader, std::string_view layout_instruction,
                                     std::string_view environment_instruction,
                                     std::string_view things, const SymbolicLayout& layout,
                                     const Scene& scene);

// A line a claim that is not satisfied and one for the words that were not understood, leaving out
// what one of the warnings so far quotes already. How two readings differ: reading_difference.h.
std::vector<std::string> WarningsOf(const FidelityReport& report,
                                    const std::vector<std::string>& so_far);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_H_
