#!/usr/bin/env bash
# transformers splits words otherwise than SentencePiece where two pieces of a BPE vocabulary have the same score.
#
# Versions: transformers 5.24.0, tokenizers 0.23.3, sentencepiece 0.2.3, protobuf 7.36.2 and numpy 2.4.6 from PyPI.
# Expected: LlamaTokenizer made from a SentencePiece model file yields the pieces that SentencePiece itself yields.
# Observed: SentencePiece merges the pair of the highest score, and of pairs with equal scores the leftmost one.
# transformers turns the scores into a list of ranked merges, in which no two are equal: of pairs with equal scores it
# takes the piece that stands first in the vocabulary. With "bc" before "ab" and equal scores, "abc" is "ab c" in
# SentencePiece and "a bc" in transformers, so that the network gets other numbers. If "ab" stands first, then both
# agree, which shows that it is the order of the vocabulary. Trained vocabularies have distinct scores, but pieces that
# are appended to one often share a score.
# Since: In transformers 4.57.3 LlamaTokenizerFast did so, while LlamaTokenizer ran SentencePiece and was right. In the
# 5.x version here LlamaTokenizer does it too.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check transformers==5.24.0 tokenizers==0.23.3 sentencepiece==0.2.3 \
    protobuf==7.36.2 numpy==2.4.6

venv/bin/python - <<'PY' 2> messages.txt | tee seen.txt
import os
import sentencepiece
import transformers
from sentencepiece import sentencepiece_model_pb2

BPE, NORMAL, UNKNOWN, CONTROL = 2, 1, 2, 3


def write(folder, pairs):
    model = sentencepiece_model_pb2.ModelProto()
    model.trainer_spec.model_type = BPE
    model.normalizer_spec.name = "identity"
    model.normalizer_spec.remove_extra_whitespaces = False
    special = [("<unk>", 0, UNKNOWN), ("<s>", 0, CONTROL), ("</s>", 0, CONTROL)]
    letters = [(letter, -3, NORMAL) for letter in "\u2581abc"]
    for text, score, kind in special + [(pair, -1, NORMAL) for pair in pairs] + letters:
        piece = model.pieces.add()
        piece.piece, piece.score, piece.type = text, score, kind
    os.mkdir(folder)
    with open(folder + "/tokenizer.model", "wb") as file:
        file.write(model.SerializeToString())


for pairs in (["bc", "ab"], ["ab", "bc"]):
    folder = "_".join(pairs)
    write(folder, pairs)
    reference = sentencepiece.SentencePieceProcessor(model_file=folder + "/tokenizer.model")
    tokenizer = transformers.LlamaTokenizer.from_pretrained(folder)
    for name, split in (("SentencePiece", reference.encode("abc", out_type=str)), ("transformers", tokenizer.tokenize("abc"))):
        print("vocabulary", *pairs, f"in {name}:", *(piece.replace("\u2581", "_") for piece in split))
PY

grep -q '^vocabulary bc ab in SentencePiece: _ ab c$' seen.txt
grep -q '^vocabulary bc ab in transformers: _ a bc$' seen.txt
grep -q '^vocabulary ab bc in SentencePiece: _ ab c$' seen.txt
grep -q '^vocabulary ab bc in transformers: _ ab c$' seen.txt
echo "The behaviour is as described."
