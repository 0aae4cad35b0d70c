#ifndef LATTICEWORLD_LANGUAGE_REMOTE_REMOTE_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_REMOTE_H_

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"

namespace latticeworld {

inline constexpr int kMostRepairTurns = 8;

// RemoteOptions says how a model is asked.
struct RemoteOptions {
  int repair_turns = 2;      // times that violations go back to the model; 0 .. kMostRepairTurns
  double temperature = 0.7;  // 0 .. 2
  int layout_max_tokens = 2048;       // of one answer, thinking included; 64 .. 65536
  int environment_max_tokens = 4096;  // the same
  bool mends = false;  // of environments, what only the rules forbid becomes the nearest legal
                       // value, with a warning, and does not go back to the model
  std::string name = "remote";  // by which the generators go
};
// Returns everything that is wrong with the options.
std::vector<Violation> Validate(const RemoteOptions& options);

// These make generators that ask a chat server: they send the prompts (prompts/*.txt), ask for the
// form of the answer, read strictly whatever comes, and have the model repair it. A server may be
// shared; each call asks it at most 1 + repair_turns times. Progress reports the rows of a layout
// as they arrive; a layout that cannot become legal is cut short and repaired. The options must be
// valid. Errors: as ChatServer (INVALID_ARGUMENT may mean that the server refused what it was
// sent), and DATA_LOSS with every violation of the last answer when no turn repaired it.
std::unique_ptr<LayoutGenerator> MakeRemoteLayoutGenerator(std::shared_ptr<ChatServer> server,
                                                           const RemoteOptions& options);
std::unique_ptr<EnvironmentGenerator> MakeRemoteEnvironmentGenerator(
    std::shared_ptr<ChatServer> server, const RemoteOptions& options);

// Makes a server that gives recorded replies, each purpose's in their order, so that a world can be
// made again without its model. Generators over it, with at least as many repair turns as were
// recorded, give the same answers byte for byte. Errors of Complete: OUT_OF_RANGE when more is
// asked than was recorded; CANCELLED.
std::shared_ptr<ChatServer> MakeReplayServer(std::vector<ModelReply> replies);

// These make generators that fail as those named `name` did. They give the same replies, of which
// the last is the record of the failure, so that a fallback over them answers as it did then, byte
// for byte.
std::unique_ptr<LayoutGenerator> MakeFailedLayoutGenerator(std::string name,
                                                           std::vector<ModelReply> replies);
std::unique_ptr<EnvironmentGenerator> MakeFailedEnvironmentGenerator(
    std::string name, std::vector<ModelReply> replies);

// These make generators that ask `first`. Whatever its server failed of (UNAVAILABLE,
// DEADLINE_EXCEEDED, UNAUTHENTICATED, DATA_LOSS, INVALID_ARGUMENT of the server, ...), `second`
// answers: its answer gets a first warning that says why, and the failure is recorded after the
// replies of `first`. A request that is invalid itself is refused with INVALID_ARGUMENT before
// either is asked, and CANCELLED is passed on. name() is that of `first`.
std::unique_ptr<LayoutGenerator> MakeFallbackLayoutGenerator(
    std::unique_ptr<LayoutGenerator> first, std::unique_ptr<LayoutGenerator> second);
std::unique_ptr<EnvironmentGenerator> MakeFallbackEnvironmentGenerator(
    std::unique_ptr<EnvironmentGenerator> first, std::unique_ptr<EnvironmentGenerator> second);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_REMOTE_H_
