"""Forms of a plane as a picture: a PNG with a see-through ground."""

import struct
import zlib

PIXELS_PER_MM = 3


BLOCK = 8  # pixels


def drawn(layers, width, height):
    """Rows of RGBA. layers: (form, colour), one over the other; x from the middle, y up from the lower edge, mm."""
    columns, count = int(width * PIXELS_PER_MM), int(height * PIXELS_PER_MM)
    rows = [bytearray(4 * columns) for _ in range(count)]
    place = lambda column, row: (column / PIXELS_PER_MM - 0.5 * width, (count - row) / PIXELS_PER_MM)
    for top in range(0, count, BLOCK):
        for left in range(0, columns, BLOCK):
            seen = nearby(layers, *place(left + 0.5 * BLOCK, top + 0.5 * BLOCK))
            if not seen:
                continue
            even = pixel(seen, 0.0, 0.0) if all(form is None for form, _ in seen) else None
            for row in range(top, min(top + BLOCK, count)):
                for column in range(left, min(left + BLOCK, columns)):
                    rows[row][4 * column:4 * column + 4] = \
                        even or pixel(seen, *place(column + 0.5, row + 0.5))
    return rows


def nearby(layers, x, y):
    """The layers that are seen in a block about this place; those that cover it all without a form."""
    seen = []
    for form, colour in layers:
        d = form(x, y) * PIXELS_PER_MM
        if d < -1.2 * BLOCK:
            seen = [(None, colour)]
        elif d < 1.2 * BLOCK:
            seen.append((form, colour))
    return seen


def pixel(layers, x, y):
    colour, cover = (255.0, 255.0, 255.0), 0.0
    for form, over in layers:
        share = min(1.0, max(0.0, 0.5 - form(x, y) * PIXELS_PER_MM)) if form else 1.0
        if share > 0.0:
            total = share + cover * (1.0 - share)
            colour = [(share * b + (total - share) * a) / total for a, b in zip(colour, over)]
            cover = total
    return bytes(int(c + 0.5) for c in (*colour, 255.0 * cover))


def write_png(path, rows):
    def chunk(kind, content):
        whole = kind + content
        return struct.pack(">I", len(content)) + whole + struct.pack(">I", zlib.crc32(whole))
    header = struct.pack(">IIBBBBB", len(rows[0]) // 4, len(rows), 8, 6, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b""))
