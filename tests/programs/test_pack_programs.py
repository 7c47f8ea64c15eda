"""Packs programs of many compilers: they behave as before, and are smaller than xz makes them. The table that is
printed at the end is in packer/README.md."""
import lzma
import shutil
import time

import pytest

from running import BUILD, SOURCE, needs, run, transcript

pytestmark = pytest.mark.long
needs('gcc', 'g++', 'strip')
PROGRAMS = SOURCE / 'tests/support/programs'
LARGE = 100_000

# Name, command that builds it, and commands that run it
BUILT = [(f'hello of C, {compiler} {link}'.strip(), f'{compiler} -O2 -o {{}} hello.c {link}', [['./run']])
         for compiler in ('gcc', 'clang') for link in ('', '-no-pie', '-static', '-static-pie')] + [
    ('hello of C, static, musl', 'musl-gcc -O2 -static -o {} hello.c', [['./run']]),
    ('hello of Rust', 'rustc -O -o {} hello.rs', [['./run']]),
    ('hello of Go, with a goroutine', 'go build -o {} hello.go', [['./run']]),
    ('SDL2 and OpenGL, C++', 'g++ -O2 -o {} triangle.cpp -lSDL2 -lGL', [['xvfb-run', '-a', './run', '3']])]
# Name, program, and commands that run it; they may change `file`, which has the word `one`
INSTALLED = [
    ('bash', '/usr/bin/bash', [['./run', '-c', 'for i in 1 2 3; do echo $((i * i)); done; exit 4']]),
    ('busybox', '/usr/bin/busybox', [['busybox', 'awk', 'BEGIN { print 6 * 7 }'],
                                     ['busybox', 'sh', '-c', 'echo a | tr a b; exit 4']]),
    ('curl', '/usr/bin/curl', [['./run', '-sS', 'file:///etc/hostname'], ['./run', '--version']]),
    ('vim', '/usr/bin/vim.basic', [['./run', '-es', '-u', 'NONE', '-c', 's/one/two/', '-c', 'wq', 'file']]),
    ('python3.11', '/usr/bin/python3.11', [
        ['./run', '-c', 'import sys, json, ctypes, threading; print(json.dumps([1, {}])); sys.exit(3)']]),
    ('radiosity', BUILD / 'radiosity', [['./run', '--help']])]


@pytest.fixture(scope='module')
def table(request):
    """The rows of the table."""
    rows = []
    yield rows
    with request.config.pluginmanager.getplugin('capturemanager').global_and_fixture_disabled():
        print('\n| | file | xz -9e --x86 | packed | / xz | s | `--fast` | / xz | s |')
        for name, file, small, packed, seconds, fast, fast_seconds in sorted(rows, key=lambda row: row[1]):
            print(f'| {name} | {file} | {small} | {packed} | {packed / small:.2f} | {seconds:.1f} | '
                  f'{fast} | {fast / small:.2f} | {fast_seconds:.1f} |')


def xz(data, *before, **options):
    """The size that xz -9e makes."""
    last = {'id': lzma.FILTER_LZMA2, 'preset': 9 | lzma.PRESET_EXTREME, **options}
    return len(lzma.compress(data, filters=[*before, last]))


def noise(data):
    """The bytes in blocks of 4 KB that xz cannot compress, such as curl's manual, which is compressed."""
    blocks = (data[at:at + 4096] for at in range(0, len(data), 4096))
    return sum(4096 for block in blocks if xz(block, dict_size=4096) > 4000)


def behaviour(folder, commands):
    """What the commands print, their statuses, what they leave in `file`, and the seconds that they took."""
    (folder / 'file').write_text('one\n')
    began = time.monotonic()
    done = [transcript(*command, cwd=folder, executable=folder / 'run' if command[0] == 'busybox' else None)
            for command in commands]
    return done, (folder / 'file').read_text(), time.monotonic() - began


def check(name, program, commands, folder, table):
    """Asserts that a program behaves as before, and is small if it has 100 KB. Returns its size without symbols."""
    for part in 'before', 'packed', 'fast':
        (folder / part).mkdir()
    shutil.copy(program, folder / 'before/run')
    stripped = folder / 'stripped'
    if run('strip', '-o', stripped, program, status=None).returncode:
        shutil.copy(program, stripped)
    # This may take longer than PATIENCE on a busy machine
    run(BUILD / 'pack', stripped, '-o', folder / 'packed/run', timeout=None)
    run(BUILD / 'pack', stripped, '-o', folder / 'fast/run', '--fast', timeout=None)
    done, file, _ = behaviour(folder / 'before', commands)
    assert all(0 <= status <= 9 for _, status in done), done
    assert any(output for output, _ in done) or file != 'one\n'
    *got, seconds = behaviour(folder / 'packed', commands)
    assert got == [done, file]
    *got, fast_seconds = behaviour(folder / 'fast', commands)
    assert got == [done, file]
    data = stripped.read_bytes()
    small = xz(data, {'id': lzma.FILTER_X86})
    packed, fast = ((folder / part / 'run').stat().st_size for part in ('packed', 'fast'))
    table.append((name, len(data), small, packed, seconds, fast, fast_seconds))
    if len(data) >= LARGE:
        assert packed - noise(data) <= 0.8 * (small - noise(data))
    return len(data)


@pytest.mark.parametrize('name, build, commands', BUILT, ids=[row[0] for row in BUILT])
def test_a_built_program_behaves_as_before_and_is_small(name, build, commands, tmp_path, table):
    needs(build.split()[0], *[command[0] for command in commands if command[0] != './run'])
    program = tmp_path / 'program'
    env = {'GOCACHE': tmp_path / 'cache', 'GOFLAGS': '-mod=mod'}
    if run(*build.format(program).split(), cwd=PROGRAMS, env=env, status=None).returncode:
        pytest.skip(f'a library of {name} is not installed')
    check(name, program, commands, tmp_path, table)


@pytest.mark.parametrize('name, program, commands', INSTALLED, ids=[row[0] for row in INSTALLED])
def test_an_installed_program_behaves_as_before_and_is_small(name, program, commands, tmp_path, table):
    needs(program)
    assert check(name, program, commands, tmp_path, table) >= LARGE
