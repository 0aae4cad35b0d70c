#include "latticeworld/dataset/writing/data_card.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFailuresInCard = 20;

std::string_view NameOfTask(std::size_t task) { return NameOf(static_cast<DatasetTask>(task)); }

std::uint64_t SumBelow(const DatasetTallies& tallies, const std::string& prefix) {
  std::uint64_t sum = 0;
  for (auto it = tallies.lower_bound(prefix); it != tallies.end(); ++it) {
    if (!StartsWith(it->first, prefix)) break;
    sum += it->second;
  }
  return sum;
}

// "12.3 %"
std::string Share(std::uint64_t part, std::uint64_t whole) {
  const double percent = whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / whole;
  return FormatDouble(static_cast<double>(static_cast<int>(percent * 10.0 + 0.5)) / 10.0) + " %";
}

// "| name | 12 | 3.4 % |" for each tally below the prefix.
std::string TableOf(const DatasetTallies& tallies, const std::string& prefix,
                    const std::string& title) {
  const std::uint64_t sum = SumBelow(tallies, prefix);
  if (sum == 0) return "";
  std::string table = "| " + title + " | count | share |\n|---|---|---|\n";
  for (auto it = tallies.lower_bound(prefix); it != tallies.end(); ++it) {
    if (!StartsWith(it->first, prefix)) break;
    table += "| " + it->first.substr(prefix.size()) + " | " + std::to_string(it->second) + " | " +
             Share(it->second, sum) + " |\n";
  }
  return table + "\n";
}

std::string ClassTable(const DatasetTallies& tallies, Vocabulary vocabulary) {
  const std::string name(NameOf(vocabulary));
  const std::string prefix = "cells/" + name + "/";
  const std::uint64_t sum = SumBelow(tallies, prefix);
  if (sum == 0) return "";
  std::string table = "| letter | " + name + " class | share of the cells |\n|---|---|---|\n";
  for (const LayoutClass& entry : ClassesOf(vocabulary)) {
    table += std::string("| ") + entry.letter + " | " + std::string(entry.name) + " | " +
             Share(TallyOf(tallies, prefix + entry.letter), sum) + " |\n";
  }
  return table + "\n";
}

std::string LengthLine(const DatasetFacts& facts, std::size_t task) {
  const std::string name(NameOfTask(task));
  const std::uint64_t records = SumBelow(facts.tallies, "records/" + name + "/");
  if (records == 0) return "";
  const std::string prefix = "length/" + name + "/";
  auto last = facts.tallies.upper_bound(prefix + "~");
  std::string longest = std::prev(last)->first.substr(prefix.size());
  const std::uint64_t mean = TallyOf(facts.tallies, "bytes/" + name) / records;
  return "| " + name + " | " + std::to_string(records) + " | " + std::to_string(mean) +
         " | less than " + std::to_string(std::stoul(longest) + 100) + " |\n";
}

// The size category of the Hub.
std::string SizeCategory(std::uint64_t records) {
  constexpr std::pair<std::uint64_t, const char*> kCategories[] = {
      {1000, "n<1K"}, {10000, "1K<n<10K"}, {100000, "10K<n<100K"}, {1000000, "100K<n<1M"}};
  for (const auto& [end, name] : kCategories) {
    if (records < end) return name;
  }
  return "1M<n<10M";
}

// Text that comes from outside, such as a file's name, as words of Markdown: no line, no tag and no
// mark of its own.
std::string Plain(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      plain += ' ';
      continue;
    }
    if (std::string_view("\\`*<>[]|&").find(c) != std::string_view::npos) plain += '\\';
    plain += c;
  }
  return plain;
}

