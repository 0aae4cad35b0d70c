#ifndef LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_
#define LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/reading/coverage.h"

namespace latticeworld {

// What was read in a layout instruction. A text is read once in a request: who draws the layout and
// the fidelity report use the same reading.
struct LayoutReading {
  std::vector<std::string> sentences;  // of the small language
  bool of_sentences = false;  // the plan was made of them; false: they say what rules have read
  LayoutPlan plan;            // with its claims, its warnings and what was not understood
  TextCoverage coverage;
  // Of a token of the sentences, in the mean, natural, where a model said them and tells it; 0:
  // none.
  double log_probability = 0.0;
  std::vector<Claim> second;  // claims of a second reading of the same text; empty: there is none
};

// What was read in an environment instruction. Claims of it depend on the layout that it speaks of:
// ClaimsOf (claims_of_heard.h).
struct EnvironmentReading {
  std::vector<std::string> sentences;
  HeardEnvironment heard;
  TextCoverage coverage;
  double log_probability = 0.0;
  std::optional<HeardEnvironment> second;
};

// The purposes of the replies of a model that reads (ModelReply).
inline constexpr std::string_view kLayoutWords = "layout_words";
inline constexpr std::string_view kEnvironmentWords = "environment_words";

// Reads instructions: text to plan.
class InstructionReader {
 public:
  virtual ~InstructionReader() = default;
  virtual std::string_view name() const = 0;
  // replies (never null): what a model answered is appended, in order. Errors: CANCELLED, and what
  // the reader adds (UNAVAILABLE, ...).
  virtual Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                           std::vector<ModelReply>* replies) = 0;
  virtual Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                                     const Progress& progress,
                                                     std::vector<ModelReply>* replies) = 0;
};

// The text already is the small language (sentences/sentence.h); what is not is not understood. No
// model, some microseconds a sentence.
std::unique_ptr<InstructionReader> MakeControlledReader();

// The rules of grounded/reading and grounded/environment over free text.
std::unique_ptr<InstructionReader> MakeRuleReader();

// Lets the first read; whatever it fails of, but CANCELLED, the second reads, with a first warning
// that says why, and the failure is recorded after the first one's replies. name(): the first's.
std::shared_ptr<InstructionReader> MakeFallbackReader(std::shared_ptr<InstructionReader> first,
                                                      std::shared_ptr<InstructionReader> second);

// A reader that fails as another one did: its replies, of which the last is the record of the
// failure, are those of layouts and of environments. Where there are none `reader` reads.
std::shared_ptr<InstructionReader> MakeFailedReader(std::shared_ptr<InstructionReader> reader,
                                                    std::vector<ModelReply> layout,
                                                    std::vector<ModelReply> environment);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_
