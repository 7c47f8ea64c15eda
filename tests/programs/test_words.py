"""Random command lines of words that are right, wrong, extreme, missing, repeated, empty, very long or not even text.

The program ends with status 0, 1 or 2, and leaves no half-written file. When it fails it prints one line on standard
error and nothing on standard output; when it succeeds it prints nothing on standard error. --help lists the options.
"""
import os
import re
import shutil
from pathlib import Path

import pytest

from running import BUILD, FILM, SOURCE, needs_built, refuses, run

LONG = 100000 * '0'
JUNK = ['', ' ', 'two\nlines', '\33[31mred', 'žluťoučký kůň', '\udcff\udcfe\1', LONG,
        *'- -- 0 -1 1e999 -nan inf 99999999999999999999 0x10 +1 .5 1. ٣ %n%s%x --help= -h ...'.split(),
        *'*\'"\\', '/dev/null/x', 'none/deeper']
FOLDERS = [*'d d/ ./e . d/. ž \udcff - none/d file /proc'.split(), LONG[:300], LONG[:5000]]
TO_WRITE = [*'a ./b ž \udcfe - none/b . file /dev/full /dev/null'.split(), LONG[:300], LONG[:5000]]
TO_READ = [*'file fifo /dev/zero /dev/null none .'.split(), '']
# Values to try for a placeholder of --help, or for an option. The first three are likely to be valid
VALUES = {name: values.split() for name, values in {
    '--effort': 'fast 0 0.1 fastest',  # others search for minutes
    '--page': '256 8192 16384 255 16385',
    'A': '1 10 30 0.01 1e30 1e31 1e-19 1e6 0 -1',
    'BYTES': '65536 1e8 9999 1 0 1e9 1.5',
    'DEGREES': '10 60 -90 170 0 171 1e9',
    'ELEVATION,AZIMUTH,R,G,B': '30,60,5,5,5 90,0,1,2,3 0,0,1,1,1 -90,400,1,1,1 1,2,3,4 1,2,3,4,-5',
    'FACTOR': '0.5 l=1 2 l=0 l=1e13',
    'LIST': 'all none 1 l=2 2 1,1 l= ,',
    'MATERIAL': 'l m none',
    'MB': '500 100 900 1 0.5 1e6 1e7',
    'N': '8 1 32 2 16 25 64 0 6 7 33 65 1026 32769 1.5 -1',
    'N/M': '30000/1001 1000 23.976 60 1/1000 1001 25/0 23.9761 1000000/1000000',
    'R': '1 1e-4 0.5 2 1e-8',
    'R,E': '0.06,16 0,1000 1,1 2,1 1,0 1',
    'R,G,B': '1,1,1 0.2,0.3,0.5 0,0,0 -1,0,0 1,2 nan,0,0',
    'S': '20 20.04 20.1 20.2 20.123456 20.1234567 00020 0 0.01 19 164 163.999999 164.000001 165 100001 1e30 1e31 -1',
    'STOPS': '0 -20 20 21',
    'WxH': '16x9 1x1 8x8 64x36 7x13 7680x1 1x4320 0x0 7681x1 16x 16X9 16x9x3 x9 -16x9 99999999999x9',
    'X,Y,Z': '0,5,4.9 0,4,-5 0,0,0 1e30,0,0 1,2 1,2,3,4 nan,0,0',
    'X,Y,Z,SIZE,R,G,B': '1,2,3,0.5,9,9,9 0,0,0,1e-9,1,1,1 1e9,0,0,1,1,1,1 0,0,0,0,1,1,1 1,2,3',
    '[NAME=]R,G,B': '0,0.5,1 l=1,1,2 1,1,1 none=1 1,2 =',
}.items()}
VALUES |= {'AREA': VALUES['A'], 'DIR': FOLDERS, 'K': VALUES['N'], 'PX': VALUES['N']}

SHORT = '--size 16x9 --quality draft --from 20 --to 20.04'
PICTURE = '-o x.png --size 16x9 --eye 0,5,4 --at 0,4,-5'
# A command line has one of these, before or after its random words: it keeps the run short
BOUNDS = {
    'film': [SHORT, f'{SHORT} --dump e', f'{SHORT} --dump e'],
    'pack': ['hello.elf -o out', 'file -o out', '/dev/zero -o out', '--test test', '--test fifo', '-d test -o out',
             'hello.elf', 'fifo'],
    'radiosity': ['generate cube -o x.obj', 'solve m.obj -o x.rad', 'solve m.rad', 'solve fifo -o x.rad', 'solve',
                  'transfer m.obj -o x.prt --rays 8', f'render m.rad {PICTURE}', f'render m.prt {PICTURE}',
                  'render m.prt', 'render', 'export m.rad --csv x.csv', 'export m.prt --csv x.csv', 'export m.obj',
                  'sing', '']}


def make_files(name, folder):
    """Makes the files that words name. An option that a file is named after reads files; other options write them."""
    (folder / 'file').write_text('a text\n')
    os.mkfifo(folder / 'fifo')
    if name == 'pack':
        run('bash', SOURCE / 'packer/example/build.sh', BUILD / name, folder)
        run(BUILD / name, 'hello.elf', '-o', 'test', '--save-model', 'model', '--report', 'than', cwd=folder)
        shutil.copy(folder / 'test', folder / 'd')
        shutil.copy(BUILD / f'{FILM}.map', folder / 'map')
        (folder / 'symbols').write_text(run('nm', '-A', 'hello.elf', cwd=folder).stdout)
        (folder / 'rooms').write_text('room 9 a.o\n')
    if name == 'radiosity':
        shutil.copy(SOURCE / 'tests/support/models/lamp.obj', folder / 'm.obj')
        shutil.copy(SOURCE / 'tests/support/models/lamp.mtl', folder)
        shutil.copy(SOURCE / 'tests/support/pictures/zip_rgba.exr', folder / 'sky')
        run(BUILD / name, 'solve', 'm.obj', '-o', 'm.rad', '--patch', 1, '--element', 1, cwd=folder)
        run(BUILD / name, 'transfer', 'm.obj', '-o', 'm.prt', '--bands', 2, '--element', 1, cwd=folder)
        shutil.copy(folder / 'm.rad', folder / 'resume')


