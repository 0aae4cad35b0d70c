#ifndef LATTICEWORLD_EPISODE_JOURNAL_JSON_H_
#define LATTICEWORLD_EPISODE_JOURNAL_JSON_H_

#include <string>
#include <string_view>

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/journal.h"

namespace latticeworld {

// A call as one line of JSON, exact: what is decoded has the same bits in every number. "call" says
// which it is: {"call": "command", "agent": "robot", "linear_mps": [1.0, 0.0, 0.0], ...}. NaN is
// null, and so is what was not given.
std::string EncodeCall(const JournalCall& call);
// Errors: DATA_LOSS saying what is wrong in it.
Result<JournalCall> DecodeCall(std::string_view json);

// What a simulator runs with, as JSON: the options, and the files that users added to the species.
std::string EncodeSimulatorOptions(const SimulatorOptions& options);
// Errors: DATA_LOSS saying what is wrong in it.
Result<SimulatorOptions> DecodeSimulatorOptions(std::string_view json);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_JOURNAL_JSON_H_
