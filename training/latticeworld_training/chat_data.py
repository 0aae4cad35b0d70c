"""Conversations in JSON Lines as tokens.

A line is {"messages": [{"role": "system" | "user" | "assistant", "content": "..."}, ...], ...}, what `latticeworld
dataset` writes and the usual fine-tuning tools read. Conversations are laid out in the manner of ChatML with the system
message left out: a model that is trained for one task learns it from the answers, and a long explanation before each of
them would take most of its time.
"""

import json
import random
from dataclasses import dataclass

import torch

from .tokenizer import BEGIN, TURN_BEGIN, TURN_END

# What a GGUF file says of the layout below; LatticeWorld knows it by its marks.
CHAT_TEMPLATE = (
    "{{ bos_token }}{% for message in messages %}{% if message['role'] != 'system' %}"
    "{{ '<|im_start|>' + message['role'] + '\\n' + message['content'] + '<|im_end|>' + '\\n' }}"
    "{% endif %}{% endfor %}{% if add_generation_prompt %}{{ '<|im_start|>assistant\\n' }}{% endif %}"
)
IGNORED = -100  # target of what the loss does not count


@dataclass
class Example:
    tokens: list  # of int
    answers: list  # of bool: whether the token is the assistant's, and counted in the loss


def plain_answer(content):
    """An answer as the decoder's grammars have it: no blanks at its end, and none between the tokens of JSON."""
    content = content.rstrip()
    if not content.startswith("{"):
        return content
    try:
        return json.dumps(json.loads(content), separators=(",", ":"), ensure_ascii=False)
    except ValueError:
        return content


# Before what somebody said of an environment; its prompt shows the map above.
DESCRIPTION = "Description of the environment:"


def brief(messages):
    """A conversation about an environment without what takes most of its tokens and follows from the rest: the map, and
    the answer's fine attributes. Other conversations stay as they are.

    A small model that begins with brief ones hears several times as many descriptions in the same time."""
    shorter = []
    for role, content in messages:
        if role == "user" and DESCRIPTION in content:
            content = content[content.index(DESCRIPTION) :]
        elif role == "assistant" and content.startswith("{"):
            answer = json.loads(content)
            answer.pop("fine", None)
            content = json.dumps(answer, separators=(",", ":"), ensure_ascii=False)
        shorter.append((role, content))
    return shorter


def _pair(role, content):
    return role, plain_answer(content) if role == "assistant" else content


def read_conversations(paths):
    """The messages of each line of the files: lists of (role, content), answers plain.

    Raises ValueError naming file and line."""
    conversations = []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                try:
                    messages = json.loads(line)["messages"]
                    if not any(message["role"] == "assistant" for message in messages):
                        raise ValueError("no message of the assistant")
                    conversations.append([_pair(message["role"], message["content"]) for message in messages])
                except (ValueError, KeyError, TypeError) as error:
                    raise ValueError(f"{path}, line {number}: no conversation: {error!r}") from error
    return conversations


def prompt_tokens(tokenizer, messages):
    """Tokens of (role, content) pairs up to where the answer begins."""
    example = encode_conversation(tokenizer, messages)
    return example.tokens + [TURN_BEGIN] + tokenizer.encode("assistant\n")


def encode_conversation(tokenizer, messages):
    """An Example of (role, content) pairs; answers are made plain."""
    tokens, answers = [BEGIN], [False]
    newline = tokenizer.encode("\n")
    for role, content in messages:
        if role == "system":
            continue
        if role == "assistant":
            opening, said = tokenizer.encode("assistant\n"), tokenizer.encode(plain_answer(content))
        else:
            opening, said = tokenizer.encode(role + "\n" + content), []
        tokens += [TURN_BEGIN] + opening + said + [TURN_END] + newline
        answers += [False] * (1 + len(opening)) + [True] * len(said) + [role == "assistant"] + [False] * len(newline)
    return Example(tokens, answers)


def without_prompt(example):
    """An Example of the answers alone, as if nothing had been asked: what guidance at work compares with."""
    turn = example.answers.index(True)
    while example.tokens[turn] != TURN_BEGIN:
        turn -= 1
    return Example([BEGIN] + example.tokens[turn:], [False] + example.answers[turn:])


def encode_all(tokenizer, conversations, most_tokens):
    """Examples of at most `most_tokens` tokens, and how many conversations were longer."""
    examples = [encode_conversation(tokenizer, messages) for messages in conversations]
    fit = [example for example in examples if len(example.tokens) <= most_tokens]
    return fit, len(examples) - len(fit)


def batches_of_epoch(examples, batch_size, seed, epoch):
    """Lists of indices of examples: all of them once, in an order of seed and epoch; those of a batch are of like
    length, so that little is filled up."""
    order = list(range(len(examples)))
    generator = random.Random(f"{seed} {epoch}")
    generator.shuffle(order)
    batches = []
    pool = 32 * batch_size
    for begin in range(0, len(order), pool):
        some = sorted(order[begin : begin + pool], key=lambda i: len(examples[i].tokens))
        batches += [some[i : i + batch_size] for i in range(0, len(some), batch_size)]
    generator.shuffle(batches)
    return batches


def batch_tensors(examples, device=None):
    """Tokens (batch, length) and what follows each: targets (batch, length), IGNORED where it is not the
    assistant's."""
    length = max(len(example.tokens) for example in examples) - 1
    tokens = torch.zeros(len(examples), length, dtype=torch.long)
    targets = torch.full((len(examples), length), IGNORED)
    for row, example in enumerate(examples):
        size = len(example.tokens) - 1
        tokens[row, :size] = torch.tensor(example.tokens[:-1])
        following = [t if a else IGNORED for t, a in zip(example.tokens[1:], example.answers[1:])]
        targets[row, :size] = torch.tensor(following)
    return tokens.to(device), targets.to(device)
