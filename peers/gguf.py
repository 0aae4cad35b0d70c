"""gguf reads the models that are shipped, and writes one of them again."""
# pypi: gguf==0.19.0 numpy==2.4.6

import importlib.metadata
import pathlib

import gguf
import numpy

from peer import Peer

MODELS = pathlib.Path(__file__).resolve().parents[1] / "models"


def main():
    peer = Peer("gguf", importlib.metadata.version("gguf"), "`models/*.gguf`")
    for path in sorted(MODELS.glob("*.gguf")):
        reader = gguf.GGUFReader(path)
        fields = {key: field.contents() for key, field in reader.fields.items()}
        kinds = sorted({tensor.tensor_type.name for tensor in reader.tensors})
        weights = sum(int(tensor.n_elements) for tensor in reader.tensors)
        finite = all(numpy.isfinite(gguf.quants.dequantize(tensor.data, tensor.tensor_type)).all()
                     for tensor in reader.tensors)
        peer.check(path.name, finite, f"{fields['general.architecture']}, {weights} weights as "
                   f"{', '.join(kinds)}, {len(fields.get('tokenizer.ggml.tokens', []))} tokens, chat "
                   f"template: {'yes' if 'tokenizer.chat_template' in fields else 'no'}")
    peer.finish()


main()
