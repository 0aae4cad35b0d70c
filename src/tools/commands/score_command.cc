#include "tools/commands/score_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_claims_json.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/generation/fidelity/fidelity.h"
#include "latticeworld/generation/fidelity/fidelity_benchmark.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/layout/claims/claims_json.h"
#include "tools/arguments.h"
#include "tools/fidelity_tables.h"
#include "tools/interrupt.h"
#include "tools/language_arguments.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

constexpr std::size_t kMaxLayoutBytes = 64u << 10;
constexpr std::size_t kMaxClaimsBytes = 1u << 20;

// The text of a file that an option names; "" without the option.
Result<std::string> FileOf(const CLI::App& command, const std::string& option) {
  const std::optional<std::string> path = ValueOf(command, option);
  if (!path) return std::string();
  const auto text = ReadFile(*path, kMaxClaimsBytes);
  if (!text.ok()) return text.status().WithContext(option);
  return *text;
}

// A world against claims that somebody wrote down, whatever its words were read as.
Status ScoreByClaims(const CLI::App& command, const World& world) {
  LW_ASSIGN_OR_RETURN(const std::string layout_text, FileOf(command, "--claims"));
  LW_ASSIGN_OR_RETURN(const std::string environment_text, FileOf(command, "--environment-claims"));
  LayoutReading layout;
  if (!layout_text.empty()) {
    auto claims = DecodeClaims(layout_text, world.layout.vocabulary);
    if (!claims.ok()) return claims.status().WithContext("--claims");
    layout.plan.claims = *std::move(claims);
  }
  FidelityReport report = AssessLayoutFidelity(layout, world.layout);
  if (!environment_text.empty()) {
    const auto claims = ParseEnvironmentClaims(environment_text);
    if (!claims.ok()) return claims.status().WithContext("--environment-claims");
    for (const EnvironmentClaim& claim : *claims) {
      report.claims.push_back(OutcomeOf(claim, world.environment));
    }
  }
  PrintReport(report, &std::cout);
  return Status();
}

Status ScoreBundle(const CLI::App& command, const std::string& directory) {
  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(directory));
  if (command.count("--claims") + command.count("--environment-claims") > 0) {
    return ScoreByClaims(command, *world);
  }
  // The reader that read the instructions then reads them again, with the replies that it had.
  const LanguageStack language = MakeReplayStack(world->replies);
  LW_ASSIGN_OR_RETURN(
      const FidelityReport report,
      ReadAndAssess(language.readers.at(world->request.reader).get(),
                    world->request.layout_instruction, world->request.environment_instruction,
                    world->request.things, world->layout, *world->scene));
  PrintReport(report, &std::cout);
  return Status();
}

// A layout of any origin against the words that asked for it.
Status ScoreSymbols(const CLI::App& command) {
  ArgumentReader arguments(&command);
  arguments.RequireBeside("--symbols", "--layout");
  const std::string named = arguments.Choice("--vocabulary", {"suburb", "wild"}, "");
  LW_RETURN_IF_ERROR(arguments.status());
  LW_ASSIGN_OR_RETURN(const std::string instruction, TextOf(command, "--layout"));
  LW_RETURN_IF_ERROR(ValidateText("--layout", instruction, kMaxInstructionBytes));
  const Vocabulary vocabulary =
      named.empty() ? ChooseVocabulary(instruction) : *FromName<Vocabulary>(named);
  const auto text = ReadFile(*ValueOf(command, "--symbols"), kMaxLayoutBytes);
  if (!text.ok()) return text.status().WithContext("--symbols");
  const auto layout = ParseLayout(*text, vocabulary);
  if (!layout.ok()) return layout.status();
  PrintReport(AssessLayoutFidelity(ReadLayoutInstruction(instruction, vocabulary), *layout),
              &std::cout);
  return Status();
}

// The one of a stack's readers or generators that an option names.
template <typename Value>
Result<typename std::map<std::string, Value>::iterator> Named(
    const char* option, const CLI::App& command, const std::string& otherwise,
    std::map<std::string, Value>* by_name) {
  const std::string name = ValueOf(command, option).value_or(otherwise);
  const auto found = by_name->find(name);
  if (found != by_name->end()) return found;
  std::vector<std::string> names;
  for (const auto& [legal, value] : *by_name) names.push_back(legal);
  return InvalidArgument(std::string(option) + ": is " + Quote(name) + "; legal are " +
                         Join(names, ", ") +
                         "; others need --reader-model, --local-model or --remote-url");
}

