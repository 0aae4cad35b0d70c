#include "latticeworld/language/local/weights/large_memory.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace latticeworld {
namespace {

constexpr std::size_t kLine = 64;  // [bytes] of the cache; where each block begins
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kLargePage = kLine, kChunk = 0;  // a chunk a block, whose end is watched
#else
constexpr std::size_t kLargePage = std::size_t{2} << 20, kChunk = std::size_t{32} << 20;
#endif

// Memory of whole large pages that blocks are cut from, one behind the other. It is given back when
// none of them is left.
struct Chunk {
  std::size_t size = 0, used = 0;
  std::size_t blocks = 0;
  void* memory = nullptr;
};

// What stands in the line before a block.
struct BlockHead {
  Chunk* chunk;
};

std::size_t RoundedUp(std::size_t size, std::size_t to) { return (size + to - 1) / to * to; }

class Chunks {
 public:
  void* Allocate(std::size_t bytes) {
    if (bytes > std::numeric_limits<std::size_t>::max() / 4) throw std::bad_alloc();
    const std::size_t size = kLine + RoundedUp(bytes, kLine);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (open_ == nullptr || open_->size - open_->used < size) Open(size);
    auto* const head =
        reinterpret_cast<BlockHead*>(static_cast<char*>(open_->memory) + open_->used);
    head->chunk = open_;
    open_->used += size;
    ++open_->blocks;
    return reinterpret_cast<char*>(head) + kLine;
  }

  void Free(void* block) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    Chunk* const chunk = reinterpret_cast<BlockHead*>(static_cast<char*>(block) - kLine)->chunk;
    if (--chunk->blocks > 0) return;
    if (chunk == open_) open_ = nullptr;
    Discard(chunk);
  }

 private:
  // A chunk with room for a block; the one before is no longer cut from.
  void Open(std::size_t size) {
    auto* const chunk = new Chunk;
    chunk->size = RoundedUp(std::max(size, kChunk), kLargePage);
    chunk->memory = std::aligned_alloc(kLargePage, chunk->size);
    if (chunk->memory == nullptr) {
      delete chunk;
      throw std::bad_alloc();
    }
#if defined(__linux__)
    // A wish: where it is not granted, pages stay small.
    madvise(chunk->memory, chunk->size, MADV_HUGEPAGE);
#endif
    open_ = chunk;
  }

  static void Discard(Chunk* chunk) noexcept {
    std::free(chunk->memory);
    delete chunk;
  }

  std::mutex mutex_;
  Chunk* open_ = nullptr;  // has a block at least
};

Chunks& TheChunks() {
  static Chunks& chunks = *new Chunks;  // outlives whatever is freed at the end of the program
  return chunks;
}

}  // namespace

void* AllocateLarge(std::size_t bytes) { return TheChunks().Allocate(bytes); }

void FreeLarge(void* memory) noexcept {
  if (memory != nullptr) TheChunks().Free(memory);
}

}  // namespace latticeworld
