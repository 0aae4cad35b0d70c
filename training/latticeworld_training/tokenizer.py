"""A tokenizer in SentencePiece's manner, made for maps and plain English.

Text becomes pieces by SentencePiece's merges: of all neighbours that make a piece together, those of the highest score
first, the leftmost of equals (Kudo and Richardson 2018); bytes stand for what has no piece. So GGUF files can hold it
(`tokenizer.ggml.model` "llama"), and LatticeWorld's decoder and llama.cpp divide texts in the same way.

Rows of a map become pieces of four squares counted from the row's beginning, because all pairs of letters have one
score and all fours a higher one: eight tokens a row and one for its end. What lies above a square is thus the same
number of tokens back everywhere, which even a small model can use. A rare four that is no piece becomes two pairs, and
the rest of its row may then be cut two squares aside.
"""

import collections
import heapq
import itertools
import json
import re

from .whole_files import whole_file

SPACE = "\u2581"  # how SentencePiece spells a space
UNKNOWN, BEGIN, TURN_BEGIN, TURN_END = range(4)
CONTROLS = ["<unk>", "<s>", "<|im_start|>", "<|im_end|>"]
FIRST_BYTE = len(CONTROLS)
# llama.cpp's numbers of the kinds of tokens.
NORMAL, KIND_UNKNOWN, CONTROL, BYTE = 1, 2, 3, 6
# Letters of both vocabularies of layouts.
LAYOUT_LETTERS = "ABDFGRSW"
PAIR_SCORE, FOUR_SCORE = 1.0, 2.0
# Within JSON that is written without spaces, members are words: '{' | '"a":[0,0,15],' | '"b":"c",' | ...
_WORD_ENDS = re.compile('(?<=[,{])(?=")')
_CAPITALS = re.compile("[A-Z][A-Z]")


class Tokenizer:
    """pieces: texts of tokens, spaces as SPACE; scores: higher ones are merged first."""

    def __init__(self, pieces, scores):
        self.pieces = list(pieces)
        self.scores = [float(score) for score in scores]
        first = FIRST_BYTE + 256
        self._of_piece = {piece: first + i for i, piece in enumerate(self.pieces[first:])}
        # Neighbours within some piece: a text can be cut wherever there are none.
        self._inner = {pair for piece in self._of_piece for pair in zip(piece, piece[1:])}
        self._known = {}

    def __len__(self):
        return len(self.pieces)

    @property
    def kinds(self):
        """llama.cpp's kind of each token."""
        rest = len(self.pieces) - FIRST_BYTE - 256
        return [KIND_UNKNOWN] + [CONTROL] * (FIRST_BYTE - 1) + [BYTE] * 256 + [NORMAL] * rest

    def encode(self, text):
        """Tokens of a text (list of int), none of which controls."""
        text = text.replace(" ", SPACE)
        tokens = []
        begin = 0
        for at in range(1, len(text) + 1):
            if at < len(text) and (text[at - 1], text[at]) in self._inner:
                continue
            tokens += self._merged(text[begin:at])
            begin = at
        return tokens

    def decode(self, tokens):
        """The text that tokens spell; those that control spell nothing."""
        spelled = b""
        for token in tokens:
            if FIRST_BYTE <= token < FIRST_BYTE + 256:
                spelled += bytes([token - FIRST_BYTE])
            elif token >= FIRST_BYTE + 256:
                spelled += self.pieces[token].replace(SPACE, " ").encode()
        return spelled.decode("utf-8", "replace")

    def _merged(self, text):
        known = self._known.get(text)
        if known is None:
            known = self._merge(text)
            if len(self._known) < 1_000_000:
                self._known[text] = known
        return known

    def _merge(self, text):
        symbols = list(text)  # "" once merged into the one before
        before = list(range(-1, len(symbols) - 1))
        after = list(range(1, len(symbols) + 1))
        merges = []

        def offer(left, right):
            if left < 0 or right >= len(symbols):
                return
            token = self._of_piece.get(symbols[left] + symbols[right])
            if token is not None:
                size = len(symbols[left]) + len(symbols[right])
                heapq.heappush(merges, (-self.scores[token], left, right, size))

        for right in range(1, len(symbols)):
            offer(right - 1, right)
        while merges:
            _, left, right, size = heapq.heappop(merges)
            if not symbols[left] or not symbols[right]:
                continue
            if len(symbols[left]) + len(symbols[right]) != size:
                continue
            symbols[left] += symbols[right]
            symbols[right] = ""
            after[left] = after[right]
            if after[right] < len(symbols):
                before[after[right]] = left
            offer(before[left], left)
            offer(left, after[left])
        tokens = []
        for symbol in filter(None, symbols):
            token = self._of_piece.get(symbol)
            tokens += [token] if token is not None else [FIRST_BYTE + b for b in symbol.encode()]
        return tokens

    def save(self, path):
        with whole_file(path) as file:
            json.dump({"pieces": self.pieces, "scores": self.scores}, file)

    @staticmethod
    def load(path):
        with open(path, encoding="utf-8") as file:
            made = json.load(file)
        return Tokenizer(made["pieces"], made["scores"])


