"""By what the reader `checked` chooses between two readings: what is read of the program's tables, and the fit."""

import io
import os
import stat
import tempfile
import unittest
from contextlib import redirect_stdout
from unittest import mock

import numpy

from latticeworld_training import fit_choice

TOLD = {"log_probability": -0.1, "words": 10, "carried": 6, "second_carried": 9, "lost": 3, "second_lost": 1, "claims": 4,
        "second_claims": 6, "agreed": 3}


class FitTest(unittest.TestCase):
    def signs(self, count, seed):
        draws = numpy.random.default_rng(seed)
        return numpy.hstack([numpy.ones((count, 1)), draws.normal(size=(count, 6))])

    def test_weights_tell_which_reading_is_better(self):
        for seed in range(5):
            signs = self.signs(400, seed)
            truth = numpy.array([0.5, 2.0, 0.0, -1.0, 0.0, 0.7, 0.0])
            gains = numpy.where(signs @ truth > 0, 2, -1)
            weights = fit_choice.fit(signs, gains)
            right = (signs @ weights > 0) == (gains > 0)
            self.assertGreater(right.mean(), 0.95, weights)

    def test_texts_that_both_read_as_well_tell_nothing(self):
        signs = self.signs(200, 3)
        gains = numpy.where(signs[:, 1] > 0, 1, -1)
        more = numpy.vstack([signs, self.signs(200, 4)])
        numpy.testing.assert_allclose(fit_choice.fit(more, numpy.concatenate([gains, numpy.zeros(200, int)])),
                                      fit_choice.fit(signs, gains))

    def test_that_a_model_is_sure_never_speaks_against_it(self):
        signs = self.signs(300, 5)
        gains = numpy.where(-signs[:, fit_choice.SURE] + signs[:, 4] > 0, 1, -1)
        weights = fit_choice.fit(signs, gains)
        self.assertEqual(weights[fit_choice.SURE], 0.0)
        self.assertGreater(weights[4], 0.0)

    def test_signs_are_bounded(self):
        numpy.testing.assert_allclose(fit_choice.signs_of(TOLD), [1, -0.1, 2, 0.3, 0.5, 0.75, 0.5])
        far = dict(TOLD, log_probability=-9, lost=90, claims=0, second_claims=50, agreed=0)
        self.assertEqual(fit_choice.signs_of(far)[1:5], [-1, 4, 0.3, 2])


class ProgramTest(unittest.TestCase):
    def test_parts_of_the_programs_tables_are_fitted_apart(self):
        evidence = " ".join(f"{name}={number}" for name, number in TOLD.items())
        lines = ["environment instructions, x", "  agents               1 of     4   0.250", "  coarse    4 of 4 1.000"]
        lines += ["  all claims           5 of     8   0.625", '  x 1 agents: "3 sheep"', "       0 sheep; 3 is asked"]
        lines += ['  x 1 no_agents: "No robots"', '  x 2 agents: "a horse"']
        lines += [f"  x {text} evidence of {part}: {evidence}" for text in (1, 2) for part in ("agents", "coarse")]
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "program")
            with open(program, "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\ncat <<'END'\n" + "\n".join(lines) + "\nEND\n")
            os.chmod(program, stat.S_IRWXU)
            misses, told, claims = fit_choice.score(program, "x.jsonl", [])
            self.assertEqual(misses, {("agents", "x 1"): 2, ("agents", "x 2"): 1})
            self.assertEqual(told["coarse", "x 2"], TOLD)
            self.assertEqual(claims, {"agents": 4, "coarse": 4})
            arguments = ["", "--program", program, "--reader-model", "m", "--examples", "x.jsonl"]
            with mock.patch("sys.argv", arguments), redirect_stdout(io.StringIO()) as said:
                fit_choice.main()
        self.assertIn("agents: of 4 claims hold: model 1, rules 1, chosen 1, the better one 1", said.getvalue())
        self.assertIn("coarse: of 4 claims hold: model 4", said.getvalue())


if __name__ == "__main__":
    unittest.main()
