#include "tools/dataset_sources.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/remote_annotator.h"
#include "latticeworld/dataset/captions/written_annotator.h"
#include "latticeworld/dataset/sources/generated_source.h"
#include "latticeworld/dataset/sources/given_environments.h"
#include "latticeworld/dataset/sources/given_instructions.h"
#include "latticeworld/dataset/sources/loveda_source.h"
#include "latticeworld/dataset/sources/scenes_source.h"
#include "latticeworld/language/chat/openai_client.h"
#include "tools/arguments.h"
#include "tools/server_arguments.h"

namespace latticeworld::tools {
namespace {

constexpr std::int64_t kMostGenerated = 10'000'000;

template <typename Enum>
std::vector<std::string> NamesOf() {
  std::vector<std::string> names;
  for (const auto& entry : EnumNames(Enum{})) names.emplace_back(entry.name);
  return names;
}

// What is illegal of fields that are called as arguments are, added to what is of the arguments.
Status Unusable(ArgumentReader* reader, std::vector<Violation> violations,
                const std::string& prefix = "--") {
  for (Violation& violation : violations)
    violation.pointer = OptionOf(prefix, std::move(violation.pointer));
  reader->AddIllegal({}, std::move(violations));
  return reader->status();
}

Result<WrittenOptions> ReadWritten(const CLI::App& command, double size_m) {
  ArgumentReader reader(&command);
  const auto facts = reader.NumberPair("--facts");
  WrittenOptions written;
  written.size_m = size_m;
  if (facts) {
    if (facts->first != std::trunc(facts->first) || facts->second != std::trunc(facts->second))
      reader.Refuse("--facts", *ValueOf(command, "--facts"), "two whole numbers parted by a comma");
    written.least_facts = static_cast<int>(std::clamp(facts->first, -1.0, 1e6));
    written.most_facts = static_cast<int>(std::clamp(facts->second, -1.0, 1e6));
  }
  std::vector<Violation> violations = Validate(written);
  for (Violation& violation : violations)
    if (EndsWith(violation.pointer, "_facts")) violation.pointer = "facts";
  LW_RETURN_IF_ERROR(Unusable(&reader, std::move(violations)));
  return written;
}

Result<std::unique_ptr<Annotator>> MakeRemote(const CLI::App& command, OpenAiOptions server,
                                              double size_m) {
  ArgumentReader reader(&command);
  server.sees = command.count("--remote-sees") > 0;
  RemoteAnnotatorOptions options;
  options.repair_turns = reader.Whole("--remote-repair-turns", options.repair_turns);
  options.temperature = reader.Number("--remote-temperature", options.temperature);
  options.size_m = size_m;
  options.name = server.model.empty() ? "remote" : server.model;
  std::vector<Violation> violations = Validate(server);
  for (Violation& violation : Validate(options)) violations.push_back(std::move(violation));
  LW_RETURN_IF_ERROR(Unusable(&reader, std::move(violations), "--remote-"));
  LW_ASSIGN_OR_RETURN(std::shared_ptr<OpenAiClient> client, MakeOpenAiClient(server));
  return MakeRemoteAnnotator(std::move(client), options);
}

}  // namespace

void AddDatasetSourceOptions(CLI::App* command) {
  AddValueOption(command, "--generate", "N", "N places of LatticeWorld's own generator.");
  AddValueOption(command, "--loveda", "DIR", "The images of a LoveDA folder as published.");
  AddValueOption(command, "--scenes", "DIR",
                 "Tiles of scenes with segmentation.png and elevation.tif (docs/datasets.md).");
  AddValueOption(command, "--instructions", "FILE",
                 "The instructions of a JSON file, as those of a fidelity benchmark, answered by "
                 "the embedded generator.");
  AddValueOption(command, "--environment-instructions", "FILE",
                 "The same for environments, of places of LatticeWorld's own generator.");
  AddValueOption(command, "--answers", "N",
                 "With instructions: different answers to each, 1 to 1000 [8].");
  AddValueOption(command, "--leave-out", "N",
                 "With instructions: every Nth, from the first on, is not used [0: all are].");
  AddValueOption(command, "--relief-share", "SHARE",
                 "With --generate: of the places that have a relief, 0 to 1 [0.5].");
  AddValueOption(command, "--loveda-scenes", "WHICH", "rural, urban or all [rural].");
  AddValueOption(command, "--erosion", "SHARE",
                 "With --scenes: how far rivers cut back into the land, 0 to 0.5 [0.05].");
  AddValueOption(command, "--annotator", "NAME",
                 "Who writes: written (embedded) or remote (a model behind --remote-url) "
                 "[written].");
  AddValueOption(command, "--facts", "LEAST,MOST",
                 "How much the written annotator says of a layout, 1 to 12 [3,8].");
  AddServerOptions(command);
  AddValueOption(command, "--remote-repair-turns", "N",
                 "Times that what is wrong with an answer goes back to the model, 0 to 8 [3].");
  AddValueOption(command, "--remote-temperature", "NUMBER", "0 to 2 [0.8].");
  command->add_flag("--remote-sees", "The model looks at images: it gets the layout as one.");
}

Result<std::unique_ptr<InstanceSource>> MakeDatasetSource(const CLI::App& command) {
  ArgumentReader reader(&command);
  // The options of all sources are read.
  GeneratedSourceOptions generated;
  generated.groups = static_cast<std::size_t>(reader.Integer("--generate", 1, kMostGenerated, 1));
  generated.seed = reader.Unsigned("--seed", 0);
  generated.relief_share = reader.Number("--relief-share", generated.relief_share);
  LoveDaOptions loveda;
  loveda.folder = ValueOf(command, "--loveda").value_or("");
  loveda.scenes =
      *FromName<LoveDaScenes>(reader.Choice("--loveda-scenes", NamesOf<LoveDaScenes>(), "rural"));
  ScenesOptions scenes;
  scenes.folder = ValueOf(command, "--scenes").value_or("");
  scenes.erosion = reader.Number("--erosion", scenes.erosion);
  GivenInstructionsOptions given;
  given.answers = reader.Whole("--answers", given.answers);
  given.leave_out = reader.Whole("--leave-out", given.leave_out);
  given.seed = generated.seed;
  // There is one source, and only its options are legal beside it.
  reader.AllowOneOf(
      {"--generate", "--loveda", "--scenes", "--instructions", "--environment-instructions"});
  const bool asked_of_environments = command.count("--environment-instructions") > 0;
  const char* const asked = asked_of_environments ? "--environment-instructions" : "--instructions";
  reader.RequireBeside("--answers", asked);
  reader.RequireBeside("--leave-out", asked);
  reader.RequireBeside("--relief-share", "--generate");
  reader.RequireBeside("--loveda-scenes", "--loveda");
  reader.RequireBeside("--erosion", "--scenes");
  // Asked before any folder is read, which takes longer.
  std::vector<Violation> violations = Validate(generated);
  for (Violation& violation : Validate(scenes)) violations.push_back(std::move(violation));
  for (Violation& violation : Validate(given)) violations.push_back(std::move(violation));
  LW_RETURN_IF_ERROR(Unusable(&reader, std::move(violations)));
  // The source is made from its options.
  if (const auto file = ValueOf(command, asked)) {
    LW_ASSIGN_OR_RETURN(std::vector<GivenInstruction> instructions, ReadGivenInstructions(*file));
    const std::string title = "Instructions of " + std::filesystem::path(*file).filename().string();
    return asked_of_environments ? MakeGivenEnvironmentSource(std::move(instructions), title, given)
                                 : MakeGivenSource(std::move(instructions), title, given);
  }
  if (command.count("--loveda") > 0) return MakeLoveDaSource(loveda);
  if (command.count("--scenes") > 0) return MakeScenesSource(scenes);
  if (command.count("--generate") > 0) return MakeGeneratedSource(generated);
  return InvalidArgument(
      "a source is missing; legal is --generate N, --loveda DIR, --scenes DIR, "
      "--instructions FILE, --environment-instructions FILE");
}

Result<std::unique_ptr<Annotator>> MakeDatasetAnnotator(const CLI::App& command, double size_m) {
  ArgumentReader reader(&command);
  const std::string name = reader.Choice("--annotator", {"written", "remote"}, "written");
  OpenAiOptions server = ReadServerOptions(command, &reader);
  for (const char* option : {"--remote-repair-turns", "--remote-temperature"}) {
    reader.RequireBeside(option, "--remote-url");
  }
  LW_RETURN_IF_ERROR(reader.status());
  const bool has_url = command.count("--remote-url") > 0;
  if ((name == "remote") != has_url)
    return InvalidArgument("--annotator remote and --remote-url belong together: one is missing");
  if (has_url && command.count("--facts") > 0)
    return InvalidArgument("--facts is the written annotator's; a model writes as it likes");
  if (has_url) return MakeRemote(command, std::move(server), size_m);
  if (const auto file = ValueOf(command, "--instructions")) {
    if (command.count("--facts") > 0)
      return InvalidArgument("--facts is the written annotator's; --instructions are given");
    LW_ASSIGN_OR_RETURN(std::vector<GivenInstruction> instructions, ReadGivenInstructions(*file));
    return MakeGivenAnnotator(std::move(instructions), size_m);
  }
  if (const auto file = ValueOf(command, "--environment-instructions")) {
    LW_ASSIGN_OR_RETURN(std::vector<GivenInstruction> instructions, ReadGivenInstructions(*file));
    LW_ASSIGN_OR_RETURN(const WrittenOptions written, ReadWritten(command, size_m));
    return MakeGivenEnvironmentAnnotator(std::move(instructions), written);
  }
  LW_ASSIGN_OR_RETURN(const WrittenOptions written, ReadWritten(command, size_m));
  return MakeWrittenAnnotator(written);
}

}  // namespace latticeworld::tools