// A YAML string that needs no thought: in double quotes, as JSON writes it.
std::string Quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string FrontMatter(const DatasetFacts& facts) {
  const std::string& licence = facts.source.licence;
  std::string yaml = "---\npretty_name: " + Quoted("LatticeWorld " + facts.source.name) + "\n";
  if (licence.empty()) {
    yaml += "license: unknown\n";
  } else {
    yaml += "license: " + Quoted(ToLowerAscii(licence)) + "\n";
  }
  yaml += "language:\n- en\ntask_categories:\n- text-generation\n";
  if (!facts.image_sums_sha256.empty()) yaml += "- image-to-text\n";
  yaml += "tags:\n- robotics\n- simulation\n- terrain\n- layout\n";
  yaml += "size_categories:\n- " + SizeCategory(SumBelow(facts.tallies, "records/")) + "\n";
  yaml += "configs:\n";
  for (std::size_t task = 0; task < kDatasetTasks; ++task) {
    std::string files;
    for (const DatasetFile& file : facts.files) {
      if (file.task != static_cast<DatasetTask>(task)) continue;
      files += "  - split: " + std::string(NameOf(file.split)) + "\n    path: " + file.path + "\n";
    }
    if (files.empty()) continue;
    yaml += "- config_name: " + std::string(NameOfTask(task)) + "\n  data_files:\n" + files;
  }
  return yaml + "---\n\n";
}

std::string FileTable(const DatasetFacts& facts) {
  std::string table = "| file | records | bytes | SHA-256 |\n|---|---|---|---|\n";
  for (const DatasetFile& file : facts.files) {
    table += "| `" + file.path + "` | " + std::to_string(file.records) + " | " +
             std::to_string(file.bytes) + " | `" + file.sha256.substr(0, 16) + "...` |\n";
  }
  return table + "\n";
}

std::string HowMade(const DatasetFacts& facts) {
  std::string text = "## How it was made\n\n" + Plain(facts.source.title) +
                     ". Words by the annotator \"" + Plain(facts.annotator) +
                     "\", which writes an instruction for a layout that there is; every claim of a "
                     "layout's instruction was measured on that layout and holds (they stand in "
                     "the records as `claims`).";
  if (facts.options.environment) {
    text +=
        " Environments: season, weather, hour, style and agents are drawn so that every value "
        "comes up, the rest follows by the rules of the program, and a description is written "
        "for what came out.";
  }
  text += "\n\nLatticeWorld " + facts.version + ", seed " + std::to_string(facts.options.seed) +
          ". The same command gives the same bytes";
  if (facts.annotator != "written") text += ", but for what the model answers";
  text += facts.command.empty() ? ".\n\n" : ":\n\n    " + facts.command + "\n\n";
  return text;
}

std::string Limits(const DatasetFacts& facts) {
  std::string text =
      "## Limits\n\n- The instructions are English and were written by a program"
      " for layouts that there were; people ask for other things in other words.\n"
      "- A layout has 32 x 32 cells and one class a cell. Roads and rivers are one cell wide or "
      "more, however narrow they are.\n";
  if (facts.source.name == "generated")
    text +=
        "- The places are laid out by a program from random plans. Their classes, shapes and "
        "shares are not those of the earth.\n";
  if (facts.options.layouts == LayoutsBy::kGrounded)
    text +=
        "- Layouts are the embedded generator's answers to the instructions, not the places that "
        "these were written for.\n";
  if (TallyOf(facts.tallies, "relief") < SumBelow(facts.tallies, "instances/"))
    text += "- Places without a relief are scenes of fixed height.\n";
  if (facts.options.prompts == PromptForm::kShort)
    text += "- The records leave the system message out.\n";
  return text + "\n";
}

std::string Failures(const DatasetFacts& facts) {
  if (facts.failed.empty()) return "";
  const std::size_t count = facts.failed.size();
  std::string text = "## Left out\n\n" + std::to_string(count) +
                     (count == 1 ? " group or instance" : " groups or instances") +
                     " could not be used; `dataset.json` names all.\n\n";
  for (std::size_t i = 0; i < std::min(count, kMostFailuresInCard); ++i) {
    const FailedInstance& failed = facts.failed[i];
    text += "- " + Plain(failed.instance.empty() ? failed.group : failed.instance) + ": " +
            Plain(Quote(failed.reason, 300)) + "\n";
  }
  return text + "\n";
}

}  // namespace

std::uint64_t TallyOf(const DatasetTallies& tallies, const std::string& key) {
  const auto found = tallies.find(key);
  return found == tallies.end() ? 0 : found->second;
}

