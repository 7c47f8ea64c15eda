"""The film reads no uninitialised memory and nothing out of bounds: valgrind's memcheck checks a picture of each scene,
in draft and in film."""
import pytest

from running import BUILD, FILM, SOURCE, needs, run

needs('valgrind')

ODRAZ = BUILD / f'{FILM}.elf'  # as it ships, but with symbols


@pytest.mark.parametrize('quality', ['draft', 'film'])
@pytest.mark.parametrize('scenes, count, options', [
    ('point, table and flake', 4, '--fps 1/12 --from 12 --to 50'),
    ('credits', 1, '--fps 1 --from 159 --to 160'),
    # Memcheck takes half an hour to solve the hall
    pytest.param('patches, hall and odraz', 3, '--fps 1/29 --from 58 --to 117', marks=pytest.mark.long)])
def test_memcheck_finds_nothing_wrong_in(scenes, count, options, quality, tmp_path):
    log, pictures = tmp_path / 'log', tmp_path / 'pictures'
    # One thread in the film and one in the driver. The driver's vectors have 128 bits, which valgrind runs faster
    checked = run(
        'valgrind', '--error-exitcode=9', '--smc-check=none', f'--log-file={log}',
        f'--suppressions={SOURCE}/tests/support/valgrind.supp', ODRAZ, '--dump', pictures, '--size', '64x36',
        '--threads', 1, '--quality', quality, *options.split(), timeout=None,
        env={'LP_NUM_THREADS': 0, 'LP_NATIVE_VECTOR_WIDTH': 128}, status=None)
    assert checked.returncode == 0 and 'ERROR SUMMARY: 0 errors' in log.read_text(), log.read_text()
    assert len([*pictures.iterdir()]) == count


def test_memcheck_would_find_a_read_of_what_was_not_written(tmp_path):
    run('cc', '-O0', '-o', tmp_path / 'blind', SOURCE / 'tests/support/programs/blind.c')
    run('valgrind', '-q', '--error-exitcode=9', tmp_path / 'blind', status=9)
