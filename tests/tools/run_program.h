#ifndef LATTICEWORLD_TESTS_TOOLS_RUN_PROGRAM_H_
#define LATTICEWORLD_TESTS_TOOLS_RUN_PROGRAM_H_

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace latticeworld {

struct ProgramRun {
  int exit_status = -1;  // -1: ended by a signal or not started
  std::string out;
  std::string err;
};

struct RunOptions {
  long max_file_bytes = -1;  // limit on the size of a file that it writes; -1: none
  int signal = 0;            // sent once the program has said something on stderr; 0: none
  std::string out_path;      // where its standard output goes; "": to ProgramRun::out
};

// Runs `latticeworld` with these arguments and waits for its end.
ProgramRun RunProgram(const std::vector<std::string>& arguments, const RunOptions& options = {});

// A test with a directory of its own, removed at its end.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  std::string PathOf(const std::string& name) const { return (directory_ / name).string(); }
  void Write(const std::string& name, const std::string& content) const;
  std::string Read(const std::string& name) const;
  std::vector<std::string> Entries() const;  // names in the directory, hidden ones too

 private:
  std::filesystem::path directory_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_TOOLS_RUN_PROGRAM_H_
