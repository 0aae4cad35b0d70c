#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETING_READER_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETING_READER_H_

#include <memory>

#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {

// A reader that leaves the understanding to a large language model: the model says an instruction
// in the small language, which its prompt describes. Models of a few billion weights understand
// words better than they draw maps.
//
// options: valid; repair_turns are the times that what is wrong with its answer, sentences of no
// form and words of the text that no sentence carries, goes back to it; layout_max_tokens and
// environment_max_tokens bound an answer; mends has no use. The second reading is the rules' of the
// same text; where the model finds that nothing is asked, theirs counts. Once there are sentences
// they are used, whatever becomes of the server. name(): "remote". Errors: as
// MakeRemoteLayoutGenerator.
std::shared_ptr<InstructionReader> MakeInterpretingReader(std::shared_ptr<ChatServer> server,
                                                          const RemoteOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETING_READER_H_
