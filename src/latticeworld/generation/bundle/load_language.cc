#include "latticeworld/generation/bundle/load_language.h"

#include <memory>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpreting_reader.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/reading/checked_reader.h"
#include "latticeworld/language/reading/model_reader.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

LanguageGenerator MakeGrounded() {
  return {MakeGroundedLayoutGenerator(), MakeGroundedEnvironmentGenerator()};
}

// What needs neither a model nor a server.
LanguageStack MakeEmbedded() {
  LanguageStack stack;
  stack.readers["rules"] = MakeRuleReader();
  stack.readers["controlled"] = MakeControlledReader();
  stack.generators["grounded"] = MakeGrounded();
  stack.default_reader = "rules";
  stack.default_generator = "grounded";
  return stack;
}

LanguageGenerator WithFallback(LanguageGenerator model, bool fallback) {
  if (!fallback) return model;
  LanguageGenerator grounded = MakeGrounded();
  return {
      MakeFallbackLayoutGenerator(std::move(model.layout), std::move(grounded.layout)),
      MakeFallbackEnvironmentGenerator(std::move(model.environment),
                                       std::move(grounded.environment)),
  };
}

std::shared_ptr<InstructionReader> WithFallback(std::shared_ptr<InstructionReader> reader,
                                                bool fallback) {
  if (!fallback) return reader;
  return MakeFallbackReader(std::move(reader), MakeRuleReader());
}

LanguageGenerator MakeRemote(const std::shared_ptr<ChatServer>& server,
                             const RemoteOptions& options) {
  return {MakeRemoteLayoutGenerator(server, options),
          MakeRemoteEnvironmentGenerator(server, options)};
}

// Returns the options for asking a model in this process through the interface of remote models.
// Its answers have their form by construction; models of this size cannot be talked into what no
// form says.
RemoteOptions AskedInProcess() {
  RemoteOptions model;
  model.name = "local";
  model.mends = true;
  // Every letter may be a token, and longer answers cost no more than their tokens.
  model.environment_max_tokens = 16384;
  return model;
}

Result<LanguageGenerator> LoadLocal(const LocalModelOptions& options) {
  LW_ASSIGN_OR_RETURN(const std::shared_ptr<ChatServer> layout,
                      MakeLocalChatServer(options.layout_model, options.threads));
  RemoteOptions model = AskedInProcess();
  model.temperature = options.temperature;
  LanguageGenerator generator;
  generator.layout =
      MakeBestOfLayoutGenerator(MakeRemoteLayoutGenerator(layout, model), options.tries);
  if (options.environment_model == "grounded") {
    generator.environment = MakeGroundedEnvironmentGenerator();
    return WithFallback(std::move(generator), options.fallback);
  }
  std::shared_ptr<ChatServer> environment = layout;
  if (!options.environment_model.empty() && options.environment_model != options.layout_model) {
    LW_ASSIGN_OR_RETURN(environment,
                        MakeLocalChatServer(options.environment_model, options.threads));
  }
  generator.environment = MakeRemoteEnvironmentGenerator(environment, model);
  return WithFallback(std::move(generator), options.fallback);
}

// What a recording has for a purpose.
std::vector<ModelReply> RepliesFor(std::string_view purpose,
                                   const std::vector<ModelReply>& replies) {
  std::vector<ModelReply> found;
  for (const ModelReply& reply : replies) {
    if (reply.purpose == purpose) found.push_back(reply);
  }
  return found;
}

bool HaveFailed(const std::vector<ModelReply>& replies) {
  return !replies.empty() && !replies.back().failure.ok();
}

// The generator whose model is a recording, as it answered then: where it failed it fails again, so
// that the grounded one answers; where nothing is recorded no model was asked.
LanguageGenerator AsRecorded(LanguageGenerator model, const std::vector<ModelReply>& replies) {
  const std::string name(model.layout->name());
  const std::vector<ModelReply> layout = RepliesFor("layout", replies);
  const std::vector<ModelReply> environment = RepliesFor("environment", replies);
  if (HaveFailed(layout)) model.layout = MakeFailedLayoutGenerator(name, layout);
  if (HaveFailed(environment)) {
    model.environment = MakeFailedEnvironmentGenerator(name, environment);
  }
  LanguageGenerator generator = WithFallback(std::move(model), true);
  if (layout.empty()) generator.layout = MakeGroundedLayoutGenerator();
  if (environment.empty()) generator.environment = MakeGroundedEnvironmentGenerator();
  return generator;
}

// A reader whose model is a recording: where that failed it fails again.
std::shared_ptr<InstructionReader> AsRecorded(std::shared_ptr<InstructionReader> reader,
                                              const std::vector<ModelReply>& replies) {
  std::vector<ModelReply> layout = RepliesFor(kLayoutWords, replies);
  std::vector<ModelReply> environment = RepliesFor(kEnvironmentWords, replies);
  if (!HaveFailed(layout)) layout.clear();
  if (!HaveFailed(environment)) environment.clear();
  return MakeFailedReader(std::move(reader), std::move(layout), std::move(environment));
}

