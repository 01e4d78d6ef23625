#!/usr/bin/env python3
"""Usage: tools/texture_sheet.py FOLDER SHEET.png [MIP]: draws all textures of FOLDER/textures.wad, with their names, in
the colors of FOLDER/gfx/palette.lmp."""
import struct
import sys
import zlib

WIDTH, GAP, LABEL = 1120, 4, 9
INK, GROUND = 14, 1  # palette indices of two grays

# Letters of 3 x 5 pixels: one octal digit per row, its highest bit on the left.
LETTERS = {
    'a': '25755', 'b': '65656', 'c': '34443', 'd': '65556', 'e': '74647', 'f': '74644', 'g': '34553', 'h': '55755',
    'i': '72227', 'j': '11152', 'k': '55655', 'l': '44447', 'm': '57755', 'n': '65555', 'o': '25552', 'p': '65644',
    'q': '25563', 'r': '65655', 's': '34216', 't': '72222', 'u': '55557', 'v': '55552', 'w': '55775', 'x': '55255',
    'y': '55222', 'z': '71247', '0': '75557', '1': '26227', '2': '61247', '3': '61216', '4': '55711', '5': '74616',
    '6': '34757', '7': '71222', '8': '75757', '9': '75716', '_': '00007', '+': '02720', '*': '05250', '{': '32423'}


def read_textures(wad, mip):
    count, table = struct.unpack_from('<ii', wad, 4)
    for i in range(count):
        place, _, _, kind, _, _, name = struct.unpack_from('<iiiBBh16s', wad, table + 32 * i)
        if kind != 68:
            continue
        width, height, *mips = struct.unpack_from('<6I', wad, place + 16)
        width, height = width >> mip, height >> mip
        start = place + mips[mip]
        rows = [wad[start + y * width:start + (y + 1) * width] for y in range(height)]
        yield name.split(b'\0')[0].decode(), width, rows


def lay_out(textures):
    """Arranges textures of equal height in rows. Returns (name, left, top, rows of texels) of each, and the total height."""
    placed, left, top, highest = [], GAP, GAP, 0
    for name, width, rows in sorted(textures, key=lambda t: (len(t[2]), t[0].lstrip('+0123456789'), t[0])):
        cell = max(width, 4 * len(name))
        if left + cell + GAP > WIDTH or (highest and len(rows) != highest):
            left, top, highest = GAP, top + highest + LABEL + GAP, 0
        placed.append((name, left, top, rows))
        left, highest = left + cell + GAP, len(rows)
    return placed, top + highest + LABEL + GAP


def draw(placed, height):
    sheet = [bytearray([GROUND]) * WIDTH for _ in range(height)]
    for name, left, top, rows in placed:
        for y, row in enumerate(rows):
            sheet[top + y][left:left + len(row)] = row
        for i, letter in enumerate(name):
            for y, bits in enumerate(LETTERS.get(letter.lower(), '00000')):
                for x in range(3):
                    if int(bits) & (4 >> x):
                        sheet[top + len(rows) + 2 + y][left + 4 * i + x] = INK
    return sheet


def write_png(path, palette, sheet):
    def chunk(kind, body):
        return struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))
    pixels = b''.join(b'\0' + bytes(row) for row in sheet)
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>2I5B', WIDTH, len(sheet), 8, 3, 0, 0, 0)) +
                   chunk(b'PLTE', palette) + chunk(b'IDAT', zlib.compress(pixels, 9)) + chunk(b'IEND', b''))


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    folder, path = sys.argv[1:3]
    mip = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    with open(folder + '/textures.wad', 'rb') as wad, open(folder + '/gfx/palette.lmp', 'rb') as palette:
        write_png(path, palette.read(), draw(*lay_out(list(read_textures(wad.read(), mip)))))


main()