def options_of(*command, folder):
    """The options that --help lists, each with its values: those that are likely to be valid, and all."""
    options = []
    usage = run(*command, '--help').stdout
    for option, placeholder, about in re.findall(r'^ +(--?[a-z][a-z-]*)(?: (\S+))? *(.*)', usage, re.M):
        likely, every = [], []
        for part in [option] if option in VALUES else placeholder.split('|') if placeholder else []:
            if part in VALUES:
                values = VALUES[part]
            elif part.islower() or part == '-':
                values = [part]
            elif part == 'NAME':
                choices = re.match(r'(\w+, )+\w+ or \w+', about)  # draft, play or film
                values = re.split(', | or ', choices[0]) if choices else ['x']
            elif (folder / option.strip('-')).exists():
                values = [option.strip('-')] * 3 + TO_READ + sorted(os.listdir(folder))
            else:
                values = [f'x{Path(part).suffix}', *TO_WRITE]
            likely += values[:3]
            every += values
        options.append((option, likely, every))
    return options


def group(chance, option, likely, values):
    """An option and a value, or what a user might write in their place."""
    junk, given = chance.choice(JUNK), [option, chance.choice(values)] if values else [option]
    # An option without a value takes the next word as its value
    odd = [[option], [junk], [option[:-1]], [f'{option}={given[-1]}'], [option, junk], [option, junk], given, given]
    kind = chance.randrange(32)
    if kind < len(odd):
        return odd[kind]
    return [option, chance.choice(likely)] if likely else [option]


def faults_of(name, result, folder, given):
    """What is wrong with a run."""
    lines = result.stderr.split(b'\n')[:-1]
    if name == 'radiosity':
        lines = [line for line in lines if not line.startswith(b'progress: ')]
    if result.returncode == 0:
        # radiosity prints notes on the model, pack its search's progress, and a note if the file of --than is missing
        notes = {'radiosity': (b'radiosity: ',), 'pack': (b'searching', b'pack: there is no')}.get(name, ())
        if any(not line.startswith(notes) for line in lines):
            yield 'it prints errors although it succeeds'
    elif result.returncode == 1 and re.search(b'^processor: ', result.stdout, re.M):
        return  # --doctor prints a list, and exits with 1 if something is missing
    elif result.returncode in (1, 2):
        if len(lines) != 1:
            yield f'{len(lines)} lines on standard error'
        if result.stdout and name != 'pack':  # which prints its results before it fails to write a file
            yield 'standard output although it fails'
    else:
        yield f'status {result.returncode}'
    if result.stderr and not result.stderr.endswith(b'\n'):
        yield 'half a line on standard error'
    if re.search(rb'[\x01-\x09\x0b-\x1f]', result.stderr):
        yield 'control characters on standard error'
    if set(os.listdir(folder)) != given:
        yield from (f'{file} is left behind' for file in folder.rglob('*.part'))
        for file in folder.rglob('*.ppm'):
            picture = file.read_bytes()
            header = re.match(rb'P6\n(\d+) (\d+)\n255\n', picture)
            if not header or len(picture) != header.end() + 3 * int(header[1]) * int(header[2]):
                yield f'{file} is not whole'


@pytest.mark.parametrize('name, runs', [
    (f'{FILM}-safe', 40), ('radiosity', 60), *[pytest.param(*more, marks=pytest.mark.long) for more in (
        (FILM, 100), (f'{FILM}-safe', 2000), ('pack', 300), ('radiosity', 300))]])
def test_survives_random_words(name, runs, chance, tmp_path):
    needs_built(name)
    given, folder = tmp_path / 'given', tmp_path / 'run'
    given.mkdir()
    make_files(name, given)
    run('cp', '-a', given, folder)
    commands = ['generate', 'solve', 'transfer', 'export', 'render'] if name == 'radiosity' else []
    known = {command: options_of(BUILD / name, command, folder=given) for command in commands}
    every = options_of(BUILD / name, folder=given) + sum(known.values(), [])
    assert len(every) >= 6
    successes = 0
    for n in range(runs):
        bounds = chance.choice(BOUNDS.get(name, BOUNDS['film'])).split()
        options = known.get(bounds[0], every) if bounds else every
        words = sum((group(chance, *chance.choice(options)) for _ in range(chance.randrange(5))), [])
        words = bounds + words if chance.randrange(2) else words + bounds
        result = run(BUILD / name, *words, cwd=folder, status=None, text=False)
        faults = list(faults_of(name, result, folder, set(os.listdir(given))))
        assert not faults, f'{faults} in run {n}: {words!a:.2000}\n{result.stderr[:1000]}'
        successes += result.returncode == 0
        if set(os.listdir(folder)) != set(os.listdir(given)):
            shutil.rmtree(folder)
            run('cp', '-a', given, folder)
    print(f'{successes} of {runs} succeeded')
    assert runs / 50 < successes < runs - runs / 50  # otherwise the words would test little


@pytest.mark.parametrize('name', [f'{FILM}-safe', 'pack', 'radiosity'])
def test_repeats_control_characters_as_question_marks(name, tmp_path):
    needs_built(name)
    refuses(2, '?[31mred', BUILD / name, '--\33[31mred', cwd=tmp_path)
