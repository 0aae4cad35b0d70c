#include "latticeworld/generation/bundle/replies_json.h"

#include <exception>
#include <limits>
#include <utility>

#include "latticeworld/generation/json_fields.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;
using jf::Json;

StatusCode DecodeFailure(const Json& json) {
  constexpr int kLastCode = static_cast<int>(StatusCode::kUnauthenticated);
  const std::string name = jf::Text(json, "failure");
  for (int code = 1; code <= kLastCode; ++code) {
    if (ToString(static_cast<StatusCode>(code)) == name) return static_cast<StatusCode>(code);
  }
  jf::Fail("failure", json["failure"], "the name of an error");
}

ModelReply DecodeReply(Json json) {
  ModelReply reply;
  if (json.is_object() && json.contains("failure")) {
    jf::ExpectKeys(json, {"purpose", "failure", "message"});
    reply.purpose = jf::Text(json, "purpose");
    reply.failure = Status(DecodeFailure(json), jf::Text(json, "message"));
    return reply;
  }
  constexpr int kMost = std::numeric_limits<int>::max();
  if (json.is_object() && json.contains("warnings")) {
    for (const Json& warning : jf::Array(json, "warnings")) {
      reply.warnings.push_back(jf::Text(Json{{"warning", warning}}, "warning"));
    }
    json.erase("warnings");
  }
  if (json.is_object() && json.contains("log_probability")) {
    reply.log_probability =
        jf::Number(json, "log_probability", std::numeric_limits<double>::lowest(), 0.0);
    json.erase("log_probability");
  }
  jf::ExpectKeys(json, {"purpose", "model", "text", "finish_reason", "prompt_tokens",
                        "completion_tokens", "retries", "seconds"});
  reply.purpose = jf::Text(json, "purpose");
  reply.model = jf::Text(json, "model");
  reply.text = jf::Text(json, "text");
  reply.finish_reason = jf::Text(json, "finish_reason");
  reply.prompt_tokens = static_cast<int>(jf::Integer(json, "prompt_tokens", 0, kMost));
  reply.completion_tokens = static_cast<int>(jf::Integer(json, "completion_tokens", 0, kMost));
  reply.retries = static_cast<int>(jf::Integer(json, "retries", 0, kMost));
  reply.seconds = jf::Number(json, "seconds", 0.0);
  return reply;
}

Json Encode(const ModelReply& reply) {
  if (!reply.failure.ok()) {
    return {{"purpose", reply.purpose},
            {"failure", ToString(reply.failure.code())},
            {"message", reply.failure.message()}};
  }
  Json json = {{"purpose", reply.purpose},
               {"model", reply.model},
               {"text", reply.text},
               {"finish_reason", reply.finish_reason},
               {"prompt_tokens", reply.prompt_tokens},
               {"completion_tokens", reply.completion_tokens},
               {"retries", reply.retries},
               {"seconds", reply.seconds}};
  if (!reply.warnings.empty()) json["warnings"] = reply.warnings;
  if (reply.log_probability != 0.0) json["log_probability"] = reply.log_probability;
  return json;
}

}  // namespace

std::string EncodeReplies(const std::vector<ModelReply>& replies) {
  Json json = Json::array();
  for (const ModelReply& reply : replies) json.push_back(Encode(reply));
  return jf::Dump(json);
}

Result<std::vector<ModelReply>> DecodeReplies(std::string_view content) {
  try {
    const Json json = jf::Parse(content);
    if (!json.is_array()) return DataLoss("it is not an array");
    std::vector<ModelReply> replies;
    for (const Json& reply : json) replies.push_back(DecodeReply(reply));
    return replies;
  } catch (const std::exception& error) {  // JSON
    return DataLoss(error.what());
  }
}

}  // namespace latticeworld
