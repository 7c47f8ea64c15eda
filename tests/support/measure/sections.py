"""Two sections that take no time, and a figure of the first, in place of those of tools/measure."""
from types import SimpleNamespace

import figures
from parts import table


def section(name, source):
    rows = [{'what': 'ball', 'ms': 1234.56}]
    return SimpleNamespace(name=name, title=name, minutes=1, sources=[source], programs=['program'], packages=[],
                           targets=[], parts=[table(lambda machine: rows, 'what =; ms'), 'Text.'])


def balls(results):
    return f"Balls: {figures.rounded(results.cell('one', 'ms', 'ball'))} ms.\n"


figures.filled_in.__defaults__ = (balls,)
SECTIONS = [section('one', 'intro'), section('two', 'packer/file')]
