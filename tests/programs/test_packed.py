"""The packed program of packer/example, in odd environments and damaged."""
import os
import shutil
from pathlib import Path

import pytest

from running import BUILD, SOURCE, flip, redirected, refuses, run

pytestmark = pytest.mark.usefixtures('made')
PACK = BUILD / 'pack'


@pytest.fixture(scope='module')
def made(in_work):
    """The example, packed, also as `named`, with the name of a program to use instead."""
    Path('printed').write_text(run('bash', SOURCE / 'packer/example/build.sh', PACK, '.').stdout)
    run(PACK, *'hello.elf -o named --safe-name hello-safe --fast'.split())


def says_hello(command, words=1):
    result = run(*command.split(), status=7)
    assert (result.stdout, result.stderr) == (f'hello, {words} words, 42\n', '')


def test_its_size_is_its_payload_and_3147_bytes():
    printed = Path('printed').read_text()
    assert 'bytes left' in printed
    assert '(3147 of them stub and headers)' in printed


@pytest.mark.parametrize('command, words', [
    ('./hello', 1), ('./hello a b', 3), ('setarch -R ./hello', 1), (f'prlimit --as={120000 * 1024} ./hello', 1),
    ('./named', 1)])
def test_runs(command, words):
    says_hello(command, words)


def test_runs_by_another_path():
    says_hello(os.path.abspath('hello'))


def test_runs_with_closed_descriptors():
    run(*redirected('<&- >&- 2>&-', './hello'), status=7)


def test_reports_too_little_memory():
    refuses(1, 'not enough free memory', 'prlimit', f'--as={40000 * 1024}', './hello')


@pytest.mark.parametrize('name, text', [('hello', 'it may not run packed.'), ('named', 'use hello-safe instead')])
def test_reports_that_written_memory_may_not_be_executed(name, text, mdwe):
    refuses(1, text, f'./{name}', preexec_fn=mdwe)


@pytest.mark.parametrize('name', ['hello', 'named'])
def test_is_whole(name):
    assert ': whole; ' in run(PACK, '--test', name).stdout


def test_unpacked_it_has_the_same_code_in_the_same_place():
    run(PACK, *'-d hello -o plain'.split())
    says_hello('./plain a', 2)
    # -d gives the image as the linker laid it out, except for the loader's tables, which are zeros
    run(*'objcopy -O binary -j .text hello.elf code'.split())
    plain, elf, code = [Path(name).read_bytes() for name in ('plain', 'hello.elf', 'code')]
    assert code
    assert plain.find(code) == elf.index(code) + 4096


# Damage. Nothing can check the first 656 bytes: the header and the check itself. (elf_test damages each byte for --test
# and -d; test_damaged.py cuts and overwrites the film)
def test_a_flipped_bit_anywhere_is_refused():
    last = os.path.getsize('hello') - 1
    for at in (*range(656, last, 97), last):
        broken = shutil.copy('hello', f'broken_at_{at}')
        flip(broken, at, 1 << at % 8)
        refuses(1, 'damaged: copy it again', f'./{broken}')
    refuses(2, f'{broken}: damaged', PACK, '--test', broken)


@pytest.mark.parametrize('number', [0x55555555, 0x0fedcba9, 0xffffffff, 0], ids=hex)
def test_extreme_numbers_in_the_payload_header_are_refused(number):
    shutil.copy('hello', 'wild')
    with open('wild', 'r+b') as file:
        file.seek(528 + os.path.getsize(BUILD / 'generated/stub.bin'))  # the fields that the check reads
        file.write(number.to_bytes(4, 'little') * 3)
    refuses(1, 'damaged: copy it again', './wild')


def test_bytes_after_its_end_do_not_matter():
    shutil.copy('hello', 'longer')
    with open('longer', 'a') as file:
        file.write('more bytes\n')
    says_hello('./longer')
    run(PACK, '--test', 'longer')
