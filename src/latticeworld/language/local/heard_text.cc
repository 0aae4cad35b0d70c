#include "latticeworld/language/local/heard_text.h"

#include <cstddef>

namespace latticeworld {

Status HeardText::Begin(const std::vector<float>& seen, const std::vector<TokenId>& said,
                        const Progress& progress) {
  if (seen != seen_) {
    decoder_.Truncate(0);
    seen_.clear();
    said_.clear();
    const std::size_t width = decoder_.model().sizes.width;
    const Status status = decoder_.AppendEmbeddings(seen.data(), seen.size() / width, progress);
    if (!status.ok()) decoder_.Truncate(0);
    LW_RETURN_IF_ERROR(status);
    seen_ = seen;
  }
  std::size_t same = 0;
  while (same < said.size() && same < said_.size() && said[same] == said_[same]) ++same;
  if (same == said.size() && same > 0) --same;  // its last token gives the logits
  decoder_.Truncate(decoder_.length() - (said_.size() - same));
  said_.resize(same);
  return Add({said.begin() + static_cast<std::ptrdiff_t>(same), said.end()}, progress);
}

Status HeardText::Add(const std::vector<TokenId>& tokens, const Progress& progress) {
  const std::size_t before = decoder_.length();
  const Status status = decoder_.Append(tokens, progress);
  const std::size_t heard = decoder_.length() - before;  // all but where it was cancelled
  said_.insert(said_.end(), tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(heard));
  return status;
}

}  // namespace latticeworld
