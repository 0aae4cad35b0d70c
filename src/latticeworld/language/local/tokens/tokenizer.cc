#include "latticeworld/language/local/tokens/tokenizer.h"

#include <cmath>
#include <cstdio>
#include <queue>
#include <utility>
#include <variant>

#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

// How SentencePiece spells a space within pieces: U+2581.
constexpr std::string_view kSpace = "\xE2\x96\x81";

// llama.cpp's numbers of the kinds of tokens.
enum TokenType {
  kNormal = 1,
  kUnknown = 2,
  kControl = 3,
  kUserDefined = 4,
  kUnused = 5,
  kByte = 6
};

std::string WithSpaces(std::string_view piece) {
  std::string text;
  for (std::size_t i = 0; i < piece.size();) {
    if (piece.substr(i, kSpace.size()) == kSpace) {
      text += ' ';
      i += kSpace.size();
    } else {
      text += piece[i++];
    }
  }
  return text;
}

std::string WithMarks(std::string_view text) {
  std::string pieces;
  for (const char c : text) {
    if (c == ' ') {
      pieces += kSpace;
    } else {
      pieces += c;
    }
  }
  return pieces;
}

// "<0x41>" -> 0x41; -1: it is none.
int ByteOf(const std::string& piece) {
  unsigned byte = 0;
  int used = 0;
  if (piece.size() != 6 || std::sscanf(piece.c_str(), "<0x%2X>%n", &byte, &used) != 1 || used != 6)
    return -1;
  return static_cast<int>(byte);
}

// Bytes of the UTF-8 character that begins there; 1 where none does.
std::size_t CharacterBytes(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
  for (std::size_t i = 1; i < size; ++i)
    if (i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 1;
  return size;
}

template <typename T>
Result<const std::vector<T>*> List(const GgufFile& file, const char* key) {
  const auto found = file.metadata().find(std::string_view(key));
  if (found == file.metadata().end())
    return DataLoss("the key '" + std::string(key) + "' is missing");
  if (const auto* list = std::get_if<std::vector<T>>(&found->second)) return list;
  return DataLoss("'" + std::string(key) + "' is a list of another kind");
}

// A piece of the text while pieces are merged: a double-linked list in a
// vector.
struct Symbol {
  int before = -1, after = -1;  // indices; -1: none
  std::size_t at = 0,
              size = 0;  // in the text; size 0: merged into the one before
};

struct Merge {
  float score;
  int left, right;
  std::size_t size;  // of both when it was found
  // The best score first, then the leftmost.
  bool operator<(const Merge& other) const {
    return score < other.score || (score == other.score && left > other.left);
  }
};

}  // namespace

Result<Tokenizer> Tokenizer::Read(const GgufFile& file) {
  LW_ASSIGN_OR_RETURN(const std::string model, file.Text("tokenizer.ggml.model"));
  if (model != "llama" && model != "gpt2")
    return DataLoss("tokenizer.ggml.model is '" + model +
                    "'; read here are 'llama' (SentencePiece with scores) and 'gpt2' (pairs of "
                    "bytes)");
  Tokenizer tokenizer;
  LW_RETURN_IF_ERROR(model == "llama" ? tokenizer.ReadPieces(file) : tokenizer.ReadBytePairs(file));
  LW_RETURN_IF_ERROR(tokenizer.ReadEnds(file));
  return tokenizer;
}

Status Tokenizer::ReadPieces(const GgufFile& file) {
  LW_ASSIGN_OR_RETURN(const auto* pieces, List<std::string>(file, "tokenizer.ggml.tokens"));
  LW_ASSIGN_OR_RETURN(const auto* scores, List<double>(file, "tokenizer.ggml.scores"));
  LW_ASSIGN_OR_RETURN(const auto* types, List<double>(file, "tokenizer.ggml.token_type"));
  if (scores->size() != pieces->size() || types->size() != pieces->size())
    return DataLoss("the lists of tokens, scores and types have " + std::to_string(pieces->size()) +
                    ", " + std::to_string(scores->size()) + " and " +
                    std::to_string(types->size()) + " elements");
  for (TokenId token = 0; token < pieces->size(); ++token) {
    const std::string& piece = (*pieces)[token];
    const double type = (*types)[token];
    if (std::isnan((*scores)[token])) return DataLoss("a token's score is no number");
    scores_.push_back(static_cast<float>((*scores)[token]));
    const int byte = type == kByte ? ByteOf(piece) : -1;
    const bool control = type == kControl || type == kUnknown || type == kUnused;
    control_.push_back(control);
    if (byte >= 0) {
      bytes_.push_back(std::string(1, static_cast<char>(byte)));
      of_byte_[byte] = token;
    } else if (control) {
      bytes_.emplace_back();
      controls_.emplace(piece, token);
    } else {
      bytes_.push_back(WithSpaces(piece));
      by_text_.emplace(piece, token);
    }
  }
  return Status();
}

