"""Packed programs, in odd environments and damaged: that of packer/example, and the film. A damaged program reports it,
or the system refuses it. It never runs, never hangs, and leaves no files."""
import errno
import os
import shutil
from pathlib import Path

import pytest

from running import BUILD, FILM, SOURCE, needs_built, redirected, refuses, run

needs_built(FILM)
pytestmark = pytest.mark.usefixtures('made')
PACK = BUILD / 'pack'
WHOLE = (BUILD / FILM).read_bytes()
SIZE = len(WHOLE)
UNGUARDED = 656  # bytes that cannot be checked: the header, and the code of the check itself (packer/README.md)


@pytest.fixture(scope='module')
def made(in_work):
    """The example, packed, also as `named`, with the name of a program to use instead."""
    Path('printed').write_text(run('bash', SOURCE / 'packer/example/build.sh', PACK, '.').stdout)
    run(PACK, *'hello.elf -o named --safe-name hello-safe --fast'.split())


def says_hello(command, words=1):
    result = run(*command.split(), status=7)
    assert (result.stdout, result.stderr) == (f'hello, {words} words, 42\n', '')


@pytest.mark.parametrize('command, words', [
    ('./hello', 1), ('./hello a b', 3), ('setarch -R ./hello', 1), (f'prlimit --as={120000 * 1024} ./hello', 1),
    ('./named', 1)])
def test_runs(command, words):
    says_hello(command, words)


def test_runs_by_another_path_and_with_closed_descriptors_but_not_without_memory():
    says_hello(os.path.abspath('hello'))
    run(*redirected('<&- >&- 2>&-', './hello'), status=7)
    refuses(1, 'not enough free memory', 'prlimit', f'--as={40000 * 1024}', './hello')


def test_its_size_is_its_payload_and_3147_bytes():
    printed = Path('printed').read_text()
    assert 'bytes left' in printed
    assert '(3147 of them stub and headers)' in printed


@pytest.mark.parametrize('name, text', [('hello', 'it may not run packed.'), ('named', 'use hello-safe instead')])
def test_reports_that_written_memory_may_not_be_executed(name, text, mdwe):
    refuses(1, text, f'./{name}', preexec_fn=mdwe)


def test_unpacked_it_has_the_same_code_in_the_same_place():
    for name in 'hello', 'named':
        assert ': whole; ' in run(PACK, '--test', name).stdout
    run(PACK, *'-d hello -o plain'.split())
    says_hello('./plain a', 2)
    # -d gives the image as the linker laid it out, except for the loader's tables, which are zeros
    run(*'objcopy -O binary -j .text hello.elf code'.split())
    plain, elf, code = [Path(name).read_bytes() for name in ('plain', 'hello.elf', 'code')]
    assert code
    assert plain.find(code) == elf.index(code) + 4096


# --- Damage (elf_test damages each byte for --test and -d) ---

DUMP = ('--dump', '-', '--from', 20, '--to', 20.04, '--size', '16x9')  # frames of the film


def program_of(data, folder):
    (folder / 'broken').write_bytes(data)
    (folder / 'broken').chmod(0o755)
    return folder / 'broken'


def reports_damage(data, folder):
    refuses(1, 'damaged: copy it again', program_of(data, folder), *DUMP, cwd=folder)
    assert os.listdir(folder) == ['broken']


def test_a_flipped_bit_anywhere_is_refused(tmp_path):
    hello = bytearray(Path('hello').read_bytes())
    last = len(hello) - 1
    for at in (*range(UNGUARDED, last, 97), last):
        hello[at] ^= 1 << at % 8
        reports_damage(hello, tmp_path)
        hello[at] ^= 1 << at % 8
    refuses(2, 'broken: damaged', PACK, '--test', tmp_path / 'broken')


@pytest.mark.parametrize('number', [0x55555555, 0x0fedcba9, 0xffffffff, 0], ids=hex)
def test_extreme_numbers_in_the_payload_header_are_refused(number, tmp_path):
    hello = bytearray(Path('hello').read_bytes())
    at = 528 + os.path.getsize(BUILD / 'generated/stub.bin')  # the fields that the check reads
    hello[at:at + 12] = number.to_bytes(4, 'little') * 3
    reports_damage(hello, tmp_path)


def test_bytes_after_its_end_do_not_matter():
    shutil.copy('hello', 'longer')
    with open('longer', 'a') as file:
        file.write('more bytes\n')
    says_hello('./longer')
    run(PACK, '--test', 'longer')


def with_wrong_bytes(chance):
    """The film, where up to 4096 bytes are overwritten with other bytes of it."""
    at, other = chance.randrange(UNGUARDED, SIZE), chance.randrange(SIZE)
    wrong = WHOLE[other:other + chance.randint(1, 4096)][:SIZE - at]
    return WHOLE[:at] + wrong + WHOLE[at + len(wrong):]


def cut_short(chance):
    return WHOLE[:chance.randrange(660, SIZE)]


def cut_short_and_filled_up_with_zeros(chance):
    return WHOLE[:chance.randrange(660, SIZE - 100)].ljust(SIZE, b'\0')


@pytest.mark.parametrize('tries', [8, pytest.param(400, marks=pytest.mark.long)])
@pytest.mark.parametrize('damaged', [with_wrong_bytes, cut_short, cut_short_and_filled_up_with_zeros])
def test_the_film_reports_random_damage(damaged, tries, chance, tmp_path):
    for _ in range(tries):
        data = damaged(chance)
        if data != WHOLE:
            reports_damage(data, tmp_path)


# Borders of the header, the check, the stub and pages
@pytest.mark.parametrize('length', [1, 4, 63, 64, 65, 120, 400, 527, 528, 529, 600, 655, 656, 657, 658, 659])
def test_the_film_does_not_run_without_the_code_of_the_check(length, tmp_path):
    try:
        result = run(program_of(WHOLE[:length], tmp_path), *DUMP, cwd=tmp_path, status=None)
        assert result.returncode != 0 and not result.stdout
    except OSError as refusal:
        assert refusal.errno == errno.ENOEXEC
    assert os.listdir(tmp_path) == ['broken']


@pytest.mark.parametrize('length', [660, 661, 700, 2666, 4095, 4096, 4097, 8192, 32768, SIZE // 4096 * 4096,
                                    *range(SIZE - 5, SIZE)])
def test_the_film_reports_that_it_is_cut_at_a_border(length, tmp_path):
    reports_damage(WHOLE[:length], tmp_path)
