#ifndef LATTICEWORLD_LANGUAGE_REMOTE_THINKING_FILTER_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_THINKING_FILTER_H_

#include <string>
#include <string_view>

namespace latticeworld {

// ThinkingFilter takes what a model thinks aloud out of its answer, letter by letter as it arrives:
// <think>...</think>, and the same with thinking, thought or reasoning. A block that is not closed
// goes to the end; a closing mark without an opening one (chat templates may put that into the
// prompt) makes all before it thinking.
class ThinkingFilter {
 public:
  // Action says what is to be done with the answer after one more letter.
  enum class Action { kAppend, kDiscardAll };

  // Takes the next letter. Sets *passed to what may be added to the answer; to nothing while that
  // is undecided.
  Action Push(char letter, std::string* passed);
  // Ends the answer. Returns what was held back because a mark might have begun there.
  std::string Finish();

 private:
  bool thinking_ = false;
  std::string held_;  // "<", "</th", ...: the beginning of a mark
};

// Returns the answer without its thinking.
std::string WithoutThinking(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_THINKING_FILTER_H_
