// What a model server answers, as it stands in the body of HTTP: a chat completion or its event
// stream in pieces of any size, the body of an error, the list of models; and a server's address.

#include <algorithm>

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/chat/completion_reader.h"
#include "latticeworld/language/chat/error_body.h"
#include "latticeworld/language/chat/model_list.h"
#include "latticeworld/language/chat/server_url.h"

namespace {

void ReadCompletion(std::string_view body) {
  const latticeworld::ApiKey key;
  // The first byte says into pieces of what size the body is cut.
  const std::size_t piece = body.empty() ? 1 : 1 + static_cast<unsigned char>(body.front()) % 32;
  for (const std::size_t step : {piece, std::max<std::size_t>(body.size(), 1)}) {
    latticeworld::CompletionReader reader(&key);
    for (std::size_t at = 0; at < body.size(); at += step) {
      if (!reader.Feed(body.substr(at, step))) break;
    }
    (void)reader.Finish("text/event-stream");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view body = latticeworld::fuzz::TextOf(data, size);
  switch (latticeworld::fuzz::TakeChoice(&body, 4)) {
    case 0:
      ReadCompletion(body);
      break;
    case 1: {
      const latticeworld::ErrorBody error = latticeworld::ParseErrorBody(body);
      (void)latticeworld::FailureOf(latticeworld::HttpStatusOf(error), error, {});
      break;
    }
    case 2:
      (void)latticeworld::FirstModel(body);
      break;
    default:
      (void)latticeworld::ParseServerUrl(std::string(body));
  }
  return 0;
}
