"""Runs programs, and waits for them.

A test fails for a wrong result, not for a busy machine: it waits for a condition, not for a fixed time. After PATIENCE
seconds a program is taken to hang, and the test fails. ctest's time-out (tests/CMakeLists.txt) is longer.
"""
import csv
import math
import os
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.pop('BUILD', SOURCE / 'build')).resolve()  # not for the programs: tools/ read a BUILD, too
CONF = dict(re.findall(r'^(\w+)="?(.*?)"?$', (SOURCE / 'intro/film.conf').read_text(), re.M))
FILM = CONF['FILM']
PACKED, SAFE = BUILD / FILM, BUILD / f'{FILM}-safe'  # the same program; the second one starts without unpacking
PATIENCE = float(os.environ.get('PATIENCE', 1200))


def needs(*programs):
    """Skips the test, or at the top of a file all its tests, where one of these programs or files is not installed."""
    for program in programs:
        if not shutil.which(program) and not Path(program).exists():
            pytest.skip(f'{program} is not installed', allow_module_level=True)


def needs_built(*programs):
    """Skips the test, or at the top of a file all its tests, where the build lacks one of these files."""
    for program in programs:
        if not (BUILD / program).exists():
            pytest.skip(f'{program} is not built', allow_module_level=True)


def words_of(command):
    """The words of a command, where paths and numbers may stand for their text."""
    return [word if isinstance(word, (str, bytes)) else str(word) for word in command]


def environment(changes):
    """The environment with some variables changed; those whose value is None are removed."""
    merged = {**os.environ, **(changes or {})}
    merged = {name: value for name, value in merged.items() if value is not None}
    return dict(zip(merged, words_of(merged.values())))


def run(*command, status=0, env=None, **options):
    """Runs a command and returns the completed process, with its outputs as text, or as bytes with text=False.

    It must exit with this status, or be ended by the signal -status; None allows all. env: variables to change, or to
    remove (None). options: those of subprocess.run, such as cwd and input.
    """
    __tracebackhide__ = True
    options = {'stdout': subprocess.PIPE, 'stderr': subprocess.PIPE, 'text': True, 'timeout': PATIENCE, **options}
    if options['text']:
        options['errors'] = 'surrogateescape'
    if 'input' not in options:
        options = {'stdin': subprocess.DEVNULL, **options}
    result = subprocess.run(words_of(command), env=environment(env), check=False, **options)
    if status is not None:
        outputs = f'{result.stdout or ""!s:.2000}\n{result.stderr or ""!s:.2000}'
        assert result.returncode == status, f'{" ".join(map(str, command)):.1000}\n{outputs}'
    return result


def transcript(*command, **options):
    """What a command prints on stdout and stderr together, and its exit status."""
    result = run(*command, status=None, stderr=subprocess.STDOUT, **options)
    return result.stdout, result.returncode


def refuses(status, text, *command, **options):
    """Asserts that a command exits with this status, and prints one line with this text on stderr, nothing on stdout.
    Returns the line."""
    __tracebackhide__ = True
    result = run(*command, status=status, **options)
    line = result.stderr
    assert text in line and line.find('\n') == len(line) - 1, f'wanted "{text}" in one line, got: {line:.1000}'
    assert not result.stdout, f'it printed {result.stdout:.300}'
    return line


def redirected(redirections, *command):
    """The command with a shell's redirections, such as '<&- >/dev/full'."""
    return ('sh', '-c', f'exec "$@" {redirections}', 'sh', *command)


def wait_for(condition, pause=0.1):
    """Calls condition() until it returns something true, and returns that."""
    __tracebackhide__ = True
    end = time.monotonic() + PATIENCE
    while not (result := condition()):
        assert time.monotonic() < end, f'waited {PATIENCE:.0f} s in vain'
        time.sleep(pause)
    return result