Status Tokenizer::ReadBytePairs(const GgufFile& file) {
  const Result<std::string> pre = file.Text("tokenizer.ggml.pre");
  const std::string words = pre.ok() ? *pre : "gpt-2";
  if (words != "gpt-2" && words != "smollm")
    return DataLoss("tokenizer.ggml.pre is '" + words + "'; read here are 'gpt-2' and 'smollm'");
  LW_ASSIGN_OR_RETURN(const auto* pieces, List<std::string>(file, "tokenizer.ggml.tokens"));
  LW_ASSIGN_OR_RETURN(const auto* merges, List<std::string>(file, "tokenizer.ggml.merges"));
  LW_ASSIGN_OR_RETURN(const auto* types, List<double>(file, "tokenizer.ggml.token_type"));
  if (types->size() != pieces->size())
    return DataLoss("the lists of tokens and types have " + std::to_string(pieces->size()) +
                    " and " + std::to_string(types->size()) + " elements");
  for (TokenId token = 0; token < pieces->size(); ++token) {
    const bool control = (*types)[token] != kNormal && (*types)[token] != kUserDefined;
    control_.push_back(control);
    bytes_.push_back(control ? std::string() : BytesOfPiece((*pieces)[token]));
    if (control) controls_.emplace((*pieces)[token], token);
  }
  LW_ASSIGN_OR_RETURN(pairs_, BytePairs::Make(*pieces, *merges, words == "smollm"));
  adds_space_ = false;
  return Status();
}

Status Tokenizer::ReadEnds(const GgufFile& file) {
  if (bytes_.empty()) return DataLoss("the list of tokens is empty");
  const std::uint64_t last = bytes_.size() - 1;
  LW_ASSIGN_OR_RETURN(const std::uint64_t end,
                      file.Integer("tokenizer.ggml.eos_token_id", 0, last));
  end_ = static_cast<TokenId>(end);
  if (file.Has("tokenizer.ggml.unknown_token_id")) {
    LW_ASSIGN_OR_RETURN(const std::uint64_t unknown,
                        file.Integer("tokenizer.ggml.unknown_token_id", 0, last));
    unknown_ = static_cast<TokenId>(unknown);
  }
  const auto flag = [&](const char* key, bool otherwise) {
    const auto found = file.metadata().find(std::string_view(key));
    const bool* value =
        found == file.metadata().end() ? nullptr : std::get_if<bool>(&found->second);
    return value == nullptr ? otherwise : *value;
  };
  const bool begins = flag("tokenizer.ggml.add_bos_token", !pairs_.has_value());
  if (begins && file.Has("tokenizer.ggml.bos_token_id")) {
    LW_ASSIGN_OR_RETURN(const std::uint64_t begin,
                        file.Integer("tokenizer.ggml.bos_token_id", 0, last));
    begin_ = static_cast<TokenId>(begin);
  }
  adds_space_ = flag("tokenizer.ggml.add_space_prefix", adds_space_);
  return Status();
}

std::optional<TokenId> Tokenizer::Control(std::string_view name) const {
  const auto found = controls_.find(std::string(name));
  if (found == controls_.end()) return std::nullopt;
  return found->second;
}

std::vector<TokenId> Tokenizer::Encode(std::string_view text) const {
  if (pairs_.has_value()) return pairs_->Encode(text);
  std::vector<TokenId> tokens;
  EncodeByMerging(WithMarks(text), &tokens);
  return tokens;
}

void Tokenizer::EncodeByMerging(const std::string& text, std::vector<TokenId>* tokens) const {
  // At first each character is a symbol of its own, in a doubly linked list.
  std::vector<Symbol> symbols;
  for (std::size_t at = 0; at < text.size();) {
    Symbol symbol;
    symbol.at = at;
    symbol.size = CharacterBytes(std::string_view(text).substr(at));
    symbol.before = static_cast<int>(symbols.size()) - 1;
    at += symbol.size;
    symbol.after = at < text.size() ? static_cast<int>(symbols.size()) + 1 : -1;
    symbols.push_back(symbol);
  }
  // Two neighbours that make a token together may be merged.
  std::priority_queue<Merge> merges;
  const auto offer = [&](int left, int right) {
    if (left < 0 || right < 0) return;
    const std::size_t size = symbols[left].size + symbols[right].size;
    const auto found = by_text_.find(text.substr(symbols[left].at, size));
    if (found != by_text_.end()) merges.push({scores_[found->second], left, right, size});
  };
  for (std::size_t i = 1; i < symbols.size(); ++i)
    offer(static_cast<int>(i) - 1, static_cast<int>(i));
  // The best merge is done first, unless an earlier one has changed one of its symbols.
  while (!merges.empty()) {
    const Merge merge = merges.top();
    merges.pop();
    Symbol& left = symbols[merge.left];
    Symbol& right = symbols[merge.right];
    if (left.size == 0 || right.size == 0 || left.size + right.size != merge.size) continue;
    left.size = merge.size;
    right.size = 0;
    left.after = right.after;
    if (right.after >= 0) symbols[right.after].before = merge.left;
    offer(left.before, merge.left);
    offer(merge.left, left.after);
  }
  // What is left are tokens; a character that is none is spelled in bytes.
  for (const Symbol& symbol : symbols) {
    if (symbol.size == 0) continue;
    const std::string piece = text.substr(symbol.at, symbol.size);
    const auto found = by_text_.find(piece);
    if (found != by_text_.end()) {
      tokens->push_back(found->second);
    } else {
      AddBytes(piece, tokens);
    }
  }
}

void Tokenizer::AddBytes(std::string_view text, std::vector<TokenId>* tokens) const {
  for (const char c : text)
    tokens->push_back(of_byte_[static_cast<unsigned char>(c)].value_or(unknown_));
}

}  // namespace latticeworld