// Every violation of the three, of fields that are called "remote_url", "local_tries" and so on.
Status ValidateAll(const RemoteModelOptions& remote, const LocalModelOptions& local,
                   const ReaderModelOptions& reader) {
  std::vector<Violation> violations;
  const auto add = [&violations](const char* prefix, std::vector<Violation> found) {
    for (Violation& violation : found) {
      violation.pointer = prefix + violation.pointer;
      violations.push_back(std::move(violation));
    }
  };
  add("remote_", Validate(remote));
  add("local_", Validate(local));
  add("reader_", Validate(reader));
  return Status::FromViolations("language models", std::move(violations));
}

}  // namespace

std::vector<Violation> Validate(const RemoteModelOptions& options) {
  if (!options.is_wanted()) return {};
  std::vector<Violation> violations = Validate(options.server);
  for (Violation& violation : Validate(options.model)) violations.push_back(std::move(violation));
  return violations;
}

std::vector<Violation> Validate(const LocalModelOptions& options) {
  std::vector<Violation> violations;
  if (!options.is_wanted()) return violations;
  CheckRange("temperature", options.temperature, {0.0, 2.0}, "", &violations);
  CheckRange("tries", options.tries, {1.0, 64.0}, "", &violations);
  CheckRange("threads", options.threads, {0.0, 256.0}, "", &violations);
  return violations;
}

std::vector<Violation> Validate(const ReaderModelOptions& options) {
  std::vector<Violation> violations;
  if (options.is_wanted()) CheckRange("threads", options.threads, {0.0, 256.0}, "", &violations);
  return violations;
}

Result<LoadedLanguage> LoadLanguage(const RemoteModelOptions& remote,
                                    const LocalModelOptions& local,
                                    const ReaderModelOptions& reader) {
  LW_RETURN_IF_ERROR(ValidateAll(remote, local, reader));
  LoadedLanguage loaded;
  LanguageStack& stack = loaded.stack;
  stack = MakeEmbedded();
  if (reader.is_wanted()) {
    LW_ASSIGN_OR_RETURN(std::shared_ptr<ChatServer> model,
                        MakeLocalChatServer(reader.model, reader.threads));
    const std::shared_ptr<InstructionReader>& rules = stack.readers["rules"];
    const std::shared_ptr<InstructionReader> read_by_model = MakeModelReader(std::move(model));
    stack.readers["model"] = MakeLongTextReader(MakeComparedReader(read_by_model, rules), rules);
    stack.readers["checked"] = MakeLongTextReader(MakeCheckedReader(read_by_model, rules), rules);
    stack.default_reader = "checked";
  }
  if (local.is_wanted()) {
    LW_ASSIGN_OR_RETURN(stack.generators["local"], LoadLocal(local));
    stack.default_generator = "local";
  }
  if (!remote.is_wanted()) return loaded;
  LW_ASSIGN_OR_RETURN(std::shared_ptr<OpenAiClient> server, MakeOpenAiClient(remote.server));
  stack.readers["remote"] =
      WithFallback(MakeInterpretingReader(server, remote.model), remote.fallback);
  stack.generators["remote"] = WithFallback(MakeRemote(server, remote.model), remote.fallback);
  stack.default_generator = "remote";
  loaded.server = std::move(server);
  return loaded;
}

LanguageStack MakeReplayStack(const std::vector<ModelReply>& replies) {
  RemoteOptions options;
  // The recording ends where an answer was taken, so that no turn is asked that was not.
  options.repair_turns = kMostRepairTurns;
  RemoteOptions local = AskedInProcess();
  local.repair_turns = kMostRepairTurns;
  const auto server = [&replies] { return MakeReplayServer(replies); };
  LanguageStack stack = MakeEmbedded();
  const std::shared_ptr<InstructionReader>& rules = stack.readers["rules"];
  stack.readers["model"] = MakeLongTextReader(
      AsRecorded(MakeComparedReader(MakeModelReader(server()), rules), replies), rules);
  stack.readers["checked"] = MakeLongTextReader(
      AsRecorded(MakeCheckedReader(MakeModelReader(server()), rules), replies), rules);
  stack.readers["remote"] =
      WithFallback(AsRecorded(MakeInterpretingReader(server(), options), replies), true);
  stack.generators["remote"] = AsRecorded(MakeRemote(server(), options), replies);
  stack.generators["local"] = AsRecorded(MakeRemote(server(), local), replies);
  return stack;
}

WorldGenerator MakeDefaultWorldGenerator() { return WorldGenerator(MakeEmbedded()); }

}  // namespace latticeworld
