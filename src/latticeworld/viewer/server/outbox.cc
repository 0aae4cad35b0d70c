#include "latticeworld/viewer/server/outbox.h"

#include <utility>

namespace latticeworld {

void Outbox::SetText(const std::string& slot, SharedBytes text) {
  SharedBytes& waiting = texts_[slot];
  if (waiting == nullptr) order_.push_back(slot);
  waiting = std::move(text);
}

void Outbox::AddText(SharedBytes text) {
  if (once_.size() >= kMostOnce) once_.pop_front();
  once_.push_back(std::move(text));
}

void Outbox::SetFrame(StreamKind kind, const StreamFrame& frame) {
  Waiting& waiting = frames_[kind == StreamKind::kAgents ? 0 : 1];
  waiting.frame = frame;
  waiting.is_new = true;
}

void Outbox::SetPoints(SharedBytes points) { points_ = std::move(points); }

std::optional<OutMessage> Outbox::Next() {
  if (!order_.empty()) {
    const auto text = texts_.find(order_.front());
    order_.pop_front();
    OutMessage message{std::move(text->second), false};
    texts_.erase(text);
    return message;
  }
  if (!once_.empty()) {
    OutMessage message{std::move(once_.front()), false};
    once_.pop_front();
    return message;
  }
  for (Waiting& waiting : frames_) {
    if (!waiting.is_new) continue;
    if (waiting.sent_key != waiting.frame.key_number) {
      waiting.sent_key = waiting.frame.key_number;
      waiting.is_new = waiting.frame.delta != nullptr;
      return OutMessage{waiting.frame.key, true};
    }
    waiting.is_new = false;
    if (waiting.frame.delta != nullptr) return OutMessage{waiting.frame.delta, true};
  }
  if (points_ != nullptr) return OutMessage{std::exchange(points_, nullptr), true};
  return std::nullopt;
}

}  // namespace latticeworld
