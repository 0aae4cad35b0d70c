#ifndef LATTICEWORLD_GENERATION_BUNDLE_LOAD_LANGUAGE_H_
#define LATTICEWORLD_GENERATION_BUNDLE_LOAD_LANGUAGE_H_

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/language_stack.h"
#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {

// A model behind an OpenAI-compatible server: the generator "remote", which answers, and the reader
// "remote", which says the instruction in plain sentences.
struct RemoteModelOptions {
  OpenAiOptions server;  // url "": there is no such model
  RemoteOptions model;
  bool fallback = false;  // true: where the server cannot be had what is embedded answers

  bool is_wanted() const { return !server.url.empty(); }
};
// Returns every violation; none if the model is not wanted.
std::vector<Violation> Validate(const RemoteModelOptions& options);

// The generator "local": models in this process (language/local/local.h).
struct LocalModelOptions {
  std::string layout_model;       // GGUF file of LLM_L; "": there is no such generator
  std::string environment_model;  // of LLM_C; "": the layout's; "grounded": that generator answers
  double temperature = 1.0;       // 0 .. 2; 1: as the model has learned
  int tries = 1;          // 1 .. 64 layouts that are drawn at most; the one with most claims counts
  int threads = 0;        // 0 .. 256 that compute an answer; 0: as many as the machine has cores
  bool fallback = false;  // true: where an answer stays illegal "grounded" answers

  bool is_wanted() const { return !layout_model.empty(); }
};
// Returns every violation; none if the models are not wanted. It does not look at the files.
std::vector<Violation> Validate(const LocalModelOptions& options);

// The readers "model" and "checked": a model in this process that says instructions in the small
// language (language/reading/model_reader.h), alone or beside the rules.
struct ReaderModelOptions {
  std::string model;  // GGUF file; "": there are no such readers
  int threads = 0;    // 0 .. 256 that compute; 0: as many as the machine has cores

  bool is_wanted() const { return !model.empty(); }
};
// Returns every violation; none if the model is not wanted. It does not look at the file.
std::vector<Violation> Validate(const ReaderModelOptions& options);

struct LoadedLanguage {
  LanguageStack stack;
  std::shared_ptr<const OpenAiClient> server;  // of the remote model; nullptr: none
};

// Readers "rules" and "controlled", and generator "grounded"; and those of the models that are
// wanted. Default reader: "checked" where there is a model that reads, else "rules". Default
// generator: a model, where one was named, else "grounded".
// Errors: INVALID_ARGUMENT with every violation of the three, whose pointers are the fields' names
// after "remote_", "local_" and "reader_"; those of MakeLocalChatServer.
Result<LoadedLanguage> LoadLanguage(const RemoteModelOptions& remote,
                                    const LocalModelOptions& local = {},
                                    const ReaderModelOptions& reader = {});

// Returns what makes a world of a bundle again, with the same warnings and replies: models are the
// recorded replies. Where a failure is recorded after them, or for a generator nothing at all, what
// is embedded answers, as it did then.
LanguageStack MakeReplayStack(const std::vector<ModelReply>& replies);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_LOAD_LANGUAGE_H_
