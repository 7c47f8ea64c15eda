"""Packs programs of many compilers: they behave as before, and are smaller than xz makes them. The table that is
printed at the end is in packer/README.md. They also run under the distribution's kernel, in a machine of qemu with
5-level paging."""
import gzip
import lzma
import re
import shutil
import time

import pytest

from running import BUILD, PATIENCE, SOURCE, needs, run, transcript

pytestmark = pytest.mark.long
needs('gcc', 'g++', 'strip')
PROGRAMS = SOURCE / 'tests/support/programs'
LARGE = 100_000
LINKS = ['', '-no-pie', '-static', '-static-pie']

# Name, command that builds it, and commands that run it
BUILT = [(f'hello of C, {compiler} {link}'.strip(), f'{compiler} -O2 -o {{}} hello.c {link}', [['./run']])
         for compiler in ('gcc', 'clang') for link in LINKS] + [
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


# --- Another kernel ---

INIT = '''#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
echo "kernel $(/bin/busybox uname -r), $(/bin/busybox grep -o -m 1 la57 /proc/cpuinfo)"
export SAID=words
for program in /bin/packed* /bin/hello; do $program a word; echo "$program: status $?"; done
/bin/busybox poweroff -f
'''


@pytest.fixture(scope='module')
def kernel(work):
    needs('qemu-system-x86_64', 'busybox', 'apt-get', 'dpkg')
    depends = re.search(r'Depends: (\S+)', run('apt-cache', 'depends', 'linux-image-cloud-amd64', status=None).stdout)
    if not depends or run('apt-get', 'download', depends[1], cwd=work, status=None).returncode:
        pytest.skip('the kernel is not installed, and cannot be downloaded')
    run('dpkg', '-x', *work.glob('linux-image*.deb'), work)
    return next(work.glob('boot/vmlinuz-*'))


@pytest.fixture(scope='module')
def log(work, kernel):
    """What the machine prints. Its processor is emulated, which takes about a minute."""
    root = work / 'root'
    for folder in 'bin', 'proc', 'lib64', 'lib/x86_64-linux-gnu':
        (root / folder).mkdir(parents=True)
    libraries = [f'lib/x86_64-linux-gnu/{name}' for name in ('libc.so.6', 'libdl.so.2')]
    for file in 'bin/busybox', 'lib64/ld-linux-x86-64.so.2', *libraries:
        shutil.copy(f'/{file}', root / file)
    for link in LINKS:
        run('gcc', '-O1', '-s', PROGRAMS / 'loaded.c', *link.split(), '-o', work / 'program')
        run(BUILD / 'pack', work / 'program', '-o', root / f'bin/packed{link}', '--loader', '--fast')
    run('bash', SOURCE / 'packer/example/build.sh', BUILD / 'pack', work)
    shutil.copy(work / 'hello', root / 'bin')
    (root / 'init').write_text(INIT)
    (root / 'init').chmod(0o755)
    names = b'\n'.join(bytes(path.relative_to(root)) for path in root.rglob('*'))
    archive = run('busybox', 'cpio', '-o', '-H', 'newc', input=names, cwd=root, text=False).stdout
    (work / 'initrd').write_bytes(gzip.compress(archive, 1))
    machine = 'qemu-system-x86_64 -M q35 -cpu max,la57=on -m 512 -nographic -no-reboot'.split()
    files = ('-kernel', kernel, '-initrd', work / 'initrd')
    return run(*machine, *files, '-append', 'console=ttyS0 quiet panic=-1', timeout=2 * PATIENCE).stdout


def test_packed_programs_run_under_a_kernel_with_5_level_paging(log):
    assert re.search('kernel .*, la57$', log, re.M)
    for link in LINKS:
        assert f'\n/bin/packed{link}: status 7\n' in log
    assert log.count("\n3 words, the last 'word'; 43, 1, relative addresses, 0, words\n") == len(LINKS)
    assert '\n/bin/hello: status 7\n' in log  # a program made for packing
