#include "tools/language_arguments.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "tools/arguments.h"
#include "tools/server_arguments.h"

namespace latticeworld::tools {
namespace {

// Illegal fields of the models' options are told by the options that set them.
Status ByOptions(const Status& status) {
  if (status.violations().empty()) return status;
  std::vector<Violation> violations = status.violations();
  for (Violation& violation : violations) violation.pointer = OptionOf("--", violation.pointer);
  return Status::FromViolations("unusable arguments", std::move(violations));
}

}  // namespace

void AddLanguageOptions(CLI::App* command) {
  // These choose who reads and who answers.
  AddValueOption(
      command, "--reader", "NAME",
      "Who reads the words: rules, controlled (they are sentences of the small language, "
      "docs/small_language.md), model (--reader-model says them in it), checked (model, with the "
      "rules beside it) or remote (the model behind --remote-url says them in it) [checked where "
      "a model that reads is given, else rules].");
  AddValueOption(
      command, "--generator", "NAME",
      "Who answers them: grounded (draws what was read), remote (the model behind --remote-url) or "
      "local (a model in this process, --local-model) [remote where --remote-url is given, else "
      "local where --local-model is, else grounded].");
  // These are for models in this process.
  AddValueOption(command, "--reader-model", "FILE",
                 "GGUF file of a model that was taught to read (scripts/fetch_reader.sh) "
                 "[what LATTICEWORLD_READER_MODEL names; else none].");
  AddValueOption(command, "--reader-threads", "N",
                 "That read, which does not depend on them, 0 to 256 [0: as many as cores].");
  AddValueOption(command, "--local-model", "FILE",
                 "GGUF file of LLaMA's architecture (f32, f16, q4_1 or q8_0) that draws layouts.");
  AddValueOption(command, "--local-environment-model", "FILE",
                 "The same for environments, or grounded for the embedded back end "
                 "[that of --local-model].");
  AddValueOption(command, "--local-temperature", "NUMBER", "0 to 2 [1].");
  AddValueOption(
      command, "--local-tries", "N",
      "Layouts that are drawn at most, 1 to 64; the one that has most of what is read in "
      "the words is the answer [1].");
  AddValueOption(command, "--local-threads", "N",
                 "That compute an answer, which does not depend on them, 0 to 256 [0: as many as "
                 "cores].");
  command->add_flag("--local-fallback",
                    "Where its answer stays illegal, grounded answers, with a warning.");
  // These are for a model on a server.
  AddServerOptions(command);
  AddValueOption(command, "--remote-repair-turns", "N",
                 "Times that what is wrong with an answer goes back to the model, 0 to 8 [2].");
  AddValueOption(command, "--remote-temperature", "NUMBER", "0 to 2 [0.7].");
  AddValueOption(command, "--remote-layout-max-tokens", "N",
                 "Of one answer, thinking included, 64 to 65536 [2048].");
  AddValueOption(command, "--remote-environment-max-tokens", "N",
                 "The same for environments [4096].");
  command->add_flag("--remote-sees", "The model looks at images: it gets the relief as one.");
  command->add_flag("--remote-fallback",
                    "Where the server cannot be had, grounded answers, with a warning.");
}

Result<LanguageStack> LoadLanguage(const CLI::App& command) {
  ArgumentReader arguments(&command);
  RemoteModelOptions remote;
  remote.server = ReadServerOptions(command, &arguments);
  remote.server.sees = command.count("--remote-sees") > 0;
  remote.fallback = command.count("--remote-fallback") > 0;
  remote.model.repair_turns =
      static_cast<int>(arguments.Integer("--remote-repair-turns", 0, 8, remote.model.repair_turns));
  remote.model.temperature = arguments.Number("--remote-temperature", remote.model.temperature);
  remote.model.layout_max_tokens = static_cast<int>(
      arguments.Integer("--remote-layout-max-tokens", 64, 65536, remote.model.layout_max_tokens));
  remote.model.environment_max_tokens = static_cast<int>(arguments.Integer(
      "--remote-environment-max-tokens", 64, 65536, remote.model.environment_max_tokens));
  for (const char* option : {"--remote-repair-turns", "--remote-temperature",
                             "--remote-layout-max-tokens", "--remote-environment-max-tokens"}) {
    arguments.RequireBeside(option, "--remote-url");
  }
  LocalModelOptions local;
  local.layout_model = ValueOf(command, "--local-model").value_or("");
  local.environment_model = ValueOf(command, "--local-environment-model").value_or("");
  local.fallback = command.count("--local-fallback") > 0;
  local.temperature = arguments.Number("--local-temperature", local.temperature);
  local.tries = static_cast<int>(arguments.Integer("--local-tries", 1, 64, local.tries));
  local.threads = static_cast<int>(arguments.Integer("--local-threads", 0, 256, local.threads));
  for (const char* option :
       {"--local-environment-model", "--local-temperature", "--local-threads", "--local-tries"})
    arguments.RequireBeside(option, "--local-model");
  ReaderModelOptions reader;
  const char* named = std::getenv("LATTICEWORLD_READER_MODEL");
  reader.model = ValueOf(command, "--reader-model").value_or(named == nullptr ? "" : named);
  reader.threads = static_cast<int>(arguments.Integer("--reader-threads", 0, 256, reader.threads));
  if (!reader.is_wanted()) arguments.RequireBeside("--reader-threads", "--reader-model");
  LW_RETURN_IF_ERROR(arguments.status());

  auto loaded = latticeworld::LoadLanguage(remote, local, reader);
  if (!loaded.ok()) return ByOptions(loaded.status());
  return std::move(loaded->stack);
}

}  // namespace latticeworld::tools
