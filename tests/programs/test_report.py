"""pack and tools/ledger pack report sizes: pages, texts and JSON add up to the file, and are compared with earlier
ones."""
import json
import os
import re
import shutil
from pathlib import Path

import pytest

from report_pages import adds_up, part_of
from running import BUILD, SOURCE, needs, refuses, run

needs('objdump', 'gcc', 'ar', 'perl')
pytestmark = pytest.mark.usefixtures('made')
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


def report_adds_up(path):
    """Asserts that each part of a report adds up, in whole bits; returns the report."""
    report = json.loads(Path(path).read_text())
    parts = [part for part in report.values() if isinstance(part, dict) and part]
    assert len(parts) >= 2
    for part in parts:
        assert 8 * report['overhead'] + report['rest'] + sum(row['bits'] for row in part.values()) == 8 * report['file']
    return report


def test_page_and_report_add_up_to_the_file_and_the_text_has_size_and_budget():
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


# --- tools/ledger, with this program in place of the film ---
def test_the_films_page_has_rooms_and_adds_up():
    os.makedirs('film/generated')
    for name, place in ('program', 'odraz.elf'), ('program.map', 'odraz.map'), ('a.html', 'odraz'):
        shutil.copy(name, f'film/{place}')
    os.symlink(BUILD / 'pack', 'film/pack')
    Path('film/generated/symbols').touch()
    ledger = SOURCE / 'tools/ledger', 'pack'
    assert re.search('^the 20 costliest symbols ', run(*ledger, env={'BUILD': 'film'}).stdout, re.M)
    run(*ledger, '--html', 'film.html', '--than', SOURCE / 'intro/size_ledger.json', env={'BUILD': 'film'})
    tables, _ = adds_up('film.html')
    assert tables['shares']['stub'] >= 1000
    assert tables['stubRoom'] == 'stub'
    assert tables['before']['rooms']['intro'] >= 10