Status ScoreBenchmark(const CLI::App& command) {
  ArgumentReader arguments(&command);
  const std::string part_name =
      arguments.Choice("--part", {"development", "test", "first_sight"}, "development");
  const std::uint64_t seed = arguments.Unsigned("--seed", 1);
  const std::uint64_t most = arguments.Unsigned("--most", 1000000);
  LW_RETURN_IF_ERROR(arguments.status());
  LW_ASSIGN_OR_RETURN(LanguageStack language, LoadLanguage(command));
  LW_ASSIGN_OR_RETURN(const auto reader,
                      Named("--reader", command, language.default_reader, &language.readers));
  LW_ASSIGN_OR_RETURN(
      const auto generator,
      Named("--generator", command, language.default_generator, &language.generators));
  const std::optional<std::string> examples = ValueOf(command, "--examples");
  LW_ASSIGN_OR_RETURN(const FidelityBenchmark benchmark,
                      examples ? ReadReaderExamples(*examples, most)
                               : ReadFidelityBenchmark(*ValueOf(command, "--benchmark"),
                                                       *FromName<BenchmarkPart>(part_name)));

  ProgressDisplay display;
  // What the generators say of a single answer is not shown.
  Progress progress([&display](std::string_view stage, double fraction) {
    if (stage == "layouts" || stage == "environments") display.Show(stage, fraction);
  });
  const CancelOnInterrupt cancel_on_interrupt(&progress);
  auto layouts = ScoreLayouts(benchmark.layouts, seed, reader->second.get(),
                              generator->second.layout.get(), progress);
  auto environments = layouts.ok()
                          ? ScoreEnvironments(benchmark.environments, seed, reader->second.get(),
                                              generator->second.environment.get(), progress)
                          : layouts.status();
  display.Clear();
  if (!environments.ok()) return environments.status();
  const std::string what = examples ? *examples : part_name + " part";
  const std::string ending =
      ", " + what + ", read by " + reader->first + ", answered by " + generator->first;
  const auto print = [&](const std::string& kind, const FidelityScore& score) {
    PrintScore(kind + " instructions" + ending, score, &std::cout);
    if (command.count("--misses") > 0) PrintMisses(score, &std::cout);
    if (command.count("--warnings") > 0) PrintWarnings(score, &std::cout);
    if (command.count("--evidence") > 0) PrintEvidence(score, &std::cout);
  };
  print("layout", *layouts);
  print("environment", *environments);
  return Status();
}

Status Score(const CLI::App& command) {
  const auto bundle = ValueOf(command, "DIR");
  const bool symbols = ValueOf(command, "--symbols").has_value();
  const bool benchmark = ValueOf(command, "--benchmark").has_value();
  const bool examples = ValueOf(command, "--examples").has_value();
  if (bundle.has_value() + symbols + benchmark + examples != 1) {
    return InvalidArgument("give one of a bundle, --symbols, --benchmark and --examples");
  }
  if (bundle) return ScoreBundle(command, *bundle);
  return symbols ? ScoreSymbols(command) : ScoreBenchmark(command);
}

}  // namespace

void AddScoreCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "score", "Says how well a bundle, a layout or a back end matches the words.");
  AddValueOption(command, "DIR", "DIR", "A bundle: measured by its own instructions.");
  AddValueOption(
      command, "--claims", "FILE",
      "Beside DIR: claims on its layout, an array as in benchmarks/fidelity, in the place "
      "of what is read in its instructions.");
  AddValueOption(command, "--environment-claims", "FILE", "The same on its environment.");
  AddValueOption(command, "--symbols", "FILE",
                 "A layout, 32 lines of 32 letters: measured by the words of --layout.");
  AddValueOption(command, "--layout", "TEXT", "Those words; @FILE reads them from a file.");
  AddValueOption(command, "--vocabulary", "NAME", "suburb or wild. Without it the words decide.");
  AddValueOption(command, "--benchmark", "DIR",
                 "A benchmark, such as benchmarks/fidelity: a back end answers its instructions, "
                 "and the claims written down for them are measured.");
  AddValueOption(
      command, "--examples", "FILE",
      "Examples for readers, JSON Lines as in training/examples: the same, by the claims "
      "of their sentences.");
  AddValueOption(command, "--most", "N", "Beside --examples: the first N of them [all].");
  AddValueOption(command, "--part", "NAME", "development, test or first_sight [development].");
  AddValueOption(command, "--seed", "N", "What the answers are drawn from [1].");
  command->add_flag("--misses", "Also lists every claim that is not satisfied.");
  command->add_flag("--warnings",
                    "Beside --benchmark and --examples: also lists every warning of an answer.");
  command->add_flag(
      "--evidence",
      "Beside --benchmark and --examples, where a model reads: also lists what is known of "
      "its reading of each text and of that of the rules.");
  AddLanguageOptions(command);
  command->callback([command, exit_status] {
    const Status status = Score(*command);
    if (!status.ok()) *exit_status = ReportFailure("score", status);
  });
}

}  // namespace latticeworld::tools
