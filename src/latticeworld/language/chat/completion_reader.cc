#include "latticeworld/language/chat/completion_reader.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/chat/error_body.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kEndMark = "[DONE]";

std::string_view SkipBlanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string_view::npos ? "" : text.substr(begin);
}

// nullptr: there is no such member, or it is null.
const Json* Member(const Json& json, const char* name) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(name);
  return found == json.end() || found->is_null() ? nullptr : &*found;
}

std::string TextMember(const Json& json, const char* name) {
  const Json* member = Member(json, name);
  return member != nullptr && member->is_string() ? member->get<std::string>() : "";
}

int CountMember(const Json& json, const char* name) {
  constexpr std::int64_t kMost = 1'000'000'000;
  const Json* member = Member(json, name);
  if (member == nullptr || !member->is_number_integer()) return 0;
  const auto count = member->get<std::int64_t>();
  return count < 0 || count > kMost ? 0 : static_cast<int>(count);
}

// The text of a message's content: itself, or that of its parts of type "text".
std::string ContentText(const Json& message) {
  const Json* content = Member(message, "content");
  if (content == nullptr || !content->is_array()) return TextMember(message, "content");
  std::string text;
  for (const Json& part : *content) {
    if (TextMember(part, "type") == "text") text += TextMember(part, "text");
  }
  return text;
}

// What a message marks as thinking; servers that change a member's name send both for a while.
std::string ThinkingText(const Json& message) {
  for (const char* name : {"reasoning_content", "reasoning", "thinking"}) {
    std::string text = TextMember(message, name);
    if (!text.empty()) return text;
  }
  return "";
}

bool HasParts(const Json& message) {
  const Json* content = Member(message, "content");
  return content != nullptr && content->is_array() && !content->empty();
}

bool IsError(const Json& json) {
  const Json* value = &json;
  while (value->is_array() && !value->empty()) value = &value->front();
  return Member(*value, "error") != nullptr || TextMember(*value, "object") == "error";
}

// Whether a text is the beginning of JSON and no more, unlike one that no more text would mend.
bool IsBegunJson(std::string_view text) {
  try {
    return Json::parse(text).is_discarded();  // never: it throws instead
  } catch (const Json::parse_error& error) {
    return error.byte > text.size();
  } catch (const Json::exception&) {  // a number beyond all bounds
    return false;
  }
}

}  // namespace

bool CompletionReader::Feed(std::string_view bytes) {
  if (failure_ || done_) return false;
  if (kind_ != Kind::kEvents) {
    body_ += bytes;
    if (kind_ == Kind::kUnknown) Sniff();
    constexpr std::size_t kEnoughToQuote = 256;
    if (kind_ == Kind::kOther) return body_.size() < kEnoughToQuote;
    if (kind_ != Kind::kEvents) return true;
    bytes = body_;
  }
  events_.Feed(bytes,
               [this](std::string_view type, std::string_view data) { ReadEvent(type, data); });
  body_.clear();
  return !failure_ && !done_;
}

// An event stream begins with one of its fields, a comment or a byte order mark.
void CompletionReader::Sniff() {
  std::string_view begin = body_;
  if (StartsWith(begin, "\xEF\xBB\xBF")) begin.remove_prefix(3);
  begin = SkipBlanks(begin);
  if (begin.empty()) return;
  if (begin.front() == '{' || begin.front() == '[') {
    kind_ = Kind::kJson;
    spoken_ = true;  // a server that does not stream says all at once
    return;
  }
  bool could_become_events = false;
  for (const std::string_view field : {":", "data:", "event:", "id:", "retry:"}) {
    if (StartsWith(begin, field)) kind_ = Kind::kEvents;
    could_become_events |= StartsWith(field, begin);
  }
  if (kind_ == Kind::kUnknown && !could_become_events && begin.front() != '\xEF') {
    kind_ = Kind::kOther;
  }
}

