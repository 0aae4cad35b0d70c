#include "latticeworld/common/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

namespace latticeworld {

int CoreCount() {
  // Asking takes as long as tracing a hundred rays: it reads a file.
  static const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return cores;
}

void ParallelFor(int count, int threads, const std::function<void(int begin, int end)>& body) {
  if (count <= 0) return;
  const int parts = std::min(count, threads > 0 ? threads : CoreCount());
  const auto begin_of = [&](int part) {
    return static_cast<int>(static_cast<std::int64_t>(part) * count / parts);
  };
  std::vector<std::thread> others;
  others.reserve(parts - 1);
  int part = 1;
  try {
    for (; part < parts; ++part) {
      others.emplace_back([&, part] { body(begin_of(part), begin_of(part + 1)); });
    }
  } catch (const std::system_error&) {  // no more threads can be had: the rest is done here
  }
  body(begin_of(0), begin_of(1));
  for (; part < parts; ++part) body(begin_of(part), begin_of(part + 1));
  for (std::thread& other : others) other.join();
}

void ParallelInPieces(int count, int piece, int threads,
                      const std::function<void(int begin, int end)>& body) {
  if (count <= 0) return;
  const int pieces = (count - 1) / piece + 1;
  std::atomic<int> next{0};
  // A thread may come too late for any piece.
  ParallelFor(pieces, threads, [&](int, int) {
    for (int i = next++; i < pieces; i = next++) {
      const int begin = i * piece;
      body(begin, piece < count - begin ? begin + piece : count);
    }
  });
}

}  // namespace latticeworld
