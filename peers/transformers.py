"""transformers reads the tokenizers of the models that are shipped."""
# pypi: transformers==5.24.0 gguf==0.19.0 sentencepiece==0.2.3 protobuf tiktoken jinja2 numpy==2.4.6

import pathlib

import transformers

from peer import Peer

MODELS = pathlib.Path(__file__).resolve().parents[1] / "models"
TEXTS = ("A lake in the lower left, a wood in the upper left.", "GGGGWWWW\nGGGGGGGG\n",
         "Caf\u00e9, 3 km", "  two  blanks")


def main():
    peer = Peer("transformers", transformers.__version__, "`models/*.gguf`, the tokenizers")
    for path in sorted(MODELS.glob("*.gguf")):
        try:
            tokenizer = transformers.AutoTokenizer.from_pretrained(str(MODELS), gguf_file=path.name)
        except Exception as error:
            peer.check(path.name, False, repr(error)[:200])
            continue
        back = [tokenizer.decode(tokenizer(text)["input_ids"], skip_special_tokens=True)
                for text in TEXTS]
        same = sum(a.strip() == b.strip() for a, b in zip(TEXTS, back))
        chat = tokenizer.apply_chat_template([{"role": "user", "content": "A lake."}],
                                             tokenize=False, add_generation_prompt=True)
        peer.check(path.name, True, f"{len(tokenizer)} tokens, {same} of {len(TEXTS)} texts come back "
                   f"as they were, a chat is {chat!r}")
    peer.finish()


main()
