// Runs a fuzz target, without libFuzzer, on every file of its corpus and on damaged copies of each.
// Usage: fuzz_TARGET CORPUS_DIRECTORY DAMAGED_COPIES
//        fuzz_TARGET FILE
// The copies are the same in every run. Where an input ends the program, it is left in the working
// directory as finding-TARGET, and its name and its copy's number are told.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "fuzz/support/damage.h"

namespace {

namespace fs = std::filesystem;

// What an input may make a reader allocate, the program's own included.
constexpr rlim_t kMostAddressSpace = rlim_t{6} << 30;

std::string current_input;
std::string finding_file;
char what_runs[512];  // "scene.json, damaged copy 17"

// Writes down the input that ended the program. Only async-signal-safe functions are called.
void OnFatalSignal(int signal) {
  const int file = open(finding_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0) {
    (void)!write(file, current_input.data(), current_input.size());
    close(file);
  }
  constexpr char kText[] = "ended within: ";
  (void)!write(STDERR_FILENO, kText, sizeof(kText) - 1);
  (void)!write(STDERR_FILENO, what_runs, std::char_traits<char>::length(what_runs));
  (void)!write(STDERR_FILENO, "\n", 1);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void Run(const std::string& input) {
  current_input = input;
  // A copy of exactly its size on the heap, so that checkers of memory see what reads beyond it.
  const std::vector<std::uint8_t> bytes(input.begin(), input.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

struct CorpusFile {
  std::string name;
  std::string bytes;
};

// The files of a folder, or the one file, sorted by name.
std::vector<CorpusFile> ReadCorpus(const fs::path& path) {
  std::vector<fs::path> paths;
  if (fs::is_directory(path)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
      paths.push_back(entry.path());
    }
  } else {
    paths.push_back(path);
  }
  std::sort(paths.begin(), paths.end());
  std::vector<CorpusFile> files;
  for (const fs::path& file : paths) {
    std::ifstream stream(file, std::ios::binary);
    files.push_back({file.filename().string(), std::string(std::istreambuf_iterator<char>(stream),
                                                           std::istreambuf_iterator<char>())});
  }
  return files;
}

// The same for a name on every machine (FNV-1a).
std::uint64_t SeedOf(const std::string& name) {
  std::uint64_t seed = 14695981039346656037u;
  for (const char letter : name) {
    seed = (seed ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  }
  return seed;
}

void LimitMemory() {
#ifndef __SANITIZE_ADDRESS__  // which takes terabytes of addresses for itself
  const rlimit limit{kMostAddressSpace, kMostAddressSpace};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

// On a stack of their own, for the usual one may have run out.
void HandleFatalSignals() {
  static char memory[1 << 16];
  stack_t stack{};
  stack.ss_sp = memory;
  stack.ss_size = sizeof(memory);
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = OnFatalSignal;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGTERM}) {
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int copies = argc > 2 ? std::atoi(argv[2]) : 0;
  if (argc < 2 || copies < 0) {
    std::fprintf(stderr, "usage: %s CORPUS_DIRECTORY|FILE [DAMAGED_COPIES]\n", argv[0]);
    return 2;
  }
  const std::vector<CorpusFile> corpus = ReadCorpus(argv[1]);
  if (corpus.empty()) {
    std::fprintf(stderr, "%s is empty: a target without inputs tests nothing\n", argv[1]);
    return 1;
  }
  std::vector<std::string> inputs;
  for (const CorpusFile& file : corpus) inputs.push_back(file.bytes);
  finding_file = "finding-" + fs::path(argv[0]).filename().string();
  LimitMemory();
  HandleFatalSignals();
  for (const CorpusFile& file : corpus) {
    std::snprintf(what_runs, sizeof(what_runs), "%s", file.name.c_str());
    Run(file.bytes);
    const std::uint64_t seed = SeedOf(file.name);
    for (int copy = 0; copy < copies; ++copy) {
      std::snprintf(what_runs, sizeof(what_runs), "%s, damaged copy %d", file.name.c_str(), copy);
      Run(latticeworld::fuzz::Damaged(file.bytes, inputs, seed + static_cast<unsigned>(copy)));
    }
  }
  std::printf("%zu inputs, each and %d damaged copies of it\n", corpus.size(), copies);
  return 0;
}
