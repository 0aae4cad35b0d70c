// Writes seeds of the fuzz targets: DIRECTORY/<target>/<name>, beside what is there already. Seeds
// that are written by hand, or that were found, stand in the corpus alone.
// Usage: write_fuzz_seeds DIRECTORY

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "fuzz/seeds/seeds.h"

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  namespace fuzz = latticeworld::fuzz;
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s DIRECTORY\n", argv[0]);
    return 2;
  }
  const fs::path directory = argv[1];
  int written = 0;
  const fuzz::TakeSeed take = [&](const std::string& target, const std::string& name,
                                  const std::string& bytes) {
    fs::create_directories(directory / target);
    std::ofstream(directory / target / name, std::ios::binary) << bytes;
    ++written;
  };
  fuzz::LanguageSeeds(take);
  fuzz::ReliefSeeds(take);
  fuzz::WorldSeeds(take);
  fuzz::RosSeeds(take);
  std::printf("%d seeds\n", written);
  return 0;
}
