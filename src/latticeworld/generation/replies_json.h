#ifndef LATTICEWORLD_GENERATION_REPLIES_JSON_H_
#define LATTICEWORLD_GENERATION_REPLIES_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

// replies.json: an array with what a language model answered, in order, and a key for each field of
// ModelReply; from it a world can be made again without the model.
std::string EncodeReplies(const std::vector<ModelReply>& replies);
// Errors: DATA_LOSS saying what is wrong: keys, types, values.
Result<std::vector<ModelReply>> DecodeReplies(std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_REPLIES_JSON_H_
