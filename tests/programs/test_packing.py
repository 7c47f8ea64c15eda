"""The packer's command line, with the small example; and ordinary programs, which must behave as before. In a long run
also static programs, which contain glibc. (elf_test tests which programs are refused.)"""
import os
import re
import shutil
import signal
from pathlib import Path

import pytest

from running import BUILD, SOURCE, flip, needs, number, refuses, run, transcript

needs('gcc')
PACK, PROGRAMS = BUILD / 'pack', SOURCE / 'tests/support/programs'


def pack(words, **options):
    return run(PACK, *words.split(), **options)


@pytest.fixture(scope='module')
def made(work):
    """A folder with the example without symbols, which pack would report, `in`; and packed, with a report. And an
    ordinary program, c; c.packed; what pack has printed; and `named`, packed with the name of another program."""
    run('bash', SOURCE / 'packer/example/build.sh', 'true', work)  # `true` in place of pack
    run('strip', '-s', '-o', work / 'in', work / 'hello.elf')
    shutil.copy(SOURCE / 'tests/support/small.model', work / 'model')
    pack('in --model model -o hello --report report', cwd=work)
    run('gcc', '-O1', PROGRAMS / 'loaded.c', '-o', 'c', cwd=work)
    (work / 'printed').write_text(pack('c -o c.packed', cwd=work).stdout)
    pack('c -o named --safe-name hello-safe --model model', cwd=work)
    return work


@pytest.fixture(autouse=True)
def in_a_folder(made, tmp_path, monkeypatch):
    """Runs the test in a folder with copies of these files alone."""
    for name in 'in', 'model', 'hello', 'report', 'c', 'c.packed', 'printed', 'named':
        shutil.copy(made / name, tmp_path)
    monkeypatch.chdir(tmp_path)


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
    before = sorted(os.listdir())
    refuses(2, text, PACK, *words.split())
    assert sorted(os.listdir()) == before
    run('cmp', 'in', made / 'in')


# --- Ordinary programs ---

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
    pack('made -o packed --model model')
    behave_the_same('made', 'packed')


def test_behaves_as_before_with_its_interpreters_name_moved():
    needs('patchelf')
    run('patchelf', '--add-needed', 'libm.so.6', 'c')
    run('patchelf', '--set-interpreter', f'/lib64/{"../lib64/" * 6}ld-linux-x86-64.so.2', 'c')
    pack('c -o packed --model model')
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
    pack('c -o lost --model model')
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
def test_a_file_keeps_its_mode_a_symbolic_link_stays_a_link_and_appended_bytes_are_left_out_and_reported():
    os.chmod('c', 0o750)
    pack('c -o p --fast', umask=0o022)
    assert os.stat('p').st_mode & 0o7777 == 0o750
    os.chmod('p', 0o710)
    pack('-d p -o q')
    assert os.stat('q').st_mode & 0o7777 == 0o710
    os.mkdir('target')
    os.symlink('target/file', 'link')
    pack('c -o link --model model')
    assert os.path.islink('link')
    pack('--test target/file')
    with open('c', 'a') as file:
        file.write(1000 * 'x')
    assert '1000 bytes appended' in pack('c -o y --model model').stdout


def test_refuses_a_setuid_program_and_one_with_file_capabilities():
    os.chmod('c', 0o4755)
    refuses(2, 'setuid', PACK, 'c', '-o', 'x')
    assert not os.path.exists('x')
    os.chmod('c', 0o755)
    setcap = Path('/sbin/setcap')  # not in the PATH of users
    if not setcap.exists() or run(setcap, 'cap_net_raw=p', 'c', status=None).returncode:
        pytest.skip('files cannot be given capabilities here')
    refuses(2, 'file capabilities', PACK, 'c', '-o', 'x')
    assert not os.path.exists('x')