def _is_row(line):
    return len(line) == 32 and not line.strip(LAYOUT_LETTERS)


def _layout_pieces(rows, most_fours):
    """(piece, score): letters, all pairs, and the fours that rows have most often."""
    fours = collections.Counter(row[i : i + 4] for row in rows for i in range(0, 32, 4))
    for letter in LAYOUT_LETTERS:
        fours[4 * letter] += 1
    common = sorted(fours, key=lambda four: (-fours[four], four))[:most_fours]
    pairs = ["".join(pair) for pair in itertools.product(LAYOUT_LETTERS, repeat=2)]
    return (
        [(letter, 0.0) for letter in LAYOUT_LETTERS]
        + [(pair, PAIR_SCORE) for pair in pairs]
        + [(four, FOUR_SCORE) for four in common]
    )


def _word_pieces(words, count):
    """Up to `count` pieces of words ({word: how often}) by byte-pair merges (Sennrich et al. 2016)."""
    pieces = sorted({character for word in words for character in word})[:count]
    spellings = {word: list(word) for word in words}
    while len(pieces) < count:
        pairs = collections.Counter()
        for word, symbols in spellings.items():
            for pair in zip(symbols, symbols[1:]):
                pairs[pair] += words[word]
        # Two capitals side by side belong to rows.
        fit = [pair for pair in pairs if not _CAPITALS.search(pair[0] + pair[1])]
        if not fit:
            break
        best = min(fit, key=lambda pair: (-pairs[pair], pair))
        if pairs[best] < 2:
            break
        pieces.append(best[0] + best[1])
        for word, symbols in spellings.items():
            for i in range(len(symbols) - 1, 0, -1):
                if i < len(symbols) and (symbols[i - 1], symbols[i]) == best:
                    symbols[i - 1 : i + 1] = [best[0] + best[1]]
    return pieces


def train_tokenizer(texts, most_fours=1000, most_words=1000):
    """A tokenizer for texts such as these: at most `most_fours` pieces of maps, `most_words` of words."""
    rows, words = [], collections.Counter()
    for text in texts:
        for line in text.split("\n"):
            if _is_row(line):
                rows.append(line)
            else:
                pieces = _WORD_ENDS.sub(" ", line.replace(" ", " " + SPACE)).split(" ")
                words.update(piece for piece in pieces if piece)
    pieces = [(piece, 0.0) for piece in CONTROLS]
    pieces += [(f"<0x{byte:02X}>", 0.0) for byte in range(256)]
    pieces += _layout_pieces(rows, most_fours)
    taken = {piece for piece, _ in pieces}
    for rank, piece in enumerate(_word_pieces(words, most_words)):
        if piece not in taken:
            pieces.append((piece, -1.0 - rank))
    return Tokenizer(*zip(*pieces))
