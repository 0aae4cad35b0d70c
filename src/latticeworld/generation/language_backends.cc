#include "latticeworld/generation/language_backends.h"

#include <utility>

#include "latticeworld/language/grounded/grounded.h"

namespace latticeworld {
namespace {

LanguageBackend MakeGrounded() {
  return {MakeGroundedLayoutGenerator(), MakeGroundedEnvironmentGenerator()};
}

LanguageBackend MakeRemote(const std::shared_ptr<ChatServer>& server, const RemoteOptions& options,
                           bool fallback) {
  LanguageBackend remote{MakeRemoteLayoutGenerator(server, options),
                         MakeRemoteEnvironmentGenerator(server, options)};
  if (!fallback) return remote;
  LanguageBackend grounded = MakeGrounded();
  return {
      MakeFallbackLayoutGenerator(std::move(remote.layout), std::move(grounded.layout)),
      MakeFallbackEnvironmentGenerator(std::move(remote.environment),
                                       std::move(grounded.environment)),
  };
}

}  // namespace

std::vector<Violation> Validate(const RemoteBackendOptions& options) {
  if (!options.is_wanted()) return {};
  std::vector<Violation> violations = Validate(options.server);
  for (Violation& violation : Validate(options.model)) violations.push_back(std::move(violation));
  return violations;
}

Result<LanguageBackends> MakeLanguageBackends(const RemoteBackendOptions& remote) {
  LW_RETURN_IF_ERROR(Status::FromViolations("remote language back end", Validate(remote)));
  LanguageBackends backends;
  backends.by_name["grounded"] = MakeGrounded();
  if (!remote.is_wanted()) return backends;
  LW_ASSIGN_OR_RETURN(std::shared_ptr<OpenAiClient> server, MakeOpenAiClient(remote.server));
  backends.by_name["remote"] = MakeRemote(server, remote.model, remote.fallback);
  backends.server = std::move(server);
  return backends;
}

LanguageBackends MakeReplayBackends(std::vector<ModelReply> replies) {
  RemoteOptions options;
  // The recording ends where an answer was taken, so that no turn is asked that was not.
  options.repair_turns = static_cast<int>(replies.size());
  LanguageBackends backends;
  backends.by_name["grounded"] = MakeGrounded();
  backends.by_name["remote"] =
      MakeRemote(MakeReplayServer(std::move(replies)), options, /*fallback=*/true);
  return backends;
}

WorldGenerator MakeDefaultWorldGenerator() {
  std::map<std::string, LanguageBackend> backends;
  backends["grounded"] = MakeGrounded();
  return WorldGenerator(std::move(backends), "grounded");
}

}  // namespace latticeworld
