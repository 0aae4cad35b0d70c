// episode COMMAND BAG...: what an episode was, as text, tables and a picture. Needs no ROS master.
// docs/episodes.md.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/episode/episode_text.h"
#include "latticeworld/episode/track_picture.h"
#include "latticeworld_ros/episode/episode_reader.h"

namespace {

using latticeworld::EpisodeReader;
using latticeworld::EpisodeRecord;
using latticeworld::PictureOptions;
using latticeworld::Status;
using latticeworld::WriteFile;

constexpr int kFailure = 1;
constexpr int kUnusable = 2;

struct Arguments {
  std::vector<std::string> bags;
  std::string out;
  int width_px = 1200;
};

Status WriteTables(const EpisodeRecord& record, const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return latticeworld::PermissionDenied("cannot make " + directory.string() + ": " +
                                          error.message());
  }
  LW_RETURN_IF_ERROR(WriteFile(directory / "tracks.csv", latticeworld::TracksCsv(record)));
  LW_RETURN_IF_ERROR(WriteFile(directory / "events.csv", latticeworld::EventsCsv(record)));
  return WriteFile(directory / "metrics.csv", latticeworld::MetricsCsv(record));
}

Status DrawPicture(const EpisodeReader& reader, const EpisodeRecord& record,
                   const Arguments& arguments) {
  LW_ASSIGN_OR_RETURN(const auto world, reader.ReadWorld());
  PictureOptions options;
  options.width_px = arguments.width_px;
  LW_ASSIGN_OR_RETURN(const std::string png,
                      latticeworld::DrawTracks(*world->scene, record, options));
  return WriteFile(arguments.out, png);
}

Status Run(const std::string& command, const Arguments& arguments) {
  LW_ASSIGN_OR_RETURN(const auto reader, EpisodeReader::Open(std::vector<std::filesystem::path>(
                                             arguments.bags.begin(), arguments.bags.end())));
  LW_ASSIGN_OR_RETURN(const EpisodeRecord record, reader->ReadRecord());
  if (command == "summary") std::cout << latticeworld::SummaryOf(record);
  if (command == "metrics") std::cout << latticeworld::MetricsCsv(record);
  if (command == "csv") return WriteTables(record, arguments.out);
  if (command == "picture") return DrawPicture(*reader, record, arguments);
  return Status();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What a recorded episode was.");
  app.require_subcommand(1);
  Arguments arguments;
  const auto add = [&](const char* name, const char* text) {
    CLI::App* command = app.add_subcommand(name, text);
    command->add_option("BAG", arguments.bags, "The episode; of a split one, every part in order.")
        ->required();
    return command;
  };
  add("summary", "What was recorded, who was there and what happened, to read.");
  add("metrics", "A table of what every agent did, as CSV.");
  add("csv", "Writes tracks.csv, events.csv and metrics.csv.")
      ->add_option("--out", arguments.out, "The directory; made where there is none.")
      ->required();
  CLI::App* picture = add("picture", "Draws the ways that agents went on the map of the world.");
  picture->add_option("--out", arguments.out, "The PNG; an existing one is replaced.")->required();
  picture->add_option("--width", arguments.width_px, "Width, 64 to 4096 pixels [1200].")
      ->check(CLI::Range(64, 4096));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUnusable;
  }
  const Status status = Run(app.get_subcommands().front()->get_name(), arguments);
  if (status.ok()) return 0;
  std::cerr << "episode: " << status.ToString() << "\n";
  return kFailure;
}
