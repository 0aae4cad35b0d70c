"""Fits by what the reader `checked` chooses between its two readings of a text, the model's and the rules'.

    python3 -m latticeworld_training.fit_choice --program devel/lib/latticeworld/latticeworld \
        --reader-model build/models/reader.gguf --examples examples/left_out/k01_layouts.jsonl

The texts are those of authors on whom the model was not trained. Where the two readings have unlike numbers of claims
right in a part (land; coarse attributes, fine ones, agents), a logistic regression learns which has more, each text
weighted by the difference. Prints for each part its kWeights (src/latticeworld/language/reading/reading_evidence.cc),
and how many claims hold by the model's readings, the rules', the chosen ones' (of texts that the weights have not seen,
author by author, or in five folds of one author's) and the better ones'. `checked` fills in besides what only one of
two readings of an environment has: how many of its claims hold `latticeworld score --reader checked` says.
"""

import argparse
import collections
import re
import subprocess

import numpy as np

MISS = re.compile(r'^  (\S+ \d+) (\w+): "')
EVIDENCE = re.compile(r"^  (\S+ \d+) evidence of (\w+): (.*)$")
KIND = re.compile(r"^  (\w+) +(\d+) of +(\d+) ")
PARTS = {"coarse": "coarse", "density": "fine", "variant": "fine", "parameter": "fine", "agents": "agents",
         "no_agents": "agents", "total_agents": "agents"}  # kinds of claims; those of layouts are of the land

SURE = 1  # the place of log_probability in signs_of


def score(program, path, options):
    """{(part, text): misses}, {(part, text): evidence}, {part: claims}: of the texts of a file of examples."""
    command = [program, "score", "--examples", path, "--misses"] + options
    misses, evidence, claims = collections.Counter(), {}, collections.Counter()
    for line in subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines():
        if miss := MISS.match(line):
            misses[PARTS.get(miss[2], "land"), miss[1]] += 1
        elif said := EVIDENCE.match(line):
            pairs = (pair.split("=") for pair in said[3].split())
            evidence[said[2], said[1]] = {name: float(number) for name, number in pairs}
        elif kind := KIND.match(line):
            claims[PARTS.get(kind[1], "land")] += int(kind[3])
    return misses, evidence, claims


def signs_of(evidence):
    """What reading_evidence.cc weighs, in its order."""
    e = evidence
    return [1.0, max(e["log_probability"], -1.0), min(max(e["lost"] - e["second_lost"], -4.0), 4.0),
            (e["second_carried"] - e["carried"]) / max(1, e["words"]),
            min((e["second_claims"] - e["claims"]) / max(1, e["claims"]), 2.0),
            e["agreed"] / max(1, e["claims"]), e["agreed"] / max(1, e["second_claims"])]


def fit(signs, gains, penalty=1.0, sure=SURE):
    """Weights (signs,) of texts with these signs (n, signs), whose model's readings have so many claims more right than
    the rules' (n,). The penalty is of weights of signs scaled to unit deviation. That a model is sure of its sentences
    never speaks against them: its weight is not negative."""
    told = gains != 0
    if not told.any():
        return np.zeros(signs.shape[1])
    x, right, weight = signs[told], (gains[told] > 0).astype(float), np.abs(gains[told])
    mean, deviation = x.mean(0), x.std(0)
    mean[0], deviation[0] = 0.0, 1.0
    deviation[deviation == 0] = 1.0
    x = (x - mean) / deviation
    penalties = penalty * (np.arange(x.shape[1]) > 0)
    weights = np.zeros(x.shape[1])
    for _ in range(50):  # Newton's method
        p = 1.0 / (1.0 + np.exp(-x @ weights))
        slope = x.T @ (weight * (right - p)) - penalties * weights
        curvature = (x * (weight * p * (1.0 - p))[:, None]).T @ x + np.diag(penalties + 1e-9)
        weights = weights + np.linalg.solve(curvature, slope)
    weights = weights / deviation
    weights[0] -= weights[1:] @ mean[1:]
    if sure is not None and weights[sure] < 0:
        weights = np.insert(fit(np.delete(signs, sure, axis=1), gains, penalty, sure=None), sure, 0.0)
    return weights


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="latticeworld")
    parser.add_argument("--reader-model", required=True, help="GGUF file")
    parser.add_argument("--examples", required=True, nargs="+", help="JSON Lines")
    given = parser.parse_args()
    model, rules, evidence, claims = {}, {}, {}, collections.Counter()
    for path in given.examples:
        misses, told, total = score(given.program, path,
                                    ["--reader", "model", "--reader-model", given.reader_model, "--evidence"])
        model.update(misses)
        evidence.update(told)
        claims.update(total)
        rules.update(score(given.program, path, ["--reader", "rules"])[0])
    for part in sorted({part for part, _ in evidence}):
        # What has no evidence is the small language already, and is read once.
        texts = sorted(each for each in evidence if each[0] == part)
        signs = np.array([signs_of(evidence[each]) for each in texts])
        lost = np.array([(model.get(each, 0), rules.get(each, 0)) for each in texts])
        gains = lost[:, 1] - lost[:, 0]
        chosen = 0
        authors = [text.split()[0].split("_")[0] for _, text in texts]
        folds = np.unique(authors, return_inverse=True)[1]
        if folds.max() == 0:
            folds = np.random.default_rng(1).permutation(len(gains)) % 5
        for fold in range(folds.max() + 1):
            weights = fit(signs[folds != fold], gains[folds != fold])
            chosen += lost[:, 0][(folds == fold) & (signs @ weights >= 0)].sum()
            chosen += lost[:, 1][(folds == fold) & (signs @ weights < 0)].sum()
        print(f"{part}: of {claims[part]} claims hold: model {claims[part] - lost[:, 0].sum()}, "
              f"rules {claims[part] - lost[:, 1].sum()}, chosen {claims[part] - chosen}, "
              f"the better one {claims[part] - lost.min(1).sum()}")
        print("    {" + ", ".join(f"{weight:.3f}" for weight in fit(signs, gains)) + "},")


if __name__ == "__main__":
    main()
