"""The packer's example for Windows, run by Wine."""
import shutil

import pytest

from running import BUILD, SOURCE, flip, refuses, run
from wine import answers_box

pytestmark = pytest.mark.windows
PACK = BUILD / 'pack'
CHECKED = 512 + 264 + 300  # after headers, imports, and the code that checks and reports


@pytest.fixture(scope='module')
def example(work):
    run('bash', SOURCE / 'packer/example/build.sh', PACK, work, '--pe')
    return work / 'hello.exe'


@pytest.fixture
def broken(example, tmp_path):
    return shutil.copy(example, tmp_path / 'broken.exe')


def greets(*command, **options):
    result = run(*command, status=7, **options)
    assert (result.stdout.rstrip(), result.stderr) == ('hello, 42', '')


def test_runs_by_any_path(wine, example):
    greets(wine, example)
    greets(wine, './hello.exe', cwd=example.parent)


def test_is_unpacked_into_what_plain_makes(wine, example, tmp_path):
    plain, again = tmp_path / 'plain.exe', tmp_path / 'again.exe'
    run(PACK, '-d', example, '-o', plain)
    greets(wine, plain)
    run(PACK, example.parent / 'hello_windows.elf', '-o', again, '--pe', '--plain')
    run('cmp', plain, again)


# The film has the same checking code
def test_refuses_a_flipped_bit_anywhere(wine, example, broken, tmp_path):
    size = example.stat().st_size
    assert size > 3000
    for at in [*range(CHECKED, size - 1, 97), size - 1]:
        shutil.copy(example, broken)
        flip(broken, at, 1 << at % 8)
        refuses(1, 'damaged: copy it again', wine, broken)
        refuses(2, f'{broken}: ', PACK, '--test', broken)
        refuses(2, f'{broken}: ', PACK, '-d', broken, '-o', tmp_path / 'x')


def test_runs_with_bytes_after_its_end(wine, broken):
    broken.write_bytes(broken.read_bytes() + b'more bytes\n')
    greets(wine, broken)


def test_reports_damage_in_a_box_without_standard_error(wine, broken, display):
    flip(broken, broken.stat().st_size - 1, 1)
    assert answers_box(display('640x480'), 'damaged: copy it again', wine, broken) == 1
