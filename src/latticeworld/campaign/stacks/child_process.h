#ifndef LATTICEWORLD_CAMPAIGN_STACKS_CHILD_PROCESS_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_CHILD_PROCESS_H_

#include <signal.h>
#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// How a process ended.
struct ProcessEnd {
  int exit_status = -1;  // -1: by a signal
  int signal = 0;
  std::string ToString() const;  // "ended with status 3", "was ended by signal 11"
};

struct ChildOptions {
  std::filesystem::path folder;  // that it runs in; empty: this one
  bool own_group = false;        // with all that it starts, so that they can be ended together
  int death_signal = SIGKILL;    // that it gets when this process ends, however it does
};

// A process that is spoken to over its standard input and output.
struct ChildProcess {
  pid_t pid = 0;
  int in = -1, out = -1;  // ends of pipes: to its input, from its output; the caller's to close
};

// command: the program (a path, or a name that PATH has) and its arguments. A program that cannot
// be run ends with status 127. Errors: RESOURCE_EXHAUSTED.
Result<ChildProcess> StartChild(const std::vector<std::string>& command,
                                const ChildOptions& options = {});

// Whether StartChild can run it: a program with a "/" is a path, from that folder where it is
// relative, and any other is looked for in PATH.
bool IsProgram(const std::string& program, const std::filesystem::path& folder);

// Writes like write(), but raises no signal when nobody reads any more: then it fails with errno
// EPIPE.
ssize_t WriteQuietly(int descriptor, const char* data, std::size_t size);

// What waitpid told.
ProcessEnd EndOf(int wait_status);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_CHILD_PROCESS_H_