class Program:
    """A program in the background, which ends with the `with` block. Its outputs go into files of the folder."""

    def __init__(self, folder, *command, env=None, **options):
        self.out, self.err = Path(folder) / 'out', Path(folder) / 'err'
        with open(self.out, 'wb') as out, open(self.err, 'wb') as err:
            options = {'stdin': subprocess.DEVNULL, 'stdout': out, 'stderr': err, **options}
            self.process = subprocess.Popen(words_of(command), env=environment(env), **options)
        self.pid = self.process.pid

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def output(self):
        """What it has printed so far on stdout."""
        return self.out.read_text(errors='surrogateescape')

    def errors(self):
        """What it has printed so far on stderr."""
        return self.err.read_text(errors='surrogateescape')

    def runs(self):
        return self.process.poll() is None

    def signal(self, number):
        self.process.send_signal(number)

    def ended(self):
        """Waits for its end, and returns its exit status; it is killed if it does not end."""
        try:
            return self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise

    def end(self):
        """Ends it. Nothing depends on how."""
        if self.runs():
            self.signal(signal.SIGTERM)
            self.signal(signal.SIGCONT)
            try:
                self.process.wait(10)
            except subprocess.TimeoutExpired:
                self.process.kill()
        self.process.wait()

    def seconds_worked(self):
        """The processor time that it has used, in seconds, to a hundredth."""
        numbers = Path(f'/proc/{self.pid}/stat').read_text().rpartition(')')[2].split()
        return (int(numbers[11]) + int(numbers[12])) / os.sysconf('SC_CLK_TCK')

    def comes(self, condition, pause=0.1):
        """Waits until condition() is true, and returns its value. The test fails if the program ends first."""
        __tracebackhide__ = True

        def came():
            ended = not self.runs()  # first, since it may end after the condition came true
            return condition() or ended and 'ended'
        value = wait_for(came, pause)
        assert value != 'ended', f'it ended with status {self.process.returncode}: {self.errors():.1000}'
        return value

    def works(self, seconds):
        """Waits until it has used so much more processor time. The test fails if it ends first."""
        __tracebackhide__ = True
        until = self.seconds_worked() + seconds
        return self.comes(lambda: self.seconds_worked() >= until, pause=0.02)


def number(pattern, text):
    """The number that the first group of the pattern matches in the text. Neither nan nor inf is one."""
    found = re.search(pattern, text, re.M)
    assert found, f'no {pattern} in: {text:.2000}'
    value = float(found.group(1))
    assert math.isfinite(value), f'{found.group(0)} is no number'
    return value


def rows_in(text):
    """The rows of a CSV table as dictionaries. It must have a row; its numbers are floats, and finite."""
    def value(text):
        try:
            parsed = float(text)
        except ValueError:
            return text
        assert math.isfinite(parsed), f'the table has the number {text}'
        return parsed
    rows = [{name: value(text) for name, text in row.items()} for row in csv.DictReader(text.splitlines())]
    assert rows, 'the table has no rows'
    return rows


def rows_of(path):
    """The rows of a CSV file (rows_in)."""
    return rows_in(Path(path).read_text())


def check_bytes(got, wanted):
    """Asserts that these bytes are the same. With -v, an `assert` in a test would list all differences, for hours."""
    __tracebackhide__ = True
    assert got == wanted, f'{len(got)} bytes and {len(wanted)} differ after {len(os.path.commonprefix([got, wanted]))}'


def lacking(library, folder):
    """The environment in which this shared library cannot be loaded: a text file in a folder is found in its place."""
    place = Path(folder) / f'{library}.d'
    place.mkdir(exist_ok=True)
    (place / library).write_text('not a library\n')
    return {'LD_LIBRARY_PATH': place}


def flip(path, offset, bits=255):
    """Inverts the bits of one byte of a file that are set in the mask."""
    data = bytearray(Path(path).read_bytes())
    data[offset] ^= bits
    Path(path).write_bytes(data)


class Repository:
    """A small repository of git, and what a test does with it."""

    def __init__(self, folder):
        self.folder = folder
        run('git', 'init', '-q', folder)

    def write(self, name, text):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(text)

    def git(self, *words):
        """Returns what git prints."""
        return run('git', '-c', 'user.name=test', '-c', 'user.email=test', *words, cwd=self.folder).stdout.strip()

    def commit(self, *names):
        self.git('add', *names)
        self.git('commit', '-q', '--allow-empty', '-m', 'one')


def copy_sources(folder):
    """Copies the files that git tracks, except those that were removed without a commit."""
    for name in run('git', 'ls-files', '-z', cwd=SOURCE).stdout.split('\0'):
        if name and (SOURCE / name).is_file():
            (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(SOURCE / name, Path(folder) / name)
