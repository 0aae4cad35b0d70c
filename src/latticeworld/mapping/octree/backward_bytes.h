#ifndef LATTICEWORLD_MAPPING_OCTREE_BACKWARD_BYTES_H_
#define LATTICEWORLD_MAPPING_OCTREE_BACKWARD_BYTES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace latticeworld {

// Bytes that are written from the last to the first, as the walk comes.
class BackwardBuffer {
 public:
  // Memory that is never written costs nothing.
  explicit BackwardBuffer(std::size_t capacity)
      : bytes_(new char[capacity]), capacity_(capacity), at_(capacity) {}

  void Put(const char* bytes, std::size_t count) {
    at_ -= count;
    std::memcpy(bytes_.get() + at_, bytes, count);
  }
  void Drop(std::size_t count) { at_ += count; }
  void Clear() { at_ = capacity_; }
  const char* data() const { return bytes_.get() + at_; }
  std::size_t size() const { return capacity_ - at_; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t capacity_;
  std::size_t at_;  // of the first byte written
};

// The same for the upper nodes: whole cubes are only noted, and copied once in the end.
class BackwardPieces {
 public:
  void Put(const char* bytes, std::size_t count) {
    Piece piece = {nullptr, count, {}};
    std::memcpy(piece.own.data(), bytes, count);
    pieces_.push_back(piece);
  }
  void PutCube(const char* bytes, std::size_t count) { pieces_.push_back({bytes, count, {}}); }
  void Drop(std::size_t count) {
    for (; count > 0; pieces_.pop_back()) count -= pieces_.back().size;
  }
  std::vector<std::int8_t> Join() const {
    std::size_t size = 0;
    for (const Piece& piece : pieces_) size += piece.size;
    std::vector<std::int8_t> bytes;
    bytes.reserve(size);
    for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) {
      const char* from = piece->bytes != nullptr ? piece->bytes : piece->own.data();
      bytes.insert(bytes.end(), from, from + piece->size);
    }
    return bytes;
  }

 private:
  struct Piece {
    const char* bytes;  // null: own
    std::size_t size;
    std::array<char, 5> own;
  };
  std::vector<Piece> pieces_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_BACKWARD_BYTES_H_
