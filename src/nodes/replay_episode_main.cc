// replay_episode BAG...: proves that an episode is what its world, seed and commands come to, or
// plays it. Needs no ROS master to prove. docs/episodes.md.

#include <ros/ros.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "latticeworld/episode/journal_json.h"
#include "latticeworld/episode/replay.h"
#include "latticeworld_ros/episode/episode_player.h"
#include "latticeworld_ros/episode/episode_reader.h"
#include "latticeworld_ros/node/node_start.h"

namespace {

using latticeworld::Divergence;
using latticeworld::EpisodeReader;
using latticeworld::Progress;
using latticeworld::RecordedSteps;
using latticeworld::ReplayReport;
using latticeworld::Result;
using latticeworld::Status;

constexpr int kFailure = 1;
constexpr int kUnusable = 2;

std::atomic<Progress*> to_cancel{nullptr};

int Fail(const Status& status) {
  std::cerr << "replay_episode: " << status.ToString() << "\n";
  return kFailure;
}

void Print(const Divergence& divergence) {
  std::cout << "DIFFERS at step " << divergence.recorded.step << " (after call "
            << divergence.recorded.calls << ")\n";
  if (divergence.failure.empty()) {
    std::cout << "  recorded   " << divergence.recorded.state_hash << "\n"
              << "  simulated  " << divergence.state_hash << "\n";
  } else {
    std::cout << "  " << divergence.failure << "\n";
  }
  if (divergence.last_agreed) {
    std::cout << "  the states agreed until step " << divergence.last_agreed->step << "\n";
  } else {
    std::cout << "  no state before it agreed\n";
  }
}

// steps: gets those that are recorded.
Result<ReplayReport> VerifyOrFail(const EpisodeReader& reader, const Progress& progress,
                                  RecordedSteps* steps) {
  LW_ASSIGN_OR_RETURN(const auto world, reader.ReadWorld());
  LW_ASSIGN_OR_RETURN(const auto options,
                      latticeworld::DecodeSimulatorOptions(reader.start().options));
  std::vector<std::string> warnings;
  LW_ASSIGN_OR_RETURN(const auto plan, reader.ReadPlan(&warnings));
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << "\n";
  *steps = plan.steps;
  return latticeworld::Replay(world->scene, options, plan, progress);
}

int Verify(const EpisodeReader& reader) {
  Progress progress;
  to_cancel = &progress;
  std::signal(SIGINT, [](int) {
    if (Progress* one = to_cancel.load()) one->Cancel();
  });
  const auto begin = std::chrono::steady_clock::now();
  RecordedSteps steps;
  const Result<ReplayReport> report = VerifyOrFail(reader, progress, &steps);
  to_cancel = nullptr;
  if (!report.ok()) return Fail(report.status());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cout << "episode " << reader.start().name << " in " << reader.start().world_id << ", seed "
            << reader.start().seed << "\n";
  std::printf("simulated %llu steps with %llu calls in %.1f s\n",
              static_cast<unsigned long long>(report->steps),
              static_cast<unsigned long long>(report->calls), seconds);
  std::fflush(stdout);
  if (report->divergence) {
    Print(*report->divergence);
    return kFailure;
  }
  std::cout << latticeworld::ProofText(*report, steps) << "\n";
  return latticeworld::IsProven(*report, steps) ? 0 : kFailure;
}

int Play(const EpisodeReader& reader, double rate, int argc, char** argv) {
  ros::init(argc, argv, "replay_episode", ros::init_options::AnonymousName);
  if (!ros::master::check()) {
    return Fail(latticeworld::Unavailable("there is no ROS master; roscore starts one"));
  }
  // Nobody waits for a clock that this program tells.
  ros::param::set("/use_sim_time", true);
  latticeworld::PrepareNode();
  ros::Time::init();
  ros::NodeHandle node;
  const Status played = PlayEpisode(node, reader, rate);
  if (!played.ok()) return Fail(played);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Proves that a recorded episode is what its world, seed and commands come to, or "
      "plays it.");
  std::vector<std::string> bags;
  bool verify = false, play = false;
  double rate = 1.0;
  app.add_option("BAG", bags, "The episode; of a split one, every part in order.")->required();
  auto* verify_flag = app.add_flag("--verify", verify,
                                   "Simulate it again and compare every recorded state [this].");
  auto* play_flag = app.add_flag("--play", play, "Publish what was recorded, the clock too.");
  verify_flag->excludes(play_flag);
  app.add_option("--rate", rate, "Of --play: recorded over wall time, 0.01 to 1000 [1].")
      ->needs(play_flag)
      ->check(CLI::Range(0.01, 1000.0));
  // What roslaunch adds is no bag.
  std::vector<std::string> arguments;
  for (int i = argc - 1; i > 0; --i) {
    const std::string argument = argv[i];
    if (argument.rfind("__", 0) != 0 && argument.find(":=") == std::string::npos) {
      arguments.push_back(argument);
    }
  }
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUnusable;
  }
  const auto reader =
      EpisodeReader::Open(std::vector<std::filesystem::path>(bags.begin(), bags.end()));
  if (!reader.ok()) return Fail(reader.status());
  return play ? Play(**reader, rate, argc, argv) : Verify(**reader);
}
