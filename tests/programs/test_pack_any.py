"""Packs programs of ordinary compilers, which must behave as before. In a long run also static programs, which contain
glibc. (elf_test tests which programs are refused.)"""
import os
import shutil
from pathlib import Path

import pytest

from running import BUILD, SOURCE, flip, needs, number, refuses, run, transcript

needs('gcc')
PACK, PROGRAMS, MODEL = BUILD / 'pack', SOURCE / 'tests/support/programs', SOURCE / 'tests/support/small.model'


def pack(words, *options):
    return run(PACK, *words.split(), *options)


FAST = ('--model', MODEL)  # has few contexts


@pytest.fixture(scope='module')
def made(work):
    """A folder with the program c; c.packed; what pack has printed; and `named`, packed with the name of another."""
    run('gcc', '-O1', PROGRAMS / 'loaded.c', '-o', 'c', cwd=work)
    (work / 'printed').write_text(run(PACK, *'c -o c.packed'.split(), cwd=work).stdout)
    run(PACK, *'c -o named --safe-name hello-safe'.split(), *FAST, cwd=work)
    return work


@pytest.fixture(autouse=True)
def in_a_folder(made, tmp_path, monkeypatch):
    """Runs the test in a folder with copies of these files."""
    shutil.copytree(made, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)


def behave_the_same(program, packed):
    """Asserts that both programs do the same with two arguments, under the same name, which they may print."""
    done = []
    for file in program, packed:
        os.renames(file, f'{file}.d/run')
        done.append(transcript('./run', 'a', 'b c', cwd=f'{file}.d', env={'SAID': 'words'}))
    assert done[0] == done[1]
    assert done[0][0]


def test_behaves_as_before_and_stub_and_headers_take_3220_bytes_at_most():
    behave_the_same('c', 'c.packed')
    assert number(r'^c\.packed: .*\((\d+) of them', Path('printed').read_text()) <= 3220


@pytest.mark.parametrize('compiler, source', [
    *[(compiler, 'loaded.c') for compiler in (
        'gcc -no-pie -Wl,-s', 'gcc -Wl,-z,now -Wl,-z,pack-relative-relocs', 'gcc -Wl,-z,noseparate-code',
        'gcc -Wl,-z,max-page-size=0x4000', 'clang', 'musl-gcc', 'musl-gcc -static')],
    ('g++ -pthread', 'thrown.cpp'),  # threads and exceptions
    pytest.param('gcc -static -Wl,-s', 'loaded.c', marks=pytest.mark.long),
    pytest.param('gcc -static-pie -Wl,-s', 'loaded.c', marks=pytest.mark.long)])
def test_behaves_as_before_if_made_by(compiler, source):
    needs(compiler.split()[0])
    if run(*compiler.split(), '-O1', PROGRAMS / source, '-o', 'made', status=None).returncode:
        pytest.skip('it cannot link this')
    pack('made -o packed', *FAST)
    behave_the_same('made', 'packed')


def test_behaves_as_before_with_its_interpreters_name_moved():
    needs('patchelf')
    run('patchelf', '--add-needed', 'libm.so.6', 'c')
    run('patchelf', '--set-interpreter', f'/lib64/{"../lib64/" * 6}ld-linux-x86-64.so.2', 'c')
    pack('c -o packed', *FAST)
    behave_the_same('c', 'packed')


def test_unpacked_it_behaves_as_before():
    assert 'whole' in pack('--test c.packed').stdout
    pack('-d c.packed -o plain')
    behave_the_same('c', 'plain')


# Errors begin with the program's name, and the program itself does not run
def test_reports_that_it_is_damaged_and_too_little_memory():
    refuses(1, './c.packed: not enough free memory', 'prlimit', f'--as={30000 * 1024}', './c.packed')
    shutil.copy('c.packed', 'flipped')
    flip('flipped', 3800)
    refuses(1, './flipped: damaged: copy it again', './flipped')
    os.truncate('c.packed', 3900)
    refuses(1, './c.packed: damaged: copy it again', './c.packed')


@pytest.mark.parametrize('interpreter, error', [('lib64/lost', '02'), ('.', '21'), ('dev/null', '80')],
                         ids=['missing', 'folder', 'empty'])
def test_reports_an_interpreter_that_cannot_be_used(interpreter, error):
    name = b'/lib64/ld-linux-x86-64.so.2'
    Path('c').write_bytes(Path('c').read_bytes().replace(name, interpreter.encode().rjust(len(name), b'/')))
    pack('c -o lost', *FAST)
    refuses(1, f'./lost: no interpreter: errno {error}', './lost')


def test_runs_without_open_as_its_interpreter_does_and_reports_that_it_cannot_openat():
    deny = ('gcc', '-O1', PROGRAMS / 'deny.c', '-o', 'deny')
    run(*deny, '-DCALL=SYS_open')
    assert "the last 'x'" in run('./deny', './c.packed', 'x', status=7).stdout
    run(*deny, '-DCALL=SYS_openat')
    refuses(1, './c.packed: no interpreter: errno 01', './deny', './c.packed')


def test_reports_that_written_memory_may_not_be_executed_and_which_program_to_use_instead(mdwe):
    refuses(1, './c.packed: may not run packed', './c.packed', preexec_fn=mdwe)
    refuses(1, './named: use hello-safe', './named', preexec_fn=mdwe)


# The file that is written
def test_a_file_keeps_its_mode_and_a_symbolic_link_stays_a_link():
    os.chmod('c', 0o750)
    run(PACK, *'c -o p --fast'.split(), umask=0o022)
    assert os.stat('p').st_mode & 0o7777 == 0o750
    os.chmod('p', 0o710)
    pack('-d p -o q')
    assert os.stat('q').st_mode & 0o7777 == 0o710
    os.mkdir('target')
    os.symlink('target/file', 'link')
    pack('c -o link', *FAST)
    assert os.path.islink('link')
    pack('--test target/file')


def test_appended_bytes_are_left_out_and_reported():
    with open('c', 'a') as file:
        file.write(1000 * 'x')
    assert '1000 bytes appended' in pack('c -o y', *FAST).stdout


def test_refuses_a_setuid_program_and_one_with_file_capabilities():
    os.chmod('c', 0o4755)
    refuses(2, 'setuid', PACK, 'c', '-o', 'x')
    os.chmod('c', 0o755)
    setcap = Path('/sbin/setcap')  # not in the PATH of users
    if not setcap.exists() or run(setcap, 'cap_net_raw=p', 'c', status=None).returncode:
        pytest.skip('files cannot be given capabilities here')
    refuses(2, 'file capabilities', PACK, 'c', '-o', 'x')
    assert not os.path.exists('x')
