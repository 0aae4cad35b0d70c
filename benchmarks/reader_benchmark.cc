// How long a model that reads takes for instructions of 50 to 70 words, and its memory.
// Usage: reader_benchmark READER.gguf EXAMPLES.jsonl... (training/examples)

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/generation/fidelity/fidelity_benchmark.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/reading/model_reader.h"

namespace latticeworld {
namespace {

constexpr std::ptrdiff_t kLeastWords = 50, kMostWords = 70;
constexpr std::size_t kMostTexts = 60;  // of each kind

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Of this process, resident [MB].
double MemoryMegabytes() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0.0;
  statm >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

bool IsLongEnough(const std::string& text) {
  const std::ptrdiff_t words = 1 + std::count(text.begin(), text.end(), ' ');
  return words >= kLeastWords && words <= kMostWords;
}

void Tell(const char* kind, const std::vector<double>& seconds) {
  std::printf("%-12s %3zu texts: median %.2f s, 95th percentile %.2f s, longest %.2f s\n", kind,
              seconds.size(), Quantile(seconds, 0.5), Quantile(seconds, 0.95),
              Quantile(seconds, 1.0));
}

int Run(int argc, char** argv) {
  FidelityBenchmark texts;
  for (int i = 2; i < argc; ++i) {
    FidelityBenchmark more = ReadReaderExamples(argv[i], 1000000).value();
    for (LayoutItem& item : more.layouts) texts.layouts.push_back(std::move(item));
    for (EnvironmentItem& item : more.environments) texts.environments.push_back(std::move(item));
  }
  const double before = MemoryMegabytes();
  const Clock::time_point begin = Clock::now();
  const auto reader = MakeModelReader(MakeLocalChatServer(argv[1], /*threads=*/0).value());
  std::printf("loaded in %.2f s\n", SecondsSince(begin));
  std::vector<ModelReply> replies;
  std::vector<double> layouts, environments;
  for (const LayoutItem& item : texts.layouts) {
    if (layouts.size() == kMostTexts || !IsLongEnough(item.instruction)) continue;
    LayoutRequest request;
    request.instruction = item.instruction;
    request.vocabulary = item.vocabulary;
    const Clock::time_point read = Clock::now();
    if (!reader->ReadLayout(request, Progress(), &replies).ok()) return EXIT_FAILURE;
    layouts.push_back(SecondsSince(read));
  }
  for (const EnvironmentItem& item : texts.environments) {
    if (environments.size() == kMostTexts || !IsLongEnough(item.instruction)) continue;
    EnvironmentRequest request;
    request.instruction = item.instruction;
    request.layout = &item.layout;
    const Clock::time_point read = Clock::now();
    if (!reader->ReadEnvironment(request, Progress(), &replies).ok()) return EXIT_FAILURE;
    environments.push_back(SecondsSince(read));
  }
  Tell("layouts", layouts);
  Tell("environments", environments);
  std::printf("memory grew by %.0f MB\n", MemoryMegabytes() - before);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace latticeworld

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s READER.gguf EXAMPLES.jsonl...\n", argv[0]);
    return 2;
  }
  return latticeworld::Run(argc, argv);
}