std::string ManifestJson(const DatasetFacts& facts) {
  const DatasetOptions& options = facts.options;
  // Every file is listed with its checksum, and every instance that failed with its reason.
  Json files = Json::array();
  for (const DatasetFile& file : facts.files) {
    files.push_back({{"path", file.path},
                     {"task", NameOf(file.task)},
                     {"split", NameOf(file.split)},
                     {"records", file.records},
                     {"bytes", file.bytes},
                     {"sha256", file.sha256}});
  }
  Json failed = Json::array();
  for (const FailedInstance& instance : facts.failed) {
    failed.push_back(
        {{"group", instance.group}, {"instance", instance.instance}, {"reason", instance.reason}});
  }
  // The rest says what the data were made from, by whom and with which options.
  Json manifest = {{"format", "latticeworld data set"},
                   {"format_version", 1},
                   {"version", facts.version},
                   {"source",
                    {{"name", facts.source.name},
                     {"title", facts.source.title},
                     {"licence", facts.source.licence},
                     {"citation", facts.source.citation},
                     {"groups", facts.groups}}},
                   {"annotator", facts.annotator},
                   {"options",
                    {{"seed", options.seed},
                     {"layout", options.layout},
                     {"environment", options.environment},
                     {"images", options.images},
                     {"prompts", NameOf(options.prompts)},
                     {"layouts", NameOf(options.layouts)},
                     {"train_share", options.train_share},
                     {"validation_share", options.validation_share},
                     {"sketch_share", options.sketch_share},
                     {"size_m", options.size_m},
                     {"groups_per_part", options.groups_per_part}}},
                   {"files", std::move(files)},
                   {"images_sha256", facts.image_sums_sha256},
                   {"counts", facts.tallies},
                   {"failed", std::move(failed)}};
  return manifest.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string DataCard(const DatasetFacts& facts) {
  const DatasetTallies& tallies = facts.tallies;
  const std::uint64_t instances = SumBelow(tallies, "instances/");
  std::string card = FrontMatter(facts);
  card += "# LatticeWorld data set: " + facts.source.name + "\n\n" + std::to_string(instances) +
          " places of 32 x 32 symbols with instructions in English, for models that turn words "
          "into layouts and environments. " +
          std::to_string(TallyOf(tallies, "relief")) + " of them have a relief. " +
          std::to_string(SumBelow(tallies, "groups/")) + " of " + std::to_string(facts.groups) +
          " groups of the source are in it; a group, which is a source image with all that was "
          "cut from it, is in one split only.\n\n";
  card +=
      "A record is one line of JSON: `messages` (system, user, assistant) are what LatticeWorld "
      "sends to a model and what it should answer; `images` are paths of the height map and the "
      "sketch, if any (heights [m] = `height_offset_m` + `height_scale_m` * value / 65535); `id`, "
      "`group`, `vocabulary`, and for layouts `claims`.\n\n";
  card += "## Files\n\n" + FileTable(facts);
  if (!facts.image_sums_sha256.empty())
    card += std::to_string(TallyOf(tallies, "images")) +
            " images; `sha256sum -c images.sha256` checks them.\n\n";
  card += "## What is in it\n\n";
  card += "| task | records | bytes of what is said, mean | longest |\n|---|---|---|---|\n";
  for (std::size_t task = 0; task < kDatasetTasks; ++task) card += LengthLine(facts, task);
  card += "\n" + TableOf(tallies, "vocabulary/", "vocabulary");
  for (const auto& entry : EnumNames(Vocabulary{})) card += ClassTable(tallies, entry.value);
  card += TableOf(tallies, "claims/", "claim in a layout's instruction");
  card += TableOf(tallies, "season/", "season") + TableOf(tallies, "weather/", "weather");
  card += TableOf(tallies, "time_of_day/", "time of day") + TableOf(tallies, "style/", "style");
  card += TableOf(tallies, "species/", "agent");
  card += HowMade(facts);
  card += "## Licence\n\n" + (facts.source.licence.empty()
                                  ? std::string("Of the images: not known to the program; "
                                                "ask whoever they come from.")
                                  : Plain(facts.source.licence) + ".");
  card +=
      facts.source.citation.empty() ? "\n\n" : " Cite: " + Plain(facts.source.citation) + "\n\n";
  return card + Limits(facts) + Failures(facts);
}

}  // namespace latticeworld
