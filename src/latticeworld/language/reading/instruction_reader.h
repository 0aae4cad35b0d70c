#ifndef LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_
#define LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/reading/coverage.h"

namespace latticeworld {

// ReadingPart is what may count of one of two readings while the rest counts of the other.
enum class ReadingPart : std::uint8_t {
  kLand,    // the whole of a layout
  kCoarse,  // season, weather, time of day, style and kind of terrain
  kFine,    // densities, variants and parameters of assets
  kAgents,
};

constexpr std::array<EnumName<ReadingPart>, 4> EnumNames(ReadingPart) {
  return {{{ReadingPart::kLand, "land"},
           {ReadingPart::kCoarse, "coarse"},
           {ReadingPart::kFine, "fine"},
           {ReadingPart::kAgents, "agents"}}};
}

// ReadingEvidence is what two readings of one text, a model's and a second one, tell about which of
// them is right in a part (reading_evidence.h).
struct ReadingEvidence {
  ReadingPart part = ReadingPart::kLand;
  double log_probability = 0.0;  // of the model, as in LayoutReading: untold counts as sure
  int words = 0;                 // of the text, as in TextCoverage
  int carried = 0, second_carried = 0;
  int lost = 0, second_lost = 0;
  int claims = 0, second_claims = 0;  // sentences that say the claims of the part
  int agreed = 0;                     // of them, those of both
};

// LayoutReading is what a reader has read in a layout instruction. A text is read once in a
// request: the generator that draws the layout and the fidelity report use the same reading.
struct LayoutReading {
  std::vector<std::string> sentences;  // of the small language
  bool of_sentences = false;  // the plan was made of them; false: they say what rules have read
  LayoutPlan plan;            // with its claims, its warnings and what was not understood
  TextCoverage coverage;
  // The mean natural logarithm of the probability of a token of the sentences, where a model said
  // them and its server tells it; else 0.
  double log_probability = 0.0;
  std::vector<Claim> second;  // claims of a second reading of the same text; empty: there is none
  std::vector<ReadingEvidence> evidence;  // of each part, where there are two readings
};

// EnvironmentReading is what a reader has read in an environment instruction. The claims that
// follow from it depend on the layout that the instruction speaks of: ClaimsOf (claims_of_heard.h)
// makes them.
struct EnvironmentReading {
  std::vector<std::string> sentences;
  HeardEnvironment heard;
  TextCoverage coverage;
  double log_probability = 0.0;
  std::optional<HeardEnvironment> second;
  std::vector<ReadingEvidence> evidence;  // as in LayoutReading
};

// A model that reads gives its replies (ModelReply) these purposes.
inline constexpr std::string_view kLayoutWords = "layout_words";
inline constexpr std::string_view kEnvironmentWords = "environment_words";

// InstructionReader reads instructions: it makes a plan of a text.
class InstructionReader {
 public:
  virtual ~InstructionReader() = default;
  virtual std::string_view name() const = 0;
  // Whether it reads only those sentences of free text that are of the kind that is asked for
  // (words/subjects.h).
  virtual bool reads_by_kind() const { return false; }
  // Reads the request's instruction. What a model answered on the way is appended to *replies, in
  // order; `replies` is never null. Errors: CANCELLED, and those that the reader adds (UNAVAILABLE,
  // ...).
  virtual Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                           std::vector<ModelReply>* replies) = 0;
  virtual Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                                     const Progress& progress,
                                                     std::vector<ModelReply>* replies) = 0;
};

// Makes the reader of texts that are the small language already (sentences/sentence.h). Whatever
// else stands in a text is not understood. It uses no model and takes some microseconds a sentence.
std::unique_ptr<InstructionReader> MakeControlledReader();

// Makes the reader that applies the rules of grounded/reading and grounded/environment to free
// text.
std::unique_ptr<InstructionReader> MakeRuleReader();

// Makes a reader that lets `first` read. Where `first` fails of anything but CANCELLED, `second`
// reads: its reading gets a first warning that says why, and the failure is recorded after the
// replies of `first`. name() is that of `first`.
std::shared_ptr<InstructionReader> MakeFallbackReader(std::shared_ptr<InstructionReader> first,
                                                      std::shared_ptr<InstructionReader> second);

// Makes the same reader, but that `second` reads only what is too long for `first`
// (RESOURCE_EXHAUSTED); other failures of `first` are its own.
std::shared_ptr<InstructionReader> MakeLongTextReader(std::shared_ptr<InstructionReader> first,
                                                      std::shared_ptr<InstructionReader> second);

// Makes a reader that fails as another one did. It gives that reader's replies, those of layouts
// and those of environments, of which the last is the record of the failure. Where there are no
// replies `reader` reads.
std::shared_ptr<InstructionReader> MakeFailedReader(std::shared_ptr<InstructionReader> reader,
                                                    std::vector<ModelReply> layout,
                                                    std::vector<ModelReply> environment);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_
