#!/usr/bin/python3
"""world_server with the shipped reader, asked as a vision model captions aerial pictures.

LATTICEWORLD_READER: the reader joined with its base (scripts/fetch_reader.sh).
"""

import os
import unittest

from server_process import Server
from world_client import World, run

# Of the author g01 (training/examples/left_out), on whom nobody trained. Each with claims that are to
# be read in it: the kind, and a word of what it quotes.
CAPTIONS = {
    "Aerial view of a residential suburb bisected by a straight road running from the top edge to the "
    "bottom edge, with dense woodland filling the left half and detached houses scattered across the "
    "right half.": {("course", "road"), ("shape", "road"), ("amount", "woodland"), ("scattered", "")},
    "A winding river enters at the left edge of the picture, passes through a small village near the "
    "centre, and empties into a large lake in the lower right.":
        {("through", "river"), ("present", "village"), ("present", "lake"), ("amount", "lake")},
}
LEAST_READ = 0.6  # of the words that say something


class ReaderTest(unittest.TestCase):
    def test_captions_of_aerial_pictures_become_the_worlds_that_they_tell_of(self):
        with Server(reader_model=os.environ["LATTICEWORLD_READER"]):
            world = World()
            for caption, claims in CAPTIONS.items():
                answer = world.generate(seed=5, layout=caption, environment="")  # fails unless it is OK
                self.assertEqual("checked", answer.reading.reader)
                self.assertGreaterEqual(len(answer.reading.layout), 3, answer.reading)
                self.assertGreaterEqual(answer.reading.words_read, LEAST_READ * answer.reading.words,
                                        answer.reading)
                for claim in answer.fidelity:
                    self.assertTrue(claim.satisfied, claim)
                    self.assertIn(claim.words, caption)
                for kind, word in claims:
                    self.assertTrue(any(kind == claim.kind and word in claim.words
                                        for claim in answer.fidelity), (kind, word, answer.fidelity))


if __name__ == "__main__":
    run("reader_test", ReaderTest)
