#ifndef LATTICEWORLD_GENERATION_LANGUAGE_BACKENDS_H_
#define LATTICEWORLD_GENERATION_LANGUAGE_BACKENDS_H_

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {

// The back end "remote": a model behind an OpenAI-compatible server.
struct RemoteBackendOptions {
  OpenAiOptions server;  // url "": there is no such back end
  RemoteOptions model;
  bool fallback = false;  // true: where the server cannot be had the grounded back end answers

  bool is_wanted() const { return !server.url.empty(); }
};
// None when the back end is not wanted.
std::vector<Violation> Validate(const RemoteBackendOptions& options);

struct LanguageBackends {
  std::map<std::string, LanguageBackend> by_name;  // "grounded", and "remote" where it is wanted
  std::shared_ptr<const OpenAiClient> server;      // of "remote"; nullptr: none
};

// Errors: INVALID_ARGUMENT with every violation.
Result<LanguageBackends> MakeLanguageBackends(const RemoteBackendOptions& remote);

// Back ends for making a world of a bundle again: "remote" reads the recorded replies, and where
// there are none the grounded back end answers, as it did then.
LanguageBackends MakeReplayBackends(std::vector<ModelReply> replies);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_LANGUAGE_BACKENDS_H_
