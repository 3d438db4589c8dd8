"""Writes PNG files of 8 bits a channel."""
import struct
import zlib


def write_png(path, width, height, channels, rows):
    """`rows`: bytes of each row, from the top. `channels`: 1 grey, 2 with alpha, 3 colours, 4 with alpha."""
    colour_type = {1: 0, 2: 4, 3: 2, 4: 6}[channels]

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    packed = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows), 9)
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, colour_type, 0, 0, 0)) +
                  chunk(b"IDAT", packed) + chunk(b"IEND", b""))
