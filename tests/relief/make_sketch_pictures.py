"""Writes one small sketch in the picture formats that OpenCV reads but does not write.

usage: make_sketch_pictures.py DIRECTORY

64 x 64 pixels: a blue stroke in columns 15 to 18, a black one in rows 40 to 43 over it, on white.
"""
import pathlib
import struct
import sys
import zlib

SIDE = 64
WHITE, BLUE, BLACK = 0, 1, 2
COLOURS = [(255, 255, 255), (20, 60, 230), (10, 10, 10)]


def ink(row, col):
    if 40 <= row <= 43:
        return BLACK
    return BLUE if 15 <= col <= 18 else WHITE


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(bits, colour_type, pixel, extra=b""):
    """pixel: the bytes of a pixel by its ink; for 1 bit its value."""
    lines = b""
    for row in range(SIDE):
        if bits == 1:
            value = sum(pixel(ink(row, col)) << (SIDE - 1 - col) for col in range(SIDE))
            line = value.to_bytes(SIDE // 8, "big")
        else:
            line = b"".join(pixel(ink(row, col)) for col in range(SIDE))
        lines += b"\0" + line
    header = struct.pack(">IIBBBBB", SIDE, SIDE, bits, colour_type, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra +
            chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def tiff(photometric, samples, pixel, more=()):
    """Uncompressed, 8 bits a sample. more: further entries (tag, type, values)."""
    data = b"".join(pixel(ink(row, col)) for row in range(SIDE) for col in range(SIDE))
    short, long = 3, 4
    entries = [(256, long, [SIDE]), (257, long, [SIDE]), (258, short, [8] * samples), (259, short, [1]),
               (262, short, [photometric]), (273, long, [8]), (277, short, [samples]),
               (278, long, [SIDE]), (279, long, [len(data)]), *more]
    entries.sort()
    start = 8 + len(data)
    after = start + 2 + 12 * len(entries) + 4
    directory, tail = struct.pack("<H", len(entries)), b""
    for tag, kind, values in entries:
        packed = struct.pack("<" + ("H" if kind == short else "I") * len(values), *values)
        if len(packed) > 4:
            place = struct.pack("<I", after + len(tail))
            tail += packed
        else:
            place = packed.ljust(4, b"\0")
        directory += struct.pack("<HHI", tag, kind, len(values)) + place
    return b"II*\0" + struct.pack("<I", start) + data + directory + struct.pack("<I", 0) + tail


def cmyk(colour):
    black = 255 - max(colour)
    return bytes([255 - black - channel for channel in colour] + [black])


def main():
    directory = pathlib.Path(sys.argv[1])
    directory.mkdir(parents=True, exist_ok=True)
    palette = chunk(b"PLTE", b"".join(bytes(c) for c in COLOURS))
    # What is not drawn is a transparent black.
    see_through = chunk(b"PLTE", b"".join(bytes(c) for c in [(0, 0, 0)] + COLOURS[1:]))
    pictures = {
        "palette.png": png(8, 3, lambda i: bytes([i]), palette),
        "palette_transparent.png": png(8, 3, lambda i: bytes([i]), see_through + chunk(b"tRNS", b"\0")),
        "rgba.png": png(8, 6, lambda i: bytes((0, 0, 0) if i == WHITE else COLOURS[i]) +
                        bytes([255 * (i != WHITE)])),
        "rgba_16.png": png(16, 6, lambda i: struct.pack(">4H", *(257 * c for c in COLOURS[i]),
                                                        65535 * (i != WHITE))),
        "rgb_16.png": png(16, 2, lambda i: struct.pack(">3H", *(257 * c for c in COLOURS[i]))),
        "cmyk.tiff": tiff(5, 4, lambda i: cmyk(COLOURS[i]), [(332, 3, [1])]),
        "rgb.tiff": tiff(2, 3, lambda i: bytes(COLOURS[i])),
        "palette.tiff": tiff(3, 1, lambda i: bytes([i]), [
            (320, 3, [257 * (COLOURS[i][k] if i < 3 else 0) for k in range(3) for i in range(256)])]),
        # These have no blue.
        "grey_1.png": png(1, 0, lambda i: i == WHITE),
        "grey_alpha.png": png(8, 4, lambda i: bytes([0, 255 * (i == BLACK)])),
        "grey_alpha_16.png": png(16, 4, lambda i: struct.pack(">2H", 0, 65535 * (i == BLACK))),
        "grey_16.png": png(16, 0, lambda i: struct.pack(">H", 257 * COLOURS[i][0])),
    }
    for name, data in pictures.items():
        (directory / name).write_bytes(data)


if __name__ == "__main__":
    main()
