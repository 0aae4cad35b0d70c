#ifndef LATTICEWORLD_COMMON_DIGEST_H_
#define LATTICEWORLD_COMMON_DIGEST_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace latticeworld {

// SHA-256 over what is added, in order.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  void AddBytes(const void* data, std::size_t size);
  void AddText(std::string_view text);  // its length goes in too
  template <typename T>
  void Add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "padding would go into the hash");
    AddBytes(&value, sizeof(value));
  }

  // Ends the digest: 64 hexadecimal digits. Call once.
  std::string Hex();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

std::string Sha256Hex(std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_DIGEST_H_
