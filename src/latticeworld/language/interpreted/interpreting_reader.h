#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETING_READER_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETING_READER_H_

#include <memory>

#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {

// A reader that leaves the understanding to a large language model: the model says in plain
// sentences what an instruction asks for, sees what the rules make of them, and may say them again;
// then the rules read the sentences. Models of a few billion weights understand words better than
// they draw maps.
//
// options: valid; repair_turns are the times that the model sees its sentences read, or that what
// is wrong with its answer goes back to it; layout_max_tokens and environment_max_tokens bound an
// answer; mends has no use. The first warning of a reading says how the instruction was read; the
// second reading is the rules' of the person's own words. Once there are sentences they are used,
// whatever becomes of the server. name(): "remote". Errors: as MakeRemoteLayoutGenerator.
std::shared_ptr<InstructionReader> MakeInterpretingReader(std::shared_ptr<ChatServer> server,
                                                          const RemoteOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETING_READER_H_
