"""The parts of a section: tables and paragraphs. A part is a text, or a function from the machine to Markdown."""
import csv
import re
import textwrap

from machine import Failed


def rows(text):
    """The rows of a CSV as dictionaries, keyed by the column titles."""
    return list(csv.DictReader(text.splitlines()))


def markdown(lines):
    """A Markdown table of rows of cells, of which the first is the head."""
    head, *body = ['| ' + ' | '.join(map(str, line)) + ' |' for line in lines]
    return '\n'.join([head, '|' + '---|' * len(lines[0]), *body])


def table(source, columns):
    """A part with a table. `source` is a command that prints a CSV, or source(machine) returns dictionaries. columns:
    'key = heading; key; ...'."""
    pairs = [' '.join(column.split()).partition('=') for column in columns.split(';')]
    keys, heads = [key.strip() for key, _, _ in pairs], [(head or key).strip() for key, _, head in pairs]

    def part(machine):
        lines = list(source(machine) if callable(source) else rows(machine.run(source)))
        missing = [key for key in keys if lines and key not in lines[0]]
        if missing:
            raise Failed(f"table {'; '.join(heads)}: its source has no '{missing[0]}'")
        return markdown([heads] + [[line[key] for key in keys] for line in lines])
    return part


def matrix(source, corner):
    """A part with a table of cells: source(machine) yields (row, column, value). Rows and columns keep their order of
    first appearance."""
    def part(machine):
        cells = {(row, column): value for row, column, value in source(machine)}
        across = list(dict.fromkeys(column for _, column in cells))
        down = dict.fromkeys(row for row, _ in cells)
        return markdown([[corner, *across]] + [
            [row, *(cells.get((row, column), '') for column in across)] for row in down])
    return part


def text_of(part, machine):
    if callable(part):
        return part(machine)
    filled = re.sub(r'\{(\w+)\}', lambda name: str(machine.facts[name[1]]), textwrap.dedent(part).strip())
    return textwrap.fill(' '.join(filled.split()), 120, break_long_words=False, break_on_hyphens=False)
