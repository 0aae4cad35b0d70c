// How fast a language model in this process reads and writes, beside llama.cpp on the same files
// and beside what no decoder can pass that needs every weight for every token: adding up as many
// bytes. Weights are random, for speed does not depend on what they say, but for those of the
// models that are shipped. Usage: local_model_benchmark [DIRECTORY of llama.cpp as the tests
// install it [FILE.gguf ...]]: of files that are named those alone

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "language/local/tiny_model.h"
#include "latticeworld/common/work_crew.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"
#include "latticeworld/language/local/decoding/llama_model.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/local/weights/gguf_file.h"
#include "latticeworld/language/local/weights/large_memory.h"
#include "latticeworld/language/remote/forms.h"

namespace latticeworld {
namespace {

constexpr int kRead = 512, kWritten = 256;
using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Speeds {
  double read = 0.0, written = 0.0;  // tokens a second
};

std::vector<TokenId> Prompt() {
  std::vector<TokenId> tokens;
  for (int i = 0; i < kRead; ++i) tokens.push_back(5 + i % 300);
  return tokens;
}

// The best of three: whoever shares the machine only takes away.
Speeds Ours(const std::string& file, int threads) {
  const GgufFile opened = GgufFile::Open(file).value();
  const auto model = std::make_shared<const LlamaModel>(ReadLlamaModel(opened).value());
  const auto crew = std::make_shared<WorkCrew>(threads);
  const Progress progress;
  Speeds best;
  for (int i = 0; i < 3; ++i) {
    LlamaDecoder decoder(model, crew);
    Clock::time_point begin = Clock::now();
    if (!decoder.Append(Prompt(), progress).ok()) std::abort();
    best.read = std::max(best.read, kRead / SecondsSince(begin));
    begin = Clock::now();
    for (int k = 0; k < kWritten; ++k)
      if (!decoder.Append({static_cast<TokenId>(10 + k)}, progress).ok()) std::abort();
    best.written = std::max(best.written, kWritten / SecondsSince(begin));
  }
  return best;
}

// Times a second that one thread adds up as many bytes as the file has; the best of ten.
double BareReadings(const std::string& file) {
  LargeVector<std::uint64_t> words(std::filesystem::file_size(file) / sizeof(std::uint64_t), 1);
  double best = 0.0;
  for (int i = 0; i < 10; ++i) {
    const Clock::time_point begin = Clock::now();
    const std::uint64_t sum = std::accumulate(words.begin(), words.end(), std::uint64_t{0});
    best = std::max(best, 1.0 / SecondsSince(begin));
    words[0] = sum;  // so that it is wanted
  }
  return best;
}

// llama.cpp answers one question a line; its time is that between two lines.
Speeds Theirs(const std::string& file, const std::string& directory) {
  std::string tokens;
  for (const TokenId token : Prompt())
    tokens += (tokens.empty() ? "" : ",") + std::to_string(token);
  const std::string asked =
      std::filesystem::temp_directory_path() / ("questions-" + std::to_string(getpid()));
  std::ofstream out(asked);
  for (const int count : {1, 1, 1 + kWritten})
    out << "{\"tokens\":[" << tokens << "],\"count\":" << count << "}\n";
  out.close();
  const std::string command =
      "cd '" + directory + "' && ./node '" LLAMA_ANSWERS "' '" + file + "' < '" + asked + "'";
  FILE* answers = popen(command.c_str(), "r");
  if (answers == nullptr) return {};
  std::vector<Clock::time_point> heard;
  for (int c = std::fgetc(answers); c != EOF; c = std::fgetc(answers))
    if (c == '\n') heard.push_back(Clock::now());
  pclose(answers);
  std::filesystem::remove(asked);
  if (heard.size() != 3) return {};
  const auto between = [&](int i) {
    return std::chrono::duration<double>(heard[i + 1] - heard[i]).count();
  };
  return {kRead / between(0), kWritten / (between(1) - between(0))};
}

// Seconds of one layout under its grammar, with the prompt of the remote back end.
double LayoutSeconds(const std::string& file) {
  const auto server = MakeLocalChatServer(file, /*threads=*/1).value();
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "A lake lies in the north, and a wood south of it.", ""}};
  request.form = LayoutForm(Vocabulary::kSuburb);
  const Clock::time_point begin = Clock::now();
  if (!server->Complete(request, {}, Progress()).ok()) std::abort();
  return SecondsSince(begin);
}

void Measure(const char* name, const std::string& file, const std::string& llama,
             bool draws = true) {
  const Speeds ours = Ours(file, 1), all = Ours(file, 0);
  std::printf(
      "%-12s reads %7.0f, writes %6.0f tokens/s (%.2f of the bare readings); all cores "
      "%7.0f, %6.0f",
      name, ours.read, ours.written, ours.written / BareReadings(file), all.read, all.written);
  if (draws) std::printf("; a layout in %5.2f s on one", LayoutSeconds(file));
  if (!llama.empty()) {
    const Speeds theirs = Theirs(file, llama);
    std::printf("; llama.cpp %7.0f, %6.0f: ratio %.2f, %.2f", theirs.read, theirs.written,
                ours.read / theirs.read, ours.written / theirs.written);
  }
  std::printf("\n");
  std::fflush(stdout);
}

void MeasureRandom(const char* name, std::uint32_t type, std::size_t layers, std::size_t width,
                   std::size_t hidden, const std::string& llama) {
  TinyModel model;
  model.weight_type = type;
  model.layers = layers;
  model.width = width;
  model.hidden = hidden;
  model.heads = model.kv_heads = width / 32;
  Measure(name, ModelFile(TinyGguf(model)).path(), llama);
}

}  // namespace
}  // namespace latticeworld

int main(int argc, char** argv) {
  const std::string llama = argc > 1 ? argv[1] : "";
  for (int i = 2; i < argc; ++i) {
    const std::string file = std::filesystem::absolute(argv[i]);  // llama.cpp starts elsewhere
    latticeworld::Measure(argv[i], file, llama, /*draws=*/false);
  }
  if (argc > 2) return EXIT_SUCCESS;
  using latticeworld::MeasureRandom;
  latticeworld::Measure("shipped", SHIPPED_MODELS "/layouts.gguf", llama);
  MeasureRandom("1 M f32", 0, 2, 192, 512, llama);
  MeasureRandom("10 M f32", 0, 6, 384, 1024, llama);
  MeasureRandom("50 M f32", 0, 12, 576, 1536, llama);
  MeasureRandom("10 M q8_0", 8, 6, 384, 1024, llama);
  MeasureRandom("50 M q8_0", 8, 12, 576, 1536, llama);
  return EXIT_SUCCESS;
}
