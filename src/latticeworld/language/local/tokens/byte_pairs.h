#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_BYTE_PAIRS_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_BYTE_PAIRS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"

namespace latticeworld {

// The bytes that a piece of a byte-level vocabulary stands for: its characters are those of the
// alphabet that GPT-2 writes bytes in, "\xC4\xA0" for a blank. Empty where one of them is none.
std::string BytesOfPiece(std::string_view piece);

// Words of a text before merging, none across two of them (Radford et al. 2019): a word with the
// blank before it, digits, runs of other signs, blanks. single_digits: each digit is a word of its
// own, as the pre-tokenizer "smollm" has it. Letters and signs beyond ASCII are told apart by the
// blocks of Unicode that they lie in.
std::vector<std::string_view> ByteLevelWords(std::string_view text, bool single_digits);

// Byte-pair encoding over bytes: within a word the pair of the lowest rank is merged first, of
// equals the leftmost (Sennrich et al. 2016).
class BytePairs {
 public:
  // pieces: of the vocabulary, as the file spells them. merges: "left right", by rank.
  // Bytes that the vocabulary lacks, as those of control characters, are left out of texts.
  // Errors: DATA_LOSS: a printable byte without a token, a merge of what are no tokens.
  static Result<BytePairs> Make(const std::vector<std::string>& pieces,
                                const std::vector<std::string>& merges, bool single_digits);

  std::vector<TokenId> Encode(std::string_view text) const;

 private:
  struct Merge {
    int rank = 0;
    TokenId token = 0;  // what the two become
  };
  void EncodeWord(std::string_view word, std::vector<TokenId>* tokens) const;
  const Merge* Find(TokenId left, TokenId right) const;

  std::optional<TokenId> of_byte_[256];
  std::unordered_map<std::uint64_t, Merge> merges_;  // by left and right token
  bool single_digits_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_BYTE_PAIRS_H_
