#ifndef LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_
#define LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// What was read in a layout instruction. A text is read once in a request: who draws the layout and
// the fidelity report use the same reading.
struct LayoutReading {
  std::vector<std::string> sentences;  // of the small language; empty where rules read the text
  LayoutPlan plan;                     // with its claims, its warnings and what was not understood
};

// What was read in an environment instruction. Claims of it depend on the layout that it speaks of:
// ClaimsOf (claims_of_heard.h).
struct EnvironmentReading {
  std::vector<std::string> sentences;
  HeardEnvironment heard;
};

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

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_INSTRUCTION_READER_H_
