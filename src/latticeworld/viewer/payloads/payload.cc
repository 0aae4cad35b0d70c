#include "latticeworld/viewer/payloads/payload.h"

#include <zlib.h>

#include <array>
#include <limits>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Smaller ones fit into one packet anyway.
constexpr std::size_t kLeastToCompress = 1024;
constexpr int kGzipWindow = 15 + 16;  // the greatest window, with gzip's header
constexpr int kLevel = 6;
constexpr int kMemory = 9;
constexpr std::size_t kTagDigits = 20;

// Empty: it cannot be done, or does not pay.
std::string Gzip(const std::string& bytes) {
  if (bytes.size() < kLeastToCompress || bytes.size() > std::numeric_limits<uInt>::max()) return "";
  z_stream stream{};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK) {
    return "";
  }
  std::string coded(bytes.size() - bytes.size() / 10, '\0');  // more is not worth it
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib only reads
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(coded.data());
  stream.avail_out = static_cast<uInt>(coded.size());
  const int result = deflate(&stream, Z_FINISH);
  coded.resize(result == Z_STREAM_END ? coded.size() - stream.avail_out : 0);
  (void)deflateEnd(&stream);
  coded.shrink_to_fit();
  return coded;
}

struct TypeOfName {
  std::string_view extension;
  std::string_view type;
  bool compressible;
};

constexpr std::array<TypeOfName, 18> kTypes = {{
    {".html", "text/html; charset=utf-8", true},
    {".js", "text/javascript; charset=utf-8", true},
    {".mjs", "text/javascript; charset=utf-8", true},
    {".css", "text/css; charset=utf-8", true},
    {".json", "application/json", true},
    {".map", "application/json", true},
    {".webmanifest", "application/manifest+json", true},
    {".svg", "image/svg+xml", true},
    {".txt", "text/plain; charset=utf-8", true},
    {".wasm", "application/wasm", true},
    {".glb", "model/gltf-binary", true},
    {".bin", "application/octet-stream", true},
    {".png", "image/png", false},
    {".jpg", "image/jpeg", false},
    {".webp", "image/webp", false},
    {".ico", "image/x-icon", false},
    {".woff2", "font/woff2", false},
    {".gz", "application/gzip", false},
}};

}  // namespace

Payload MakePayload(std::string content_type, std::string bytes, bool compress) {
  Payload payload;
  payload.content_type = std::move(content_type);
  payload.bytes = std::move(bytes);
  if (compress) payload.gzip = Gzip(payload.bytes);
  payload.etag = "\"" + Sha256Hex(payload.bytes).substr(0, kTagDigits) + "\"";
  return payload;
}

std::string_view ContentTypeOf(std::string_view name) {
  for (const TypeOfName& type : kTypes) {
    if (EndsWith(name, type.extension)) return type.type;
  }
  return "application/octet-stream";
}

bool IsCompressible(std::string_view content_type) {
  for (const TypeOfName& type : kTypes) {
    if (type.type == content_type) return type.compressible;
  }
  return false;
}

}  // namespace latticeworld
