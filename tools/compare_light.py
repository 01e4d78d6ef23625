#!/usr/bin/env python3
"""Usage: tools/compare_light.py TEMBLOR ROOMS.md [NAME]...

Compiles the rooms of a table and compares the light with the table's. ROOMS.md has rows
`| NAME | SAMPLES, MEAN, MAX | ...`, and ROOMS/NAME.map lies next to it. Means are also compared as totals (samples times
mean), because the compilers cut faces in different places. Ends with status 1 if a room differs by more than 5%, and
more than one step of the light map, in the maximum and in either the mean or the total.
"""
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

TOLERANCE = 0.05
LIGHT_LUMP = 8
# Palette entry 4 is a neutral gray of 63.
TEXTURES = {"TECH04_1": 4, "TLIGHT01": 4, "SKY4": 4, "*WATER0": 4}


def write_wad(path):
    """Writes one plain texture for each name that the rooms use."""
    size = 64
    data, directory = b"", b""
    for name, texel in TEXTURES.items():
        width, height = (size * 2, size) if name.startswith("SKY") else (size, size)
        texture = struct.pack("<16s6I", name.encode(), width, height, 40, 40 + width * height,
                              40 + width * height * 5 // 4, 40 + width * height * 21 // 16)
        texture += bytes([texel]) * (width * height * 85 // 64)
        directory += struct.pack("<3I2BH16s", 12 + len(data), len(texture), len(texture), 0x44, 0, 0, name.encode())
        data += texture
    path.write_bytes(struct.pack("<4s2I", b"WAD2", len(TEXTURES), 12 + len(data)) + data + directory)


def measure(bsp):
    """Returns the number, mean, and maximum of the level's gray samples."""
    offset, size = struct.unpack_from("<2I", bsp, 4 + LIGHT_LUMP * 8)
    samples = bsp[offset:offset + size]
    return len(samples), sum(samples) / max(1, len(samples)), max(samples, default=0)


def differs(ours, theirs):
    return abs(ours - theirs) > max(1, TOLERANCE * theirs)


def main():
    temblor, table, names = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]), sys.argv[3:]
    failed = 0
    print(f"{'room':24}{'expected':>20}{'ours':>20}{'mean':>7}{'total':>7}{'max':>7}")
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        write_wad(work / "base.wad")
        for name, *expected in re.findall(r"^\| ([\w-]+) \| (\d+), ([\d.]+), (\d+) \|", table.read_text(), re.M):
            if names and name not in names:
                continue
            room = work / f"{name}.map"
            room.write_text((table.with_suffix("") / room.name).read_text())
            done = subprocess.run([temblor, "compile", "--clean", str(room)], cwd=work, capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"{name}: {done.stderr}")
            count, mean, brightest = measure((work / f"{name}.bsp").read_bytes())
            samples, their_mean, their_max = (float(number) for number in expected)
            total_ratio = count * mean / (samples * their_mean) if samples * their_mean else 1 + count
            mean_ratio = mean / their_mean if their_mean else 1 + count
            is_wrong = differs(brightest, their_max) or (
                differs(mean, their_mean) and abs(total_ratio - 1) > TOLERANCE)
            failed += is_wrong
            print(f"{name:24}{samples:10.0f}{their_mean:6.1f}{their_max:4.0f}{count:10}{mean:6.1f}{brightest:4}"
                  f"{mean_ratio:7.2f}{total_ratio:7.2f}{brightest / their_max if their_max else 1 + count:7.2f}"
                  f"{'  differs' if is_wrong else ''}")
    print(f"{failed} rooms differ")
    sys.exit(failed != 0)


if __name__ == "__main__":
    main()
