#!/usr/bin/env bash
# Usage: tools/measure_code.sh: prints measurements of the sources:
#   the number of files in each folder, with a mark where there are more than 25;
#   the share of comment lines, own-line comments / (code + own-line comments), for each top folder;
#   functions with more than 7 parameters; the longest files and functions.
# The parser is a heuristic: it finds functions by their braces and does not expand macros.
cd "$(dirname "$0")/.." || exit 1
exec python3 - <<'PYTHON'
import collections
import re
import subprocess

MOST_FILES = 25
MOST_PARAMETERS = 7
FOLDERS = ("src", "tests", "bench", "fuzz")

tracked = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], capture_output=True,
                         text=True, check=True).stdout.split("\n")
tracked = [path for path in tracked if "/" in path and not path.startswith("build/")]


def blank(match):
    """Replaces a match by the same number of empty lines."""
    return " " + "\n" * match.group(0).count("\n")


TOKENS = re.compile(r'R"(\w*)\((?:.|\n)*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*(?:.|\n)*?\*/'
                    r'|^[ \t]*#(?:[^\n\\]|\\(?:.|\n))*', re.M)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def parameters(text):
    """Counts the parameters in the text between a function's parentheses."""
    depth, count = 0, 1
    for c in text:
        if c in "(<[{":
            depth += 1
        elif c in ")>]}":
            depth -= 1
        elif c == "," and depth == 0:
            count += 1
    return count if text.strip() not in ("", "void") else 0


FUNCTION = re.compile(r"([~\w:<>,\s*&\[\]]*?)([\w:~]+|operator[^\s(]+)\s*$")
NOT_A_FUNCTION = re.compile(r"\b(if|for|while|switch|catch|return|namespace|struct|class|enum|union|do|else|case)\b|=")


def functions(text):
    """Yields (name, number of parameters, first line, number of lines) of each function with a body."""
    text = TOKENS.sub(blank, text)
    start, stack = 0, []
    for i, c in enumerate(text):
        if c == "{":
            head = text[start:i]
            found = None
            close = head.find("(")
            if close >= 0:
                depth, end = 0, -1
                for j in range(close, len(head)):
                    depth += {"(": 1, ")": -1}.get(head[j], 0)
                    if depth == 0:
                        end = j
                        break
                name = FUNCTION.search(head[:close])
                if end > 0 and name and not NOT_A_FUNCTION.search(head[:close]) and name.group(1).strip() + name.group(2):
                    first = text.count("\n", 0, start + len(head) - len(head.lstrip())) + 1
                    found = (name.group(2), parameters(head[close + 1:end]), first)
            stack.append(found)
            start = i + 1
        elif c == "}":
            found = stack.pop() if stack else None
            if found:
                yield *found, text.count("\n", 0, i) + 2 - found[2]
            start = i + 1
        elif c == ";":
            start = i + 1


print("files in each folder (more than %d: !)" % MOST_FILES)
counts = collections.Counter(path.rsplit("/", 1)[0] for path in tracked)
for folder, count in sorted(counts.items()):
    if not folder.startswith("fuzz/corpus"):
        print("%s %4d %s" % ("!" if count > MOST_FILES else " ", count, folder))

comments, code = collections.Counter(), collections.Counter()
long_files, long_functions, long_lists = [], [], []
for path in tracked:
    top = path.split("/")[0]
    if top not in FOLDERS or not path.endswith((".cpp", ".h")):
        continue
    text = read(path)
    key = "/".join(path.split("/")[:2]) if top == "src" else top
    lines = [line.strip() for line in text.split("\n") if line.strip()]
    own = sum(line.startswith("//") for line in lines)
    for name in {key, top, "all"}:
        comments[name] += own
        code[name] += len(lines) - own
    long_files.append((len(text.split("\n")) - 1, path))
    for name, count, first, length in functions(text):
        long_functions.append((length, "%s:%d %s" % (path, first, name)))
        if count > MOST_PARAMETERS:
            long_lists.append((count, "%s:%d %s" % (path, first, name)))

print("\ncomment lines / (code + comment lines)")
for name in sorted(code):
    print("  %5.1f %%  %s" % (100 * comments[name] / (comments[name] + code[name]), name))
print("\nfunctions with more than %d parameters" % MOST_PARAMETERS)
for count, where in sorted(long_lists, reverse=True) or [(0, "none")]:
    print("  %3d %s" % (count, where))
for title, rows in (("longest files, lines", long_files), ("longest functions, lines", long_functions)):
    print("\n" + title)
    for length, where in sorted(rows, reverse=True)[:15]:
        print("  %4d %s" % (length, where))
PYTHON
