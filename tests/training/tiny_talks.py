"""Small conversations for the tests: words of places, answered by maps of a few rows."""

import json
import random

from latticeworld_training import chat_data, fitting, llama, tokenizer

PLACES = {"north": 0, "south": 1, "west": 2, "east": 3}
THINGS = {"lake": "W", "forest": "F", "farm": "A", "village": "B"}


def answer_of(letter, place, rows=4):
    lines = []
    for row in range(rows):
        if place == "north":
            line = 32 * (letter if row < rows // 2 else "G")
        elif place == "south":
            line = 32 * (letter if row >= rows // 2 else "G")
        else:
            line = (16 * letter + 16 * "G") if place == "west" else (16 * "G" + 16 * letter)
        lines.append(line)
    return "\n".join(lines)


def conversations(count, seed=1):
    """Lists of (role, content), all different up to 16."""
    pairs = [(thing, place) for thing in THINGS for place in PLACES]
    random.Random(seed).shuffle(pairs)
    pairs = [pairs[i % len(pairs)] for i in range(count)]
    return [
        [
            ("system", "You draw maps."),
            ("user", f"A {thing} lies in the {place}."),
            ("assistant", answer_of(THINGS[thing], place) + "\n"),
        ]
        for thing, place in pairs
    ]


def write_conversations(path, count, seed=1):
    with open(path, "w", encoding="utf-8") as file:
        for talk in conversations(count, seed):
            messages = [{"role": role, "content": content} for role, content in talk]
            file.write(json.dumps({"messages": messages, "images": []}) + "\n")


def tiny_tokenizer():
    texts = [content for talk in conversations(16) for role, content in talk if role != "system"]
    return tokenizer.train_tokenizer(texts, most_fours=12, most_words=60)


def tiny_sizes(tokens):
    return llama.LlamaSizes(tokens=tokens, width=32, layers=2, heads=4, kv_heads=2, hidden=64, context=256)


def learned_by_heart(directory, count=8, epochs=250, optimizer="adamw"):
    """A tiny model that knows `count` conversations, its tokenizer, the conversations and the losses of its steps."""
    import torch

    torch.manual_seed(3)
    torch.set_num_threads(1)
    spelling = tiny_tokenizer()
    talks = conversations(count)
    examples, _ = chat_data.encode_all(spelling, talks, 256)
    model = llama.Llama(tiny_sizes(len(spelling)))
    options = fitting.FitOptions(
        optimizer=optimizer, rate=1e-2, epochs=epochs, batch_size=8, warmup_steps=5, checkpoint_steps=epochs
    )
    losses = fitting.fit(model, examples, [], directory, options, say=lambda text: None)
    return model.eval(), spelling, talks, losses
