"""tools/watch from a clone, without a display and with one. In a long run it builds, and makes the whole video.
Otherwise it uses built programs, and the film has 24 s and small frames."""
import os
import re
from types import SimpleNamespace

import pytest

from pictures import read_picture
from running import BUILD, FILM, SAFE, SOURCE, Program, copy_sources, needs, needs_built, refuses, run

needs('ffmpeg', 'ffprobe', 'g++')
needs_built('contact_sheet')
WATCH, PROGRAMS = SOURCE / 'tools/watch', SOURCE / 'tests/support/programs'


@pytest.fixture(scope='module', autouse=True)
def packages():
    """Skips the tests where tools/watch would install packages."""
    scripts = WATCH.read_text() + (SOURCE / 'tools/build/packages.sh').read_text()
    lists = re.findall('^ *need "(?:building|the contact sheet.*)" (.*)', scripts, re.M)
    assert len(lists) == 2
    names = ' '.join(lists).split()
    states = run('dpkg-query', '-W', '-f', '${Status}\n', *names, status=None).stdout.splitlines()
    if states != ['install ok installed'] * len(names):
        pytest.skip('a package that tools/watch needs is not installed')


@pytest.fixture(scope='module')
def clone(work):
    """A clone in which stand-ins for CMake and for the film are used."""
    house, bin = work / 'a house', work / 'bin'
    copy_sources(house)
    bin.mkdir()
    (house / 'build').mkdir()
    (bin / 'cmake').symlink_to(PROGRAMS / 'cmake.py')
    (house / f'build/{FILM}-safe').symlink_to(PROGRAMS / 'short_film.py')
    env = {'PATH': f'{bin}:{os.environ["PATH"]}', 'BUILT': f'{BUILD / FILM}:{BUILD}/contact_sheet',
           'WHOLE': SAFE}
    return SimpleNamespace(house=house, env=env, seconds=2)


@pytest.fixture(scope='module')
def builds(work):
    """A clone that builds the whole film."""
    copy_sources(work / 'house')
    return SimpleNamespace(house=work / 'house', env={}, seconds=16)


@pytest.mark.parametrize('name', ['clone', pytest.param('builds', marks=pytest.mark.long)])
def test_without_a_display_makes_a_contact_sheet_and_a_video(name, request, tmp_path):
    clone = request.getfixturevalue(name)
    with Program(tmp_path, clone.house / 'tools/watch', env=clone.env) as watch:
        assert watch.ended() == 0, watch.errors()
        printed = watch.errors()
    # What it does and how long it takes comes first, and that there is no display before it builds
    assert re.match('building the film: about two minutes .* log in .*/build/build.log\n', printed)
    assert re.search('^no display.*^building: ', printed, re.M | re.S)
    to = clone.house / 'build'
    assert read_picture(to / 'film.png').shape[:2] == (1560, 1956)  # 33 frames
    probe = ('ffprobe', '-v', 'error', '-show_entries', 'stream=codec_name,duration', '-of', 'csv=p=0')
    seconds = f'{clone.seconds}.000000'  # one of every ten of the film
    assert run(*probe, to / 'film.mp4').stdout.split() == [f'h264,{seconds}', f'aac,{seconds}']


def test_a_build_that_fails_ends_it_with_the_reason_and_a_display_that_cannot_be_opened_counts_as_none(clone):
    env = {**clone.env, 'DISPLAY': ':99999999', 'BUILT': ''}
    printed = run(clone.house / 'tools/watch', status=1, env=env).stderr
    assert 'no compiler' in printed.splitlines()
    assert re.search(r'^no display \(DISPLAY is :99999999, ', printed, re.M)


@pytest.mark.parametrize('text, options', [
    ("cannot use '--nope'", ['--window', '--nope']),
    ('needs a value, S', ['--mute', '--from']),
    ("cannot use '--mute' with --web", ['--web', '--mute']),
    ("cannot use '--mute=1'", ['--from=60', '--mute=1']),
    ("tools/render: cannot use '--nope'", ['--whole', '--nope'])])
def test_answers_before_it_builds(clone, text, options):
    env = {**clone.env, 'BUILT': ''}
    refuses(2, text, clone.house / 'tools/watch', *options, env=env)
    for known in ['--from', 2], ['--from=60', '--size=640x360'], ['--web']:
        assert run(clone.house / 'tools/watch', *known, '--version', env=env).stdout.startswith(f'{FILM} ')


def test_with_a_display_says_that_it_packs_and_plays_the_film_as_large_as_the_screen(clone, display):
    needs('pgrep')
    screen = display('640x400')
    window = screen.begin(clone.house / 'tools/watch', '--mute', env={**clone.env, 'PACKS': ' packing'})
    assert window.size() == (640, 400)
    screen.do('key', 'Escape')
    assert window.program.ended() == 0
