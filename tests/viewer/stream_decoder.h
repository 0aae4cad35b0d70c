#ifndef LATTICEWORLD_TESTS_VIEWER_STREAM_DECODER_H_
#define LATTICEWORLD_TESTS_VIEWER_STREAM_DECODER_H_

#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/viewer/payloads/state_stream.h"

namespace latticeworld {

// Reads state frames as docs/viewer.md writes them, as a client would.
class StreamDecoder {
 public:
  // False: the frame is to be ignored, for its key frame is not known. Frames that are not whole
  // are failures of the test.
  bool Read(const std::string& bytes);

  int kind() const { return kind_; }
  bool is_key() const { return is_key_; }
  double time_s() const { return time_s_; }
  std::uint32_t version() const { return version_; }
  const std::vector<StreamedThing>& things() const { return things_; }

 private:
  int kind_ = 0;
  bool is_key_ = false;
  bool has_key_ = false;
  std::uint16_t key_number_ = 0;
  std::uint32_t version_ = 0;
  double time_s_ = 0.0;
  std::vector<StreamedThing> key_;
  std::vector<StreamedThing> things_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_VIEWER_STREAM_DECODER_H_
