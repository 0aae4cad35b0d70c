#ifndef LATTICEWORLD_LANGUAGE_GENERATOR_H_
#define LATTICEWORLD_LANGUAGE_GENERATOR_H_

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

inline constexpr std::size_t kMaxInstructionBytes = 16384;

struct LayoutReading;       // reading/instruction_reader.h
struct EnvironmentReading;  //

struct LayoutRequest {
  std::string instruction;  // x_L: UTF-8, at most kMaxInstructionBytes; empty only with a relief
  Vocabulary vocabulary = Vocabulary::kSuburb;
  const Relief* relief = nullptr;  // v_L, or none
  std::uint64_t seed = 0;
  const LayoutReading* reading = nullptr;  // of the instruction, where it has been read; or none
};

// One answer of a language model, as it came: enough to read the same layout or environment from it
// again without the model. Or, at the end of those for a layout or an environment, why none of them
// was used.
struct ModelReply {
  std::string purpose;  // "layout", "environment"; "layout_words", "environment_words": how each
                        // was read
  std::string model;    // as its server names it
  std::string text;
  std::string finish_reason;
  int prompt_tokens = 0;  // 0: not said
  int completion_tokens = 0;
  int retries = 0;
  double seconds = 0.0;
  double log_probability = 0.0;         // of the text, natural; 0: not said
  std::vector<std::string> warnings{};  // of how its server treats what it is asked
  // If this is not OK, there was no reply, and it is what the back end failed of before another one
  // answered. The purpose is "layout" or "environment", and the rest says nothing.
  Status failure{};
};

struct LayoutAnswer {
  SymbolicLayout layout;
  std::vector<std::string> warnings;  // each quotes the words it is about
};

// LLM_L: text (and relief) to the symbolic layout.
class LayoutGenerator {
 public:
  virtual ~LayoutGenerator() = default;
  virtual std::string_view name() const = 0;
  // replies (never null): what a model answered is appended, in order, refused answers too, and
  // also where there is no layout in the end. Errors: INVALID_ARGUMENT, CANCELLED, and what the
  // back end adds (UNAVAILABLE, ...).
  virtual Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress,
                                        std::vector<ModelReply>* replies) = 0;
  // Does the same for callers who do not keep the replies.
  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress) {
    std::vector<ModelReply> replies;
    return Generate(request, progress, &replies);
  }
};

struct EnvironmentRequest {
  std::string instruction;  // x_C: may be empty, then all follows from the layout
  const Relief* relief = nullptr;
  const SymbolicLayout* layout = nullptr;                             // never null
  std::shared_ptr<const Catalogue> catalogue = Catalogue::BuiltIn();  // never null
  double size_m = 512.0;                                              // side of the world
  std::uint64_t seed = 0;
  const EnvironmentReading* reading = nullptr;  // of the instruction, or none
};

struct EnvironmentAnswer {
  EnvironmentConfig environment;  // valid
  std::vector<std::string> warnings;
};

// LLM_C: text (and relief) and layout to the environment configuration.
class EnvironmentGenerator {
 public:
  virtual ~EnvironmentGenerator() = default;
  virtual std::string_view name() const = 0;
  // Generates an environment; replies and errors are those of LayoutGenerator::Generate.
  virtual Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) = 0;
  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request, const Progress& progress) {
    std::vector<ModelReply> replies;
    return Generate(request, progress, &replies);
  }
};

// What is wrong with the words alone, before there is a request that holds them: UTF-8, length, and
// of a layout that there are some unless a relief speaks for them.
Status ValidateLayoutInstruction(std::string_view instruction, bool has_relief);
Status ValidateEnvironmentInstruction(std::string_view instruction);

// The checks that every back end's request passes: its words, and what stands beside them.
Status Validate(const LayoutRequest& request);
Status Validate(const EnvironmentRequest& request);

// The vocabulary that the words speak of: suburb for buildings, roads and fields, wild for rock and
// snow; suburb when nothing tells. A cabin or a church alone, which may stand anywhere, is no
// suburb.
Vocabulary ChooseVocabulary(std::string_view layout_instruction);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GENERATOR_H_
