#ifndef LATTICEWORLD_GENERATION_BUNDLE_REPLIES_JSON_H_
#define LATTICEWORLD_GENERATION_BUNDLE_REPLIES_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// replies.json: an array with what a language model answered, those for the layout before those for
// the environment, each in their order; from it a world can be made again without the model. A
// reply has a key for each field of ModelReply but `failure`:
//
//   {"purpose": "layout", "model": "m", "text": "FFF...", "finish_reason": "stop",
//    "prompt_tokens": 700, "completion_tokens": 1055, "retries": 0, "seconds": 1.5}
//
// and, where its server gave cause for some, "warnings", a list of texts. Where another back end
// had to answer, the record of the failure follows the replies:
//
//   {"purpose": "layout", "failure": "DATA_LOSS", "message": "the language model gave no ..."}
std::string EncodeReplies(const std::vector<ModelReply>& replies);
// Errors: DATA_LOSS saying what is wrong: keys, types, values.
Result<std::vector<ModelReply>> DecodeReplies(std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_REPLIES_JSON_H_
