#include "latticeworld_ros/episode/episode_files.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <system_error>
#include <utility>

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr char kBag[] = ".bag";
constexpr char kActive[] = ".active";
constexpr char kPart[] = ".part";

bool Drop(std::string* text, const std::string& ending) {
  if (text->size() <= ending.size() ||
      text->compare(text->size() - ending.size(), ending.size(), ending) != 0) {
    return false;
  }
  text->resize(text->size() - ending.size());
  return true;
}

// "scout.part12" -> {"scout", 12}; "scout" -> {"scout", -1}.
std::pair<std::string, long> NameAndPart(const std::string& stem) {
  constexpr std::size_t kMostDigits = 9;
  const std::size_t dot = stem.rfind(kPart);
  if (dot == std::string::npos || dot == 0) return {stem, -1};
  const std::string digits = stem.substr(dot + std::strlen(kPart));
  const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
  if (digits.empty() || digits.size() > kMostDigits ||
      !std::all_of(digits.begin(), digits.end(), is_digit)) {
    return {stem, -1};
  }
  return {stem.substr(0, dot), std::stol(digits)};
}

struct Found {
  std::map<long, std::string> paths;  // by part
  std::uint64_t bytes = 0;
  bool complete = true;
};

}  // namespace

std::vector<latticeworld_msgs::Episode> EpisodesIn(const fs::path& directory) {
  std::map<std::string, Found> found;
  std::error_code error;
  fs::directory_iterator entries(directory, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    std::error_code ignored;
    if (!entries->is_regular_file(ignored)) continue;
    std::string stem = entries->path().filename().string();
    const bool active = Drop(&stem, kActive);
    if (!Drop(&stem, kBag)) continue;
    const auto [name, part] = NameAndPart(stem);
    Found& episode = found[name];
    episode.paths[part] = entries->path().string();
    const std::uintmax_t bytes = entries->file_size(ignored);
    if (!ignored) episode.bytes += bytes;
    episode.complete = episode.complete && !active;
  }
  std::vector<latticeworld_msgs::Episode> episodes;
  for (const auto& [name, one] : found) {
    latticeworld_msgs::Episode episode;
    episode.name = name;
    for (const auto& [part, path] : one.paths) episode.paths.push_back(path);
    episode.bytes = one.bytes;
    episode.complete = one.complete;
    episodes.push_back(std::move(episode));
  }
  return episodes;
}

std::vector<std::string> FilesOfEpisode(const fs::path& directory, const std::string& name) {
  for (const latticeworld_msgs::Episode& episode : EpisodesIn(directory)) {
    if (episode.name == name) return episode.paths;
  }
  return {};
}

}  // namespace latticeworld
