#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETED_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETED_H_

#include <memory>

#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {

// Generators that leave the reading to a language model and the rest to the embedded back end: the
// model says in plain sentences what an instruction asks for, sees what the embedded reader makes
// of them, and may say them again; then the embedded generator answers the sentences. Models of a
// few billion weights understand words better than they draw maps.
//
// options: valid; repair_turns are the times that the model sees its sentences read, or that what
// is wrong with its answer goes back to it; layout_max_tokens and environment_max_tokens bound an
// answer; mends has no use. The first warning of an answer says how the instruction was read. Once
// there are sentences they are used, whatever becomes of the server.
// Errors: as MakeRemoteLayoutGenerator.
std::unique_ptr<LayoutGenerator> MakeInterpretedLayoutGenerator(std::shared_ptr<ChatServer> server,
                                                                const RemoteOptions& options);
std::unique_ptr<EnvironmentGenerator> MakeInterpretedEnvironmentGenerator(
    std::shared_ptr<ChatServer> server, const RemoteOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETED_H_
