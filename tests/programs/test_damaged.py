"""The packed film, cut short and with wrong bytes, reports that it is damaged, or the system refuses it. It never runs,
never hangs, and leaves no files.

The film cannot check its first 656 bytes: the header, which the system and its loader read, and the code of the check
itself (packer/README.md). A changed byte there could make the program do anything, so these bytes are not changed;
the file is only cut there. test_packed.py damages a small program everywhere.
"""
import errno
import os

import pytest

from running import BUILD, FILM, needs_built, refuses, run

needs_built(FILM)
WHOLE = (BUILD / FILM).read_bytes()
SIZE = len(WHOLE)
UNGUARDED = 656
DUMP = ('--dump', '-', '--from', 20, '--to', 20.04, '--size', '16x9')


def program_of(data, folder):
    (folder / 'broken').write_bytes(data)
    (folder / 'broken').chmod(0o755)
    return folder / 'broken'


def reports_damage(data, folder):
    refuses(1, 'damaged: copy it again', program_of(data, folder), *DUMP, cwd=folder)
    assert os.listdir(folder) == ['broken']


def with_wrong_bytes(chance):
    """The film, where up to 4096 bytes are overwritten with other bytes of it."""
    at, other = chance.randrange(UNGUARDED, SIZE), chance.randrange(SIZE)
    wrong = WHOLE[other:other + chance.randint(1, 4096)][:SIZE - at]
    return WHOLE[:at] + wrong + WHOLE[at + len(wrong):]


def cut_short(chance):
    return WHOLE[:chance.randrange(660, SIZE)]


def cut_short_and_filled_up_with_zeros(chance):
    return WHOLE[:chance.randrange(660, SIZE - 100)].ljust(SIZE, b'\0')


def test_the_whole_film_runs(tmp_path):
    assert run(program_of(WHOLE, tmp_path), '--version').stdout.startswith(FILM)


@pytest.mark.parametrize('tries', [8, pytest.param(400, marks=pytest.mark.long)])
@pytest.mark.parametrize('damaged', [with_wrong_bytes, cut_short, cut_short_and_filled_up_with_zeros])
def test_reports_random_damage(damaged, tries, chance, tmp_path):
    for _ in range(tries):
        data = damaged(chance)
        if data != WHOLE:
            reports_damage(data, tmp_path)


# Borders of the header, the check, the stub and pages
@pytest.mark.parametrize('length', [1, 4, 63, 64, 65, 120, 400, 527, 528, 529, 600, 655, 656, 657, 658, 659])
def test_does_not_run_without_the_code_of_the_check(length, tmp_path):
    try:
        result = run(program_of(WHOLE[:length], tmp_path), *DUMP, cwd=tmp_path, status=None)
        assert result.returncode != 0 and not result.stdout
    except OSError as refusal:
        assert refusal.errno == errno.ENOEXEC
    assert os.listdir(tmp_path) == ['broken']


@pytest.mark.parametrize('length', [660, 661, 700, 2666, 4095, 4096, 4097, 8192, 32768, SIZE // 4096 * 4096,
                                    SIZE - 5, SIZE - 4, SIZE - 3, SIZE - 2, SIZE - 1])
def test_reports_that_it_is_cut_at_a_border(length, tmp_path):
    reports_damage(WHOLE[:length], tmp_path)
