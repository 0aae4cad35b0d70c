// How fast a language model in this process reads and writes, beside llama.cpp on the same files.
// Weights are random, for speed does not depend on what they say, but for those of the model that
// is shipped. Usage: local_model_benchmark [DIRECTORY of llama.cpp as the tests install it]

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "language/local/tiny_model.h"
#include "latticeworld/language/local/gguf_file.h"
#include "latticeworld/language/local/llama_decoder.h"
#include "latticeworld/language/local/llama_model.h"
#include "latticeworld/language/local/local.h"
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

Speeds Ours(const std::string& file) {
  const GgufFile opened = GgufFile::Open(file).value();
  LlamaDecoder decoder(std::make_shared<const LlamaModel>(ReadLlamaModel(opened).value()));
  const Progress progress;
  Speeds speeds;
  Clock::time_point begin = Clock::now();
  if (!decoder.Append(Prompt(), progress).ok()) std::abort();
  speeds.read = kRead / SecondsSince(begin);
  begin = Clock::now();
  for (int i = 0; i < kWritten; ++i)
    if (!decoder.Append({static_cast<TokenId>(10 + i)}, progress).ok()) std::abort();
  speeds.written = kWritten / SecondsSince(begin);
  return speeds;
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
  const auto server = MakeLocalChatServer(file).value();
  ChatRequest request;
  request.messages = {{ChatRole::kUser, "A lake lies in the north, and a wood south of it.", ""}};
  request.form = LayoutForm(Vocabulary::kSuburb);
  const Clock::time_point begin = Clock::now();
  if (!server->Complete(request, {}, Progress()).ok()) std::abort();
  return SecondsSince(begin);
}

void Measure(const char* name, const std::string& file, const std::string& llama) {
  const Speeds ours = Ours(file);
  std::printf("%-12s reads %7.0f, writes %6.0f tokens/s, a layout in %5.2f s", name, ours.read,
              ours.written, LayoutSeconds(file));
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
  using latticeworld::MeasureRandom;
  latticeworld::Measure("shipped", SHIPPED_MODELS "/layouts.gguf", llama);
  MeasureRandom("1 M f32", 0, 2, 192, 512, llama);
  MeasureRandom("10 M f32", 0, 6, 384, 1024, llama);
  MeasureRandom("10 M q8_0", 8, 6, 384, 1024, llama);
  MeasureRandom("50 M q8_0", 8, 12, 576, 1536, llama);
  return EXIT_SUCCESS;
}
