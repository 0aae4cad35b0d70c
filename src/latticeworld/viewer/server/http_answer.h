#ifndef LATTICEWORLD_VIEWER_SERVER_HTTP_ANSWER_H_
#define LATTICEWORLD_VIEWER_SERVER_HTTP_ANSWER_H_

#include <memory>
#include <string>
#include <string_view>

#include "latticeworld/common/status.h"
#include "latticeworld/viewer/payloads/payload.h"
#include "latticeworld/viewer/payloads/world_payloads.h"

namespace latticeworld {

// What of an HTTP request decides its answer.
struct HttpQuestion {
  std::string method;  // "GET"
  std::string target;  // as it was sent: "/api/world.json?x"
  std::string if_none_match, accept_encoding;
};

// An answer; its body lies in a payload or in `text`.
struct HttpAnswer {
  int status = 200;
  std::string content_type;
  std::string etag;  // empty: none
  std::string cache_control;
  bool is_gzip = false;
  std::string_view body;  // lives as long as `keeper` (or `text`)
  std::shared_ptr<const void> keeper;
  std::shared_ptr<const std::string> text;
};

// Answers from memory; nothing of a request reaches the disk. world: null where none runs.
HttpAnswer AnswerHttp(const HttpQuestion& question, const std::shared_ptr<const PayloadMap>& page,
                      const std::shared_ptr<const WorldPayloads>& world);

// {"code": ..., "message": ...} with the HTTP status of the code.
HttpAnswer HttpError(const Status& status);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_HTTP_ANSWER_H_
