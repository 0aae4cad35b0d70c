#include "latticeworld/sensing/solids/embree_handles.h"

#include <string>

namespace latticeworld {

Status EmbreeStatus(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  switch (error) {
    case RTC_ERROR_NONE:
      return Status();
    case RTC_ERROR_OUT_OF_MEMORY:
      return ResourceExhausted("no memory for the rays' world");
    case RTC_ERROR_UNSUPPORTED_CPU:
      return Internal("Embree does not support this processor");
    default:
      return Internal("Embree failed with error " + std::to_string(static_cast<int>(error)));
  }
}

}  // namespace latticeworld
