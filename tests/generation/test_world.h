#ifndef LATTICEWORLD_TESTS_GENERATION_TEST_WORLD_H_
#define LATTICEWORLD_TESTS_GENERATION_TEST_WORLD_H_

#include <filesystem>
#include <memory>
#include <string>

#include "latticeworld/generation/world.h"

namespace latticeworld {

// A small world made by hand, 32 m at 0.5 m (64 x 64 cells): rolling ground, a lake, a wood in the
// upper left, assets of every kind, two sheep and a robot, a claim, a warning and a picture.
std::shared_ptr<World> MakeTestWorld();

// A binary PGM of a slope from black (west) to white (east).
std::string MakePgm(int rows, int cols);

// Every field of two worlds is the same, floats bit for bit (NaN is NaN).
void ExpectSameWorld(const World& a, const World& b);

// A directory of its own for one test, removed at its end.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }
  // Names of what is in it, hidden ones too.
  std::vector<std::string> Entries() const;

 private:
  std::filesystem::path path_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_GENERATION_TEST_WORLD_H_
