"""The packed film: its size, and one check of each kind. Other tests run all checks on the unpacked film, which is the
same program and starts seconds sooner; tools/test --long runs them on the packed one."""
import pytest

from running import BUILD, CONF, FILM, redirected, refuses, run

PACKED, SAFE = BUILD / FILM, BUILD / f'{FILM}-safe'
SMALL = ('--size', '64x36', '--from', 2, '--to', 2.2, '--quality', 'draft')


@pytest.mark.parametrize('name', [FILM, f'{FILM}.exe'])
def test_is_within_its_budget_and_whole(name):
    assert (BUILD / name).stat().st_size <= int(CONF['FILM_BUDGET'])
    assert ': whole; ' in run(BUILD / 'pack', '--test', BUILD / name).stdout


def test_prints_the_version_of_the_unpacked_film():
    assert run(PACKED, '--version').stdout == run(SAFE, '--version').stdout


def test_dumps_what_the_unpacked_film_does_without_descriptors_and_without_opengl(tmp_path):
    run(SAFE, '--dump', tmp_path / 'wanted', *SMALL)
    command = redirected('<&- >&- 2>&-', PACKED, '--dump', tmp_path / 'got', *SMALL)
    run(*command, env={'LIBGL_DRIVERS_PATH': '/none'})
    run('diff', '-r', tmp_path / 'wanted', tmp_path / 'got')


def test_refuses_to_play_without_a_display():
    refuses(1, 'no X display', PACKED)


def test_opens_a_window_with_its_name(display):
    assert display().begin(PACKED, '--window', '--mute').number
