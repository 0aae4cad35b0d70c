#include "latticeworld/language/remote/thinking_filter.h"

#include <utility>

namespace latticeworld {
namespace {

constexpr std::string_view kOpening[] = {"<think>", "<thinking>", "<thought>", "<reasoning>"};
constexpr std::string_view kClosing[] = {"</think>", "</thinking>", "</thought>", "</reasoning>"};

template <typename Marks>
bool IsOneOf(std::string_view text, const Marks& marks) {
  for (const std::string_view mark : marks) {
    if (text == mark) return true;
  }
  return false;
}

template <typename Marks>
bool Begins(std::string_view text, const Marks& marks) {
  for (const std::string_view mark : marks) {
    if (mark.substr(0, text.size()) == text) return true;
  }
  return false;
}

}  // namespace

ThinkingFilter::Action ThinkingFilter::Push(char letter, std::string* passed) {
  passed->clear();
  if (letter == '<' || held_.empty()) {
    // No mark holds a second "<": what was held back is text, and a new mark may begin.
    std::swap(*passed, held_);
    if (letter == '<') {
      held_ = "<";
    } else {
      *passed += letter;
    }
  } else {
    held_ += letter;
    if (IsOneOf(held_, kClosing)) {
      held_.clear();
      // A closing mark without an opening one: all that came was thinking.
      return std::exchange(thinking_, false) ? Action::kAppend : Action::kDiscardAll;
    }
    if (IsOneOf(held_, kOpening)) {
      held_.clear();
      thinking_ = true;
    } else if (!Begins(held_, kOpening) && !Begins(held_, kClosing)) {
      std::swap(*passed, held_);
    }
  }
  if (thinking_) passed->clear();
  return Action::kAppend;
}

std::string ThinkingFilter::Finish() {
  std::string rest = std::exchange(held_, "");
  return thinking_ ? "" : rest;
}

std::string WithoutThinking(std::string_view text) {
  ThinkingFilter filter;
  std::string answer;
  std::string passed;
  for (const char letter : text) {
    if (filter.Push(letter, &passed) == ThinkingFilter::Action::kDiscardAll) answer.clear();
    answer += passed;
  }
  return answer + filter.Finish();
}

}  // namespace latticeworld
