#include "latticeworld/language/not_understood.h"

#include "latticeworld/common/text.h"

namespace latticeworld {

void NotUnderstood::Add(std::size_t begin, std::size_t end) {
  if (!open_) begin_ = begin;
  end_ = end;
  open_ = true;
}

void NotUnderstood::Close() {
  if (!open_) return;
  open_ = false;
  if (warnings_.size() == kMaxWarnings) {
    ++left_out_;
    return;
  }
  warnings_.push_back("not understood: " + Quote(instruction_.substr(begin_, end_ - begin_)));
}

void NotUnderstood::AppendTo(std::vector<std::string>* warnings) {
  Close();
  warnings->insert(warnings->end(), warnings_.begin(), warnings_.end());
  if (left_out_ > 0) {
    warnings->push_back("not understood: " + std::to_string(left_out_) + " more phrases");
  }
}

}  // namespace latticeworld
