"""pack and tools/ledger pack report sizes: pages, texts and JSON add up to the file, and are compared with earlier
ones. In a long run Chromium opens the film's page."""
import base64
import json
import os
import re
import shutil
import zlib
from pathlib import Path

import pytest

from pictures import numpy, read_picture
from running import BUILD, SOURCE, needs, number, refuses, run

needs('objdump', 'gcc', 'ar', 'perl')
pytestmark = pytest.mark.usefixtures('made')
long = pytest.mark.long
PROGRAMS, EXAMPLE = SOURCE / 'tests/support/programs', SOURCE / 'packer/example/build.sh'
PACK = (BUILD / 'pack', '--model', SOURCE / 'tests/support/small.model')
FIRST = 'program -o packed --map program.map'
SECOND = 'second/program -o other --map second/program.map'


def pack(words, **options):
    return run(*PACK, *words.split(), **options).stdout


def build(folder, more):
    """Builds a program of two files, one of them in an archive."""
    (folder / 'folder').mkdir(parents=True)
    run('gcc', '-O1', '-c', f'-DMORE={more}', PROGRAMS / 'once.c', '-o', 'folder/main.o', cwd=folder)
    run('gcc', '-O1', '-c', PROGRAMS / 'twice.c', cwd=folder)
    run('ar', 'rc', 'libtwice.a', 'twice.o', cwd=folder)
    run(*'gcc folder/main.o libtwice.a -Wl,-Map=program.map -o program'.split(), cwd=folder)


@pytest.fixture(scope='module')
def made(in_work):
    """A program; its page, report and text; and a second program, in which one function is longer."""
    build(in_work, '')
    build(in_work / 'second', '+ (i > 5 ? i / 7 : i << 20 ^ 0x12345678)')
    pack(f'{FIRST} --html a.html --report a.json --text a.md --budget 5000')


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


def report_adds_up(path):
    """Asserts that each part of a report adds up, in whole bits; returns the report."""
    report = json.loads(Path(path).read_text())
    parts = [part for part in report.values() if isinstance(part, dict) and part]
    assert len(parts) >= 2
    for part in parts:
        assert 8 * report['overhead'] + report['rest'] + sum(row['bits'] for row in part.values()) == 8 * report['file']
    return report


def test_page_and_report_add_up_to_the_file_whose_size_the_text_has():
    tables, instructions = adds_up('a.html')
    size = os.path.getsize('packed')
    assert tables['file'] == report_adds_up('a.json')['file'] == size
    assert 10 <= len(tables['stretches']) < 100
    assert instructions > 0
    assert re.search(rf'^\*\*`packed`: {size:,} bytes\*\*, .* left of 5,000$', Path('a.md').read_text(), re.M)


def test_the_page_lists_each_part_once_has_the_programs_bytes_and_needs_no_network():
    *_, objects, folders, symbols = zip(*adds_up('a.html')[0]['stretches'])
    assert {('twice.o', 'libtwice.a'), ('main.o', 'folder')} <= set(zip(objects, folders))
    assert symbols.count('once') + symbols.count('again') == 1, 'two names of one function'
    assert '(nothing named in .rodata)' in symbols
    address = re.search(r' \.text +PROGBITS +([0-9a-f]+)', run('readelf', '-SW', 'program').stdout)[1]
    run('objcopy', '-O', 'binary', '-j', '.text', 'program', 'code')
    code, at = Path('code').read_bytes(), int(address, 16)
    assert part_of('a.html', 'bytes')[at:at + len(code)] == code
    assert not re.search(r'https?://|src=|@import|url\(', page := Path('a.html').read_text())
    assert '<noscript><p>This page needs JavaScript' in page  # a browser that runs scripts does not show it


def test_without_objdump_the_page_has_no_instructions_and_without_symbols_the_text_is_about_sections():
    pack('program -o packed_c --html c.html', env={'PATH': '/none'})
    assert adds_up('c.html')[1] == 0
    run('strip', 'program', '-o', 'stripped')
    pack('stripped -o packed_d --html d.html --text d.md')
    adds_up('d.html')
    assert '|   packed | section |\n' in Path('d.md').read_text()


def test_the_page_of_a_program_made_for_packing_adds_up():
    run('bash', EXAMPLE, 'true', '.')
    pack('hello.elf -o hello --html e.html --report e.json')
    adds_up('e.html')
    report_adds_up('e.json')


