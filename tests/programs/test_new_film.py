"""tools/new-film refuses wrong arguments with one line, and leaves no files. In a long run a film with a long name is
made, built, packed and tested, and nothing in it is called odraz."""
import datetime
import os
import re
import signal

import pytest

from pictures import read_ppm
from running import BUILD, FILM, SOURCE, needs, number, refuses, run

if run('git', '-C', SOURCE, 'rev-parse', 'HEAD', status=None).returncode:
    pytest.skip('a new film needs a git repository', allow_module_level=True)

NEW = SOURCE / 'tools/new-film'
PACKAGES = 'cmake ninja-build libcli11-dev libstb-dev libtinyexr-dev zlib1g-dev libglfw3-dev'.split()


def test_prints_its_usage_needs_a_folder_and_a_name_and_prints_gits_own_line_where_git_refuses(tmp_path):
    assert run(NEW, '--help').stdout.startswith('usage: tools/new-film DIR NAME')
    refuses(2, 'name a folder and the film', NEW)
    env = {'GIT_TEST_ASSUME_DIFFERENT_OWNER': 1}
    assert 'dubious ownership' in refuses(2, 'safe.directory', NEW, tmp_path / 'made', 'mira', env=env)


@pytest.mark.parametrize('to, name, text', [
    *[('made', name, 'a name has 1 to 11 letters, digits and -')
      for name in ('', 'twelveletter', 'a film', 'a_b', 'a.b', 'a/b', 'película', 'a\nb')],
    *[('made', name, f'the name {name} is already used') for name in 'odraz pack Tests film all compare live'.split()],
    ('no/where', 'mira', 'there is no folder no to make'),
    ('full', 'mira', 'already exists: choose a new or empty folder'),
    ('full/.file', 'mira', 'already exists'),
    (SOURCE / 'tools/mira', 'mira', 'is in this repository'),
    ('link/mira', 'mira', 'is in this repository'),
    ('/mira', 'mira', 'cannot write to /')])
def test_refuses_an_unsuitable_folder_or_name_and_leaves_nothing(to, name, text, tmp_path):
    if to == '/mira' and os.getuid() == 0:
        pytest.skip('root may write to /')
    (tmp_path / 'full').mkdir()
    (tmp_path / 'full/.file').touch()
    (tmp_path / 'link').symlink_to(SOURCE)
    refuses(2, text, NEW, to, name, cwd=tmp_path)
    assert sorted(file.name for file in tmp_path.rglob('*')) == ['.file', 'full', 'link']


def not_copied(film):
    """The headers of tools and tests, and the modules of tests, that a new film includes or imports but lacks."""
    found = set()
    for folder in 'intro', 'packer', 'tools', 'tests/unit':
        for file in (film / folder).rglob('*.*'):
            found.update(re.findall(rb'^#include "((?:tools|tests)/[^"]*)"', file.read_bytes(), re.M))
    names = {name.decode() for name in found}
    for file in (film / 'tests/programs').glob('*.py'):
        modules = re.findall(r'^(?:from|import) (\w+)', file.read_text(), re.M)
        names.update(f'tests/programs/{name}.py' for name in modules)
    return [name for name in names if (SOURCE / name).exists() and not (film / name).exists()]


@pytest.mark.parametrize('exists', [False, True])
def test_leaves_nothing_where_it_is_interrupted(exists, tmp_path, background):
    needs('dpkg-query')
    installed = run('dpkg-query', '-W', '-f', '${Status}\n', *PACKAGES, status=None).stdout
    if installed.count('ok installed') < len(PACKAGES):
        pytest.skip('what builds a film is not installed')
    film = tmp_path / 'made'
    if exists:
        film.mkdir()
    program = background(NEW, film, 'mira', start_new_session=True)
    program.comes((film / 'build/build.log').exists)
    missing = not_copied(film)
    os.killpg(program.pid, signal.SIGTERM)
    assert program.ended() == 130
    assert film.exists() == exists
    assert not exists or not [*film.iterdir()]
    assert not missing
    assert not re.search(FILM, (SOURCE / 'intro/host/web/page.html').read_text())  # it takes the film's name


# --- The whole film ---

long = pytest.mark.long
NAME = 'wunderkmr'  # nine letters: with -safe the longest name that the packer's stub has room for


@pytest.fixture(scope='module')
def made(work):
    """The folder of a new film, which is built and tested."""
    needs('git', 'zip', 'unzip', 'ffprobe')
    printed = run(NEW, work / 'film', NAME, '--test', timeout=None).stdout
    assert re.search(rf'^build/{NAME}: \d+ bytes, \d+ left of 65536', printed, re.M)
    assert re.search('^100% tests passed', printed, re.M)
    return work / 'film'


