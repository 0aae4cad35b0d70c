#!/usr/bin/env python3
"""Runs the tests against real llama.cpp and writes what went over the wire as Markdown.

Usage: record_exchange.py LANGUAGE_LLAMA_TEST OUT.md
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

TESTS = ("LlamaTest.NoiseUnderTheGrammarIsALegalLayoutInOneTurn:"
         "LlamaTest.WhatTheSchemaLetsThroughWronglyIsCaughtByValidation")
LONGEST = 1900  # characters of a text that are shown
EVENTS = 3  # shown from either end of a stream


def shortened(text):
    if len(text) <= LONGEST:
        return text
    half = LONGEST // 2
    return f"{text[:half]}\n[... {len(text) - 2 * half} characters left out ...]\n{text[-half:]}"


def fenced(text, kind="text"):
    return f"```{kind}\n{text.rstrip()}\n```\n"


def exchange(record, title, shown):
    body = dict(record["request"])
    messages = body.pop("messages")
    schema = body.get("json_schema")
    if schema is not None:
        length = len(json.dumps(schema, separators=(",", ":")))
        body["json_schema"] = f"[the schema of the system prompt, {length} characters]"
    out = [f"## {title}\n", "Request, `POST /v1/chat/completions`, but for its messages:\n",
           fenced(json.dumps(body, indent=2), "json")]
    for message in messages:
        text = message["content"]
        out += [f"Message of the `{message['role']}`:\n",
                "(the same as above)\n" if text in shown else fenced(shortened(text))]
        shown.add(text)
    events = record["events"]
    out += [f"Answer, a stream of {len(events)} events; the first and the last {EVENTS}:\n",
            fenced("".join(events[:EVENTS])
                   + f"[... {len(events) - 2 * EVENTS} events left out ...]\n\n"
                   + "".join(events[-EVENTS:]) + "data: [DONE]\n"),
            "Its text, put together:\n", fenced(record["answer"])]
    shown.add(record["answer"])
    return "\n".join(out)


def main():
    test, out = sys.argv[1:]
    with tempfile.TemporaryDirectory() as directory:
        records = pathlib.Path(directory, "records")
        subprocess.run([test, "--gtest_filter=" + TESTS], check=True,
                       env={**os.environ, "LLAMA_RECORD": str(records)})
        lines = [json.loads(line) for line in records.read_text().splitlines()]
    layout = lines[0]
    shown = set()
    environments = [line for line in lines if "json_schema" in line["request"]]
    text = [
        "# A recorded exchange with llama.cpp\n",
        "Written by `tests/language/remote/llama/record_exchange.py` from a run of",
        "`language_llama_test`: the remote back end's own client against real llama.cpp (by way of",
        "node-llama-cpp) with a tiny LLaMA model of random weights. The answers are noise; that",
        "they are legal all the same is the work of the grammar, and that what the schema let through",
        "wrongly goes back to the model is the work of the validation. Texts longer than",
        f"{LONGEST} characters are cut in their middle, and say so.\n",
        exchange(layout, "A layout under a GBNF grammar", shown),
        exchange(environments[0], "An environment under a JSON schema", shown),
        exchange(environments[1], "The same, asked to repair what the schema cannot say", shown),
    ]
    pathlib.Path(out).write_text("\n".join(text))


if __name__ == "__main__":
    main()