def test_for_windows_all_adds_up_but_the_zeros_that_fill_the_file():
    run('bash', EXAMPLE, 'true', '.', '--pe')
    printed = pack('hello_windows.elf -o hello.exe --pe --html f.html --report f.json')
    adds_up('f.html')
    used, size = report_adds_up('f.json')['file'], os.path.getsize('hello.exe')
    assert -(-used // 512) * 512 == size
    left = 65536 - used  # the zeros do not count for the budget
    assert re.search(rf'^hello\.exe: {used} bytes used of {size} .* {left} bytes left of 65536$', printed, re.M)
    # The file may not exceed the budget, either
    command = f'hello_windows.elf -o hello.exe --pe --budget {size - 1}'
    assert 'over budget by 1 bytes (' in run(*PACK, *command.split(), status=1).stderr


# --- Two builds ---
def test_a_comparison_names_what_grew():
    Path('rooms').write_text('house 100 main.o twice.o\nstub 4000 (stub)\n')
    text = pack(f'{SECOND} --html g.html --report g.json --text - --than a.json --rooms rooms')
    assert len(re.findall(r'^\| +\+\d+ \| +\d+ \| +\d+ \| `(?:once|again)` \|$', text, re.M)) == 1
    assert not re.search('^other: ', text, re.M)
    tables, _ = adds_up('g.html')
    assert tables['shares'] == {'house': 100, 'stub': 4000}
    assert tables['stubRoom'] == 'stub'
    unchanged = pack(f'{SECOND} --text - --than g.json')
    assert re.search(r'^No symbol changed by four bytes or more\.$', unchanged, re.M)


def test_a_program_over_its_budget_gets_a_page_too_and_a_missing_earlier_report_is_noted():
    pack(f'{SECOND} --html over.html --budget 9', status=1)
    adds_up('over.html')
    result = run(*PACK, *f'{FIRST} --text - --than none'.split())
    note = 'pack: there is no none yet, so nothing is compared: write it with --report'
    assert note in result.stderr.splitlines()
    assert ' symbol' in result.stdout


@pytest.mark.parametrize('words, text', [
    ('--than foreign', 'foreign: not a report of pack'), ('--report none/x', 'cannot write none/x')])
def test_refuses_before_anything_is_packed_or_written(words, text):
    Path('foreign').write_text('{"file": 5}\n')
    before = sorted(os.listdir())
    refuses(2, text, *PACK, *f'program -o refused --map program.map --html x.html {words}'.split())
    assert sorted(os.listdir()) == before


# --- tools/ledger ---
def ledger(*options, build=BUILD):
    return run(SOURCE / 'tools/ledger', 'pack', *options, env={'BUILD': build}).stdout


# This program is in place of the film
def test_the_films_page_has_rooms_and_adds_up():
    os.makedirs('film/generated')
    for name, place in ('program', 'odraz.elf'), ('program.map', 'odraz.map'), ('a.html', 'odraz'):
        shutil.copy(name, f'film/{place}')
    os.symlink(BUILD / 'pack', 'film/pack')
    Path('film/generated/symbols').touch()
    assert re.search('^the 20 costliest symbols ', ledger(build='film'), re.M)
    ledger('--html', 'film.html', '--than', SOURCE / 'intro/size_ledger.json', build='film')
    tables, _ = adds_up('film.html')
    assert tables['shares']['stub'] >= 1000
    assert tables['stubRoom'] == 'stub'
    assert tables['before']['rooms']['intro'] >= 10


@pytest.fixture(scope='module')
def page(in_work):
    needs('chromium', 'convert')
    ledger('--html', in_work / 'whole.html', '--than', SOURCE / 'intro/size_ledger.json')
    return in_work / 'whole.html'


@pytest.fixture
def browse(tmp_path):
    """browse(PAGE, OPTION...) opens a page without a network, and returns what chromium prints. The page may print
    nothing on its console."""
    def browse(page, *options):
        result = run('chromium', '--headless', '--no-sandbox', '--disable-gpu', '--enable-logging=stderr',
                     f'--user-data-dir={tmp_path}/profile', '--host-resolver-rules=MAP * ~NOTFOUND',
                     '--window-size=1400,1440', '--virtual-time-budget=60000', *options, f'file://{page}')
        assert not re.search('.*:CONSOLE.*', result.stderr, re.I)
        return result.stdout
    return browse


@long
def test_the_page_is_small_and_a_film_compared_with_itself_is_the_same(page):
    _, instructions = adds_up(page)
    assert 10000 <= instructions < 100000
    assert page.stat().st_size <= 640 * 1024
    text = ledger('--text', '-', '--than', BUILD / 'odraz.json')
    assert re.search(r'^\*\*`odraz`: [0-9,]+ bytes\*\*, \+0 .* left of 65,536$', text, re.M)
    assert re.search(r'^No symbol changed by four bytes or more\.$', text, re.M)


@long
def test_the_page_answers_mouse_and_keys_and_shows_what_objdump_does(page, browse, tmp_path):
    script = (SOURCE / 'tests/programs/report/poke.js').read_text()
    poked = tmp_path / 'poked.html'
    poked.write_text(page.read_text().replace('</body>', f'<script>{script}</script></body>', 1))
    dom = browse(poked, '--dump-dom')
    assert re.search('data-failed="([^"]*)"', dom)[1] == ''
    assert number('data-checked="([0-9]+)"', dom) >= 30

    code = run(*'objdump -d -w -z -M intel --no-show-raw-insn'.split(), BUILD / 'odraz.elf').stdout
    lines = re.findall(r'^ *([0-9a-f]+):\t(.*)', code, re.M)
    # without objdump's symbols
    wanted = [re.sub('  +', ' ', re.sub(' *<.*', '', f'{address} {text}')).rstrip() for address, text in lines]
    shown = re.search('<pre class="instructions">(.*?)</pre>', dom, re.S)[1].splitlines()
    assert len(shown) == len(wanted) > 20000
    assert not sorted(set(shown) ^ set(wanted))[:5]


@long
@pytest.mark.parametrize('size', ['1400,1440', '500,900'])
def test_the_page_is_drawn(size, page, browse, tmp_path):
    browse(page, '--hide-scrollbars', f'--window-size={size}', f'--screenshot={tmp_path}/page.png')
    colours = numpy.unique(read_picture(tmp_path / 'page.png').reshape(-1, 3), axis=0)
    assert len(colours) > 500


@long
def test_a_damaged_page_shows_an_error(page, browse, tmp_path):
    damaged = tmp_path / 'damaged.html'
    damaged.write_text(re.sub('(id="tables">.{5000}).', r'\1!', page.read_text(), count=1))
    assert 'This page cannot be shown' in browse(damaged, '--dump-dom')
