#ifndef LATTICEWORLD_VIEWER_PAYLOADS_PAYLOAD_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_PAYLOAD_H_

#include <map>
#include <string>
#include <string_view>

namespace latticeworld {

// What an HTTP server answers a GET with, made once and sent often. Immutable once made.
struct Payload {
  std::string content_type;  // "application/json"
  std::string bytes;
  std::string gzip;  // the same, coded (RFC 1952); empty: not worth it
  std::string etag;  // strong, with its quotes; of `bytes`
};

// compress: whether to try; what does not shrink by a tenth stays as it is.
Payload MakePayload(std::string content_type, std::string bytes, bool compress);

// Payloads by their path: "/index.html".
using PayloadMap = std::map<std::string, Payload, std::less<>>;

// Returns the type by the name's extension; "application/octet-stream" if that says nothing.
std::string_view ContentTypeOf(std::string_view name);
// Whether what has that type shrinks: texts, meshes and grids do, pictures do not.
bool IsCompressible(std::string_view content_type);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_PAYLOAD_H_