@long
def test_a_new_film_has_tests_is_committed_and_far_smaller_than_its_budget(made):
    assert number(r'Total Tests: (\d+)', run('ctest', '--test-dir', made / 'build', '-N').stdout) >= 30
    assert (made / '.git').is_dir()
    assert run('git', 'status', '--porcelain', cwd=made).stdout == ''
    commit = run('git', 'rev-parse', '--short=12', 'HEAD', cwd=made).stdout
    assert run(made / 'build' / NAME, '--version').stdout == f'{NAME} 0.1.0 {commit}'
    assert (made / 'build' / NAME).stat().st_size < 49152
    assert run(made / 'tools/ledger', 'rooms').stderr == ''  # its rooms keep to their shares


def names_odraz(program):
    return b'odraz' in program.read_bytes().lower()


@long
def test_neither_the_packed_files_nor_the_programs_in_them_name_odraz(made, tmp_path):
    build = made / 'build'
    for name in NAME, f'{NAME}.exe':
        run(build / 'pack', '-d', build / name, '-o', tmp_path / name)
    files = [build / f'{NAME}{end}' for end in ('', '.exe', '-safe', '-safe.exe')]
    files.append(made / '.github/workflows/test.yml')
    # The page, whose markup is packed, is built where its compiler is installed
    files += [*build.glob(f'{NAME}.html'), *build.glob('intro/host/web/page.html')]
    assert not [file for file in (*files, *tmp_path.iterdir()) if names_odraz(file)]
    assert names_odraz(BUILD / 'odraz-safe')  # the name in this film would be found
    assert f'use {NAME}-safe'.encode() in (build / NAME).read_bytes()  # where it may not run packed


@long
def test_its_archives_have_its_own_texts(made, tmp_path):
    run(made / 'tools/release', '--built', '--no-capture', '--pictures', made / 'tests/support/pictures')
    release = made / 'build/release'
    # With the page, if that is built, there is an index
    assert len([*release.iterdir()]) == (4 if (made / 'build' / f'{NAME}.html').exists() else 2)
    run('tar', '-C', tmp_path, '-xzf', release / f'{NAME}-0.1.0.tar.gz')
    texts = tmp_path / f'{NAME}-0.1.0'
    assert not [text for text in (f'{NAME}.nfo', 'README.txt', 'file_id.diz') if names_odraz(texts / text)]
    licensed = f'Copyright (c) {datetime.date.today().year} the {NAME} team'
    assert licensed in (texts / 'LICENSE.txt').read_text().splitlines()
    assert (texts / 'LICENSE.txt').read_bytes() == (made / 'LICENSE').read_bytes()


@long
def test_its_scene_is_lit_its_word_is_written_and_it_begins_in_the_dark(made, tmp_path):
    run(made / 'build' / f'{NAME}-safe', '--dump', tmp_path, '--fps', 1, '--size', '160x90', '--quality', 'draft')
    frames = sorted(tmp_path.iterdir())
    assert len(frames) == 10
    light = [read_ppm(frame.read_bytes()).mean() for frame in frames]
    assert light[0] < 10 and min(light[1], light[3], light[5], light[7]) > 40
    assert number(r'difference ([\d.]*),', run(BUILD / 'compare', frames[3], frames[6], status=None).stdout) > 0.5


@long
def test_without_a_display_tools_watch_makes_a_video_of_one_second(made):
    run(made / 'tools/watch')
    length = ('-show_entries', 'format=duration', '-of', 'csv=p=0')
    assert run('ffprobe', '-v', 'error', *length, made / 'build/film.mp4').stdout.startswith('1.0')


@long
def test_its_tests_find_faults(made):  # the last one, since it changes the film
    def change(file, old, new):
        text = (made / file).read_text()
        assert re.search(old, text, re.M)
        (made / file).write_text(re.sub(old, new, text, flags=re.M))
        return run('cmake', '--build', made / 'build', '--target', 'film', status=None)

    change('intro/show/scenes/stage.cpp', '{2.6f, 0.9f, 0.27f}', '{0.9f, 2.6f, 0.27f}').check_returncode()
    run(made / 'tools/golden', 'check', status=1)
    run(made / 'tools/golden', 'renew')
    run(made / 'tools/golden', 'check')
    over_budget = change('intro/film.conf', '^FILM_BUDGET=.*', 'FILM_BUDGET=30000')
    assert over_budget.returncode and re.search(r'over budget by [\d,]+ bytes', over_budget.stdout)
