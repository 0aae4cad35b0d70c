#include "latticeworld/generation/language_backends.h"

#include <memory>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/language/drawn/drawn.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpreted.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/reading/model_reader.h"

namespace latticeworld {
namespace {

// The embedded back end behind a reader.
LanguageBackend MakeDrawn(const std::string& name,
                          const std::shared_ptr<InstructionReader>& reader) {
  return {reader, MakeDrawnLayoutGenerator(name, reader),
          MakeDrawnEnvironmentGenerator(name, reader)};
}

LanguageBackend MakeGrounded() { return MakeDrawn("grounded", MakeRuleReader()); }

// What needs neither a model nor a server: free text read by rules, and the small language.
std::map<std::string, LanguageBackend> MakeEmbedded() {
  std::map<std::string, LanguageBackend> backends;
  backends["grounded"] = MakeGrounded();
  backends["controlled"] = MakeDrawn("controlled", MakeControlledReader());
  return backends;
}

LanguageBackend WithFallback(LanguageBackend model, bool fallback) {
  if (!fallback) return model;
  LanguageBackend grounded = MakeGrounded();
  return {
      model.reader,
      MakeFallbackLayoutGenerator(std::move(model.layout), std::move(grounded.layout)),
      MakeFallbackEnvironmentGenerator(std::move(model.environment),
                                       std::move(grounded.environment)),
  };
}

LanguageBackend MakeRemote(const std::shared_ptr<ChatServer>& server, const RemoteOptions& options,
                           bool fallback) {
  return WithFallback({MakeRuleReader(), MakeRemoteLayoutGenerator(server, options),
                       MakeRemoteEnvironmentGenerator(server, options)},
                      fallback);
}

LanguageBackend MakeInterpreted(const std::shared_ptr<ChatServer>& server, RemoteOptions options,
                                bool fallback) {
  options.name = "interpreted";
  return WithFallback({MakeRuleReader(), MakeInterpretedLayoutGenerator(server, options),
                       MakeInterpretedEnvironmentGenerator(server, options)},
                      fallback);
}

// As of a model in this process, which is asked as one from afar is. Its answers have their form by
// construction; models of this size cannot be talked into what no form says.
RemoteOptions LocalModelOptions() {
  RemoteOptions model;
  model.name = "local";
  model.mends = true;
  // Every letter may be a token, and longer answers cost no more than their tokens.
  model.environment_max_tokens = 16384;
  return model;
}

Result<LanguageBackend> MakeLocal(const LocalBackendOptions& options) {
  LW_ASSIGN_OR_RETURN(const std::shared_ptr<ChatServer> layout,
                      MakeLocalChatServer(options.layout_model, options.threads));
  RemoteOptions model = LocalModelOptions();
  model.temperature = options.temperature;
  LanguageBackend backend;
  backend.reader = MakeRuleReader();
  backend.layout =
      MakeBestOfLayoutGenerator(MakeRemoteLayoutGenerator(layout, model), options.tries);
  if (options.environment_model == "grounded") {
    backend.environment = MakeGroundedEnvironmentGenerator();
    return WithFallback(std::move(backend), options.fallback);
  }
  std::shared_ptr<ChatServer> environment = layout;
  if (!options.environment_model.empty() && options.environment_model != options.layout_model) {
    LW_ASSIGN_OR_RETURN(environment,
                        MakeLocalChatServer(options.environment_model, options.threads));
  }
  backend.environment = MakeRemoteEnvironmentGenerator(environment, model);
  return WithFallback(std::move(backend), options.fallback);
}

// What a recording has of "layout" or "environment".
std::vector<ModelReply> RepliesOf(const std::string& part, const std::vector<ModelReply>& replies) {
  std::vector<ModelReply> found;
  for (const ModelReply& reply : replies) {
    if (reply.purpose == part || reply.purpose == part + "_words") found.push_back(reply);
  }
  return found;
}

bool HaveFailed(const std::vector<ModelReply>& replies) {
  return !replies.empty() && !replies.back().failure.ok();
}

// The back end whose model is a recording, as it answered then: where it failed it fails again, so
// that the grounded back end answers; where nothing is recorded no model was asked.
LanguageBackend AsRecorded(LanguageBackend model, const std::vector<ModelReply>& replies) {
  const std::string name(model.layout->name());
  const std::vector<ModelReply> layout = RepliesOf("layout", replies);
  const std::vector<ModelReply> environment = RepliesOf("environment", replies);
  if (HaveFailed(layout)) model.layout = MakeFailedLayoutGenerator(name, layout);
  if (HaveFailed(environment)) {
    model.environment = MakeFailedEnvironmentGenerator(name, environment);
  }
  LanguageBackend backend = WithFallback(std::move(model), true);
  if (layout.empty()) backend.layout = MakeGroundedLayoutGenerator();
  if (environment.empty()) backend.environment = MakeGroundedEnvironmentGenerator();
  return backend;
}

}  // namespace

std::vector<Violation> Validate(const RemoteBackendOptions& options) {
  if (!options.is_wanted()) return {};
  std::vector<Violation> violations = Validate(options.server);
  for (Violation& violation : Validate(options.model)) violations.push_back(std::move(violation));
  return violations;
}

std::vector<Violation> Validate(const LocalBackendOptions& options) {
  std::vector<Violation> violations;
  if (!options.is_wanted()) return violations;
  CheckRange("temperature", options.temperature, {0.0, 2.0}, "", &violations);
  CheckRange("tries", options.tries, {1.0, 64.0}, "", &violations);
  CheckRange("threads", options.threads, {0.0, 256.0}, "", &violations);
  return violations;
}

std::vector<Violation> Validate(const ReaderBackendOptions& options) {
  std::vector<Violation> violations;
  if (options.is_wanted()) CheckRange("threads", options.threads, {0.0, 256.0}, "", &violations);
  return violations;
}

Result<LanguageBackends> MakeLanguageBackends(const RemoteBackendOptions& remote,
                                              const LocalBackendOptions& local,
                                              const ReaderBackendOptions& reader) {
  LW_RETURN_IF_ERROR(Status::FromViolations("reader", Validate(reader)));
  LW_RETURN_IF_ERROR(Status::FromViolations("remote language back end", Validate(remote)));
  LW_RETURN_IF_ERROR(Status::FromViolations("local language back end", Validate(local)));
  LanguageBackends backends;
  backends.by_name = MakeEmbedded();
  if (local.is_wanted()) {
    LW_ASSIGN_OR_RETURN(backends.by_name["local"], MakeLocal(local));
  }
  if (reader.is_wanted()) {
    LW_ASSIGN_OR_RETURN(std::shared_ptr<ChatServer> model,
                        MakeLocalChatServer(reader.model, reader.threads));
    backends.by_name["reader"] = MakeDrawn("reader", MakeModelReader(std::move(model)));
  }
  if (!remote.is_wanted()) return backends;
  LW_ASSIGN_OR_RETURN(std::shared_ptr<OpenAiClient> server, MakeOpenAiClient(remote.server));
  backends.by_name["remote"] = MakeRemote(server, remote.model, remote.fallback);
  backends.by_name["interpreted"] = MakeInterpreted(server, remote.model, remote.fallback);
  backends.server = std::move(server);
  return backends;
}

std::string DefaultBackend(const LanguageBackends& backends) {
  for (const char* name : {"remote", "local"})
    if (backends.by_name.count(name) != 0) return name;
  return "grounded";
}

LanguageBackends MakeReplayBackends(const std::vector<ModelReply>& replies) {
  RemoteOptions options;
  // The recording ends where an answer was taken, so that no turn is asked that was not.
  options.repair_turns = kMostRepairTurns;
  RemoteOptions local = LocalModelOptions();
  local.repair_turns = kMostRepairTurns;
  const auto server = [&replies] { return MakeReplayServer(replies); };
  LanguageBackends backends;
  backends.by_name = MakeEmbedded();
  backends.by_name["reader"] = AsRecorded(MakeDrawn("reader", MakeModelReader(server())), replies);
  backends.by_name["remote"] = AsRecorded(MakeRemote(server(), options, false), replies);
  backends.by_name["interpreted"] = AsRecorded(MakeInterpreted(server(), options, false), replies);
  backends.by_name["local"] = AsRecorded(MakeRemote(server(), local, false), replies);
  return backends;
}

WorldGenerator MakeDefaultWorldGenerator() { return WorldGenerator(MakeEmbedded(), "grounded"); }

}  // namespace latticeworld
