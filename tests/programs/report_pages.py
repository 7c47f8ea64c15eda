"""Pages of pack --html: what they contain, and whether it adds up."""
import base64
import json
import re
import zlib
from pathlib import Path


def part_of(page, name):
    """A part of a page's data: tables, bytes, costs or code."""
    pattern = rf'<script type="application/octet-stream" id="{name}">([A-Za-z0-9+/=]*)</script>'
    return zlib.decompress(base64.b64decode(re.search(pattern, Path(page).read_text())[1]))


def adds_up(page):
    """Asserts that a page's figures add up to the file; returns its tables, and the number of its instructions."""
    tables, costs = json.loads(part_of(page, 'tables')), list(part_of(page, 'costs'))
    for at, cost in tables['high']:
        costs[at] = cost
    assert len(costs) == len(part_of(page, 'bytes')) == tables['size'], 'not a cost for each byte'
    # Each byte is in one stretch, whose cost is the sum of its bytes' costs
    at = 0
    for begin, size, units, *_ in tables['stretches']:
        assert begin == at and size > 0, f'a stretch at {begin}, not at {at}'
        assert sum(costs[begin:begin + size]) == units, f'the stretch at {begin} costs something else'
        at += size
    assert at == tables['size'], 'stretches end before the program'
    # Instructions lie in the program and do not overlap
    end = instructions = 0
    for line in part_of(page, 'code').decode().splitlines():
        if line.startswith('@'):
            assert int(line[1:], 16) >= end, f'instructions at {line} overlap those before'
            end = int(line[1:], 16)
        else:
            end += int(line[0], 16)
            instructions += 1
    assert end <= tables['size'], 'instructions are not in the program'
    return tables, instructions
