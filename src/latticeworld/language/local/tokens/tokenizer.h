#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKENIZER_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKENIZER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"
#include "latticeworld/language/local/tokens/byte_pairs.h"

namespace latticeworld {

class GgufFile;

// The tokens of a model file and how text becomes tokens: SentencePiece's byte-pair merges by
// score with bytes for what has no token (Kudo and Richardson 2018; `tokenizer.ggml.model`
// "llama"), or merges of bytes by rank (byte_pairs.h; "gpt2" with the pre-tokenizers "gpt-2" and
// "smollm").
class Tokenizer {
 public:
  // Errors: DATA_LOSS: another kind of tokenizer or pre-tokenizer, lists of different lengths,
  // no tokens, no token for the end; those of BytePairs::Make.
  static Result<Tokenizer> Read(const GgufFile& file);

  std::size_t size() const { return bytes_.size(); }
  // What a token adds to a text, in bytes; empty for those that control.
  const std::string& BytesOf(TokenId token) const { return bytes_[token]; }
  bool IsControl(TokenId token) const { return control_[token]; }
  TokenId end() const { return end_; }
  // The control token of that name ("<|im_start|>"); none.
  std::optional<TokenId> Control(std::string_view name) const;
  // Returns the token that stands before all text; none: the model has no such token or wants none.
  std::optional<TokenId> begin() const { return begin_; }
  // Whether the model's texts begin with a space that was not written.
  bool adds_space() const { return adds_space_; }

  // Tokens of a text, none of which controls, whatever the text says: "</s>" in
  // it is five characters. Bytes without a token become the unknown token.
  std::vector<TokenId> Encode(std::string_view text) const;

 private:
  Status ReadPieces(const GgufFile& file);
  Status ReadBytePairs(const GgufFile& file);
  Status ReadEnds(const GgufFile& file);
  void EncodeByMerging(const std::string& text, std::vector<TokenId>* tokens) const;
  void AddBytes(std::string_view text, std::vector<TokenId>* tokens) const;

  std::vector<std::string> bytes_;  // by token
  std::vector<float> scores_;
  std::vector<bool> control_;
  std::unordered_map<std::string, TokenId> by_text_;  // pieces as the file spells them
  std::unordered_map<std::string, TokenId> controls_;
  std::optional<BytePairs> pairs_;  // none: merges by score
  std::optional<TokenId> of_byte_[256];
  std::optional<TokenId> begin_;
  TokenId end_ = 0;
  TokenId unknown_ = 0;
  bool adds_space_ = true;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKENIZER_H_
