#ifndef LATTICEWORLD_LANGUAGE_REMOTE_THINKING_FILTER_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_THINKING_FILTER_H_

#include <string>
#include <string_view>

namespace latticeworld {

// Takes what a model thinks aloud out of its answer, letter by letter as it arrives:
// <think>...</think>, and the same with thinking, thought or reasoning. A block that is not closed
// goes to the end; a closing mark without an opening one (chat templates may put that into the
// prompt) makes all before it thinking.
class ThinkingFilter {
 public:
  // What is to be done with the answer after one more letter.
  enum class Action { kAppend, kDiscardAll };

  // passed: set to what may be added to the answer: nothing while it is undecided.
  Action Push(char letter, std::string* passed);
  // What was held back at the end, because a mark might have begun there.
  std::string Finish();

 private:
  bool thinking_ = false;
  std::string held_;  // "<", "</th", ...: the beginning of a mark
};

// The answer without its thinking.
std::string WithoutThinking(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_THINKING_FILTER_H_
