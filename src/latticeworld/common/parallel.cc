#include "latticeworld/common/parallel.h"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

namespace latticeworld {

void ParallelFor(int count, int threads, const std::function<void(int begin, int end)>& body) {
  if (count <= 0) return;
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const int parts = std::min(count, threads > 0 ? threads : cores);
  const auto begin_of = [&](int part) {
    return static_cast<int>(static_cast<std::int64_t>(part) * count / parts);
  };
  std::vector<std::thread> others;
  others.reserve(parts - 1);
  for (int part = 1; part < parts; ++part) {
    others.emplace_back([&, part] { body(begin_of(part), begin_of(part + 1)); });
  }
  body(begin_of(0), begin_of(1));
  for (std::thread& other : others) other.join();
}

}  // namespace latticeworld
