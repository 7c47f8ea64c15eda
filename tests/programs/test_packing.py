"""The packer's command line, with the small example."""
import os
import re
import shutil
import signal
from pathlib import Path

import pytest

from running import BUILD, SOURCE, refuses, run

PACK = BUILD / 'pack'


@pytest.fixture(scope='module')
def made(work):
    """A folder with the example without symbols, which pack would report; and packed, with a report."""
    run('bash', SOURCE / 'packer/example/build.sh', 'true', work)  # `true` in place of pack
    run('strip', '-s', '-o', work / 'in', work / 'hello.elf')
    shutil.copy(SOURCE / 'tests/support/small.model', work / 'model')
    run(PACK, *'in --model model -o hello --report report'.split(), cwd=work)
    return work


@pytest.fixture(autouse=True)
def in_a_folder(made, tmp_path, monkeypatch):
    """Runs the test in a folder with copies of these files alone."""
    for name in 'in', 'model', 'hello', 'report':
        shutil.copy(made / name, tmp_path)
    monkeypatch.chdir(tmp_path)


def pack(words, **options):
    return run(PACK, *words.split(), **options)


def test_packs_over_its_earlier_output_and_prints_the_difference():
    assert re.search(r', before \d+ \(\+0\), ', pack('in --model model -o hello').stdout)
    assert os.access('hello', os.X_OK)


def test_the_films_packer_makes_the_same_and_a_plain_program_runs():
    Path('none').touch()
    result = run(BUILD / 'pack_film', *'elf in same model'.split(), '', *'65536 none none same.json'.split())
    assert re.fullmatch(r'same: \d+ bytes .* left of 65536\n', result.stdout)  # tools/ledger pack prints the costs
    run('cmp', 'same', 'hello')
    run('cmp', 'same.json', 'report')
    pack('in -o plain --plain')
    result = run('./plain', 'a', 'b', status=7)
    assert (result.stdout, result.stderr) == ('hello, 3 words, 42\n', '')


def test_an_interrupted_search_packs_with_the_best_contexts_so_far(background):
    # It starts from unsuitable contexts, so that there are better ones to find
    unsuited = re.sub('^code ', 'code byte4+byte3+instruction1+', Path('model').read_text(), flags=re.M)
    Path('unsuited').write_text(unsuited)
    assert 'bytes left' in pack('in -o poor --model unsuited').stdout
    search = background(PACK, *'in -o found --model unsuited --effort 100000 --save-model better'.split())
    search.comes(lambda: re.search(r'searching: \d+ bytes after \d+ tries, \d+ of 100000 s', search.errors()))
    search.works(1)
    search.signal(signal.SIGINT)
    assert search.ended() == 0
    assert Path('found').stat().st_size < Path('poor').stat().st_size
    assert 'bytes left' in pack('in -o again --model better').stdout
    run('cmp', 'found', 'again')


def test_a_search_ends_by_itself_and_contexts_may_replace_those_that_were_given():
    assert 'bytes left' in pack('in -o found --effort 0.5').stdout
    pack('in -o packed --model model --save-model model')


def test_a_program_may_have_just_its_budget():
    size = Path('hello').stat().st_size
    assert ', 0 bytes left' in pack(f'in --model model -o hello --budget {size}').stdout
    command = f'in --model model -o hello --budget {size - 1}'
    refuses(1, 'over budget by 1 bytes (3,', PACK, *command.split())
    assert not Path('hello').exists()
    Path('appended').write_text('kept\n')
    with open('appended', 'ab') as appended:  # a file that is appended to is not removed
        pack('in --model model -o /dev/stdout --budget 9', status=1, stdout=appended)
    assert Path('appended').read_text() == 'kept\n'


# (test_radiosity.py tests outputs that are pipes)
def test_packs_where_nobody_reads_what_it_prints():
    reading, writing = os.pipe()
    os.close(reading)
    with open(writing, 'wb') as closed:
        pack('in --model model -o packed', status=None, stdout=closed)
    run('cmp', 'packed', 'hello')


@pytest.mark.parametrize('text, words', [
    ('not a regular file', 'fifo -o x'),
    ('it is packed already', 'hello -o x'),
    ('cannot write', 'in --model model -o /dev/full/x'),
    ('would be overwritten', 'in -o ./in'),
    ('would be overwritten', 'in -o x --html in'),
    ('would be overwritten', 'in -o x --model model --report model')])
def test_refuses_and_writes_nothing(text, words, made):
    os.mkfifo('fifo')
    refuses(2, text, PACK, *words.split())
    assert sorted(os.listdir()) == ['fifo', 'hello', 'in', 'model', 'report']
    run('cmp', 'in', made / 'in')
