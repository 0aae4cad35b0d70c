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

// The back ends "remote" and "interpreted": a model behind an OpenAI-compatible server that
// answers, or that reads for the embedded back end.
struct RemoteBackendOptions {
  OpenAiOptions server;  // url "": there is no such back end
  RemoteOptions model;
  bool fallback = false;  // true: where the server cannot be had the grounded back end answers

  bool is_wanted() const { return !server.url.empty(); }
};
// None when the back end is not wanted.
std::vector<Violation> Validate(const RemoteBackendOptions& options);

// The back end "local": models in this process (language/local/local.h).
struct LocalBackendOptions {
  std::string layout_model;       // GGUF file of LLM_L; "": there is no such back end
  std::string environment_model;  // of LLM_C; "": the layout's; "grounded": that back end answers
  double temperature = 1.0;       // 0 .. 2; 1: as the model has learned
  int tries = 1;          // 1 .. 64 layouts that are drawn at most; the one with most claims counts
  int threads = 0;        // 0 .. 256 that compute an answer; 0: as many as the machine has cores
  bool fallback = false;  // true: where an answer stays illegal the grounded back end answers

  bool is_wanted() const { return !layout_model.empty(); }
};
// None when the back end is not wanted. Files are not looked at.
std::vector<Violation> Validate(const LocalBackendOptions& options);

// The back end "reader": a model in this process that says instructions in the small language
// (language/reading/model_reader.h); what it reads is drawn as "controlled" draws it.
struct ReaderBackendOptions {
  std::string model;  // GGUF file; "": there is no such back end
  int threads = 0;    // 0 .. 256 that compute; 0: as many as the machine has cores

  bool is_wanted() const { return !model.empty(); }
};
// None when the back end is not wanted. The file is not looked at.
std::vector<Violation> Validate(const ReaderBackendOptions& options);

struct LanguageBackends {
  // "grounded" and "controlled", and "remote" and "interpreted", "local" and
  // "reader" where they are wanted.
  std::map<std::string, LanguageBackend> by_name;
  std::shared_ptr<const OpenAiClient> server;  // of both; nullptr: none
};

// Errors: INVALID_ARGUMENT with every violation; those of MakeLocalChatServer.
Result<LanguageBackends> MakeLanguageBackends(const RemoteBackendOptions& remote,
                                              const LocalBackendOptions& local = {},
                                              const ReaderBackendOptions& reader = {});

// Who answers where nobody says who: a model, where one was named, else the grounded back end.
std::string DefaultBackend(const LanguageBackends& backends);

// Back ends for making a world of a bundle again, with the same warnings and replies: all but
// "grounded" and "controlled" read the recorded replies of a layout or an environment. Where a
// failure is recorded after them, or nothing at all, the grounded back end answers, as it did then.
LanguageBackends MakeReplayBackends(const std::vector<ModelReply>& replies);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_LANGUAGE_BACKENDS_H_