Failure CompletionReader::Finish(std::string_view content_type) {
  const bool is_events = kind_ == Kind::kEvents;
  bool cut_off = false;
  if (is_events && !done_ && !failure_) {
    // An event without its blank line may have been cut within: then it is no JSON.
    events_.Finish([this](std::string_view type, std::string_view data) {
      if (Json::accept(data) || StartsWith(SkipBlanks(data), kEndMark)) ReadEvent(type, data);
    });
  } else if (kind_ == Kind::kJson) {
    std::string_view text = body_;
    if (StartsWith(text, "\xEF\xBB\xBF")) text.remove_prefix(3);
    cut_off = IsBegunJson(text);
    if (!cut_off) ReadObject(text, /*in_stream=*/false);
  }
  if (failure_) return *failure_;
  if (!completion_.refusal.empty() && completion_.text.empty()) {
    return Failure::Final(InvalidArgument("the model refuses to answer: " +
                                          Quote(key_->Scrub(completion_.refusal), 300)));
  }
  if (is_events && (done_ || finished())) return {};
  if (is_events || cut_off) {
    return Failure::Passing(Unavailable("the connection ended in the middle of the answer, after " +
                                        std::to_string(completion_.text.size()) +
                                        " bytes of its text"));
  }
  if (kind_ == Kind::kJson) return {};
  if (body_.empty()) return Failure::Final(DataLoss("HTTP 200 with an empty body"));
  return Failure::Final(DataLoss("HTTP 200 with no chat completion: Content-Type " +
                                 Quote(key_->Scrub(content_type)) + ", the body begins with " +
                                 Quote(key_->Scrub(SkipBlanks(body_)))));
}

void CompletionReader::ReadEvent(std::string_view type, std::string_view data) {
  if (failure_ || done_) return;
  data = SkipBlanks(data);
  if (StartsWith(data, kEndMark)) {
    done_ = true;
  } else if (type == "error") {
    const ErrorBody error = ParseErrorBody(data);
    Fail(FailureOf(HttpStatusOf(error), error, *key_));
  } else if (!data.empty()) {
    ReadObject(data, /*in_stream=*/true);
  }
}

void CompletionReader::ReadObject(std::string_view text, bool in_stream) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_discarded() && IsError(json)) {
    const ErrorBody error = ParseErrorBody(text);
    return Fail(FailureOf(HttpStatusOf(error), error, *key_));
  }
  if (!json.is_object()) {
    return Fail(Failure::Final(
        DataLoss("HTTP 200 with something else than JSON objects: " + Quote(key_->Scrub(text)))));
  }
  if (completion_.model.empty()) completion_.model = TextMember(json, "model");
  if (const Json* usage = Member(json, "usage")) {
    completion_.prompt_tokens = CountMember(*usage, "prompt_tokens");
    completion_.completion_tokens = CountMember(*usage, "completion_tokens");
  }
  bool has_message = false;
  if (const Json* choices = Member(json, "choices"); choices != nullptr && choices->is_array()) {
    for (const Json& choice : *choices) {
      if (CountMember(choice, "index") != 0) continue;
      const Json* message = Member(choice, in_stream ? "delta" : "message");
      if (message != nullptr && message->is_object()) {
        has_message = true;
        const std::string content = ContentText(*message);
        const std::string thinking = ThinkingText(*message);
        spoken_ |= !content.empty() || !thinking.empty() || HasParts(*message);
        completion_.text += content;
        completion_.thinking += thinking;
        completion_.refusal += TextMember(*message, "refusal");
      }
      const std::string finish_reason = TextMember(choice, "finish_reason");
      if (!finish_reason.empty()) completion_.finish_reason = finish_reason;
    }
  }
  if (!in_stream && !has_message) {
    Fail(
        Failure::Final(DataLoss("HTTP 200 with JSON that is no chat completion, for it has no "
                                "choices[0].message: " +
                                Quote(key_->Scrub(text)))));
  }
}

void CompletionReader::Fail(Failure failure) {
  if (!failure_) failure_ = std::move(failure);
}

}  // namespace latticeworld
